"""The numeric sketch of a problem in a representative pose, for its figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from types import MappingProxyType

from rbpsym.expr import tree as t
from rbpsym.pictures import sketch_dimensions as dimensions
from rbpsym.pictures import sketch_supports as supports
from rbpsym.pictures.figures.sketch import Sketch, SketchBody, SketchPart
from rbpsym.pictures.pose import DrawnPose
from rbpsym.pictures.sketch_actions import arrows
from rbpsym.pictures.sketch_angles import angles
from rbpsym.pictures.sketch_forces import couples, forces
from rbpsym.proof.step import Derivation
from rbpsym.statement.model import Body, PlacedShape, Shape
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
    for part in (one for leaf in leaves(shape) for one in copies(leaf, _often(pose, leaf))):
        at = (pose.node(part.at[0]), pose.node(part.at[1]))
        yield SketchPart(part.shape.kind, _sizes(pose, part.shape), at, pose.node(part.angle), part.removed)


def _often(pose: DrawnPose, part: PlacedShape) -> int:
    return 1 if part.count is None else max(2, round(pose.node(part.count)))


def _names(derivation: Derivation) -> dict[tuple[str, str], t.Node]:
    """How the ledger names each force on each body."""
    return {
        (step.data["forces"][0].name, step.data["forces"][0].on): step.slots["force"]
        for step in derivation.chapter("forces")
    }


def _gravity(pose: DrawnPose) -> dict[str, object]:
    for element in pose.study.problem.of_kind("gravity"):
        x, y = (pose.node(n) for n in element["direction"])
        return {"gravity": (x, y), "gravity_label": element["g"]}
    return {"gravity": None}
