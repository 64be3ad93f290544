"""The document tree of the notes: blocks, phrases, figures and the writers of each format."""
