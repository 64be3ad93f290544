"""How a quantity's name is drawn: base letter, dots, primes, accent and subscripts.

`theta_1_dot` is θ̇ with subscript 1, `W_T_N_w` is W with subscripts T and N_w, `cal_W_theta` is a
calligraphic W, `I_bar` is Ī, and `I__bar` is I with the subscript “bar”. Every printer draws the same
`Glyph`, and the LaTeX reader finds names by it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from types import MappingProxyType

from rbpsym.expr.letters import NAME_OF_LETTER, SAME_LETTER, letter_named
from rbpsym.frozen import Frozen, field, replace

ACCENTS = ("hat", "bar", "tilde", "check")
DOTS = MappingProxyType({"dot": 1, "ddot": 2, "dddot": 3})
_POINTLESS = frozenset("TO")  # capitals that label a kind, not a force or point: W_{T,1}
_AXES = frozenset("xyz")
_NOTHING: Mapping[str, str] = MappingProxyType({})


class Glyph(Frozen):
    """A drawn name. `style` is "italic", "upright", "script" or "number"; `subs` are glyphs."""

    base: str
    style: str = "italic"
    dots: int = 0
    primes: int = 0
    accent: str = ""
    subs: tuple[Glyph, ...] = ()
    prefix: str = ""


class Notation(Frozen):
    """How formulas are printed.

    `aliases` draws one name as another (`theta_dot` as `omega`); `vector` is "arrow" or
    "bold"; `decimal` is the decimal mark; `differential` is "italic" or "upright".

    What a language brings: `functions` by what they are called ("sin": "sen"), `names` of bodies and the
    like ("rod": "varilla", so that `W_rod` is drawn as `W_varilla`), `words` in which formulas are spoken.
    """

    aliases: Mapping[str, str] = field(default_factory=lambda: _NOTHING)
    vector: str = "arrow"
    decimal: str = "."
    differential: str = "italic"
    functions: Mapping[str, str] = field(default_factory=lambda: _NOTHING)
    names: Mapping[str, str] = field(default_factory=lambda: _NOTHING)
    words: Mapping[str, str] = field(default_factory=lambda: _NOTHING)

    def __hash__(self) -> int:
        mappings = (self.aliases, self.names, self.functions)
        own = (tuple(sorted(mapping.items())) for mapping in mappings)
        return hash((*own, self.vector, self.decimal, self.differential))

    def glyph(self, name: str) -> Glyph:
        """The glyph of a quantity, after aliases and in the names of the language."""
        drawn = self.aliases.get(name, name)
        return glyph(renamed(drawn, self.names) if self.names else drawn)


def renamed(name: str, names: Mapping[str, str]) -> str:
    """A name with its parts as they are called: W_rod_1 with rod_1 → varilla_1; the longest parts first."""
    for own in sorted((own for own in names if own in name), key=len, reverse=True):
        name = re.sub(rf"(?<![^_]){re.escape(own)}(?![^_])", names[own], name)
    return name


DEFAULT = Notation()
MARKS: Mapping[str, tuple[str, ...]] = MappingProxyType({"vectors": ("arrow", "bold"), "decimal": (".", ",")})


def notation_for(names: Iterable[str], said: Mapping[str, str] | None = None, usual: Notation = DEFAULT) -> Notation:
    """The notation of a problem: its aliases and marks, and an upright dθ if it has a quantity that is drawn as a d.

    `usual` is the notation of the language, for what is not said.
    """
    said = said or {}
    aliases = {key: value for key, value in said.items() if key not in MARKS}
    style = "upright" if any(glyph(aliases.get(n, n)).base == "d" for n in names) else usual.differential
    return replace(
        usual,
        aliases=MappingProxyType(aliases),
        vector=said.get("vectors", usual.vector),
        decimal=said.get("decimal", usual.decimal),
        differential=style,
    )


def spaced(name: str) -> str:
    """A name as words: rod_1 and rod1 are both “rod 1”."""
    return re.sub(r"(?<=[^\W\d_])(?=\d)", " ", name.replace("_", " "))


@lru_cache(maxsize=4096)
def glyph(name: str) -> Glyph:
    """The glyph of a name; any identifier gives a glyph."""
    parts = re.findall(r"(?<=_)_[^_]+|[^_]+", name) or [name]
    script = parts[0] == "cal" and len(parts) > 1 and parts[1] not in DOTS
    parts = parts[1:] if script else parts
    if parts[0] == "Delta" and len(parts) > 1 and parts[1] not in DOTS and parts[1][0].isalpha():  # Delta_x, but not Delta_0
        return replace(glyph("_".join(parts[1:])), prefix="Δ")
    drawn = _with_parts(_base(parts[0]), parts[1:])
    return replace(drawn, style="script") if script else drawn


def _base(part: str) -> Glyph:
    """The glyph of one part: a letter, a letter with digits (x1), a number or an upright word."""
    part = SAME_LETTER.get(part, part)
    letter = letter_named(part) or (part if len(part) == 1 and part.isalpha() else None)
    if letter:
        return Glyph(letter)
    if part.isdigit():
        return Glyph(part, "number")
    indexed = re.fullmatch(r"([^\W\d]+)(\d+)", part)
    if indexed and (letter_named(indexed[1]) or len(indexed[1]) == 1):
        return replace(_base(indexed[1]), subs=(Glyph(indexed[2], "number"),))
    return Glyph(part, "upright")


def _with_parts(base: Glyph, parts: list[str]) -> Glyph:
    """The base with the meanings of the later parts: dots, accents, primes, subscripts."""
    subs: list[Glyph] = list(base.subs)
    labels: list[str] = []
    for part in parts:
        if part[0] == "_":
            _subscript(subs, labels, part[1:])
        elif part in DOTS:
            base = replace(base, dots=base.dots + DOTS[part])
        elif part in ACCENTS:
            base = replace(base, accent=part)
        elif part == "prime":
            base = _primed(base, subs, labels)
        else:
            _subscript(subs, labels, part)
    return replace(base, subs=tuple(subs))


def _primed(base: Glyph, subs: list[Glyph], labels: list[str]) -> Glyph:
    """A prime belongs to the point named last (I_{O'}), else to the base (r')."""
    if labels and len(labels[-1]) == 1 and labels[-1].isupper():
        subs[-1] = replace(subs[-1], primes=subs[-1].primes + 1)
        return base
    return replace(base, primes=base.primes + 1)


def _subscript(subs: list[Glyph], labels: list[str], part: str) -> None:
    """Append a subscript, or nest it in the one before (T, N, w -> T and N_w)."""
    if labels and _nests(labels, part):
        subs[-1] = replace(subs[-1], subs=(*subs[-1].subs, _base(part)))
    else:
        subs.append(_base(part))
    labels.append(part)


def _nests(labels: list[str], part: str) -> bool:
    """Is `part` the subscript of the label before it: of a force or point (N_w, A_1, W_rod, f_N)?"""
    before, is_first = labels[-1], len(labels) == 1
    if before == "f" and (part[0].isupper() or (part.isdigit() and not is_first)):
        return True  # friction at the contact N: f_N; the second of several: f_2
    is_kind = before in _POINTLESS and (is_first or before == "O")  # W_{T,1}, but W_{T,T_1}
    owner = len(before) == 1 and before.isupper() and not is_kind
    return (owner or before == "tau") and not part[0].isupper() and part not in _AXES


def letter_name(char: str) -> str:
    """The name of a letter ("θ" -> "theta"), or the character itself."""
    return NAME_OF_LETTER.get(char, char)
