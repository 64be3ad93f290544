"""How the quantities of a problem may be typed in an answer: θ, theta, \\theta, θ', theta_dot, ω."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from rbpsym.notation.glyphs import Notation, glyph, renamed
from rbpsym.notation.letters import without_accents
from rbpsym.notation.symbol_table import SymbolTable, drawn_glyph, symbol_table

TWINS = (("phi", "varphi"), ("theta", "vartheta"), ("epsilon", "varepsilon"), ("rho", "varrho"),
         ("lambda", "lamda"))  # fmt: skip
ELLS = ("ell", "l", "L")


@dataclass(frozen=True)
class Book:
    """The names of a problem and other ways to type them; `table` for the LaTeX reader.

    A way to type that could mean two names is left out, and so is one that is a name itself.
    `language` decides what a comma in a number means: “es” always a decimal comma.
    """

    names: frozenset[str]
    typed: Mapping[str, str] = field(default_factory=dict)
    table: SymbolTable | None = None
    language: str = "en"

    def named(self, word: str) -> str | None:
        """The name that is typed so, None if there is none."""
        return word if word in self.names else self.typed.get(word)


def book(
    names: Iterable[str],
    notation: Mapping[str, str] | None = None,
    language: str = "en",
    called: Mapping[str, str] | None = None,
) -> Book:
    """The book of some names; `notation` draws one name as another (`theta_dot` as `omega`).

    `called` is what bodies are called in the language: where rod is varilla, W_varilla is W_rod.
    """
    known, drawn, called = frozenset(names), dict(notation or {}), dict(called or {})
    found: dict[str, set[str]] = {}
    for name in known:
        rate = drawn.get(name.replace("_ddot", "_dot")) if name.endswith("_ddot") else None
        for way in (*_ways(name, drawn.get(name), called), *((f"{rate}_dot",) if rate else ())):  # ω̇ is θ̈
            found.setdefault(way, set()).add(name)
    typed = {way: min(meant) for way, meant in found.items() if len(meant) == 1 and way not in known}
    return Book(known, MappingProxyType(typed), _table(known, drawn, typed, called), language)


def _ways(name: str, alias: str | None, called: Mapping[str, str]) -> Iterator[str]:
    """Other ways to type one name."""
    own = (name, *([alias] if alias else ()))
    spoken = [word for shown in own if (word := renamed(shown, called)) != shown] if called else []
    for shown in (*own, *spoken, *map(without_accents, spoken)):
        for twin in (shown, *_twins(shown)):
            yield twin
            yield twin.replace("_", "")


def _twins(name: str) -> Iterator[str]:
    """The same letter under another name: phi and varphi; ell, l and L; w for ω; μ for the only μ_k."""
    head, dash, tail = name.partition("_")
    for group in (*TWINS, ELLS):
        if head in group:
            yield from (other + dash + tail for other in group if other != head)
    if head == "omega":
        yield f"w{dash}{tail}"
    if head == "mu" and tail:
        yield head


def _table(
    names: frozenset[str], notation: Mapping[str, str], typed: Mapping[str, str], called: Mapping[str, str]
) -> SymbolTable:
    """The table of the LaTeX reader, with the other ways to type where these are free."""
    own = symbol_table(sorted(names), Notation(MappingProxyType(dict(notation)), names=MappingProxyType(dict(called))))
    others = {drawn_glyph(glyph(way)): (name,) for way, name in sorted(typed.items())}
    for name in sorted(names):
        for primes, rate in ((1, f"{name}_dot"), (2, f"{name}_ddot")):
            if rate in names:
                others[replace(drawn_glyph(glyph(name)), primes=primes)] = (rate,)
    rated = {name.removesuffix(tail) for name in names for tail in ("_dot", "_ddot") if name.endswith(tail)}
    moving = rated | {f"{name}{tail}" for name in rated for tail in ("_dot", "_ddot")}
    return SymbolTable(MappingProxyType({**others, **own.names}), own.spellings, varies=moving.__contains__)
