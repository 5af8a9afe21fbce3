"""One normal form for launch files: the text is read into tokens, nothing is lost, and printed again."""
