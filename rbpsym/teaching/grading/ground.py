"""What holds where an answer is judged: meanings, assumptions, dimensions, the motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from types import MappingProxyType

from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.decide.signs import SYMBOL_SIGNS
from rbpsym.errors import RbpsymError
from rbpsym.expr.glyphs import Notation, glyph, renamed
from rbpsym.expr.letters import without_accents
from rbpsym.expr.symbol_table import SymbolTable, drawn_glyph, symbol_table
from rbpsym.field import BARE, Meanings, Scalar, names_in
from rbpsym.field.exponentials import with_squares
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.study import Study
from rbpsym.quantities import LENGTH, MASS, TIME, Dimension
from rbpsym.statement.checks import dimensions_with_unknowns
from rbpsym.teaching.grading.intervals import Sampling

# --- how the quantities of a problem may be typed in an answer: θ, theta, \theta, θ', theta_dot, ω


TWINS = (("phi", "varphi"), ("theta", "vartheta"), ("epsilon", "varepsilon"), ("rho", "varrho"),
         ("lambda", "lamda"))  # fmt: skip
ELLS = ("ell", "l", "L")


class Book(Frozen):
    """The names of a problem and other ways to type them; `table` for the LaTeX reader.

    A way to type that could mean two names is left out, and so is one that is a name itself.
    `language` decides what a comma in a number means: “es” always a decimal comma.
    """

    names: frozenset[str]
    typed: Mapping[str, str]
    table: SymbolTable
    language: str = "en"

    def named(self, word: str) -> str | None:
        """The name that is typed so, None if there is none."""
        return word if word in self.names else self.typed.get(word)


def book(
    names: Iterable[str], notation: Mapping[str, str] | None = None, language: str = "en", called: Mapping[str, str] | None = None
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


# ---


class GradingGround(Frozen):
    """Meanings of names (`scope`), assumptions, dimensions, and how names may be typed (`book`).

    on_motion: replaces accelerations and unknown forces by what they are; along: squares of the speeds too.
    """

    book: Book
    assumptions: Assumptions = NONE
    scope: Meanings = BARE
    dimensions: Mapping[str, Dimension] = field(default_factory=dict)
    on_motion: Callable[[Scalar], Scalar] = lambda value: value
    along: Callable[[Scalar], Scalar] = lambda value: value
    has_motion: bool = False

    @cached_property
    def sampling(self) -> Sampling:
        """Points at which formulas are compared."""
        return Sampling(self.assumptions, self.scope)


def bare_ground(symbols: Iterable[str] | Mapping[str, str], language: str = "en") -> GradingGround:
    """The ground of some names alone, with their signs (“positive”, “nonnegative”, “nonzero”, “real”)."""
    signs = dict(symbols) if isinstance(symbols, Mapping) else {}
    if unknown := sorted({*signs.values()} - {*SYMBOL_SIGNS}):
        raise RbpsymError(f"“{unknown[0]}” is no sign", instead=f"write one of {', '.join(SYMBOL_SIGNS)}.")
    return GradingGround(book(symbols, _rates_named(frozenset(symbols)), language), Assumptions(signs))


_ANGLES = ("theta", "phi", "varphi", "vartheta", "psi", "beta", "alpha", "gamma")


def _rates_named(names: frozenset[str]) -> dict[str, str]:
    """ω for the rate of the only angle that has one, if there is no other ω."""
    rates = [f"{name}_dot" for name in _ANGLES if f"{name}_dot" in names]
    return {rates[0]: "omega"} if len(rates) == 1 and "omega" not in names else {}


def ground_of(study: Study, language: str = "en") -> GradingGround:
    """The ground of a problem: its names, on its constraints."""
    problem, system = study.problem, study.system
    named = named_quantities(study)
    dimensions = {**dimensions_with_unknowns(problem), **{name: _NAMED[name.partition("_")[0]] for name in named}}
    names = {*dimensions, *named, *system.unknowns}
    scalars = {**named, **system.tied()}
    return GradingGround(
        book(names, {**_along_a_line(study), **problem.notation}, language, problem.names_in(language)),
        study.assumptions,
        system.scope.with_scalars({**system.scope.scalars, **scalars}),
        dimensions,
        study.on_motion,
        lambda value: with_squares(study.on_motion(value), study.squares),
        True,
    )


def _along_a_line(study: Study) -> dict[str, str]:
    """v and a of the only coordinate, if that goes along a line."""
    names = study.system.independent
    if len(names) != 1 or study.problem.dimensions[names[0]] != LENGTH:
        return {}
    rates = {f"{names[0]}_dot": "v", f"{names[0]}_ddot": "a"}
    return {rate: letter for rate, letter in rates.items() if letter not in study.problem.dimensions}


_NAMED = {"I": MASS * LENGTH**2, "omega": TIME**-1, "alpha": TIME**-2}


def named_quantities(study: Study) -> dict[str, Scalar]:
    """Quantities that a student may name without being told: I of each body, of the only one also about the fixed points
    from which it keeps its distance; ω and α of the only turning one."""
    bodies = study.system.bodies
    taken = {q.name for q in study.problem.parameters} | set(study.problem.notation.values())
    found = {f"I_{name}": state.moment for name, state in bodies.items()}
    found |= {f"omega_{name}": state.omega for name, state in bodies.items() if state.omega}
    found |= {f"alpha_{name}": state.alpha for name, state in bodies.items() if state.alpha}
    moments = [state.moment for state in bodies.values() if state.moment]
    found |= {"I": moments[0]} if len(moments) == 1 else {}
    turning = {state.omega for state in bodies.values() if state.omega}
    if len(bodies) == 1:
        [state] = bodies.values()
        found |= dict.fromkeys(("I", "I_cm"), state.moment)
        squares = {name: (away := state.center - place).dot(away) for name, place in study.origins.items()}
        kept = {name: square for name, square in squares.items() if not names_in(square) & {*study.system.coordinates}}
        found |= {f"I_{name}": state.moment + state.mass * square for name, square in kept.items()}
    if len(turning) == 1:
        state = next(state for state in bodies.values() if state.omega)
        found |= {"omega": state.omega, "alpha": state.alpha}
    return {name: value for name, value in found.items() if name not in taken and value is not None}
