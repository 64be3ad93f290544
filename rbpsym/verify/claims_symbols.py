"""Printed symbols of a claims file -> a table for the LaTeX reader, with a name for each of them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from types import MappingProxyType

from rbpsym.errors import ReadError
from rbpsym.notation.latex_names import drawn_name
from rbpsym.notation.latex_tokens import tokenize
from rbpsym.notation.letters import NAME_OF_LETTER
from rbpsym.notation.source import Source
from rbpsym.notation.symbol_table import Drawn, SymbolTable, spelling
from rbpsym.verify.claims_bound import World
from rbpsym.verify.claims_model import Meaning, Setting


@dataclass(frozen=True, slots=True)
class Glossary:
    """The table for the reader, and for each printed symbol (its name, has it an arrow?)."""

    table: SymbolTable
    names: Mapping[str, tuple[str, bool]]


def with_own_symbols(setting: Setting, world: World) -> Setting:
    """The setting with the problem's own names as they are printed, where it gives them no other meaning."""
    taken = {found[0] for latex in setting.symbols if (found := _drawn(latex))}
    own = {latex: Meaning(name) for latex, name in world.symbols.items() if _is_free(latex, taken)}
    return replace(setting, symbols={**own, **setting.symbols}) if own else setting


def _is_free(latex: str, taken: set[Drawn]) -> bool:
    found = _drawn(latex)
    return found is not None and found[0] not in taken


def glossary(symbols: Mapping[str, Meaning]) -> Glossary:
    """The glossary of printed symbols. Raises ReadError for one that is no symbol."""
    return _glossary(tuple(symbols.items()))


@lru_cache(maxsize=256)
def _glossary(symbols: tuple[tuple[str, Meaning], ...]) -> Glossary:
    drawn: dict[Drawn, tuple[str, ...]] = {Drawn("π"): ("pi",)}
    spelled: dict[tuple[str, ...], str] = {}
    names: dict[str, tuple[str, bool]] = {}
    shown: dict[tuple[str, bool], tuple[Drawn | str, str, Meaning]] = {}
    for latex, meaning in symbols:
        found = _drawn(latex)
        if found:
            name = name_of(found[0])
            drawn[found[0]] = (name,)
        else:
            name = _spelled_name(latex)
            spelled[_spelling(latex, meaning)] = name
        names[latex] = (name, found[1] if found else latex.lstrip().startswith(r"\vec"))
        _enter_once(shown, names[latex], found[0] if found else latex, latex, meaning)
    return Glossary(SymbolTable(MappingProxyType(drawn), MappingProxyType(spelled)), names)


def _enter_once(shown: dict, named: tuple[str, bool], drawing: Drawn | str, latex: str, meaning: Meaning) -> None:
    """Enter a printed symbol. Raises ReadError where another one with another meaning has its name."""
    for arrow in (True, False):
        drawn, other, means = shown.get((named[0], arrow), (drawing, latex, meaning))
        alike = arrow != named[1] and (drawn == drawing or isinstance(drawing, str))
        if means != meaning and not alike:
            what = f"“{other}” and “{latex}” would have one name, {named[0]}, but mean different things"
            raise ReadError(what, instead="Print one of them otherwise.", place=meaning.place or means.place)
    shown[named] = (drawing, latex, meaning)


@lru_cache(maxsize=4096)
def _drawn(latex: str) -> tuple[Drawn, bool] | None:
    return drawn_name(latex)


def _spelling(latex: str, meaning: Meaning) -> tuple[str, ...]:
    try:
        return spelling(tokenize(Source(latex))[:-1])
    except ReadError as error:
        raise ReadError(f"“{latex}” is not a symbol: {error.what}", place=meaning.place) from None


def name_of(drawn: Drawn) -> str:
    """The name that draws so: R_cm, cal_W_T, I_O_prime, v_prime, Delta_x."""
    base = NAME_OF_LETTER.get(drawn.base, drawn.base)
    parts = [*(["cal"] if drawn.script else []), base]
    parts += {1: ["dot"], 2: ["ddot"], 3: ["dddot"]}.get(drawn.dots, [])
    parts += [drawn.accent] * bool(drawn.accent) + ["prime"] * drawn.primes + _label_parts(drawn.label)
    return "_".join([*(["Delta"] if drawn.prefix else []), *parts])


def _label_parts(label: str) -> list[str]:
    plain = "".join(NAME_OF_LETTER.get(char, char) if not char.isascii() else char for char in label)
    return [part for part in plain.replace("'", "_prime").split("_") if part]


def _spelled_name(latex: str) -> str:
    """A name for what no name draws, such as W^{nc}_T."""
    for said, plain in (r"\vec", ""), (r"\mathcal", "cal "), (r"\mathpzc", "cal "), ("(", " of "):
        latex = latex.replace(said, plain)
    words = re.findall(r"[A-Za-z0-9]+|'", latex)
    return "_".join("prime" if word == "'" else word for word in words) or "symbol"
