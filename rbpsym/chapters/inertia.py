"""Moments of inertia by integration over the mass, and Steiner's theorem where a body turns about a fixed point."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from rbpsym.decide.rooted import root_of
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, ONE, Scalar, Vector, atoms, depends_on, is_zero, lift, root, short, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.field.trig import cosine, sine
from rbpsym.mechanics import energy
from rbpsym.mechanics.inertia import Moments, mass_moments
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState
from rbpsym.present.grouping import perfect_power
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import BodyRef, PhraseRef
from rbpsym.statement.model import MassElement, Shape


def turns_about(study: Study, state: BodyState) -> dict[str, Scalar]:
    """Origins about which the body turns rigidly → square of the distance of its centre of mass."""
    found = {}
    for label, origin in study.origins.items():
        arm = state.center - origin
        square = tidy(arm.dot(arm))
        moving = [*study.system.coordinates, "t"]
        if any(depends_on(square, q) for q in moving) or not state.omega:
            continue
        if is_zero(energy.orbital_momentum(state, origin) - state.mass * square * state.omega):
            found[label] = square
    return found


def turning_together(draft: Draft, label: str) -> bool:
    """Whether all bodies turn about the fixed point with one angular velocity."""
    states = draft.study.system.bodies
    omega = next(iter(states.values())).omega
    alike = bool(omega) and all(is_zero(state.omega - omega) for state in states.values())
    return alike and all(label in turns_about(draft.study, state) for state in states.values())


def moment_about(draft: Draft, label: str) -> t.Sym:
    """The moment of inertia of the whole system about the fixed point about which it turns."""
    letter = t.Sym(draft.free(f"I_{label}"))
    [only] = list(draft.study.system.bodies)[:1]
    return letter if letter.name in draft.context.scalars else t.Sym(draft.of_body("I", only))


def moment_of(draft: Draft, name: str, label: str) -> t.Sym:
    """The moment of inertia of one of several bodies about the fixed point about which it turns."""
    about = t.Sym(draft.free(f"I_{name}_{label}"))
    return about if about.name in draft.context.scalars else t.Sym(draft.of_body("I", name))


def together(draft: Draft, label: str, names: Iterable[str], letters: list[t.Sym], phrase: str, *, final: bool = False) -> None:
    """The moments of inertia of several bodies about one place add; a `final` sum is a result, and factored."""
    total = short(sum((draft.context.scalars[letter.name] for letter in letters), NOTHING))
    whole = draft.define(draft.free(f"I_{label}"), total)
    draft.add(
        f"moment.together.{label}",
        "identity",
        t.equation(whole, t.add(*letters), draft.show(total, factor=final)),
        phrase,
        premises=[f"moment.{name}{tail}" for tail in (f".{label}", "") for name in names],
        point=t.Sym(label),
        is_result=final,
    )


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "inertia"
    for name, state in draft.study.system.bodies.items():
        moment = draft.define(draft.of_body("I", name), state.moment)
        draft.context.moments[name] = _by_power(state)
        if not state.moment:
            continue
        if not state.omega:
            _placed_only(draft, name, state)
            continue
        shape = draft.study.problem.body(name).shape
        if shape.elements or shape.given_moment is not None:
            moment_of_mass(draft, state, moment, shape, BodyRef(name))
        else:
            draft.add(
                f"moment.{name}",
                "parallel_axis",
                t.equation(moment, draft.show(state.moment)),
                "inertia.assembled" if len(draft.study.problem.body(name).shape.parts) > 1 else "inertia.one_part",
                body=BodyRef(name),
                data=_about(name, state, state.moment),
            )
        _steiner(draft, name, state, moment)
    for label in draft.study.origins:
        if len(draft.study.system.bodies) > 1 and turning_together(draft, label):
            names = tuple(draft.study.system.bodies)
            together(draft, label, names, [moment_of(draft, name, label) for name in names], "inertia.together")


def moment_of_mass(draft: Draft, state: BodyState, moment: t.Sym, shape: Shape, slot: BodyRef | PhraseRef) -> None:
    """The moment of inertia of a body or a part about its own centre of mass: by integration, or as it is given."""
    draft.context.moments[state.name] = _by_power(state)
    if shape.elements:
        _integrated(draft, state, moment, shape, slot)
        return
    given = t.equation(moment, draft.show(state.moment))
    draft.add(f"moment.{state.name}", "statement", given, "inertia.given", body=slot)


def _moments(draft: Draft, name: str) -> Moments:
    return mass_moments(draft.study.problem.body(name).shape, draft.study.system.bodies[name].inertia)


def _placed_only(draft: Draft, name: str, state: BodyState) -> None:
    """Of a body that never turns only the centre of mass is of interest."""
    elements = draft.study.problem.body(name).shape.elements
    if elements:
        moments = _moments(draft, name)
        if not (is_zero(moments.x) and is_zero(moments.y)) and _shifted_rod(elements, state) is None:
            center_of_mass(draft, state, draft.study.problem.body(name).shape, BodyRef(name))


def _by_power(state: BodyState) -> Mapping[int, Scalar]:
    return {0: state.mass, 2: state.moment}


def _integrated(draft: Draft, state: BodyState, moment: t.Sym, shape: Shape, slot: BodyRef | PhraseRef) -> None:
    moments, elements, name = mass_moments(shape, state.inertia), shape.elements, state.name
    centred = is_zero(moments.x) and is_zero(moments.y)
    shifted = _shifted_rod(elements, state)
    if not centred:
        center_of_mass(draft, state, shape, slot)
    if centred or shifted is not None:
        integral = t.add(*(_integral(draft, e, _square(e, shifted), _as_square(draft, e, shifted)) for e in elements))
        radius = t.BodyIntegral(t.Pow(t.Sym(draft.context.radius), t.TWO), name)
        whole = [radius] if name in draft.study.system.bodies else []
        draft.add(
            f"moment.{name}",
            "mass_integral",
            t.equation(moment, *whole, integral, draft.show(state.moment)),
            "inertia.integral",
            is_result=draft.study.problem.is_at_rest and bool(whole),
            body=slot,
            **_spread(draft, elements),
        )
        return
    _by_parallel_axis(draft, state, moment, elements, slot)


def _spread(draft: Draft, elements: tuple[MassElement, ...]) -> dict[str, Any]:
    """How the mass is spread: its density along a line, over a surface or in a volume, if it is one piece."""
    if len(elements) != 1 or elements[0].kind == "point":
        return {"variant": "pieces"}
    return {"variant": elements[0].kind, "density": _tidied(draft, elements[0].density)}


def _shifted_rod(elements: tuple[MassElement, ...], state: BodyState) -> tuple[Scalar, Scalar] | None:
    """For a line of mass the distance is taken from the centre of mass at once."""
    return (state.inertia.x, state.inertia.y) if len(elements) == 1 and elements[0].kind == "line" else None


def _as_square(draft: Draft, element: MassElement, center: tuple[Scalar, Scalar] | None) -> t.Node | None:
    """(s - a)² for mass along the axis of the body; None for any other."""
    if center is None or center[1] or scalar(element.y):
        return None
    return t.Pow(draft.show(scalar(element.x) - center[0]), t.TWO)


def _square(element: MassElement, center: tuple[Scalar, Scalar] | None) -> Scalar:
    x, y = scalar(element.x), scalar(element.y)
    if center is not None:
        x, y = x - center[0], y - center[1]
    return tidy(x * x + y * y)


def _integral(draft: Draft, element: MassElement, weight: Scalar, node: t.Node | None = None) -> t.Node:
    """density × ∫∫ weight × measure, the sign of a removed part in front."""
    found = draft.show(weight * scalar(element.measure), factor=True) if node is None else t.mul(node, element.measure)
    density = _tidied(draft, element.density)
    if not element.ranges:
        found = t.mul(density, found)
        return t.neg(found) if element.sign < 0 else found
    varying = {item.variable for item in element.ranges}
    inside = bool(t.names(density) & varying)
    found = t.mul(density, found) if inside else found
    for item in reversed(element.ranges):
        found = t.Integral(found, item.variable, _tidied(draft, item.lower), _tidied(draft, item.upper))
    found = found if inside else t.mul(density, found)
    return t.neg(found) if element.sign < 0 else found


def _tidied(draft: Draft, own: t.Node) -> t.Node:
    """The node as it is written, or worked out where that is shorter or spares a fraction in a fraction."""
    shown = draft.show(scalar(own), factor=True)
    return shown if _is_stacked(own) or _repeats(own) or length(shown) < length(own) else own


def _is_stacked(node: t.Node) -> bool:
    return isinstance(node, t.Div) and any(isinstance(part, t.Div) for part in t.walk(node.den))


def _repeats(node: t.Node) -> bool:
    """Does a factor stand twice: M/(a a)?"""
    return any(isinstance(part, t.Mul) and len(set(part.factors)) < len(part.factors) for part in t.walk(node))


def center_of_mass(draft: Draft, state: BodyState, shape: Shape, slot: BodyRef | PhraseRef) -> None:
    """Where the centre of mass is in the body, from the first moments of the mass."""
    moments, elements = mass_moments(shape, state.inertia), shape.elements
    is_only = draft.is_single and state.name in draft.study.system.bodies
    rows, part = [], "" if is_only else f"_{state.name}"
    for axis, place, first in (("x", state.inertia.x, moments.x), ("y", state.inertia.y, moments.y)):
        if is_zero(first):
            continue
        letter = draft.define(draft.free(f"{axis}_cm{part}"), place)
        weights = [scalar(element.x if axis == "x" else element.y) for element in elements]
        integral = t.add(*(_integral(draft, e, w) for e, w in zip(elements, weights, strict=True)))
        mean = t.mul(t.div(t.ONE, draft.show(state.mass)), integral)
        rows.append(t.equation(letter, mean, draft.show(place)))
    phrase = "inertia.center_still" if draft.study.problem.is_at_rest else "inertia.center"
    draft.add(f"center.{state.name}", "mass_integral", t.system(rows), phrase, body=slot)


def _by_parallel_axis(
    draft: Draft, state: BodyState, moment: t.Sym, elements: tuple[MassElement, ...], slot: BodyRef | PhraseRef
) -> None:
    """I about the origin of the frame by integration, then Steiner's theorem back to the centre of mass."""
    about, name = state.inertia.about_origin, state.name
    assert about is not None, name
    symbol_ = draft.define(draft.free(f"I_{name}_0"), about)
    integral = t.add(*(_integral(draft, e, _square(e, None)) for e in elements))
    draft.add(
        f"moment.{name}.origin",
        "mass_integral",
        t.equation(symbol_, integral, draft.show(about)),
        "inertia.about_origin",
        body=slot,
    )
    square = tidy(state.inertia.x**2 + state.inertia.y**2)
    shift = t.mul(draft.show(state.mass), draft.show(square))
    draft.add(
        f"moment.{name}",
        "parallel_axis",
        t.equation(moment, t.add(symbol_, t.neg(shift)), draft.show(state.moment)),
        "inertia.steiner_back",
        premises=[f"moment.{name}.origin", f"center.{name}"],
        is_result=draft.study.problem.is_at_rest and name in draft.study.system.bodies,
        body=slot,
        data={**_about(name, state, state.moment), "elements": elements},
    )


