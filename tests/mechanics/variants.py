"""Rewriting the shipped problems: other names, other sides, other angles, other coordinates."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from rbpsym.field.calculus import substitute
from rbpsym.field.normal import same
from rbpsym.field.scalar import Scalar, symbol
from rbpsym.statement.library import problem_files
from tests.mechanics.textbook import answer, read

UNTOUCHED = ("shape", "type", "title", "source", "level", "topic", "meaning")

RELATION = re.compile(" (?:>|>=|!=) 0$")


def shipped(name: str) -> str:
    """The text of a shipped problem, without its examples (the names of which a variant may change)."""
    text = problem_files()[name].read_text(encoding="utf-8")
    return text.split("[meanings.es]")[0]


def edited(text: str, *changes: tuple[str, str]) -> str:
    """The text with each passage replaced; every one must occur."""
    for old, new in changes:
        assert re.search(old, text, re.M), old
        text = re.sub(old, lambda _, new=new: new, text, flags=re.M)
    return text


def renamed(text: str, names: Mapping[str, str]) -> str:
    """Every name of the problem replaced wherever it is used."""
    pattern = re.compile(r"\b(" + "|".join(sorted(names, key=len, reverse=True)) + r")(?=\b|_dot\b|_ddot\b)")
    lines = []
    for line in re.sub(r"\s*#.*", "", text).splitlines():
        if line.startswith(UNTOUCHED):
            lines.append(line)
        elif '= "' in line and ": " in line:  # a parameter: its dimension stays
            key, rest = line.split("=", 1)
            lines.append(pattern.sub(lambda m: names[m[1]], key) + "=" + rest)
        else:
            lines.append(pattern.sub(lambda m: names[m[1]], line))
    return "\n".join(lines)

WORDS = ("complete", "reason", "stability", "state")


def values(found: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], str]]:
    """All expressions of an answer with their places."""
    if isinstance(found, dict):
        for key, part in found.items():
            yield from values(part, (*path, key))
    elif isinstance(found, list):
        for k, part in enumerate(found):
            yield from values(part, (*path, str(k)))
    elif isinstance(found, str) and path[0] != "conditions_complete" and path[-1] not in WORDS:
        yield path, RELATION.split(found)[0]


def image(text: str, expression: str, images: Mapping[str, Scalar]) -> Scalar:
    """An expression of the original, in the terms of the variant."""
    return substitute(read(text, expression), images)


def changed(
    original: str, variant: str, images: Mapping[str, Scalar], paths: Mapping[str, tuple[str, int]]
) -> list[str]:
    """Results that are not what the original's become.

    `paths`: of the original's result, that of the variant's and the sign between them.
    """
    wrong = []
    for path, (other, sign) in paths.items():
        before, after = _at(answer(original), path), _at(answer(variant), other)
        if before is None and after is None:
            continue
        if not same(image(original, before, images) * sign, read(variant, after)):
            wrong.append(f"{path}: {before} became {after}")
    return wrong


def _at(found: Any, path: str) -> str | None:
    for key in path.split("/"):
        found = found[int(key)] if isinstance(found, list) else found[key]
    return found


def names_as_scalars(names: Mapping[str, str], unknowns: Mapping[str, str]) -> dict[str, Scalar]:
    """Images of all symbols under a renaming."""
    images = {**names, **unknowns} | {f"{a}_dot": f"{b}_dot" for a, b in names.items()}
    return {a: symbol(b) for a, b in images.items()}
