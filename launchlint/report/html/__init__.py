"""The topology report: one HTML page that shows what connects, what is wrong, and where that is written."""
