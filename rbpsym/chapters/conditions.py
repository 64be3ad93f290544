"""What the constraints ask, in the coordinates as given; what they then tie to other coordinates.

Geometry first (a point on its line, a round body at the distance of its radius), then what is
asked of the speeds: no slip, a taut string. A condition that holds whatever the coordinates are is
only shown in full detail. Kleppner & Kolenkow 7.6; Meriam & Kraige, Dynamics, 5/4.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from rbpsym.chapters import places
from rbpsym.decide.signs import sign
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, Vector, is_zero, short, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.contacts import meeting, no_slip, rim_of
from rbpsym.mechanics.pushing import ways_kept, ways_taken
from rbpsym.mechanics.strings import segments, speeds_along
from rbpsym.present.forms import present
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import FULL, STANDARD, BodyRef, PhraseRef
from rbpsym.statement.curves import curve_body, toucher
from rbpsym.statement.model import Element, Turn
from rbpsym.statement.paths import runs, tensions


def write(draft: Draft) -> None:
    """The conditions of all constraints, then the coordinates and speeds that they determine."""
    given = places.as_given(draft.study.system)
    _define_tied(draft)
    ties = (*draft.study.ties, *draft.study.system.speed_ties) if draft.study.at_start else ()
    kept = {condition.constraint for condition in ties}  # their rates are told of the start alone
    _led(draft)
    for element in draft.study.problem.constraints:
        _geometric(draft, element)
        _kept_angle(draft, element)
        if element.name not in kept:
            ASKED.get(JOINTS[element.kind].rates, _nothing)(draft, element, given)
    places.found_spins(draft, given)
    places.tied(draft)


def _define_tied(draft: Draft) -> None:
    """Coordinates and speeds that are not free stand for what they are in the others."""
    system = draft.study.system
    for name, value in system.dependent.items():
        rate = time_derivative(value, system.scope)
        more = {name: value, f"{name}_dot": rate, f"{name}_ddot": time_derivative(rate, system.scope)}
        draft.context.scalars.update(more)
    for name in system.coordinates:
        if name not in system.independent:
            rate = system.scope.rates[name]
            draft.context.scalars[f"{name}_dot"] = rate
            draft.context.scalars[f"{name}_ddot"] = time_derivative(rate, system.scope)


def _nothing(draft: Draft, element: Element, given: places.FreeGeometry) -> None:
    """Nothing is asked of the speeds."""


# --- places


def _led(draft: Draft) -> None:
    """Coordinates of which an acceleration is given, or no acceleration and a speed."""
    kept = [c.name for c in draft.study.problem.kept]
    for name, place in draft.study.problem.led.items():
        told = "kept" if name in kept else "given"
        rate = t.Sym(f"{name}_dot" if name in kept else f"{name}_ddot")
        draft.add(f"condition.{name}", "constraint", t.equation(t.Sym(name), place), f"kinematics.led.{told}", rate=rate)


def _force(draft: Draft, letter: t.Node) -> dict[str, Any]:
    """The slot of the force; none where masses are not stated."""
    return {} if draft.study.problem.unstated else {"force": letter}


def _geometric(draft: Draft, element: Element) -> None:
    rows = [*places.meeting_rows(draft, element), *places.line_rows(draft, element), *places.distance_rows(draft, element)]
    rows += _driven_rows(draft, element)
    rows = rows or _moving_line_rows(draft, element)
    if not rows:
        return
    ties = any(not is_zero(scalar(row.items[0]) - scalar(row.items[-1])) for row in rows)  # no identities
    body = element.values.get("body")
    draft.add(
        f"condition.{element.name}",
        "constraint",
        t.system([_plain(row) for row in rows] if ties else rows),
        f"kinematics.condition.{'distance' if element.values.get('rim') is not None else element.kind}",
        level=STANDARD if ties else FULL,
        variant="tie" if ties else "identity",
        **_force(draft, t.Vec(element.name)),
        points=_labels(element),
        count=len(_labels(element)),
        obligations=as_taken(draft, element),
        body=BodyRef(body) if isinstance(body, str) else PhraseRef("kinematics.nothing"),
    )


def as_taken(draft: Draft, element: Element) -> tuple[t.Chain, ...]:
    """That it runs, or touches, on the side that is taken, as far as nothing declared says so: in each position, else at
    the start."""
    ways = (ways_kept(draft.study), ways_taken(draft.study))
    kept, begun = ([value for other, value in found if other is element] for found in ways)
    open_ = (value for value in dict.fromkeys(kept or begun) if sign(value, draft.study.assumptions).kind != "positive")
    return tuple(t.relation(draft.show(value), ">", t.ZERO) for value in open_)


def _kept_angle(draft: Draft, element: Element) -> None:
    """A slider does not let its body turn."""
    found = [c.value for c in draft.study.system.conditions if c.constraint == element.name and c.what == "angle"]
    if element.kind != "slider" or not found or is_zero(found[0]):
        return
    shown = draft.show(found[0])
    draft.add(
        f"kept_angle.{element.name}",
        "constraint",
        t.equation(shown.arg if isinstance(shown, t.Neg) else shown, t.ZERO),
        "kinematics.condition.kept_angle",
        level=STANDARD,
        **_force(draft, t.Vec(element.name)),
        body=BodyRef(element["point"].body),
    )


def _moving_line_rows(draft: Draft, element: Element) -> list[t.Chain]:
    """A point on a line of a body that moves: how far it is from it."""
    if element.values.get("of") is None:
        return []
    gaps = (c.value for c in draft.study.system.conditions if c.constraint == element.name and c.what == "gap")
    return [t.equation(draft.show(gap), t.ZERO) for gap in gaps if not is_zero(gap)]


def _plain(node: t.Node) -> t.Node:
    """Sines and cosines with signs and quarter turns taken out of their arguments, the signs put in front."""
    node = t.mapped(node, _plain)
    if isinstance(node, t.Fn):
        plain = present(scalar(node))
        return plain if isinstance(plain.arg if isinstance(plain, t.Neg) else plain, t.Fn) else node
    match node:
        case t.Mul(factors=factors):
            return t.mul(*factors)
        case t.Add(terms=terms):
            return t.add(*terms)
        case t.Neg(arg=arg):
            return t.neg(arg)
    return node


def _labels(element: Element) -> list[str]:
    joint = JOINTS[element.kind]
    refs = [ref for join in joint.joins(element) for ref in join if ref and (ref.body or element.kind != "pivot")]
    refs += [touch.point for touch in joint.touches(element)]
    if not refs and element.values.get("point") is not None:
        refs = [element["point"]]
    if not refs and element.kind == "string":
        refs = [turn.center for turn in (element["path"][0], element["path"][-1])]
    return [ref.label for ref in refs]


def _driven_rows(draft: Draft, element: Element) -> list[t.Chain]:
    """A given function of time: the place of a point along a direction, or the angle of a body."""
    if element.kind == "prescribed-angle":
        angle = draft.study.problem.body(element["body"]).angle
        base = draft.study.problem.body(element["of"]).angle if element["of"] else t.ZERO
        return [] if angle is None or base is None else [t.equation(t.add(angle, t.neg(base)), element["angle"])]
    if element.kind != "prescribed" or element["of"]:
        return []
    at = places.coordinates_of(draft, element["point"])
    if at is None:
        return []
    ways = zip(element["along"], at, strict=True)
    parts = [part if way == t.ONE else t.mul(way, part) for way, part in ways if way != t.ZERO]
    return [t.equation(t.add(*parts), element["distance"])]


# --- speeds


class _Part(Frozen):
    """The speed of a place of a body: that of a point of it, and what its rotation adds (or takes)."""

    still: t.Node
    turning: t.Node
    extra: t.Node | None = None


def _speed(draft: Draft, given: places.FreeGeometry, body: str | None, place: Vector, direction: Vector, about: Vector) -> _Part:
    """Speed of the material point at `place`, split at the point `about` of the same body."""
    if body is None:
        return _Part(t.ZERO, t.ZERO)
    arm = direction.dot((place - about).turned())
    moved = short(places.speed_along(given, body, about, direction))
    letter = None
    if body in given.unplaced and moved:
        letter = draft.define(draft.free("v" if draft.is_single else f"v_{body}"), draft.context.value(draft.show(moved)))
    still = letter or draft.show(moved)
    return _Part(still, _turned(draft, given, body, arm), letter)


def _turned(draft: Draft, given: places.FreeGeometry, body: str, arm: Scalar) -> t.Node:
    """arm × ω; with the letter ω where no one gave the angle of the body."""
    spin = given.spin(body)
    if spin is not None:
        return draft.show(short(arm * spin))
    omega = draft.define(draft.of_body("omega", body), draft.study.system.bodies[body].omega)
    shown = draft.show(short(arm))
    if shown == t.ZERO:
        return t.ZERO
    return t.neg(t.mul(shown.arg, omega)) if isinstance(shown, t.Neg) else t.mul(shown, omega)


def _no_slip(draft: Draft, element: Element, given: places.FreeGeometry) -> None:
    """At the contact both have one velocity: V·t = (what it touches) - (rim) ω."""
    met = meeting(element, given.geometry)
    on, by = toucher(element), curve_body(element)
    way = met.forward
    about = met.place + met.normal * rim_of(element)
    first = _speed(draft, given, on, met.place, way, about) if on else _Part(t.ZERO, t.ZERO)
    second = _speed(draft, given, by, met.place, way, given.geometry.center(by) if by else Vector({}))
    other = t.add(second.still, second.turning)
    left, right = first.still, t.add(other, t.neg(first.turning))
    still = left == t.ZERO
    if still:
        left, right = first.turning, other
    if isinstance(left, t.Neg) and isinstance(right, t.Neg):
        left, right = left.arg, right.arg
    same = left == right
    if left == t.ZERO and right == t.ZERO:
        return
    draft.add(
        f"no_slip.{element.name}",
        "no_slip",
        t.equation(t.add(t.neg(right), left), t.ZERO) if same else t.equation(left, right),
        f"kinematics.condition.{element.kind}_speed",
        level=FULL if same else STANDARD,
        premises=draft.those(f"condition.{element.name}"),
        body=BodyRef(on or by or ""),
        by=BodyRef(by) if by else PhraseRef("kinematics.nothing"),
        on=_where(element, by, met.normal),
        points=_labels(element),
        speed=_named(first.extra),
        variant="axles" if still and by and element.kind != "sticking" else "moving" if by else "fixed",
        data={"element": element},
    )


def _named(letter: t.Node | None) -> PhraseRef:
    """What the letter of a speed means that had to be named."""
    return PhraseRef("kinematics.speed_of_centre", {"speed": letter}) if letter else PhraseRef("kinematics.nothing")


def _where(element: Element, by: str | None, normal: Vector) -> PhraseRef:
    """On a line or a circle, inside or outside, of another body or fixed."""
    if element.values.get("line") is not None:
        return (PhraseRef("kinematics.on.body", {"by": BodyRef(by)}) if by else PhraseRef(f"kinematics.on.{_slope(normal)}"))
    stated = element.values.get("side")  # a guide has none
    side = stated if stated in ("inside", "outside") else "body"
    return PhraseRef(f"kinematics.on.{side}", {"by": BodyRef(by) if by else PhraseRef("kinematics.circle")})


def _slope(normal: Vector) -> str:
    """What a fixed line is, from the normal of the force with which it pushes."""
    if not normal.x:
        return "floor"
    return "line" if normal.y else "wall"


def _taut(draft: Draft, element: Element, given: places.FreeGeometry) -> None:
    """Both ends of each run of a string move along it at one speed."""
    for name, run in zip(tensions(element), runs(element["path"]), strict=True):
        if element["length"] is None:
            _run(draft, element, name, run, given)


def _run(draft: Draft, element: Element, name: str, run: tuple[Turn, ...], given: places.FreeGeometry) -> None:
    terms = [part for part in _along_run(draft, run, given) if part != t.ZERO]
    if not terms:
        return
    trivial = is_zero(sum((scalar(term) for term in terms), NOTHING))
    statement = _balanced(terms) if not trivial else t.equation(t.add(*terms), t.ZERO)
    draft.add(
        f"taut.{name}",
        "taut",
        statement,
        f"kinematics.condition.{'link' if element.values.get('rigid') else 'string'}_speed",
        level=FULL if trivial else STANDARD,
        variant="identity" if trivial else "round" if len(run) > 2 else "straight",
        **_force(draft, t.Sym(name)),
        ends=[(BodyRef(turn.body) if turn.body else turn.center.label) for turn in (run[0], run[-1])],
        obligations=as_taken(draft, element),
        data={"tension": name},
    )


def _balanced(terms: list[t.Node]) -> t.Node:
    """a + b = 0 as a = -b; more terms as their sum."""
    if len(terms) != 2:
        return t.equation(t.add(*terms), t.ZERO)
    first, second = terms
    return t.equation(t.neg(first), second) if isinstance(first, t.Neg) else t.equation(first, t.neg(second))


def _along_run(draft: Draft, run: tuple[Turn, ...], given: places.FreeGeometry) -> list[t.Node]:
    """u·v of the places where the string pulls: at its ends, and at what it slides round."""
    parts = segments(run, given.geometry)
    first, last = parts[0], parts[-1]
    found = _pull(draft, given, run[0], first.start, first.along)
    for before, after in zip(parts, parts[1:], strict=False):
        middle = given.geometry.where(after.first.center)
        found += _pull(draft, given, after.first, middle, after.along - before.along)
    return found + _pull(draft, given, run[-1], last.end, -last.along)


def _pull(draft: Draft, given: places.FreeGeometry, turn: Turn, place: Vector, way: Vector) -> list[t.Node]:
    if turn.body is None:
        return []
    part = _speed(draft, given, turn.body, place, way, given.geometry.where(turn.center))
    return [t.Group(node) if isinstance(node, t.Add) else node for node in (part.still, part.turning)]


# by what the law of a constraint asks of the speeds
ASKED: Mapping[object, Callable[[Draft, Element, places.FreeGeometry], None]] = {no_slip: _no_slip, speeds_along: _taut}
