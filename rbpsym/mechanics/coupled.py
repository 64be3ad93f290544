"""The motion of several coordinates as functions of the time where their accelerations are linear: a sum of normal motions.

q̈ = h(t) - K q with constant K: for each row w with w K = s w, η = w q moves by itself, η̈ = w h - s η. What keeps its momentum
has s = 0. About a place of rest the accelerations are those to first order. Goldstein, Classical Mechanics, 6.3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress

from rbpsym.decide.rooted import neat, root_of
from rbpsym.decide.signs import sign
from rbpsym.errors import NotApplicable, Undecided
from rbpsym.field import (
    NOTHING,
    UNITY,
    Scalar,
    depends_on,
    derivative,
    is_zero,
    names_in,
    short,
    substitute,
    symbol,
    total,
    without_even_roots,
)
from rbpsym.field.integration import definite
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics import solutions
from rbpsym.mechanics.demands import Demand, existence, settle
from rbpsym.mechanics.elimination import Matrix, determinant, solve_linear, solve_matrix
from rbpsym.mechanics.forms import AccelerationForm, driven_form
from rbpsym.mechanics.friction import slips
from rbpsym.mechanics.orbit import swinging
from rbpsym.mechanics.roots import numerator_factors, zeros
from rbpsym.mechanics.solutions import TIME, Given, InTime
from rbpsym.mechanics.solved import time_to
from rbpsym.mechanics.study import Study


class CoupledLinear(Frozen):
    """Accelerations h - K q of coordinates `names`, h functions of the time alone; what is declared or shown of the stiffness
    K: that no mode runs away (`is_stable`)."""

    names: tuple[str, ...]
    stiffness: Matrix
    rest: tuple[Scalar, ...]
    is_stable: bool = False


def exact(study: Study) -> CoupledLinear | None:
    """The accelerations of the coordinates that are linear and hold no other coordinate and no speed; None if there are none."""
    gains = {} if study.at_start or study.ties else study.dynamics.accelerations or {}
    moving = {*study.system.scope.rates, *study.system.speeds} - {"t"}
    names = tuple(name for name in study.system.independent if f"{name}_ddot" in gains)
    while names:
        rows = {n: tuple(short(-derivative(gains[f"{n}_ddot"], other)) for other in names) for n in names}
        rest = {n: short(gains[f"{n}_ddot"] + _sum(rows[n], map(symbol, names))) for n in names}
        kept = tuple(n for n in names if not any(names_in(value) & moving for value in (*rows[n], rest[n])))
        if kept == names:
            return CoupledLinear(names, tuple(rows.values()), tuple(rest.values()))
        names = kept
    return None


def small(study: Study) -> CoupledLinear | None:
    """The accelerations to first order about the one stable place of rest of all coordinates."""
    item, names = swinging(study), study.system.independent
    if item is None or item.linear.is_damped or not {*names} <= item.at.keys():
        return None
    columns = [solve_matrix(item.inertia, column) for column in zip(*item.stiffness, strict=True)]
    stiffness = tuple(zip(*columns, strict=True))
    at = [item.at[name] for name in names]
    return CoupledLinear(tuple(names), stiffness, tuple(short(_sum(row, at)) for row in stiffness), is_stable=True)


def courses(study: Study, law: CoupledLinear | None, solved: Callable[[Given], InTime | None]) -> dict[str, InTime]:
    """Each coordinate as the sum of the normal motions, each `solved`; none where one of them is not known."""
    start = study.system.scope.start
    if law is None or not {*law.names} <= start.keys():
        return {}
    roots = _roots(law, study) or {}
    rows = [(value, row) for value in roots for row in _rows(law.stiffness, value)]
    if len(rows) != len(law.names):
        return {}
    begun = [[start.get(f"{name}{dot}", NOTHING) for name in law.names] for dot in ("", "_dot")]
    modes, count = list[InTime](), len([value for value, _ in rows if value])
    for number, (value, row) in enumerate(rows, 1):
        form = driven_form(AccelerationForm(short(_sum(row, law.rest)), value))
        place, speed = (short(_sum(row, part)) for part in begun)
        mark = f"_{number}" if count > 1 else ""
        if form is None or (mode := solved(known := Given(form, place, speed, study, "", mark=mark))) is None:
            return {}
        modes.append(replace(mode, valid=()) if law.is_stable or roots[value] else mode)
    parts = solve_matrix(tuple(row for _, row in rows), [symbol(f"mode {k}") for k in range(len(rows))])
    found = dict(zip(law.names, (_summed(part, modes) for part in parts), strict=True))
    held = tuple(lasting(known, found)) if slips(study.system) else ()
    return {name: replace(one, valid=(*one.valid, *held)) for name, one in found.items()}


def courses_of(study: Study, manner: str = "") -> dict[str, InTime]:
    """The solution for each coordinate for which there is one, in the case that is named, of `small` oscillations, or
    what is left of it at last (`steady`). Raises NotApplicable where there is none."""
    case = next((case for case in solutions.CASES if case in manner), "")

    def solved(known: Given) -> InTime | None:
        if solutions.STEADY not in manner:
            return solutions.course(known, case)
        return solutions.driven(known) if known.form.drive or (known.form.stiffness and not known.name) else None

    each = {name: solutions.given(study, name, small=solutions.SMALL in manner) for name in study.system.independent}
    found = {name: one for name, known in each.items() if known is not None and (one := solved(known)) is not None}
    if len(found) < len(each) and len(each) > 1:
        law = small(study) if solutions.SMALL in manner else exact(study)
        found = {**courses(study, law, solved), **found}
    if solutions.SMALL not in manner:
        found |= _led(study, found, solved)
    if not found and not manner and len(each) == 1:
        found = {name: one for name in each if (one := _separated(study, name)) is not None}
    if not found and study.system.independent:
        raise NotApplicable("no closed form was found for the motion as a function of the time")
    return found


def _led(study: Study, known: Mapping[str, InTime], solved: Callable[[Given], InTime | None]) -> dict[str, InTime]:
    """The coordinates whose accelerations are functions of the time where those of which the motion is known are put in."""
    at = {name: one.whole for name, one in known.items()} | {f"{name}_dot": one.speed for name, one in known.items()}
    found = dict[str, InTime]()
    for name in [name for name in study.system.independent if name not in known] if known else []:
        with suppress(Undecided):  # an angle that grows by a sum in its denominator has no sine
            if (of := solutions.given(study, name, others=at)) and (one := solved(of)):
                found[name] = one
    return found


def _separated(study: Study, name: str) -> InTime | None:
    """From the speed as a function of the place: what dq over it adds up to is the time, which is solved for the place."""
    given, begin = study.assumptions, study.system.scope.start.get(name, NOTHING)
    way = sign(study.system.scope.start.get(f"{name}_dot", NOTHING), given).sense
    speed = neat(root_of(study.squares[name], given), given) * way if way and name in study.squares else NOTHING
    gone = definite(UNITY / speed, name, begin, symbol(name)) if speed else None
    places = zeros(short(gone - symbol("t")), name) if gone is not None else ()
    begun = [place for place in places if is_zero(neat(substitute(place, {"t": NOTHING}), given) - begin)]
    return InTime(begun[0], valid=tuple(existence(begun[0]))) if len(begun) == 1 else None


def _summed(value: Scalar, modes: list[InTime]) -> InTime:
    """A sum of modes, with what these ask."""
    taking = {f"mode {k}": mode for k, mode in enumerate(modes) if derivative(value, f"mode {k}")}
    place = total(short(derivative(value, name)) * mode.place for name, mode in taking.items())
    letters = {letter: known for mode in taking.values() for letter, known in mode.letters.items()}
    case = solutions.STEADY if all(mode.case == solutions.STEADY for mode in taking.values()) else ""
    return InTime(place, letters, case, tuple(dict.fromkeys(one for mode in taking.values() for one in mode.valid)))


def _roots(law: CoupledLinear, study: Study) -> Mapping[Scalar, bool] | None:
    """The roots s of det(K - s), and whether they are surely positive or zero; None where one has no closed form."""
    letter, size, given = symbol(LETTER), range(len(law.names)), study.assumptions
    whole = determinant(tuple(tuple(law.stiffness[i][j] - letter * (UNITY if i == j else NOTHING) for j in size) for i in size))
    found: dict[Scalar, bool] = {}
    for factor in numerator_factors(whole):
        value = Scalar(factor)
        c, b, a = (short(substitute(part, {LETTER: NOTHING})) for part in _slopes(value))
        if derivative(derivative(derivative(value, LETTER), LETTER), LETTER):
            return None
        if a:
            spread = root_of(short(b * b - a * c * 4), given)
            is_sure = sign(a * c, given).kind == "positive" and sign(-a * b, given).kind == "positive"
            found |= {short((spread * way - b) / a / 2): is_sure for way in (-1, 1)}
        elif b:
            found[short(-c / b)] = not c
    return found


LETTER = "root of modes"  # like “mode 1” and “row 1” it has a blank, so that it is no name of a problem


def _slopes(value: Scalar) -> tuple[Scalar, Scalar, Scalar]:
    first = derivative(value, LETTER)
    return value, first, derivative(first, LETTER) / 2


def _rows(stiffness: Matrix, value: Scalar) -> list[tuple[Scalar, ...]]:
    """All independent rows w with w K = s w."""
    size = range(len(stiffness))
    names = [f"row {k}" for k in size]
    columns = (_sum((stiffness[i][j] - (value if i == j else NOTHING) for i in size), map(symbol, names)) for j in size)
    found = solve_linear([short(column) for column in columns], names, keep_free=True)
    whole = [found.values.get(name, symbol(name)) for name in names]
    chosen = ({other: UNITY if other == name else NOTHING for other in found.free} for name in found.free)
    return [tuple(short(substitute(part, image)) for part in whole) for image in chosen]


def _sum(row: Iterable[Scalar], others: Iterable[Scalar]) -> Scalar:
    return total(a * b for a, b in zip(row, others, strict=True))


def lasting(known: Given, found: Mapping[str, InTime]) -> Iterator[Demand]:
    """What is asked of the time: that no slip has changed its sense since the start. That is said as t ≤ the first time at
    which one vanishes, if there surely is one and a formula gives it, else of the slip as far as the courses `found` tell
    it, which has to be met from the start on."""
    study, at, letters = known.study, dict[str, Scalar](), dict[str, Scalar]()
    for name, one in found.items():
        at |= {name: one.place, f"{name}_dot": derivative(one.place, "t")}
        letters |= one.letters
    for slip in slips(study.system).values():
        told = short(without_even_roots(substitute(slip, at)))
        if not names_in(told) & {"t", *study.system.coordinates, *study.system.speeds} or not depends_on(short(told / TIME), "t"):
            continue  # it stays what it is at the start, or grows from rest as it begins to
        first = time_to(told, known, letters)
        if first is not None and settle(first[1], study.assumptions) == ():
            yield Demand(short(substitute(first[0], letters) - TIME), ">=")
        else:
            yield Demand(short(without_even_roots(substitute(told, letters))), ">=")
