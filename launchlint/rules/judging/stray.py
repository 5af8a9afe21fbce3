"""What is said of a remap that does nothing where it stands, and that names what another finding speaks of."""

STRAY = "this remap does nothing"