def _about(name: str, state: BodyState, value: Scalar) -> dict[str, Any]:
    return {"body": name, "point": (state.inertia.x, state.inertia.y), "value": value}


def is_centred(draft: Draft, name: str) -> bool:
    """Whether the frame in which the mass is described has its origin at the centre of mass."""
    moments = _moments(draft, name)
    return is_zero(moments.x) and is_zero(moments.y)


def _steiner(draft: Draft, name: str, state: BodyState, moment: t.Sym) -> None:
    for label, square in turns_about(draft.study, state).items():
        if not square:
            continue
        about = state.moment + state.mass * square
        letter = draft.define(draft.free(f"I_{name}_{label}" if not draft.is_single else f"I_{label}"), about)
        sum_ = t.add(moment, t.mul(draft.show(state.mass), as_power(draft, square)))
        spelled = t.add(draft.show(state.moment), draft.show(state.mass * square))
        draft.add(
            f"moment.{name}.{label}",
            "parallel_axis",
            _closed(draft, letter, sum_, spelled, about),
            "inertia.steiner",
            premises=[f"moment.{name}"],
            body=BodyRef(name),
            point=t.Sym(label),
            data={"body": name, "point": in_frame(state, draft.study.origins[label]), "value": about},
        )


def as_power(draft: Draft, square: Scalar) -> t.Node:
    """d² as the square of the distance, where that is a plain length."""
    found = perfect_power(square.num) if square.den is ONE else None
    if found is not None and found[2] == 2:
        size = root(lift(found[0]))
        return draft.show(square) if size.number() is None else t.power(draft.show(Scalar(found[1]) * size), 2)
    distance = root_of(square, draft.study.assumptions)
    rooted = any(atoms.atom(index).kind == "root" for index in distance.atoms())
    return draft.show(square) if rooted else t.power(draft.show(distance), 2)


def _closed(draft: Draft, letter: t.Node, sum_: t.Node, spelled: t.Node, value: Scalar) -> t.Node:
    """letter = sum (= one term, if the sum is one)."""
    shown = draft.show(value)
    return t.equation(letter, sum_, spelled) if len(value.num) > 1 else t.equation(letter, sum_, spelled, shown)


def in_frame(state: BodyState, place: Vector) -> tuple[Scalar, Scalar]:
    """A place in space in the frame of the body."""
    arm = place - state.pose.origin
    c, s = cosine(state.pose.angle), sine(state.pose.angle)
    return tidy(arm.x * c + arm.y * s), tidy(arm.y * c - arm.x * s)
