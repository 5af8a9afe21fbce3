"""The dialects of launch files, and the one door through which other rooms come to what is different in each."""
