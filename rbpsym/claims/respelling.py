"""Changes of the text of a formula that can't be read, at the place where it could not, the likeliest first."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from difflib import SequenceMatcher
from itertools import pairwise

from rbpsym.errors import Incomplete, RbpsymError, UnknownName

MOST_SPELLED, NEAR = 24, 3  # names that are tried; tokens around the place that are changed
SPELLED = (r"\sin", r"\cos", r"\tan", r"\frac", r"\dot", r"\ddot", r"\sqrt", r"\left", r"\right", r"\pi", r"\partial")
_MARKS = re.compile(r"(?:\s*[\^_]\s*(?:\{[^{}]*\}|\\?\w))*")  # what stands above and below a name
_HEAD = re.compile(r"\\[A-Za-z]+\s*(?:\^\s*(?:\w|\{[^{}]*\})\s*)?\{?")
_TOKEN = re.compile(r"\\(?:[A-Za-z]+|\W)|\S")
Change = tuple[str, str]  # the text of the formula, and what was changed in words


def respellings(latex: str, error: RbpsymError, names: Iterable[str]) -> Iterator[Change]:
    """Another name where one is unknown; a name where one is lost; two tokens exchanged, or one left out."""
    if error.place is None:
        return
    lines = latex.split("\n")[: error.place.line - 1]
    begin = min(sum(len(line) + 1 for line in lines) + error.place.column - 1, len(latex))
    if isinstance(error, Incomplete):
        yield from _lost(latex, begin, names)
    elif isinstance(error, UnknownName):
        yield from _misspelt(latex, begin, begin + error.place.width, names)
    yield from _mistyped(latex, begin)
    yield from equated(latex)


def equated(latex: str) -> Iterator[Change]:
    """A plus or minus where an equals sign stands."""
    for found in reversed([*re.finditer("=", latex)]):
        for sign in "+-":
            yield f"{latex[: found.start()]}{sign}{latex[found.end() :]}", f"{sign} in place of ="


def _misspelt(latex: str, begin: int, end: int, names: Iterable[str]) -> Iterator[Change]:
    marks = _MARKS.match(latex, end)
    ends = {False: end, True: marks.end() if marks else end}  # a name may have marks above it
    alike = sorted((*names, *SPELLED), key=lambda name: -SequenceMatcher(None, name, latex[begin : ends["^" in name]]).ratio())
    for name in (*alike[:MOST_SPELLED], ""):
        wrong = latex[begin : ends["^" in name]]
        words = f"{name} in place of {wrong}" if name else f"{wrong} is too much"
        yield _put(latex, begin, begin + len(wrong), name), words


def _lost(latex: str, begin: int, names: Iterable[str]) -> Iterator[Change]:
    """In a command, or behind what stands before, perhaps in the row above; of a name with a subscript, perhaps a part alone."""
    head = _HEAD.match(latex, begin)
    begin -= latex[:begin].endswith("{}")  # an empty group is passed over
    begin = head.end() if head else len(re.sub(r"(?:\s|&|\\\\)+\Z", "", latex[:begin]))
    for name in [*sorted(names, key=len), *SPELLED][:MOST_SPELLED]:
        base, sign, label = name.partition("_")
        told = label if sign and latex[:begin].endswith(f"{base}_") else name
        told = base if sign and latex[begin:].lstrip().startswith(f"_{label}") else told
        yield _put(latex, begin, begin, told), f"{name} is missing"


def _put(latex: str, begin: int, end: int, name: str) -> str:
    apart = latex[end : end + 1].isalpha() and name[-1:].isalpha()
    return f"{latex[:begin]}{name}{' ' * apart}{latex[end:]}"


def _mistyped(latex: str, place: int) -> Iterator[Change]:
    """One token that stands twice; a sign or a square that is lost; two exchanged; one that is too much, near a place."""
    tokens = [found.span() for found in _TOKEN.finditer(latex)]
    at = next((k for k, (_, end) in enumerate(tokens) if end > place), len(tokens))
    near = tokens[max(at - NEAR, 0) : at + NEAR - 1]
    pairs = [(*one, *other) for one, other in pairwise(near)][::-1]
    for start, middle, other, end in pairs:
        if latex[start:middle] == latex[other:end]:
            yield latex[:other] + latex[end:], f"{latex[other:end]} is printed twice"
        if latex[start:middle] == "^":
            yield f"{latex[:middle]}2{latex[middle:]}", "2 is missing"
            yield latex[:start] + latex[end:], f"{latex[start:end]} is too much"
    for sign in "+-":
        yield f"{latex[:place]} {sign} {latex[place:]}", f"{sign} is missing"
    for start, middle, other, end in pairs:
        first, second = latex[start:middle], latex[other:end]
        yield f"{latex[:start]}{second}{latex[middle:other]}{first}{latex[end:]}", f"{second} before {first}"
    for start, end in reversed(near):
        yield latex[:start] + latex[end:], f"{latex[start:end]} is too much"
