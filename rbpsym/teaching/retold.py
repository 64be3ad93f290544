"""A derivation with the physics of a misconception: the first step that it spoils, and how the chapters then read."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from rbpsym.chapters.methods.registry import METHODS
from rbpsym.derive import AFTER, BEFORE
from rbpsym.errors import RbpsymError
from rbpsym.field import NOTHING, Scalar, Vector, at_most, is_zero
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.study import Study
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import Derivation, Step
from rbpsym.teaching.targets import axes, momentum

MOST_PRODUCTS = 400_000  # for one chapter; what grows beyond is no line of a student's paper
Write = Callable[[Draft], object]


class Retelling:
    """The steps of a wrong study by id, chapter by chapter, as far as they are asked for.

    A chapter that the wrong physics has no answer to ends where it fails. No step has a certificate: it is wrong.
    """

    def __init__(self, wrong: Study) -> None:
        self._draft = _Unchecked(wrong)
        self._waiting: Iterator[Write] = iter((*BEFORE, *METHODS.values(), *AFTER))

    def steps(self, ids: Iterable[str]) -> tuple[Step, ...] | None:
        """The steps with these ids; None if the wrong derivation lacks one."""
        wanted = tuple(ids)
        while not all(map(self._draft.has, wanted)):
            write = next(self._waiting, None)
            if write is None:
                return None
            with suppress(RbpsymError, KeyError, ZeroDivisionError), at_most(MOST_PRODUCTS):  # KeyError: it has no such premise
                write(self._draft)
        known = {step.id: step for step in self._draft.steps}
        return tuple(known[id] for id in wanted)


class _Unchecked(Draft):
    def certified(self, step: Step, named: tuple[str, ...]) -> Step:
        """The step as it is, with what its author names."""
        return replace(step, cites=named)


# --- the first step of a derivation that a misconception spoils: what the step states has another value in the wrong study
# Each kind of step is probed for the values that it states; no step is written anew.


Probe = Callable[[Study, str], Iterable[Scalar | None]]


def first_wrong(derivation: Derivation, wrong: Study, about: frozenset[str]) -> str:
    """The id of that step; "" if no step that is probed differs.

    Steps about kinds of quantities that the misconception is not `about` are passed over.
    """
    for step in (step for step in derivation.steps if step.chapter != "phase"):  # not how a later phase begins
        head, _, rest = step.id.partition(".")
        is_meant = head not in ONLY_IF_ABOUT or bool(ONLY_IF_ABOUT[head] & about)
        if head in PROBES and is_meant and _differs(derivation.study, wrong, PROBES[head], rest):
            return step.id
    return ""


# what is read off a state that a slip may have bent for other ends
ONLY_IF_ABOUT: Mapping[str, frozenset[str]] = {
    "moment": frozenset({"moment", "axis-moment"}),
    "momentum": frozenset({"momentum"}),
    "work": frozenset({"work"}),
    "kinetic": frozenset({"kinetic"}),
}


def _differs(right: Study, wrong: Study, probe: Probe, rest: str) -> bool:
    try:
        ours, theirs = list(probe(right, rest)), list(probe(wrong, rest))
    except (RbpsymError, LookupError, StopIteration, ZeroDivisionError):
        return True  # the wrong physics has no such step
    if len(ours) != len(theirs):
        return True
    pairs = zip(ours, theirs, strict=True)
    return any((a is None) != (b is None) or (a is not None and b is not None and not is_zero(a - b)) for a, b in pairs)


def _vector(vector: Vector) -> tuple[Scalar, Scalar]:
    return vector.x, vector.y


def _moment(study: Study, rest: str) -> Iterable[Scalar]:
    body, _, point = rest.partition(".")
    state = study.system.bodies[body]
    if point and body in axes(study):
        return (state.moment + state.mass * axes(study)[body][1],)
    return (state.moment,)


def _force(study: Study, rest: str) -> Iterable[Scalar]:
    name, _, body = rest.rpartition(".")
    state = study.system.bodies[body]
    own = [f for f in study.system.on(body) if f.name == name]
    push = sum((f.vector for f in own), Vector({}))
    return (*_vector(push), sum((torque_about_center(f, state) for f in own), NOTHING))


def _momentum(study: Study, rest: str) -> Iterable[Scalar]:
    body, _, _ = rest.rpartition(".")
    return (momentum(study, tuple(study.system.bodies) if body == "total" else (body,)),)


def _work(study: Study, rest: str) -> Iterable[Scalar | None]:
    force, _, body = rest.rpartition(".")
    item = next(w for w in study.works if (w.force, w.on) == (force, body))
    return (item.translational.value, item.rotational.value)


def _newton(study: Study, rest: str) -> Iterable[Scalar]:
    """Mass, acceleration and α of the body, and what the unknown forces become."""
    state = study.system.bodies[rest]
    return (state.mass, *_vector(state.acceleration), state.alpha, *study.dynamics.reactions.values())


PROBES: Mapping[str, Probe] = {
    "position": lambda study, body: _vector(study.system.bodies[body].center),
    "velocity": lambda study, body: _vector(study.system.bodies[body].velocity),
    "turning": lambda study, body: (study.system.bodies[body].omega,),
    "moment": _moment,
    "momentum": _momentum,
    "force": _force,
    "kinetic": lambda study, _: study.kinetic,
    "motion": lambda study, name: ((study.dynamics.accelerations or {}).get(f"{name}_ddot"),),
    "free_body": _newton,
    "reaction": lambda study, name: (study.dynamics.reactions[name],),
    "work": _work,
    "square": lambda study, name: (study.squares[name],),
    "along": lambda study, name: ((study.reactions_along_motion or {}).get(name),),
    "frequency": lambda study, place: study.equilibria[int(place) - 1].frequencies_squared,
}
