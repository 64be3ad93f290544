"""How wide a text is in a terminal: an accent stands above its letter and takes no column."""

from __future__ import annotations

from unicodedata import category


def columns(text: str) -> int:
    """The number of columns that a text takes."""
    return sum(category(char) not in ("Mn", "Me") for char in text)


def padded(text: str, width: int) -> str:
    """The text, filled with spaces to a width."""
    return text + " " * (width - columns(text))
