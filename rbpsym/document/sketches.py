"""The numeric sketch of a problem in a representative pose, for its figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from types import MappingProxyType

from rbpsym.derivation.step import Derivation
from rbpsym.document import sketch_dimensions as dimensions
from rbpsym.document import sketch_supports as supports
from rbpsym.document.figures.sketch import Point, Sketch, SketchBody, SketchCouple, SketchForce, SketchPart
from rbpsym.document.pose import DrawnPose, other_numbers
from rbpsym.document.sketch_actions import arrows
from rbpsym.document.sketch_angles import angles
from rbpsym.errors import NoNumber
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.system import Force, System
from rbpsym.notation import tree as t
from rbpsym.statement.model import Body, Shape


def sketch_of(derivation: Derivation) -> Sketch:
    """The sketch of a derived problem, with the forces of its free-body diagrams, named as in its ledger."""
    return sketch_of_pose(DrawnPose(derivation.study), _names(derivation))


def sketch_of_pose(pose: DrawnPose, names: Mapping[tuple[str, str], t.Node] = MappingProxyType({})) -> Sketch:
    """The sketch of a study in a pose; `names` are those of the forces, by force and body."""
    return Sketch(
        bodies=tuple(_bodies(pose)),
        points=tuple(supports.points(pose)),
        lines=tuple(supports.lines(pose)),
        circles=tuple(supports.circles(pose)),
        cords=tuple(supports.cords(pose)),
        arrows=tuple(arrows(pose)),
        links=tuple(supports.links(pose)),
        coils=tuple(supports.coils(pose)),
        angles=tuple(angles(pose)),
        lengths=tuple(dimensions.lengths(pose)),
        radii=tuple(dimensions.radii(pose)),
        forces=tuple(_forces(pose, names)),
        couples=tuple(_couples(pose)),
        **_gravity(pose),
    )


def _bodies(pose: DrawnPose) -> Iterator[SketchBody]:
    for body in pose.study.problem.bodies:
        state = pose.study.system.bodies[body.name]
        kind, sizes = _outline(pose, body)
        yield SketchBody(
            body.name,
            kind,
            sizes,
            pose.point(state.pose.origin),
            pose.value(state.pose.angle),
            pose.point(state.center),
            body.mass if isinstance(body.mass, t.Sym) else None,
            () if kind == "disk" else tuple(_parts(pose, body.shape)),
            tuple(pose.node(rim) for rim in pose.rims.get(body.name, ())),
        )


def _outline(pose: DrawnPose, body: Body) -> tuple[str, dict[str, float]]:
    """Kind and sizes of the outline; one of no particular shape is as large as its rims and points ask."""
    parts = body.shape.parts or (body.shape,)
    if any(getattr(part, "shape", part).kind != "given" for part in parts):
        return body.shape.kind, _sizes(pose, body.shape)
    rims = [pose.node(rim) for rim in pose.rims.get(body.name, ())]
    if rims and "center" in body.points:
        return "disk", {"radius": max(rims)}
    own = [(pose.node(x), pose.node(y)) for x, y in body.points.values()]
    xs, ys = zip((0.0, 0.0), *own, strict=True)
    if max(xs) - min(xs) > 0 and max(ys) - min(ys) > 0:
        return "box", {"left": min(xs), "right": max(xs), "bottom": min(ys), "top": max(ys)}
    return "given", {"size": 2.1 * max([math.hypot(*p) for p in own], default=0.0) or pose.size}


def _sizes(pose: DrawnPose, shape: Shape) -> dict[str, float]:
    return {name: pose.node(size) for name, size in shape.sizes.items() if name != "moment"}


def _parts(pose: DrawnPose, shape: Shape) -> Iterator[SketchPart]:
    for part in shape.parts:
        at = (pose.node(part.at[0]), pose.node(part.at[1]))
        yield SketchPart(part.shape.kind, _sizes(pose, part.shape), at, pose.node(part.angle), part.removed)


def _direction(pose: DrawnPose, force: Force) -> Point:
    """The direction in the pose; unknown components as they are at rest there, else positive.

    A known force that vanishes there (a slack spring, a damper at rest) is drawn as with other numbers, in motion.
    """
    moving = {f"{c.name}_dot": 1.0 for c in pose.study.problem.coordinates}
    known = pose.reactions()
    unknown = {name: known.get(name, 1.0) for name in force.unknowns}
    positive = dict.fromkeys(force.unknowns, 1.0)
    for numbers in (
        {**pose.numbers, **unknown},
        {**pose.numbers, **positive},
        {**pose.numbers, **positive, **moving},
        {**other_numbers(pose).numbers, **positive, **moving},
    ):
        x, y = _components(force, numbers)
        size = math.hypot(x, y)
        if size > 1e-12:
            return x / size, y / size
    return 0.0, 0.0


def _components(force: Force, numbers: Mapping[str, float]) -> Point:
    try:
        return number(force.vector.x, numbers), number(force.vector.y, numbers)
    except NoNumber:
        return 0.0, 0.0


def _names(derivation: Derivation) -> dict[tuple[str, str], t.Node]:
    """How the ledger names each force on each body."""
    return {
        (step.data["forces"][0].name, step.data["forces"][0].on): step.slots["force"]
        for step in derivation.chapter("forces")
    }


def force_node(system: System, force: Force) -> t.Node:
    """The letter of a force: N on the second body, -N on the first, W_rod for one of several weights."""
    same = system.named(force.name)
    if any(system.is_reaction(f) for f in same):
        letter = t.Vec(force.name) if force.vector else t.Sym(force.name)
        return t.neg(letter) if system.is_reaction(force) else letter
    name = force.name if len(same) == 1 else f"{force.name}_{force.on}"
    return t.Vec(name) if force.vector else t.Sym(name)


def _forces(pose: DrawnPose, names: Mapping[tuple[str, str], t.Node]) -> Iterator[SketchForce]:
    for force in pose.study.system.forces:
        direction = _direction(pose, force) if force.vector else (0.0, 0.0)
        if direction != (0.0, 0.0):
            label = names.get((force.name, force.on)) or force_node(pose.study.system, force)
            yield SketchForce(force.on, label, pose.point(force.point), direction)


def _couples(pose: DrawnPose) -> Iterator[SketchCouple]:
    """Unknown couples in the sense in which their letter is positive, known ones as they act in the pose."""
    known = pose.reactions()
    for force in pose.study.system.forces:
        if not force.couple:
            continue
        letter = _couple_letter(force)
        values = pose.numbers | known | ({letter.name: 1.0} if letter.name in force.unknowns else {})
        try:
            value = number(force.couple, values)
        except NoNumber:
            value = 1.0
        yield SketchCouple(force.on, letter, pose.center(force.on), 1 if value >= 0 else -1)


def _couple_letter(force: Force) -> t.Sym:
    """The letter of a couple; its own if it is an unknown or a parameter with its sign."""
    from rbpsym.algebra.present import present

    shown = present(force.couple)
    plain = shown.arg if isinstance(shown, t.Neg) else shown
    return plain if isinstance(plain, t.Sym) else t.Sym(force.name)


def _gravity(pose: DrawnPose) -> dict[str, object]:
    for element in pose.study.problem.of_kind("gravity"):
        x, y = (pose.node(n) for n in element["direction"])
        return {"gravity": (x, y), "gravity_label": element["g"]}
    return {"gravity": None}
