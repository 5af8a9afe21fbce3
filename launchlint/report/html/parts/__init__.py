"""The markup of the page, part by part."""
