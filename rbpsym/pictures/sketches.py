"""The numeric sketch of a problem in a representative pose, for its figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any

from rbpsym.errors import NoNumber, NotApplicable
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, names_in
from rbpsym.mechanics.motion import net_power
from rbpsym.mechanics.numbers import floating
from rbpsym.mechanics.system import Force, System
from rbpsym.pictures import sketch_dimensions as dimensions
from rbpsym.pictures import sketch_supports as supports
from rbpsym.pictures.figures.scene import Point
from rbpsym.pictures.figures.sketch import Sketch, SketchBody, SketchCouple, SketchForce, SketchPart
from rbpsym.pictures.pose import DrawnPose, Moving, other_numbers, require_motion
from rbpsym.pictures.sketch_dimensions import angles
from rbpsym.pictures.sketch_supports import arrows
from rbpsym.proof.step import Derivation
from rbpsym.statement.model import Body, Shape
from rbpsym.statement.solids import copies, leaves


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
        forces=tuple(forces(pose, names)),
        couples=tuple(couples(pose, names)),
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
            body.mass if isinstance(body.mass, t.Sym) and body.mass.name not in pose.study.problem.unstated else None,
            () if kind == "disk" else tuple(_parts(pose, body.shape)),
            tuple(pose.node(rim) for rim in pose.rims.get(body.name, ())),
        )


def _outline(pose: DrawnPose, body: Body) -> tuple[str, dict[str, float]]:
    """Kind and sizes of the outline; one of no particular shape is as large as its rims and points ask."""
    shapes = [part.shape for part in body.shape.parts] or [body.shape]
    if any(shape.kind != "given" for shape in shapes):
        return body.shape.kind, _sizes(pose, body.shape)
    own = [body.shape.sizes["radius"]] if "radius" in body.shape.sizes else []
    rims = [pose.node(rim) for rim in (*own, *pose.rims.get(body.name, ()))]
    if rims and "center" in body.points:
        return "disk", {"radius": max(rims)}
    at = [(pose.node(x), pose.node(y)) for x, y in body.points.values()]
    xs, ys = zip((0.0, 0.0), *at, strict=True)
    if max(xs) - min(xs) > 0 and max(ys) - min(ys) > 0:
        return "box", {"left": min(xs), "right": max(xs), "bottom": min(ys), "top": max(ys)}
    return "given", {"size": 2.1 * max([math.hypot(*p) for p in at], default=0.0) or pose.size}


def _sizes(pose: DrawnPose, shape: Shape) -> dict[str, float]:
    return {name: pose.node(size) for name, size in shape.sizes.items() if name != "moment"}


def _parts(pose: DrawnPose, shape: Shape) -> Iterator[SketchPart]:
    often = ((leaf, 1 if leaf.count is None else max(2, round(pose.node(leaf.count)))) for leaf in leaves(shape))
    for part in (one for leaf, count in often for one in copies(leaf, count)):
        at = (pose.node(part.at[0]), pose.node(part.at[1]))
        yield SketchPart(part.shape.kind, _sizes(pose, part.shape), at, pose.node(part.angle), part.removed)


def _names(derivation: Derivation) -> dict[tuple[str, str], t.Node]:
    """How the ledger names each force on each body."""
    return {
        (step.data["forces"][0].name, step.data["forces"][0].on): step.slots["force"]
        for step in derivation.chapter("forces")
    }


def _gravity(pose: DrawnPose) -> dict[str, Any]:
    for element in pose.study.problem.of_kind("gravity"):
        x, y = (pose.node(n) for n in element["direction"])
        return {"gravity": (x, y), "gravity_label": element["g"]}
    return {"gravity": None}


# --- the forces and couples of free-body diagrams: where they act, in which sense, how they are called


Numbers = Mapping[str, float]
Names = Mapping[tuple[str, str], t.Node]
SMALL, SHARE, STEPS = 1e-12, 1e-2, 6  # steps of this share of the time in which something moves far


def forces(pose: DrawnPose, names: Names) -> Iterator[SketchForce]:
    """The forces on all bodies, by their `names` if they have one."""
    soon = after_start(pose)
    for force in pose.study.system.forces:
        x, y, is_open = _direction(pose, force, soon) if force.vector else (0.0, 0.0, True)
        if (x, y) != (0.0, 0.0):
            yield SketchForce(force.on, _label(pose, force, names), pose.point(force.point), (x, y), is_open)


def couples(pose: DrawnPose, names: Names) -> Iterator[SketchCouple]:
    """The couples, each in the sense that it takes right after the start, else as it acts in the pose."""
    soon = after_start(pose)
    for force in pose.study.system.forces:
        if force.couple:
            positive = dict.fromkeys(force.unknowns, 1.0)
            tried = (soon, {**pose.numbers, **pose.reactions()}, *_generic(pose, positive))
            found = [floating(force.couple, numbers, 0.0) for numbers in tried]
            place = next((k for k, value in enumerate(found) if abs(value) > SMALL), 0)
            sense = -1 if found[place] < 0 else 1
            label = _label(pose, force, names)
            is_open = (place > 1 or not found[place]) and _varies(pose, force, force.couple)
            yield SketchCouple(force.on, label, pose.center(force.on), sense, is_open)


def after_start(pose: DrawnPose) -> Numbers:
    """All numbers right after the start, those of the unknown forces too; none if the motion is not known.

    Nor with numbers for which kinetic friction would not act against the slip.
    """
    system, moving = pose.study.system, Moving(pose.study, pose.numbers)
    rubbing = [e["friction"] for e in pose.study.problem.constraints if e.values.get("coefficient") is not None]
    try:
        require_motion(pose.study)
        state = moving.start()
        step = SHARE * moving.pace(state)
        for _ in range(STEPS if math.isfinite(step) else 0):
            state = moving.after(state, step)
        soon = moving.with_forces(state)
    except (NotApplicable, NoNumber):
        return {}
    return {} if any(floating(net_power(system, system.named(name)), soon) > SMALL for name in rubbing) else soon


def _direction(pose: DrawnPose, force: Force, soon: Numbers) -> tuple[float, float, bool]:
    """The direction in the pose, with the sense that the force takes right after the start; whether it has none.

    Unknown components are as they are at rest in the pose, a single one as after the start. A force that vanishes there
    (a slack spring, a damper at rest) is drawn as with other numbers, in motion.
    """
    known, positive = {**pose.numbers, **pose.reactions()}, dict.fromkeys(force.unknowns, 1.0)
    single = {name: soon[name] for name in force.unknowns if name in soon and len(force.unknowns) == 1}
    tried = ({**known, **single}, known, *_generic(pose, positive))
    drawn = [_components(force, numbers) for numbers in tried]
    place = next((k for k, way in enumerate(drawn) if math.hypot(*way) > SMALL), None)
    if place is None:
        return 0.0, 0.0, True
    size, (x, y), (later_x, later_y) = math.hypot(*drawn[place]), drawn[place], _components(force, soon)
    along = (x * later_x + y * later_y) / size
    sense = -1.0 if along < -SMALL and len(force.unknowns) < 2 else 1.0
    is_open = place > 1 and abs(along) <= SMALL and _varies(pose, force, force.vector.x, force.vector.y)
    return sense * x / size, sense * y / size, is_open


def _varies(pose: DrawnPose, force: Force, *values: Scalar) -> bool:
    """Does it depend on more than the parameters? Else its sense is always that with general ones."""
    fixed = {q.name for q in pose.study.problem.parameters}
    return bool(force.unknowns) or any(names_in(value) - fixed for value in values)


def _generic(pose: DrawnPose, positive: Numbers) -> Iterator[Numbers]:
    """Numbers with which what vanishes by chance has a value: those of a motion, and others."""
    moving = {f"{c.name}_dot": 1.0 for c in pose.study.problem.coordinates}
    yield {**pose.numbers, **positive}
    yield {**pose.numbers, **positive, **moving}
    yield {**other_numbers(pose).numbers, **positive, **moving}


def _components(force: Force, numbers: Numbers) -> Point:
    return floating(force.vector.x, numbers, 0.0), floating(force.vector.y, numbers, 0.0)


def _label(pose: DrawnPose, force: Force, names: Names) -> t.Node:
    return names.get((force.name, force.on)) or force_node(pose.study.system, force)


def force_node(system: System, force: Force) -> t.Node:
    """The letter of a force: N on the second body, -N on the first, W_rod for one of several weights."""
    same = system.named(force.name)
    if any(system.is_reaction(f) for f in same):
        letter = t.Vec(force.name) if force.vector else t.Sym(force.name)
        return t.neg(letter) if system.is_reaction(force) else letter
    name = force.name if len(same) == 1 else f"{force.name}_{force.on}"
    return t.Vec(name) if force.vector else t.Sym(name)
