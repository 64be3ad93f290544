"""The display tree: its nodes, readers and printers."""
