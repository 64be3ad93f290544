"""Characters that a page can't show: pdflatex has no letters for them, or no font that Typst finds.

The text stays as its author wrote it; only where it is set, a sign is told by its name, and a
letter of another script is a small frame.
"""

from __future__ import annotations

import re
from unicodedata import category, name

from rbpsym.expr.letters import LETTERS

# what inputenc knows with T1 and TS1, as ranges of code points
KNOWN = re.compile(
    "[\\n\\t -~\u00a0-\u0137\u0139-\u017e\u0192\u01cd-\u01d4\u0218-\u021b\u0237\u02c7\u02d8-\u02dd\u1e9e\u200c"
    "\u2010-\u2016\u2018-\u201a\u201c-\u201e\u2020-\u2022\u2030\u2031\u2039-\u203b\u2044\u20ac\u2103\u2116\u2122\u2190-\u2193\ufeff]"
)
UNSEEN = re.compile("[\u0300-\u036f\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufe00-\ufe0f\U000e0000-\U000e01ef]")
SIGNS = {
    "≤": r"\leq", "≥": r"\geq", "≠": r"\neq", "≈": r"\approx", "∞": r"\infty", "√": r"\surd", "∂": r"\partial",
    "∫": r"\int", "∑": r"\sum", "′": r"\prime", "⇒": r"\Rightarrow", "⊥": r"\perp", "∥": r"\parallel",
    "∠": r"\angle", "ω": r"\omega", "ο": "o", "−": "-",
}  # fmt: skip
GREEK = {char: f"\\{command}" for command, char in LETTERS.items() if char not in "ℏ"}
FRAME = r"\framebox[0.65em]{\rule{0pt}{1.1ex}}"


def with_rare_letters(source: str) -> str:
    """A LaTeX source that says in its preamble how each character is set that pdflatex does not know."""
    found = sorted({char for char in source if not KNOWN.match(char)})
    if not found:
        return source
    lines = [r"\providecommand{\texorpdfstring}[2]{#1}", *map(declaration, found)]
    return source.replace("\\begin{document}", "\n".join([*lines, "\\begin{document}"]), 1)


def declaration(char: str) -> str:
    """How TeX sets one character, on the page and in the title of the file."""
    shown = "" if UNSEEN.match(char) else rf"\texorpdfstring{{{tex_of(char)}}}{{?}}"
    return rf"\DeclareUnicodeCharacter{{{ord(char):04X}}}{{{shown}}}"


def tex_of(char: str) -> str:
    """A letter or sign of formulas, the name of a picture, a frame."""
    command = {**GREEK, **SIGNS}.get(char)
    if command:
        return rf"\ensuremath{{{command}}}"
    return told(char) if category(char).startswith("S") else FRAME


def told(char: str) -> str:
    """A character by its name: (rocket)."""
    return f"({name(char, f'U+{ord(char):04X}').lower()})" if not UNSEEN.match(char) else ""


LACKING = re.compile(r'the text `"(.+?)"` could not be displayed')


def written_out(text: str) -> str:
    r"""The characters of a complaint, which writes some as \u{200b}."""
    return re.sub(r"\\u\{([0-9a-f]+)\}", lambda match: chr(int(match[1], 16)), text)


def without_lacking(source: str, complaint: str) -> str | None:
    """A Typst source that tells the characters by name for which its complaint says there is no font; None if none."""
    lacking = {char for found in LACKING.findall(complaint) for char in written_out(found) if not char.isascii()}
    for char in lacking:
        source = source.replace(char, told(char))
    return source if lacking else None
