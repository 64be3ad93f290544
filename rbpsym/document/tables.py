"""Tables of the notes: the ledger of forces and the works. Every formula is a part of a proved statement."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rbpsym.derivation.step import BodyRef, Derivation, Step
from rbpsym.document.model import Block, Inlines, Math, Paragraph, Table
from rbpsym.document.words import Words
from rbpsym.notation import tree as t


def _rows(step: Step) -> tuple[t.Chain, ...]:
    """The relations of a step's statement."""
    return step.statement.rows if isinstance(step.statement, t.System) else (step.statement,)


def forces_table(steps: list[Step], derivation: Derivation, said: Words) -> Table:
    """Force, body, by whom, vector, torque about the centre of mass and about each origin."""
    origins = list(derivation.study.origins)
    header = (said.say("header.force"), said.say("header.on"), said.say("header.by"), said.say("header.vector"),
              said.say("header.torque_center"), *(said.say("header.torque_about", point=t.Sym(o)) for o in origins))
    rows = tuple(_entry(step, len(origins), said) for step in steps)
    return Table(header, rows, said.say("caption.forces"), "lllc" + "c" * (1 + len(origins)), said.prefix + "table.forces")


def _entry(step: Step, origins: int, said: Words) -> tuple[Inlines, ...]:
    rows = _rows(step)
    torques = rows[-1 - origins :]
    vector = (Math(rows[0].items[1]),) if len(rows) > 1 + origins else (Math(t.ZERO),)
    return ((Math(step.slots["force"]),), _body(step.slots["body"].name, said), _by(step.slots["by"], said), vector,
            *((Math(row.items[1]),) for row in torques))


def _body(name: str, said: Words) -> Inlines:
    return said.say("plain", text=said.body(name))


def _by(name: str, said: Words) -> Inlines:
    return said.say(f"forces.{name}") if name in ("earth", "ground", "agent") else said.say("it", body=BodyRef(name))


Sayer = Callable[[Step, Words], Iterator[Block]]


def works_blocks(steps: list[Step], said: Words, say: Sayer) -> Iterator[Block]:
    """The works as symbols, what cancels, the theorem in its halves, then the works carried out."""
    kinds = {kind: [s for s in steps if s.rule == kind] for kind in ("work", "workless", "work_energy", "work_done", "solution")}
    if kinds["work"]:
        yield Paragraph(said.say("work.intro"))
        yield _integrals(kinds["work"], said)
    for step in kinds["workless"]:
        yield from say(step, said)
    if kinds["work_energy"]:
        yield Paragraph(said.say("work.theorem.intro"))
        for step in kinds["work_energy"]:
            yield from say(step, said)
    for step in kinds["solution"]:
        yield from say(step, said)
    if kinds["work_done"]:
        yield Paragraph(said.say("work.done_intro"))
        yield _done(kinds["work_done"], said)


def _integrals(steps: list[Step], said: Words) -> Table:
    header = tuple(said.say(f"header.{key}") for key in ("force", "on", "translational", "rotational"))
    rows = tuple(_integral_row(step, said) for step in steps)
    return Table(header, rows, said.say("caption.works"), "llll", said.prefix + "table.works")


def _integral_row(step: Step, said: Words) -> tuple[Inlines, ...]:
    halves = {_half(row): row for row in _rows(step)}
    cells = [_cell(halves[half].items[0], halves[half].items[-1]) if half in halves else _nothing() for half in ("T", "theta")]
    return ((Math(step.slots["force"]),), _body(step.slots["body"].name, said), *cells)


def _half(row: t.Chain) -> str:
    """T or theta, from the name of the work."""
    return "theta" if row.items[0].name.startswith("cal_W_theta") else "T"


def _cell(letter: t.Node, value: t.Node) -> Inlines:
    return (Math(t.equation(letter, value)),)


def _nothing() -> Inlines:
    return (Math(t.ZERO),)


def _done(steps: list[Step], said: Words) -> Table:
    """The works that could be worked out, force by force."""
    found: dict[str, dict[str, Step]] = {}
    for step in steps:
        _, half, rest = step.id.split(".", 2)
        found.setdefault(rest, {})[half] = step
    header = tuple(said.say(f"header.{key}") for key in ("force", "on", "translational", "rotational"))
    return Table(header, tuple(_done_row(halves, said) for halves in found.values()), said.say("caption.done"), "llll",
                 said.prefix + "table.done")


def _done_row(halves: dict[str, Step], said: Words) -> tuple[Inlines, ...]:
    step = next(iter(halves.values()))
    cells = [(Math(halves[half].statement.items[-1]),) if half in halves else _nothing() for half in ("T", "theta")]
    return ((Math(step.slots["force"]),), _body(step.slots["body"].name, said), *cells)
