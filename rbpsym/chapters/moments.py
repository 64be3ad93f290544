"""Centres of mass and moments of inertia about any point: each part by its integral, Steiner's theorem, the sum."""

from __future__ import annotations

from rbpsym.chapters.inertia import as_power, center_of_mass, in_frame, moment_of_mass, together
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, Vector, depends_on, is_zero, short, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.inertia import Inertia, inertia
from rbpsym.mechanics.system import BodyState, Pose, at_point
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import BodyRef, PhraseRef
from rbpsym.statement.model import Body, PlacedShape, Shape
from rbpsym.statement.solids import leaves

CENTER = "cm"


class Piece(Frozen):
    """A part of a body, or the whole of it: where it is, whether it is cut out, the letter of its moment about its own centre.

    `one`: the single part of which it is all copies, `count` of them.
    """

    shape: Shape
    state: BodyState
    sign: int
    letter: t.Sym
    slot: BodyRef | PhraseRef
    one: Piece | None = None
    count: t.Node = t.ONE

    def about(self, place: Vector) -> Scalar:
        """Its share of the moment of inertia about a place."""
        arm = self.state.center - place
        return (self.state.moment + self.state.mass * tidy(arm.dot(arm))) * self.sign


def write(draft: Draft) -> None:
    """The chapter of a problem that asks for nothing else: each body about its centre of mass and about each origin."""
    names = tuple(draft.study.system.bodies)
    for name in names:
        about(draft, (name,), CENTER)
    for label in draft.study.origins:
        for name in names:
            about(draft, (name,), label)


def about(draft: Draft, names: tuple[str, ...], label: str, place: Vector | None = None) -> None:
    """The moments of inertia of bodies about a place, the centre of mass of a single one, or an origin, and their sum.

    Nothing is written where the place moves against a body so that the moment changes.
    """
    draft.chapter = "inertia"
    states = [draft.study.system.bodies[name] for name in names]
    if place is None:
        place = states[0].center if label == CENTER else draft.study.origins[label]
    if not all(_is_kept(draft, state.center - place) for state in states):
        return
    letters = [_of_body(draft, name, label, place) for name in names]
    if len(names) > 1:
        together(draft, label, names, letters, "inertia.about.all", final=True)


def _is_kept(draft: Draft, arm: Vector) -> bool:
    square = tidy(arm.dot(arm))
    return not any(depends_on(square, name) for name in (*draft.study.system.coordinates, "t"))


def center(draft: Draft, name: str) -> None:
    """The steps to the place of the centre of mass of one body."""
    draft.chapter = "inertia"
    state, pieces = draft.study.system.bodies[name], _pieces(draft, name)
    if len(pieces) > 1:
        _center(draft, name, state, pieces)
    elif pieces[0].shape.elements and (pieces[0].state.inertia.x or pieces[0].state.inertia.y):
        center_of_mass(draft, pieces[0].state, pieces[0].shape, pieces[0].slot)


# --- parts


def _pieces(draft: Draft, name: str) -> list[Piece]:
    """The parts of a body that are no composites, or the body itself."""
    body, state = draft.study.problem.body(name), draft.study.system.bodies[name]
    if not body.shape.parts:
        return [Piece(body.shape, state, 1, _letter(draft, name, CENTER, state.moment), BodyRef(name))]
    return [_piece(draft, state, number, part) for number, part in enumerate(leaves(body.shape), 1)]


def _piece(draft: Draft, body: BodyState, number: int, part: PlacedShape) -> Piece:
    name, own = body.name, inertia(Body(body.name, part.shape, part.mass))
    at = at_point(body.pose, (scalar(part.at[0]), scalar(part.at[1])))
    pose = Pose(at, body.pose.angle + scalar(part.angle))
    state = BodyState(f"{name}_{number}", own, pose, at_point(pose, (own.x, own.y)))
    letter = draft.define(draft.free(f"I_{number}" if draft.is_single else f"I_{name}_{number}"), own.moment)
    slot = PhraseRef("inertia.part", {"number": t.Num(number), "body": BodyRef(name)})
    if part.count is not None:
        return _repeated(draft, body, Piece(part.shape, state, 1, letter, slot), part, part.count)
    return Piece(part.shape, state, -1 if part.removed else 1, letter, slot)


def _repeated(draft: Draft, body: BodyState, one: Piece, part: PlacedShape, count: t.Node) -> Piece:
    """All copies of a part together, about their hub: as often the moment of one."""
    hub, often = at_point(body.pose, (scalar(part.hub[0]), scalar(part.hub[1]))), scalar(count)
    value, name = short(one.about(hub) * often), f"{one.state.name}_all"
    letter = draft.define(draft.free(f"{one.letter.name}_all"), value)
    whole = Inertia(one.state.mass * often, NOTHING, NOTHING, value)
    state = BodyState(name, whole, Pose(hub, body.pose.angle), hub)
    return Piece(part.shape, state, -1 if part.removed else 1, letter, one.slot, one, count)


