"""Which feedback asserts something of the system beside what the student did, and what decides that it is true there.

All others say what was done (a test names them). What is not true at a place is no place for it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from rbpsym.field import NOTHING, Scalar, depends_on, is_zero
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.study import Study
from rbpsym.teaching.misconceptions.model import Site
from rbpsym.teaching.target import Target

Condition = Callable[[Study, Site], bool]


def powers(study: Study, name: str) -> dict[str, tuple[Scalar, Scalar]]:
    """By body on which a force acts: its power along the path of the centre of mass, and that of its torque about it."""
    found: dict[str, tuple[Scalar, Scalar]] = {}
    for force in study.system.named(name):
        state, (along, turning) = study.system.bodies[force.on], found.get(force.on, (NOTHING, NOTHING))
        found[force.on] = (along + force.vector.dot(state.velocity), turning + torque_about_center(force, state) * state.omega)
    return found


def are_opposite(study: Study, name: str) -> bool:
    """Whether a force acts on one body, and does two works there that cancel, neither of which is zero."""
    pairs = list(powers(study, name).values())
    return len(pairs) == 1 and is_zero(sum(pairs[0], NOTHING)) and not is_zero(pairs[0][0])


def cancel_among_bodies(study: Study, name: str) -> bool:
    """Whether the works of a force on several bodies cancel, and are not all zero."""
    works = [power for pair in powers(study, name).values() for power in pair]
    return len(works) > 2 and is_zero(sum(works, NOTHING)) and not all(map(is_zero, works))


def _works_cancel(study: Study, site: Site) -> bool:
    return {"one": are_opposite, "several": cancel_among_bodies}[site.slots["variant"]](study, site.slots["force"].name)


def _works_do_not_cancel(study: Study, site: Site) -> bool:
    return not any(is_zero(sum(pair, NOTHING)) for pair in powers(study, site.slots["force"].name).values())


def _path_is_curved(study: Study, site: Site) -> bool:
    """The centre of mass of a body has an acceleration with squares of speeds."""
    parts = [part for state in study.system.bodies.values() for part in (state.acceleration.x, state.acceleration.y)]
    return any(depends_on(part, speed) for part in parts for speed in study.system.speeds)


def _acceleration_changes(study: Study, site: Site) -> bool:
    name = site.slots["coordinate"].name
    push = (study.dynamics.accelerations or {}).get(f"{name}_ddot", NOTHING)
    return any(depends_on(push, key) for key in (name, f"{name}_dot"))


TRUE_OF: Mapping[str, Condition] = {
    "contact-forces-do-no-work": _works_cancel,
    "works-add-up": lambda study, site: are_opposite(study, site.slots["force"].name),
    "works-always-cancel": _works_do_not_cancel,
    "static-friction-drains-energy": lambda study, site: are_opposite(study, site.slots["friction"].name),
    "centripetal-forgotten": _path_is_curved,
    "centripetal-outward": _path_is_curved,
    "instantaneous-center-for-accelerations": _path_is_curved,
    "uniform-acceleration-formula": _acceleration_changes,
}


ASKED_OF: Mapping[str, tuple[str, ...]] = {  # a sum, no single body; what comes of a start, no start that is asked for
    "one-body-not-in-the-sum": ("momentum.total", "kinetic", "question"),
    "start-speed-forgotten": ("speed", "reaction", "loss", "question"),
}


OF_BLOWS = ("momentum-kept-at-hinge", "struck-at-center-of-mass")  # worked out with a moment that holds in the blow alone
SPEED_AFTER = re.compile(r"[\w ]*(?:speed|velocity) of [\w. ]+ when [\w -]+ begins|start\.\w+_dot")


def is_asked_of(name: str, target: Target) -> bool:
    """Whether the feedback of a misconception speaks of a target; that on blows of a speed right after."""
    question = target.slots.get("question")
    if name in OF_BLOWS and not SPEED_AFTER.fullmatch(question.text if question else target.id):
        return False
    return target.id.startswith(ASKED_OF.get(name, ""))


def is_true(name: str, study: Study, site: Site) -> bool:
    """Whether the feedback of a misconception is true of this place in the system."""
    condition = TRUE_OF.get(name)
    return condition is None or condition(study, site)
