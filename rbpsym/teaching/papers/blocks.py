"""What worksheets have beyond notes: numbered tasks, options, rules to write on, lines with marks."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.document.model import Inlines
from rbpsym.notation.tree import Node

LETTERS = "abcdefghijklmnopqrstuvwxyz"


@dataclass(frozen=True, slots=True)
class Lead:
    """The beginning of a task: its number, its question, and at the right what it earns."""

    number: str
    inlines: Inlines
    points: str


@dataclass(frozen=True, slots=True)
class Options:
    """Answers to choose from, marked a, b, c; `right` (from 0) is ticked in a key."""

    items: tuple[Inlines, ...]
    right: int | None = None


@dataclass(frozen=True, slots=True)
class Marked:
    """Formulas below each other, each with its mark (a letter or a number) at the left."""

    lines: tuple[tuple[str, Node], ...]


@dataclass(frozen=True, slots=True)
class Rules:
    """Rules to write answers on, each after some words or a formula; `width` in cm."""

    items: tuple[Inlines, ...]
    width: float = 6.0


@dataclass(frozen=True, slots=True)
class Space:
    """Empty paper, in cm."""

    height: float


@dataclass(frozen=True, slots=True)
class Form:
    """A table whose cells are filled in by hand; the cells of a key are filled in already."""

    header: tuple[Inlines, ...]
    rows: tuple[tuple[Inlines, ...], ...]
