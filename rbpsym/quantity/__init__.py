"""The one registry of quantities: the words that name them, and how each is found of a problem's mechanics."""
