"""What a derivation starts from and no step has made: laws, starts, ranges, definitions.

A fact has an id as a step has one, and stands among the premises of the steps that need it.

* `law.force.BODY`, `law.torque.BODY`: Newton's and Euler's equations of one body;
* `law.motion`: these of all bodies together, with the conditions of the constraints, and what they make of the
  accelerations and of the unknown forces;
* `law.blow.BODY`: how a blow changes momentum and spin of one body; `law.parting.IMPULSE`: how fast what collides or
  bounces parts along an impulse; `law.tied`: what ties the speeds just after;
* `start.q`: where a coordinate starts and how fast;
* `range.q`: the range that is declared for it;
* `shape.BODY`: how the mass of a body is spread about its centre of mass;
* `def.X`: what the letter X stands for, where no step has introduced it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rbpsym.field import Scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study

MOTION = "law.motion"
PARTS = {"force": ("x", "y"), "torque": ("rotation",)}


class Fact(Frozen):
    """kind: "law", "start", "range", "shape" or "def"; subject: the body, coordinate or letter; rows: values that vanish."""

    id: str
    kind: str
    subject: str
    rows: tuple[Scalar, ...] = ()


def facts_of(study: Study) -> Mapping[str, Fact]:
    """All facts of a problem but the definitions, by id."""
    return {fact.id: fact for fact in _facts(study)}


def _facts(study: Study) -> Iterator[Fact]:
    yield Fact(MOTION, "law", "")
    for body in study.system.bodies:
        yield Fact(f"shape.{body}", "shape", body)
        for part in PARTS:
            yield Fact(f"law.{part}.{body}", "law", body)
    for coordinate in study.problem.coordinates:
        yield Fact(f"start.{coordinate.name}", "start", coordinate.name)
    for name in study.assumptions.ranges:
        yield Fact(f"range.{name}", "range", name)


def definition(letter: str) -> Fact:
    """The fact that says what a letter stands for."""
    return Fact(f"def.{letter}", "def", letter)


def law_rows(study: Study, fact: Fact) -> list[Scalar]:
    """M A - F, or I α - τ_cm, of one body; what a law of an instant says by itself."""
    if fact.rows:
        return list(fact.rows)
    part = fact.id.split(".")[1]
    return [row for body, axis, row in study.labelled_rows if body == fact.subject and axis in PARTS[part]]
