"""Display trees, names, and the readers that make trees of text."""
