"""Plain text as each format writes it, so that no character of it is taken as a command."""

from __future__ import annotations

import json
import re
from unicodedata import category, normalize

LATEX = str.maketrans({
    "\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_",
    "{": r"\{", "}": r"\}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}", "`": r"\textasciigrave{}",
    "“": "``", "”": "''", "–": "--", "—": "---", "…": r"\dots{}", "−": "$-$",
    "\u00a0": "~", '"': r"\textquotedbl{}",
})  # fmt: skip
TYPST = re.compile(r"([\\#*_`$@<>\[\]~=+/'\"-])")
TYPST_ENUMERATION = re.compile(r"^(\d+)\.")
MARKDOWN = re.compile(r"([\\`*_{}\[\]<>#|~$])")


CONTROLS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff]")
APOSTROPHE = re.compile(r"(?<=\w)'(?=\w|\s|$)")


def typographic(text: str) -> str:
    """The text with the apostrophes of print."""
    return APOSTROPHE.sub("’", text)


def without_controls(text: str) -> str:
    """The text without characters that no page shows."""
    return CONTROLS.sub("", text)


def latex_text(text: str) -> str:
    """For LaTeX (T1 encoding); letters stay as they are."""
    return normalize("NFC", without_controls(text)).translate(LATEX)


def typst_text(text: str) -> str:
    """For Typst markup; a number with a point at the start would begin a list."""
    return TYPST_ENUMERATION.sub(r"\1\.", TYPST.sub(r"\\\1", typographic(without_controls(text))))


def typst_string(text: str) -> str:
    """A Typst string with its quotes."""
    return json.dumps(without_controls(text), ensure_ascii=False)


def markdown_text(text: str) -> str:
    """For Markdown as GitHub reads it."""
    return MARKDOWN.sub(r"\\\1", typographic(text)).replace("&", "&amp;")


# --- how wide a text is in a terminal: an accent stands above its letter and takes no column


def columns(text: str) -> int:
    """The number of columns that a text takes."""
    return sum(category(char) not in ("Mn", "Me") for char in text)


def padded(text: str, width: int) -> str:
    """The text, filled with spaces to a width."""
    return text + " " * (width - columns(text))
