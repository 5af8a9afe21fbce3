"""The connection graph in text: for people, for Mermaid and Graphviz, and as JSON."""
