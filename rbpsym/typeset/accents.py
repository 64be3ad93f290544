"""Where browsers draw a formula of MathML not quite as it should be: dots that touch the letter, a gap behind limits."""

from __future__ import annotations

import re

DOTS = re.compile(r"<mo ([^>]*)>([˙¨])</mo></mover>")
LIMIT = "<msub><mo>∫</mo>"


def accented(mathml: str) -> str:
    """The MathML with classes that the style sheet (templates/notes.css) gives their distances."""
    dotted = DOTS.sub(r'<mo \1 class="dot-accent">\2</mo></mover>', mathml)
    return dotted.replace(LIMIT, '<msub class="limit"><mo>∫</mo>')
