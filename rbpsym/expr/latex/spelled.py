"""What is read as another spelling: of commands, of words between formulas, and characters beyond ASCII, ½ m v², ∂u/∂t, ẋ, 𝑥."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any
from unicodedata import category, decomposition, name, normalize

_MARKS = {"\u0307": r"\dot", "\u0308": r"\ddot", "\u20db": r"\dddot", "\u20d7": r"\vec", "\u0302": r"\hat", "\u0304": r"\bar"}
_ALPHABETS = {"BOLD": r"\boldsymbol", "SCRIPT": r"\mathcal", "FRAKTUR": r"\mathfrak", "DOUBLE-STRUCK": r"\mathbb"}
TYPED = re.compile(r"[^\W\d_][\u0300-\u036f\u20d0-\u20ff]+|[^\x00-\x7f]")


@cache
def tables() -> dict[str, Any]:
    """What is read, as data."""
    return tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))


def commands(kind: str) -> tuple[str, ...]:
    """The commands of a kind."""
    return tuple(tables()["commands"][kind].split())


@cache
def by_command(kind: str) -> dict[str, str]:
    """The kind of a part that has no value, by the command that begins it."""
    return {command: name for name, others in tables()["kinds"][kind].items() for command in others.split()}


@cache
def spelled() -> Mapping[str, str]:
    """The spelling that is read, by each other of the same."""
    return {other: text for text, others in tables()["same"].items() for other in others.split()}


@cache
def words(kind: str) -> frozenset[str]:
    """Words between formulas: those that are `joining` two, and `conditional` ones, behind which stands when a formula holds."""
    return frozenset(tables()["words"][kind])


def as_latex(text: str, start: int) -> tuple[str, int]:
    """(the LaTeX of what is typed there, where that ends); "" where nobody writes it so."""
    found = TYPED.match(text, start)
    char, end = (found[0], found.end()) if found else (text[start], start + 1)
    tag, plain = decomposition(char[0]).partition(">")[0], normalize("NFKC", char)
    written = next((latex for chars, latex in tables()["typed"].items() if char in chars), "")
    if written or category(char[0]) == "Lo":
        return written, end
    if tag in ("<super", "<sub"):
        while end < len(text) and decomposition(text[end]).startswith(tag):
            end += 1
        return f"{'^' if tag == '<super' else '_'}{{{normalize('NFKC', text[start:end])}}}", end
    if tag == "<fraction":
        above, _, below = plain.partition("⁄")
        return rf"\frac{{{above}}}{{{below}}}", end
    if tag == "<font":
        heads = [head for word, head in _ALPHABETS.items() if word in name(char)]
        return f"{''.join(f'{head}{{' for head in heads)}{plain}{'}' * len(heads)}", end
    base, *marks = list(normalize("NFD", char))
    dotted = marks == ["\u0307"] or len(char) > 1  # ü is a letter
    if marks and dotted and _MARKS.keys() >= set(marks):
        return f"{''.join(_MARKS[mark] for mark in reversed(marks))}{{{base}}}", end
    return plain if tag in ("<compat", "<wide") else "", end
