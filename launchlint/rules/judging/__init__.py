"""What several rules ask: judgements about packages, files, names and params, each in one place. They know no rule."""
