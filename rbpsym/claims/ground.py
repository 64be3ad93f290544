"""The ground on which formulas are read and decided: printed symbols with names and values, a motion, how deep one looks."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from functools import lru_cache
from types import MappingProxyType

from rbpsym.claims.model import Meaning, Setting
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.constants import is_algebraic
from rbpsym.decide.equal import PLAIN, cross_difference, scalars_equal
from rbpsym.decide.points import all_atoms
from rbpsym.errors import RbpsymError, ReadError, StatementError, Undecided
from rbpsym.expr.latex.names import drawn_name
from rbpsym.expr.latex.tokens import tokenize
from rbpsym.expr.letters import NAME_OF_LETTER
from rbpsym.expr.source import SourceText
from rbpsym.expr.symbol_table import Drawn, SymbolTable, spelling
from rbpsym.field import ONE, Meanings, Space, atoms, depends_on, is_zero, kept, substitute, time_derivative
from rbpsym.field.exponentials import with_squares
from rbpsym.field.scalar import NOTHING, UNITY, Scalar, symbol
from rbpsym.frozen import Frozen, field, replace
from rbpsym.quantity.bound import Bound, Motion, World


class Glossary(Frozen):
    """The table for the reader, and for each printed symbol (its name, has it an arrow?)."""

    table: SymbolTable
    names: Mapping[str, tuple[str, bool]]


CLOCK = "time"  # what t means where nothing else is called so: the time since the start


def with_own_symbols(setting: Setting, world: World) -> Setting:
    """The setting with the problem's own names as they are printed, where it gives them no other meaning; and the time."""
    taken = {found[0] for latex in setting.symbols if (found := _drawn(latex))}
    known = world.symbols if setting.theory or setting.phase else {"t": CLOCK, **world.symbols}
    own = {latex: Meaning(name) for latex, name in known.items() if _is_free(latex, taken)}
    return replace(setting, symbols={**own, **setting.symbols}) if own else setting


def _is_free(latex: str, taken: set[Drawn]) -> bool:
    found = _drawn(latex)
    return found is not None and found[0] not in taken


def glossary(symbols: Mapping[str, Meaning]) -> Glossary:
    """The glossary of printed symbols. Raises ReadError for one that is no symbol."""
    return _glossary(tuple(symbols.items()))


Entered = dict[tuple[str, bool], tuple[Drawn | str, str, Meaning]]  # how each symbol is drawn and printed, what it means


@lru_cache(maxsize=256)
def _glossary(symbols: tuple[tuple[str, Meaning], ...]) -> Glossary:
    drawn: dict[Drawn, tuple[str, ...]] = {Drawn("π"): ("pi",)}
    spelled: dict[tuple[str, ...], str] = {}
    names: dict[str, tuple[str, bool]] = {}
    shown: Entered = {}
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


def _enter_once(shown: Entered, named: tuple[str, bool], drawing: Drawn | str, latex: str, meaning: Meaning) -> None:
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
        return spelling(tokenize(SourceText(latex))[:-1])
    except ReadError as error:
        raise ReadError(f"“{latex}” is not a symbol: {error.what}", place=meaning.place) from None


def name_of(drawn: Drawn) -> str:
    """The name that draws so: R_cm, cal_W_T, I_O_prime, v_prime, Delta_x."""
    base = NAME_OF_LETTER.get(drawn.base, drawn.base)
    parts = [*(["cal"] if drawn.script else []), base]
    parts += {1: ["dot"], 2: ["ddot"], 3: ["dddot"]}.get(drawn.dots, [])
    parts += [drawn.accent] * bool(drawn.accent) + ["prime"] * drawn.primes + _label_parts(drawn.label)
    return "_".join([*filter(None, [{"Δ": "Delta", "Σ": "sum"}.get(drawn.prefix)]), *parts])


_MARKS = {
    "'": "prime", "+": "plus", "-": "minus", "*": "star", "^": "_", "(": "of", "/": "per", "=": "is", ";": "semicolon",
    ",": "comma", "|": "bar", "<": "below", ">": "above",
}  # fmt: skip