def _letter(draft: Draft, name: str, label: str, value: Scalar) -> t.Sym:
    if label == CENTER:
        return draft.define(draft.of_body("I", name), value)
    point = label.removeprefix(f"{name}.").replace(".", "_")
    return draft.define(draft.free(f"I_{point}" if draft.is_single else f"I_{name}_{point}"), value)


# --- steps


def _of_body(draft: Draft, name: str, label: str, place: Vector) -> t.Sym:
    """The steps to the moment of inertia of one body about a place, and its letter."""
    pieces, state = _pieces(draft, name), draft.study.system.bodies[name]
    for piece in pieces:
        _own_moment(draft, piece)
    center = _center(draft, name, state, pieces) if label == CENTER else ""
    value = short(sum((piece.about(place) for piece in pieces), NOTHING))
    if len(pieces) == 1 and is_zero(value - pieces[0].state.moment):
        return pieces[0].letter
    letter = _letter(draft, name, label, value)
    if not draft.has(f"moment.{name}.{label}"):
        sums = [t.add(*(form(draft, piece, place) for piece in pieces)) for form in (_named, _spelled)]
        draft.add(
            f"moment.{name}.{label}",
            "parallel_axis",
            t.equation(letter, *sums, draft.show(value, factor=True)),
            f"inertia.about.{'cm' if label == CENTER else 'point'}",
            premises=[f"moment.{piece.state.name}" for piece in pieces] + [center],
            body=BodyRef(name),
            point=[label] if "." in label else t.Sym(label),
            is_result=True,
            data={"body": name, "point": in_frame(state, place), "value": value},
        )
    return letter


def _own_moment(draft: Draft, piece: Piece) -> None:
    """The moment of inertia of a part about its own centre; of all copies of one, as often that of one."""
    if not piece.state.moment or draft.has(f"moment.{piece.state.name}"):
        return
    if piece.one is None:
        moment_of_mass(draft, piece.state, piece.letter, piece.shape, piece.slot)
        return
    _own_moment(draft, piece.one)
    sum_ = t.mul(piece.count, t.Group(_named(draft, piece.one, piece.state.center)))
    statement = t.equation(piece.letter, sum_, draft.show(piece.state.moment, factor=True))
    draft.add(f"moment.{piece.state.name}", "identity", statement, "inertia.repeated",
              premises=[f"moment.{piece.one.state.name}"], body=piece.slot, often=piece.count)  # fmt: skip


def _named(draft: Draft, piece: Piece, place: Vector) -> t.Node:
    """I + m d², of what is cut out with a minus."""
    arm = piece.state.center - place
    square = tidy(arm.dot(arm))
    own, power = piece.letter if piece.state.moment else t.ZERO, as_power(draft, square) if square else t.ZERO
    is_plain = isinstance(power, t.Pow) or not square
    shift = t.mul(draft.show(piece.state.mass), power) if is_plain else draft.show(piece.state.mass * square, factor=True)
    found = t.add(own, shift)
    return found if piece.sign > 0 else t.neg(t.Group(found) if isinstance(found, t.Add) else found)


def _spelled(draft: Draft, piece: Piece, place: Vector) -> t.Node:
    """The same as a formula."""
    return draft.show(piece.about(place), factor=True)


def _center(draft: Draft, name: str, state: BodyState, pieces: list[Piece]) -> str:
    """Where the centre of mass of a body of several parts is, from those of the parts; the id of the step."""
    id = f"center.{name}.parts"
    if len(pieces) > 1 and not draft.has(id):
        rows = []
        for axis in ("x", "y"):
            places = [getattr(piece.state.center, axis) for piece in pieces]
            if all(is_zero(place) for place in places):
                continue
            terms = (_weighed(draft, piece, place) for piece, place in zip(pieces, places, strict=True))
            value = tidy(getattr(state.center, axis))
            letter = draft.define(draft.of_body(axis, name), value)
            rows.append(t.equation(letter, t.div(t.add(*terms), draft.show(state.mass)), draft.show(value, factor=True)))
        if rows:
            data = {"body": name, "point": (state.inertia.x, state.inertia.y)}
            draft.add(id, "mass_center", t.system(rows), "inertia.center_of_parts", body=BodyRef(name), is_result=True, data=data)
    return id


def _weighed(draft: Draft, piece: Piece, place: Scalar) -> t.Node:
    found = t.mul(draft.show(piece.state.mass), draft.show(tidy(place)))
    return found if piece.sign > 0 else t.neg(found)
