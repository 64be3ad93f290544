"""The page in which a problem moves."""
