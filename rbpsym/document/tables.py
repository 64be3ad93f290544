"""Tables of the notes: the ledger of forces and the works. Every formula is a part of a proved statement."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import BodyRef, Derivation, Step
from rbpsym.document.breaking import table_width
from rbpsym.document.model import Inlines, Math, Table
from rbpsym.document.places import point_name
from rbpsym.document.pose import DrawnPose
from rbpsym.document.words import Words
from rbpsym.notation import tree as t
from rbpsym.statement.model import PointRef

TOO_WIDE = 51.0  # em: a table that is wider could not be read
PARTIES = ("earth", "ground", "agent", "string", "link", "spring", "damper")


def relations(step: Step) -> tuple[t.Chain, ...]:
    """The relations of a step's statement."""
    return step.statement.rows if isinstance(step.statement, t.System) else (step.statement,)


def forces_table(steps: list[Step], derivation: Derivation, said: Words) -> Table:
    """Each force: the vector, on what and where it acts, by whom, its torque about cm and each origin."""
    origins = list(derivation.study.origins)
    header = [said.say(f"header.{key}") for key in ("force", "acts", "torque_center")]
    header += [said.say("header.torque_about", point=t.Sym(o)) for o in origins]
    pose = DrawnPose(derivation.study)
    rows = tuple(tuple(_entry(step, origins, pose, said)) for step in steps)
    return Table(
        tuple(header), rows, said.say("caption.forces"), "lp" + "c" * (1 + len(origins)), said.prefix + "table.forces"
    )


def in_one_table(steps: list[Step], derivation: Derivation, said: Words) -> list[Step]:
    """The forces that have room in one table: those with the longest formulas are left out."""

    def width(rows: list[Step]) -> float:
        return table_width(forces_table(rows, derivation, said), said.notation)

    kept = list(steps)
    while len(kept) > 1 and width(kept) > TOO_WIDE:
        kept.remove(max(kept, key=lambda step: width([step])))
    return kept


def _entry(step: Step, origins: list[str], pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    rows = relations(step)
    torques = rows[-1 - len(origins) :]
    yield (Math(rows[0]),) if len(rows) > len(torques) else (Math(step.slots["force"]),)
    kind = "couple" if len(rows) == len(torques) else "acts"
    variant = "many" if len(pose.study.system.bodies) > 1 else "one"
    yield said.say(
        f"forces.{kind}",
        body=said.body(step.slots["body"].name),
        by=_by(step.slots["by"], said),
        at=_at(step.slots["where"], step.slots["body"].name, pose, said),
        variant=variant,
    )
    yield from ((Math(row.items[-1]),) for row in torques)


def _by(name: str, said: Words) -> Inlines:
    return said.say(f"forces.{name}") if name in PARTIES else said.say("plain", text=BodyRef(name))


def _at(label: str, on: str, pose: DrawnPose, said: Words) -> Inlines:
    """Where the force acts on a body, in a word: what touches there may be named by a point of the other body."""
    body, _, point = label.partition(".")
    if label in ("rim", "wound"):
        return said.say(f"point.{label}")
    names = pose.study.problem.body_names
    if label in names or (body in names and body != on):
        return said.say("point.contact")
    known = body in names and (point == "cm" or point in pose.study.problem.body(body).points)
    return point_name(PointRef(label, body, point), pose, said) if known else said.say("plain", text=label)


def works_table(steps: list[Step], said: Words) -> Table:
    """Both works of each force as integrals, with unknown forces as symbols."""
    several = len({step.slots["body"].name for step in steps}) > 1
    rows = tuple((_whose(step, several, said), *_halves(step)) for step in steps)
    align = "pll" if several else "lll"
    return Table(_header(said), rows, said.say("caption.works"), align, said.prefix + "table.works")


def _header(said: Words) -> tuple[Inlines, ...]:
    return tuple(said.say(f"header.{key}") for key in ("force", "translational", "rotational"))


def _whose(step: Step, several: bool, said: Words) -> Inlines:
    force = step.slots["force"]
    return said.say("forces.on", force=force, body=step.slots["body"]) if several else (Math(force),)


def _halves(step: Step) -> tuple[Inlines, ...]:
    """The two works with their symbols; a half that there is not is zero."""
    found = {_half(row): row for row in relations(step)}
    return tuple(
        (Math(t.equation(found[half].items[0], found[half].items[-1])),) if half in found else (Math(t.ZERO),)
        for half in ("T", "theta")
    )


def _half(row: t.Chain) -> str:
    """T or theta, from the name of the work."""
    return "theta" if row.items[0].name.startswith("cal_W_theta") else "T"


def done_table(steps: list[Step], said: Words) -> Table:
    """The works that could be worked out, force by force."""
    found: dict[str, dict[str, Step]] = {}
    for step in steps:
        _, half, rest = step.id.split(".", 2)
        found.setdefault(rest, {})[half] = step
    several = len({step.slots["body"].name for step in steps}) > 1
    rows = tuple(_done_row(halves, several, said) for halves in found.values())
    return Table(_header(said), rows, said.say("caption.done"), "pll" if several else "lll", said.prefix + "table.done")


def _done_row(halves: dict[str, Step], several: bool, said: Words) -> tuple[Inlines, ...]:
    step = next(iter(halves.values()))
    values = [halves[half].statement.items[-1] if half in halves else t.ZERO for half in ("T", "theta")]
    return (_whose(step, several, said), *((Math(value),) for value in values))
