"""The symbols that a LaTeX formula may contain: drawn form -> name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from rbpsym.notation.glyphs import DEFAULT, Glyph, Notation, glyph
from rbpsym.notation.latex_tokens import Token, tokenize
from rbpsym.notation.source import Source
from rbpsym.notation.tree import Node


@dataclass(frozen=True, slots=True)
class Drawn:
    """What a reader sees of a name; subscripts are one label without commas and braces."""

    base: str
    script: bool = False
    accent: str = ""
    dots: int = 0
    primes: int = 0
    label: str = ""
    prefix: str = ""


@dataclass(frozen=True, slots=True)
class SymbolTable:
    """Names by their drawn form, and names by a row of tokens (`spellings`).

    `faults` counts where the dimensions of a formula do not fit; by it a reader chooses between two readings
    (None: it refuses what can be read in two ways). `varies` says whether a name is no constant, and so may be a
    function: in x(t), V(θ) (None: nothing is known). `comma`: in 1{,}470 it is declared to be the decimal mark.
    """

    names: Mapping[Drawn, tuple[str, ...]]
    spellings: Mapping[tuple[str, ...], str] = field(default_factory=lambda: MappingProxyType({}))
    faults: Callable[[Node], int] | None = None
    varies: Callable[[str], bool] | None = None
    comma: bool = False

    @property
    def has_d(self) -> bool:
        """Is a plain d a symbol, so that only an upright d is a differential?"""
        return any(drawn.base == "d" for drawn in self.names)

    @property
    def has_e(self) -> bool:
        """Is e a symbol, so that it is not the base of the exponential function?"""
        return any(drawn.base == "e" for drawn in self.names) or any("e" in row[:1] for row in self.spellings)

    def draws_prefix(self, drawn: Drawn) -> bool:
        """Is Δ before `drawn` part of a name?"""
        return replace(drawn, prefix="Δ") in self.names


def equally(node: Node) -> int:
    """Faults that prefer no reading: for one who wants to see them all."""
    return 0


def drawn_glyph(drawing: Glyph) -> Drawn:
    """What a reader sees of a glyph."""
    label = "".join(_label(sub) for sub in drawing.subs)
    return Drawn(
        drawing.base, drawing.style == "script", drawing.accent, drawing.dots, drawing.primes,
        label, drawing.prefix,
    )  # fmt: skip


def _label(sub: Glyph) -> str:
    return sub.base + "".join(_label(part) for part in sub.subs) + "'" * sub.primes


def symbol_table(
    names: Iterable[str] | Mapping[str, str],
    notation: Notation = DEFAULT,
    spellings: Mapping[str, str] = MappingProxyType({}),
    faults: Callable[[Node], int] | None = None,
) -> SymbolTable:
    """The table of some names as `notation` draws them; `pi` is always known.

    `spellings` adds other LaTeX for a name, read exactly as written (spaces apart):
    `{r"\\mathcal{W}^{nc}_T": "W_T_nc"}`; `faults` is that of the table. A mapping in place of `names` gives only spellings.
    Raises ReadError if a spelling can't be split into tokens.
    """
    if isinstance(names, Mapping):
        names, spellings = tuple(names.values()), {**names, **spellings}
    found: dict[Drawn, tuple[str, ...]] = {}
    for name in dict.fromkeys((*names, "pi")):
        for drawing in dict.fromkeys((notation.glyph(name), glyph(name))):
            _enter(found, drawn_glyph(drawing), name, notation.aliases)
    spelled = {spelling(tokenize(Source(latex))[:-1]): name for latex, name in spellings.items()}
    return SymbolTable(MappingProxyType(found), MappingProxyType(spelled), faults, comma=notation.decimal == ",")


def _enter(found: dict[Drawn, tuple[str, ...]], drawn: Drawn, name: str, aliases: Mapping[str, str]) -> None:
    """Enter a name; the own print of a name that has an alias gives way to others."""
    others = found.get(drawn, ())
    if name in others or (others and name in aliases and drawn != drawn_glyph(glyph(aliases[name]))):
        return
    found[drawn] = (*others, name)


def spelling(tokens: Iterable[Token]) -> tuple[str, ...]:
    """The tokens as they are compared, without needless braces around one token."""
    texts = [token.text for token in tokens]
    kept: list[str] = []
    while texts:
        single = texts[0] == "{" and len(texts) > 2 and texts[2] == "}"
        kept.append(texts[1] if single else texts[0])
        texts = texts[3:] if single else texts[1:]
    return tuple(kept)
