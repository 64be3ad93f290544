"""The text that is read, with its place in a file: errors with a caret. Shared by the readers."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass

from rbpsym.errors import LimitError, Place, RbpsymError, ReadError


@dataclass(frozen=True, slots=True)
class Source:
    """The text being read and the place in a file where it begins."""

    text: str
    place: Place | None = None

    def at(self, start: int, end: int) -> Place:
        """The place of the characters from `start` to `end`, with a caret under them."""
        width = max(end - start, 1)
        if self.place and self.place.text:
            column = max(self.place.column, 1) + start
            return Place(self.place.file, self.place.line, column, self.place.text, width)
        before = self.text[:start]
        line = before.count("\n")
        column = start - (before.rfind("\n") + 1) + 1
        shown = self.text.split("\n")[line][:200] if column < 200 else ""
        base = self.place or Place()
        return Place(base.file, max(base.line, 1) + line, column, shown, min(width, 200))

    def error(self, what: str, start: int, end: int, instead: str = "") -> RbpsymError:
        """A ReadError with the place of the characters from `start` to `end`."""
        return ReadError(what, instead=instead, place=self.at(start, end))

    def limit(self, what: str, start: int = 0, end: int = 1) -> RbpsymError:
        """A LimitError at a place."""
        return LimitError(what, place=self.at(start, end))


_LIKE = {"‐": "-", "‑": "-", "‒": "-", "—": "-", "―": "-", "⁃": "-", "﹣": "-", "ꞏ": "*", "•": "*", "⸱": "*", "∣": "|"}
_INSTEAD = {
    "°": "Angles are in radians: 30° is pi/6.",
    "{": "Use parentheses.",
    "}": "Use parentheses.",
    "%": "Write a fraction, as in 3/100.",
    "\\": "This looks like LaTeX; write names and signs as on a keyboard: theta, sqrt(x), a/b.",
    "'": "A derivative is written with its name: the speed of theta is theta_dot.",
}


def refused(source: Source, char: str, start: int) -> RbpsymError:
    """The error for a character that can't be read, by its name."""
    code = f"U+{ord(char):04X}"
    name = unicodedata.name(char, "control character").lower()
    if unicodedata.category(char) in ("Cf", "Cc", "Mn", "Co", "Cn"):
        what = f"an invisible character stands here: {name} ({code})"
        return source.error(what, start, start + 1, "Delete it and type the expression again.")
    likeness = unicodedata.normalize("NFKC", char)
    likeness = _LIKE.get(char, likeness)
    hint = f"Type “{likeness}” instead." if likeness != char and likeness.isascii() else _INSTEAD.get(char, "")
    what = f"the character “{char}” ({name}, {code}) can't be read"
    return source.error(what, start, start + 1, hint or "Use plain letters and Greek letters.")