def _label_parts(label: str) -> list[str]:
    label = re.sub(r"(?<![^_^])([A-Z])'", r"\1_'", label.replace("^'", "'"))  # I_{O'}
    label = re.sub(r"\^(?=\d)", "_sup", label)  # x^1 beside x_1
    plain = "".join(NAME_OF_LETTER.get(char, char) if not char.isascii() else _MARKS.get(char, char) for char in label)
    return [part for part in re.sub(r"[^\w]", "", plain).split("_") if part]


def _spelled_name(latex: str) -> str:
    """A name for what no name draws, such as W^{nc}_T."""
    for said, plain in (r"\vec", ""), (r"\mathcal", "cal "), (r"\mathpzc", "cal "), ("(", " of "):
        latex = latex.replace(said, plain)
    words = re.findall(r"[A-Za-z0-9]+|'", latex)
    return "_".join("prime" if word == "'" else word for word in words) or "symbol"


class Ground(Frozen):
    """Names of printed symbols with their bounds; what is defined on the way is kept in `defined`."""

    world: World
    glossary: Glossary
    bounds: Mapping[tuple[str, bool], Bound] = field(default_factory=dict)
    defined: dict[str, Scalar | Space] = field(default_factory=dict)
    premises: Mapping[str, Scalar] = field(default_factory=dict)
    assumed: Assumptions | None = None
    small: tuple[str, ...] = ()  # what ≈ takes for small, where that is said

    @kept
    def motion(self) -> Motion:
        """What is true of the motion, what is given and assumed included."""
        motion = self.world.motion
        if any(found.told == CLOCK for found in self.bounds.values()) and "t" not in motion.scope.rates:
            rates, start = {**motion.scope.rates, "t": UNITY}, {**motion.scope.start, "t": NOTHING}
            motion = replace(motion, scope=replace(motion.scope, rates=rates, start=start))
        if self.assumed is not None:
            motion = replace(motion, assumptions=self.assumed)
        if not self.premises:
            return motion
        return replace(motion, moved=lambda value: substitute(motion.moved(value), self.premises))

    def kind(self, name: str) -> str:
        """What kind of meaning a scalar or vector name has ("value" for a name that is defined by now)."""
        if name in self.defined:
            return "value"
        found = self.bounds.get((name, False)) or self.bounds.get((name, True))
        return found.kind if found else "unknown"

    def bound(self, name: str) -> Bound | None:
        """The bound of a name, with or without an arrow."""
        return self.bounds.get((name, True)) or self.bounds.get((name, False))

    @property
    def scope(self) -> Meanings:
        """The scope in which trees are evaluated, with the ledger of works among the rates."""
        base, ledger = self.motion.scope, self.motion.ledger
        scalars, vectors = self._values()
        start = {**base.start, **{name: Scalar(ONE) * 0 for name in ledger}}
        return replace(base, scalars=scalars, vectors=vectors, rates={**base.rates, **ledger}, start=start)

    def _values(self) -> tuple[dict[str, Scalar], dict[str, Space]]:
        scalars: dict[str, Scalar] = {}
        vectors: dict[str, Space] = {}
        for (name, arrow), found in sorted(self.bounds.items(), key=lambda item: item[0][1], reverse=True):
            _enter(scalars, vectors, name, arrow, found)
        vectors |= {name: value for name, value in self.defined.items() if isinstance(value, Space)}
        return scalars | {name: value for name, value in self.defined.items() if isinstance(value, Scalar)}, vectors

    def generator(self, name: str) -> str | None:
        """The generator that a printed symbol stands for, None if it is something composed."""
        found = self.scope.scalars.get(name)
        if found is None:
            return name
        terms = found.num.terms
        if found.den is ONE and len(terms) == 1 and list(terms.values()) == [1]:
            [monomial] = terms
            if len(monomial) == 1 and monomial[0][1] == 1:
                return atoms.symbol_name(monomial[0][0])
        return None


