"""The model written back as a launch file: as it stands, or as one file that needs no other."""
