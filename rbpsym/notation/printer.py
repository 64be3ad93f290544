"""What all printers of formulas share: the walk over boxes, and what most of them print alike."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.notation import boxes as b
from rbpsym.notation.glyphs import Notation
from rbpsym.notation.layout import layout, layout_rows
from rbpsym.notation.tree import Node, System

# functions that are commands of their own in LaTeX and Typst
COMMANDS = frozenset(["sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "exp", "ln", "lim"])


class Printer:
    """A format of formulas: called with a box, it prints it by the method that has the name of its kind.

    `signs` are those that the format writes in another way.
    """

    mode = "display"
    signs: Mapping[str, str] = {}

    def __call__(self, box: b.Box) -> str:
        """The print of a box."""
        return getattr(self, type(box).__name__.lower())(box)

    def formula(self, node: Node, notation: Notation, aligned: bool) -> str:
        """The print of a formula; a system, or a chain that is to be aligned, in rows."""
        lay = layout_rows if aligned or isinstance(node, System) else layout
        return self(lay(node, notation, self.mode))

    def letter(self, box: b.Letter) -> str:
        """A letter in its style."""
        return getattr(self, f"in_{box.style}")(box.text)

    def operator(self, box: b.Operator) -> str:
        """A sign between what it acts on, or before it."""
        sign = self.signs.get(box.sign, box.sign)
        return sign if box.kind in ("prefix", "mark") else f" {sign} "

    def big(self, box: b.Big) -> str:
        """The sign of an integral or sum."""
        return self.signs.get(box.sign, box.sign)

    def times(self, box: b.Times) -> str:
        """What stands between factors."""
        return ""

    def prime(self, box: b.Prime) -> str:
        """Primes."""
        return "'" * box.count

    def function(self, box: b.Function) -> str:
        """The name of a function."""
        return box.name