def _enter(scalars: dict[str, Scalar], vectors: dict[str, Space], name: str, arrow: bool, found: Bound) -> None:
    """An arrow's own meaning comes first for the vector, the plain symbol's for the scalar."""
    if found.kind in ("constant", "unknown", "defined here"):
        scalars[name] = symbol(f"{name} ")
        return
    if found.scalar is not None and (not arrow or name not in scalars):
        scalars[name] = found.scalar
    if found.vector is not None and (arrow or name not in vectors):
        vectors[name] = found.vector
    for k, value in enumerate(found.points):
        vectors[f"{name}#{k}"] = value
    if found.density is not None:
        vectors[f"{name}/dm"] = found.density


_CLOCK = Bound(symbol("t"), told=CLOCK)


def grounded(setting: Setting, words: Glossary, world: World, names: Collection[str]) -> Ground:
    """The ground of formulas with some names. Raises StatementError at the phrase that means nothing."""
    bounds: dict[tuple[str, bool], Bound] = {}
    for latex, meaning in setting.symbols.items():
        if words.names[latex][0] not in names:
            continue
        try:
            bounds[words.names[latex]] = world.bound(meaning.phrase) if meaning.phrase != CLOCK else _CLOCK
        except RbpsymError as error:
            raise StatementError(f"the meaning of {latex}: {error.what}", instead=error.instead, place=meaning.place) from None
    return Ground(world, words, bounds)


DEPTHS = ("identity", "motion", "start")
HOW = {
    "identity": "identity", "motion": "on the motion", "start": "along the motion from the start",
    "sense": "along the motion from the start until it first comes to rest", "rates": "equal at the start and in rate",
    "growth": "so at the start, and its rate keeps it so", "constant": "its rate vanishes on the motion",
}  # fmt: skip


class EqualityQuestion(Frozen):
    """Two values, and how deep one may look for their equality."""

    ground: Ground
    depth: str = ""
    witnesses: bool = True

    @property
    def motion(self) -> Motion:
        """What is true of the motion."""
        return self.ground.motion

    @property
    def depths(self) -> tuple[str, ...]:
        """The depths that may be tried, from the strongest claim to the weakest."""
        return DEPTHS[: DEPTHS.index(self.depth) + 1] if self.depth else DEPTHS

    def seen(self, found: Scalar, depth: str) -> Scalar:
        """A value at some depth."""
        if depth == "identity":
            return found
        found = self.motion.moved(found)
        return with_squares(found, self.motion.squares) if depth == "start" else found

    def rate(self, found: Scalar, depth: str = "motion") -> Scalar:
        """d/dt, works and integrals included. Raises Undecided where it is not known (an unknown force's, say)."""
        if depth == "identity" and self.motion.is_lawless(found):
            raise Undecided("it is not known how this changes with time")
        return time_derivative(self.motion.settled(found), self.ground.scope)

    def begin(self, found: Scalar) -> Scalar:
        """The value in the start state."""
        return substitute(self.motion.moved(found), self.ground.scope.start)


def are_same(a: Scalar, b: Scalar, question: EqualityQuestion) -> bool:
    """Whether equality is PROVED; no witness is looked for where the normal form says no."""
    gap = cross_difference(a, b)
    if not is_zero(gap) and _is_plain(gap):
        return False
    return scalars_equal(a, b, question.motion.assumptions).is_proved


def _is_plain(value: Scalar) -> bool:
    """Is the normal form that of a field, in which only 0 is zero?"""
    return all(atoms.atom(index).kind in PLAIN and not is_algebraic(index) for index in all_atoms([value]))


def tells_of_start(value: Scalar, question: EqualityQuestion) -> bool:
    """Does it hold start values, works or integrals from the start?"""
    names = (*question.motion.starts, *question.motion.ledger)
    return any(depends_on(value, name) for name in names)


def holds_unknowns(value: Scalar, question: EqualityQuestion) -> bool:
    """Does it hold unknown forces or accelerations?"""
    return any(depends_on(value, name) for name in question.motion.unsettled)
