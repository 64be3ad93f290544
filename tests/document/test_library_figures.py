"""The figures of every problem that ships and of every example: no label collides, in three poses each."""

from __future__ import annotations

import math
from functools import cache

import pytest

from rbpsym.document.notes_figures import describe, describe_free_body
from rbpsym.document.phrases import problem_notation
from rbpsym.errors import NotApplicable
from rbpsym.expr import tree as t
from rbpsym.field.scalar import symbol
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.study import Study
from rbpsym.pictures.figures.scene import Scene, placed
from rbpsym.pictures.figures.schematic import free_body, schematic
from rbpsym.pictures.figures.sketch import Sketch, SketchCouple
from rbpsym.pictures.figures.svg import to_svg
from rbpsym.pictures.figures.tikz import to_tikz
from rbpsym.pictures.plots.following import Flow, leg, require_motion
from rbpsym.pictures.pose import DrawnPose
from rbpsym.pictures.sketches import sketch_of, sketch_of_pose
from rbpsym.quantities import NUMBER
from rbpsym.statement.library import problem_files
from tests.architecture.source import ROOT
from tests.document.collisions import collisions
from tests.library.derived import derived_from

pytestmark = pytest.mark.heavy(of=20)

EXAMPLES = sorted((ROOT / "docs" / "examples").glob("*/*.toml"))
FILES = {**problem_files(), **{f"{path.parent.name}-{path.stem}": path for path in EXAMPLES}}
SHARES = (None, 0.3, 0.8)


@cache
def study(name: str) -> Study:
    return derived_from(FILES[name]).study


def pose(found: Study, share: float | None) -> DrawnPose:
    """The pose of the notes, or one in which each coordinate stands at a share of its range."""
    first = DrawnPose(found)
    if share is None:
        return first
    moved = {c.name: place(first, c, share) for c in found.problem.coordinates if c.name in found.system.coordinates}
    return DrawnPose(found, moved)


def place(first: DrawnPose, coordinate, share: float) -> float:
    from rbpsym.field.evaluate import scalar

    low, high = (None if b is None else number(scalar(b), first.numbers) for b in (coordinate.lower, coordinate.upper))
    here = first.numbers[coordinate.name]
    wide = 1.2 if coordinate.quantity.dimension == NUMBER else 0.4 * first.size
    low = here - wide if low is None else low
    high = here + wide if high is None else high
    return low + share * (high - low)


def scenes(name: str, share: float | None) -> tuple[Sketch, dict[str, Scene]]:
    sketch = sketch_of_pose(pose(study(name), share))
    bodies = {body.name: free_body(sketch, body.name) for body in sketch.bodies}
    return sketch, {"the system": schematic(sketch), **bodies}


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("share", SHARES)
def test_no_label_collides(name: str, share: float | None) -> None:
    notation = problem_notation(study(name).problem)
    for what, scene in scenes(name, share)[1].items():
        done = placed(scene, notation)
        assert collisions(done) == [], what
        left, bottom, right, top = done.bounds
        assert all(
            left <= one.box[0] and bottom <= one.box[1] and one.box[2] <= right and one.box[3] <= top
            for one in done.labels
        )
        assert right - left < 14
        assert top - bottom < 12


@pytest.mark.parametrize("name", FILES)
def test_every_part_of_the_statement_is_seen(name: str) -> None:
    """Bodies, strings, springs, pivots, circles, forces: what is stated is drawn and told, in both printers."""
    problem, (sketch, drawn) = study(name).problem, scenes(name, None)
    kinds = [element.kind for element in (*problem.constraints, *problem.interactions)]
    later = [e for phase in problem.phases for e in (phase.gap, *phase.impulses) if e is not None and e.kind != "blow"]
    held = [*problem.constraints, *{e.name: e for e in later}.values()]
    kinds += ["string" for e in held[len(problem.constraints) :] if "path" in e.values]
    assert len(sketch.bodies) == len(problem.bodies)
    assert len([cord for cord in sketch.cords if cord.kind != "rail"]) == kinds.count("string") + kinds.count("pull")
    assert len(sketch.links) == kinds.count("spring") + kinds.count("damper")
    assert len(sketch.coils) == kinds.count("torsion-spring") + kinds.count("rotary-damper")
    assert sum(point.kind == "pivot" for point in sketch.points) >= kinds.count("pivot")
    fixed = {e["circle"].label for e in held if e.values.get("circle") and e["circle"].body is None}
    assert len({circle.at for circle in sketch.circles}) >= len(fixed)
    ground = {e["line"].label for e in held if e.values.get("line") is not None and not e["of"]}
    assert len(sketch.lines) == len(ground)
    text = describe(sketch, "en", problem_notation(problem)) + "".join(
        describe_free_body(sketch, b.name) for b in sketch.bodies
    )
    assert all(body.name in text for body in sketch.bodies)
    for scene in drawn.values():
        assert "nan" not in to_svg(scene).lower()
        assert to_tikz(scene).startswith(r"\begin{tikzpicture}")


@pytest.mark.parametrize("name", FILES)
def test_every_force_stands_at_its_point_in_its_diagram(name: str) -> None:
    """Each force of the ledger has an arrow on its body, at the point where it acts."""
    found = pose(study(name), None)
    sketch = sketch_of_pose(found)
    stated = [force for force in found.study.system.forces if force.vector]
    assert len(sketch.forces) == len(stated)
    for force, drawn in zip(stated, sketch.forces, strict=True):
        assert drawn.body == force.on
        assert math.dist(drawn.at, found.point(force.point)) < 1e-9, force.name
        assert math.isclose(math.hypot(*drawn.direction), 1.0), force.name


