"""Values that show themselves in notebooks: how they look is known on the floor of documents."""

from __future__ import annotations

from importlib import import_module

from rbpsym.frozen import Frozen

LOOKS = "rbpsym.document.looks"


class Shown(Frozen):
    """What Jupyter shows as a page and not as source text."""

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """HTML with MathML, LaTeX and plain text, by media type."""
        found: dict[str, str] = import_module(LOOKS).looks(self)
        return found
