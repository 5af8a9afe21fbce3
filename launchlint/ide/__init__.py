"""What an editor asks of a launch file, answered: pure functions of a view of the file and an offset, without a word of any protocol."""