def soon(name: str, given: dict[str, float]):
    """The motion right after the start, or None: numbers at some moments."""
    try:
        require_motion(study(name))
        flow = Flow(study(name), given)
        pace = flow.pace(flow.start())
        return leg(derived_from(FILES[name]), given, end=0.05 * pace if math.isfinite(pace) else 1.0)
    except NotApplicable:
        return None


@pytest.mark.parametrize("name", FILES)
def test_forces_and_couples_have_the_sense_that_they_take(name: str) -> None:
    """On the motion that is integrated from the start; where the sign of a letter is told, its value there has it."""
    found = pose(study(name), None)
    sketch, way = sketch_of_pose(found), soon(name, dict(found.numbers))
    system = found.study.system
    told = zip((f for f in system.forces if f.vector), sketch.forces, strict=True)
    turning = zip((f for f in system.forces if f.couple), sketch.couples, strict=True)
    for force, drawn in (*told, *turning) if way else ():
        single = dict.fromkeys(force.unknowns, 1.0)
        if len(single) < 2 and not drawn.is_open:
            unknown = way.values(symbol(*single)) if single else 1.0
            if isinstance(drawn, SketchCouple):
                values = drawn.sign * way.values(force.couple)
            elif single:
                x, y = (number(part, {**found.numbers, **single}) for part in (force.vector.x, force.vector.y))
                values = unknown * (x * drawn.direction[0] + y * drawn.direction[1])
            else:
                x, y = (way.values(part) for part in (force.vector.x, force.vector.y))
                values = x * drawn.direction[0] + y * drawn.direction[1]
            size = max(abs(values))
            assert size < 1e-12 or next(v for v in values if abs(v) > 1e-9 * size) > 0, force.name


@pytest.mark.parametrize("name", FILES)
def test_action_and_reaction_are_drawn_opposite_and_named_as_in_the_table(name: str) -> None:
    derivation = derived_from(FILES[name])
    sketch, system = sketch_of(derivation), study(name).system
    table = {(step.slots["body"].name, step.slots["force"]) for step in derivation.chapter("forces")}
    assert {(drawn.body, drawn.label) for drawn in (*sketch.forces, *sketch.couples)} <= table or not table
    ends = {force.name: system.named(force.name) for force in system.forces if system.is_reaction(force)}
    for first, second, *_ in ends.values():
        arrows = {f.body: f for f in sketch.forces if f.label in (t.Vec(first.name), t.neg(t.Vec(first.name)))}
        turns = {c.body: c for c in sketch.couples if c.label in (t.Sym(first.name), t.neg(t.Sym(first.name)))}
        if arrows:
            (x, y), (u, v) = arrows[first.on].direction, arrows[second.on].direction
            assert math.isclose(x, -u, abs_tol=1e-9) and math.isclose(y, -v, abs_tol=1e-9), first.name
        if turns:
            assert turns[first.on].sign == -turns[second.on].sign, first.name


@pytest.mark.parametrize(
    ("name", "letters"),
    [
        ("block-on-table", "dhR"),
        ("disk-on-incline", "R"),
        ("disk-off-center", "dR"),
        ("rod-over-corner", "h"),
        ("spring-coupled-pendulums", "bd"),
        ("rear-wheel-drive", "bhL"),
        ("cylinder-in-cylinder", "aR"),
    ],
)
def test_lengths_of_the_statement_are_dimensions(name: str, letters: str) -> None:
    """Also distances that no shape has: found between points of the drawing, for these numbers and for others."""
    sketch = sketch_of_pose(pose(study(name), None))
    shown = {mark.label.name for mark in (*sketch.lengths, *sketch.radii) if hasattr(mark.label, "name")}
    assert set(letters) <= shown


def test_slopes_are_angles() -> None:
    sketch = sketch_of_pose(pose(study("disk-on-incline"), None))
    assert "beta" in {mark.label.name for mark in sketch.angles}


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("share", SHARES)
def test_coordinates_are_drawn_as_long_and_as_wide_as_they_are(name: str, share: float | None) -> None:
    found = pose(study(name), share)
    sketch, coordinates = sketch_of_pose(found), {c.name for c in found.study.problem.coordinates}
    for mark in sketch.lengths:
        if isinstance(mark.label, t.Sym) and mark.label.name in coordinates:
            assert math.isclose(math.dist(mark.start, mark.end), abs(found.numbers[mark.label.name])), mark
    for angle in sketch.angles:
        turn = angle.end - angle.start
        assert 0.0 < abs(turn) < math.tau, angle
        if isinstance(angle.label, t.Sym) and angle.label.name in coordinates:
            gap = abs(turn) - abs(found.numbers[angle.label.name])
            assert math.isclose(math.remainder(gap, math.tau), 0.0, abs_tol=1e-9), angle


@pytest.mark.parametrize(
    ("name", "letters"),
    [
        ("cylinder-on-wedge", {"x", "s", "phi"}),
        ("ball-on-incline", {"s", "phi"}),
        ("elastic-pendulum", {"r", "theta"}),
        ("bead-in-rolling-hoop", {"x", "theta", "phi"}),
        ("rod-on-two-strings", {"phi", "theta"}),
    ],
)
def test_ways_and_angles_along_any_line_and_about_any_centre_are_drawn(name: str, letters: set[str]) -> None:
    sketch = sketch_of_pose(pose(study(name), None))
    assert letters <= {mark.label.name for mark in (*sketch.lengths, *sketch.angles) if isinstance(mark.label, t.Sym)}
