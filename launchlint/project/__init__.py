"""What is asked for, worked out: configuration → options, entry files, rules. Commands and the language server stand on it."""
