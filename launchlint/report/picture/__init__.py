"""Pictures of a topology, or of what changed in one, as SVG: drawn without a browser."""
