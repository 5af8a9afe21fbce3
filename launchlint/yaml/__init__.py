"""YAML with places: one reader for all that is written in it (parameter files, the configuration, the probe's, lists of entries)."""
