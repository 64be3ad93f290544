"""Accents of MathML as browsers should draw them: a short arrow, dots that keep off the letter."""

from __future__ import annotations

from collections.abc import Mapping

# The style sheet gives the classes their size and distance (templates/notes.css).
CLASSES: Mapping[str, str] = {"→": "arrow-accent", "˙": "dot-accent", "¨": "dot-accent"}


def accented(mathml: str) -> str:
    """The MathML with a class on each accent that browsers draw too large or too low."""
    for sign, name in CLASSES.items():
        plain = f'<mo stretchy="false">{sign}</mo></mover>'
        mathml = mathml.replace(plain, f'<mo stretchy="false" class="{name}">{sign}</mo></mover>')
    return mathml
