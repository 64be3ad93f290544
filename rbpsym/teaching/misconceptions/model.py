"""A misconception, the places in a problem where a student may fall for it, and studies in which a part was replaced."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property, partial
from typing import Any

from rbpsym.expr.tree import Node, Vec
from rbpsym.field import NOTHING, Scalar, Vector, is_zero
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, field, replace
from rbpsym.mechanics.numbers import floating, number, sample
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState, Force, System
from rbpsym.present.forms import present
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Element, Problem


class Site(Frozen):
    """Where a misconception applies in a problem: `slots` fill its feedback; `wrong()` is the study with it."""

    slots: Mapping[str, Any]
    wrong: Callable[[], Study]


Sites = Callable[[Study], Iterator[Site]]


class Misconception(Frozen):
    """A misconception of the literature as an operator.

    name: its key, also of its phrases (`misconception.<name>`) and of `literature.DESCRIBED`; sites(study): where
    it applies, decided by the structure of the problem; about: kinds of targets (`targets.KINDS`, "axis-moment")
    that it can change. tells: chapters that a
    derivation with the slip must leave out to read as a student's (None: it does not read so at all).
    """

    name: str
    sites: Sites
    about: frozenset[str] = field(default_factory=frozenset)
    tells: frozenset[str] | None = None


MOTION = frozenset({"acceleration", "reaction", "speed", "frequency", "work", "friction", "loss"})
SPIN = MOTION | {"momentum", "kinetic", "axis-moment"}
INERTIA = SPIN | {"moment"}
WORKS = frozenset({"work"})
FORCES = frozenset({"reaction", "work", "friction", "loss"})
ENERGY = frozenset({"speed", "reaction", "loss"})

WELL: frozenset[str] = frozenset()  # the derivation with the slip reads well as it is
NO_INERTIA = frozenset({"inertia"})  # it does from the angular momentum on
NO_FORCES = frozenset({"inertia", "forces"})


# --- studies in which a part of the mechanics was replaced; all else is worked out from it as always


def with_parts(study: Study, **parts: object) -> Study:
    """The same problem, with these parts of `Study` (by the names of its properties) taken as given.

    The parts that are not given are worked out anew from those that are.
    """
    wrong = Study(study.problem)
    for name, part in parts.items():
        kept = name if isinstance(getattr(Study, name), cached_property) else f"_{name}"
        assert isinstance(getattr(Study, kept), cached_property), name
        wrong.__dict__[kept] = part  # a cached property is looked up there first
    return wrong


def with_body(study: Study, name: str, **changes: Any) -> System:
    """The system with the state of one body changed."""
    bodies = {**study.system.bodies, name: replace(study.system.bodies[name], **changes)}
    return replace(study.system, bodies=bodies)


def with_inertia(study: Study, name: str, **changes: Scalar) -> Study:
    """The study with another mass or moment of inertia of a body; the forces stay as they are.

    Where the motion has phases, the statement itself is given another moment, so that all of them have it.
    """
    moment, inertia = changes.get("moment"), study.system.bodies[name].inertia
    if study.problem.phases and len(changes) == 1 and moment and not (inertia.x or inertia.y):
        return restated(study, name, given_moment=present(moment, study.style))
    own = replace(study.system.bodies[name].inertia, **changes)
    return with_parts(study, system=with_body(study, name, inertia=own))


def restated(study: Study, body: str, *, given_moment: Node, mass: Node | None = None) -> Study:
    """The statement, in each phase, with another moment of inertia (and mass) of a body, all else derived anew."""

    def turned(problem: Problem) -> Problem:
        old = problem.body(body)
        own = replace(old, shape=replace(old.shape, given_moment=given_moment), mass=old.mass if mass is None else mass)
        return replace(problem, bodies=tuple(own if b.name == body else b for b in problem.bodies))

    phases = tuple(replace(phase, problem=turned(phase.problem)) for phase in study.problem.phases)
    return Study(replace(turned(study.problem), phases=phases))


def with_forces(study: Study, change: Callable[[Force], Force | None]) -> Study:
    """The study with changed forces (None drops one)."""
    found = (change(force) for force in study.system.forces)
    return with_parts(study, system=replace(study.system, forces=tuple(f for f in found if f is not None)))


def with_force(study: Study, name: str, change: Callable[[Force], Force]) -> Study:
    """The force of this name changed, on each body."""
    return with_forces(study, lambda f: change(f) if f.name == name else f)


def opposite(force: Force) -> Force:
    """The force and its torque with the other sign."""
    return replace(force, vector=-force.vector, couple=-force.couple)


Pick = Callable[[Study], Iterable[Force]]
Wrong = Callable[[Study, Force], Force | None]


def of_forces(pick: Pick, wrong: Wrong, drawn: Callable[[str], Node] = Vec) -> Sites:
    """At each force that is picked the study in which it alone is another one, or none."""

    def sites(study: Study) -> Iterator[Site]:
        for force in pick(study):
            changed = partial(_with_one, study, force, wrong)
            yield Site({"force": drawn(force.name), "body": BodyRef(force.on)}, changed)

    return sites


def _with_one(study: Study, force: Force, wrong: Wrong) -> Study:
    return with_forces(study, lambda f: wrong(study, f) if f is force else f)


def of_elements(
    pick: Callable[[Study], Iterable[Element]], wrong: Callable[[Element], Element], slots: Callable[[Element], Mapping[str, Any]]
) -> Sites:
    """At each element of the statement that is picked the study in which it alone is another one."""
    return lambda study: (Site(slots(e), partial(with_element, study, e, wrong(e))) for e in pick(study))


def without(part: str, pick: Callable[[Study], Iterable[tuple[str, Mapping[str, Any]]]]) -> Sites:
    """At each body that is picked the study in which it has no “moment” (of inertia) or no “mass”; with what else is said."""
    return lambda study: (
        Site({"body": BodyRef(name), **slots}, partial(with_inertia, study, name, **{part: NOTHING}))
        for name, slots in pick(study)
    )


def of_bodies(pick: Callable[[Study], Iterable[tuple[str, Mapping[str, Any]]]]) -> Sites:
    """At each body that is picked another kinematics of it in momenta, energies and works."""
    return lambda study: (
        Site({"body": BodyRef(name)}, partial(with_kinematics, study, with_body(study, name, **changes)))
        for name, changes in pick(study)
    )


def with_kinematics(study: Study, system: System, **more: object) -> Study:
    """Another kinematics of bodies in momenta, energies and works; the true dynamics stays."""
    return with_parts(study, system=system, **{"dynamics": study.dynamics, "squares": study.squares, **more})


def with_reactions(study: Study, found: Mapping[str, Scalar]) -> Study:
    """Other values of the unknown forces; the true motion stays."""
    return with_kinematics(study, study.system, dynamics=replace(study.dynamics, reactions=found))


def with_elements(study: Study, change: Callable[[Element], Element | None]) -> Study:
    """Interactions and constraints of the statement changed (None drops one), all else derived anew."""
    problem = study.problem

    def kept(elements: tuple[Element, ...]) -> tuple[Element, ...]:
        return tuple(filter(None, map(change, elements)))

    return Study(replace(problem, interactions=kept(problem.interactions), constraints=kept(problem.constraints)))


def with_element(study: Study, element: Element, changed: Element | None) -> Study:
    """One element of the statement changed (None: left out), all else derived anew."""
    return with_elements(study, lambda e: changed if e is element else e)


def numbers_of(study: Study) -> dict[str, float]:
    """Sample numbers, to choose the sense of a vector; never for a verdict."""
    numbers = sample(study.problem)
    return numbers | {name: number(value, numbers) for name, value in study.system.dependent.items()}


def sign_of(study: Study, value: Scalar) -> int:
    """Sign of a value at sample numbers, 0 if it is too small to tell or unknown."""
    found = floating(value, numbers_of(study))
    return (found > 1e-9) - (found < -1e-9)


def arms(study: Study) -> dict[str, Vector]:
    """From the fixed axis to the centre of mass, for each body that turns about one."""
    from rbpsym.teaching.targets import axes

    return {name: study.system.bodies[name].center - study.origins[label] for name, (label, _) in axes(study).items()}


def weights(study: Study, body: str | None = None) -> list[Force]:
    """The weights (of one body)."""
    return [f for f in study.system.forces if f.law == "gravity" and body in (None, f.on)]


def spinning(study: Study) -> Iterable[tuple[str, BodyState]]:
    """Bodies that turn and have a moment of inertia."""
    return [(n, s) for n, s in study.system.bodies.items() if s.moment and s.omega and not is_zero(s.omega)]


def is_nonzero(node: Any) -> bool:
    """Whether a tree of a statement has a value that does not vanish identically."""
    return node is not None and not is_zero(scalar(node))
