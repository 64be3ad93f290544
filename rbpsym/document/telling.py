"""Steps as paragraphs and displays: each in its own words, or several under one sentence and one number."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from rbpsym.chapters.methods.newton_euler import EACH_BODY
from rbpsym.document.breaking import lines, table_width
from rbpsym.document.model import Block, Display, Inlines, Math, Paragraph, Table, Text
from rbpsym.document.places import point_name
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.pictures.pose import DrawnPose
from rbpsym.proof.duties import merged
from rbpsym.proof.grounds import Said, is_steady
from rbpsym.proof.step import BodyRef, Derivation, Step, StepRef
from rbpsym.statement.model import PointRef

# --- tables of the notes: the ledger of forces and the works. Every formula is a part of a proved statement


TOO_WIDE = 51.0  # em: a table that is wider could not be read


def forces_table(steps: list[Step], derivation: Derivation, said: Words) -> Table:
    """Each force: the vector, on what and where it acts, by whom, its torque about cm and each origin; where balances are
    taken about other points, their own torques stand in these."""
    origins, is_about = told_origins(derivation, said), not tells_statics(derivation, said)
    header = [said.say(f"header.{key}") for key in ("force", "acts", *(("torque_center",) if is_about else ()))]
    header += [said.say("header.torque_about", point=t.Sym(o)) for o in origins]
    pose = DrawnPose(derivation.study)
    entries = (tuple(_entry(step, origins, pose, said)) for step in steps)
    rows = tuple(entry if is_about else (*entry[:2], *entry[3:]) for entry in entries)
    align = "lp" + "c" * (len(header) - 2)
    caption = said.say("caption.forces" if is_about else "caption.acting")
    return Table(tuple(header), rows, caption, align, said.prefix + "table.forces")


def tells_statics(derivation: Derivation, said: Words) -> bool:
    """Do shown balances of what is at rest name their points?"""
    found = (step for step in derivation.chapter("reactions") if step.phrase.startswith("statics."))
    return not said.is_full and any(step.id in said.shown for step in found)


def told_origins(derivation: Derivation, said: Words) -> list[str]:
    """The fixed points about which torques are told: in full notes all, else those about which a shown step takes them."""
    shown = [step for step in derivation.steps if step.id in said.shown and step.chapter != "forces"]
    names = {name for step in shown for name in t.names(step.statement)}
    return [o for o in derivation.study.origins if said.is_full or any(n.startswith(f"tau_{o}") for n in names)]


def in_one_table(steps: list[Step], derivation: Derivation, said: Words) -> list[Step]:
    """The forces that have room in one table: those with the longest formulas are left out."""

    def width(rows: list[Step]) -> float:
        return table_width(forces_table(rows, derivation, said), said.notation)

    kept = list(steps)
    while len(kept) > 1 and width(kept) > TOO_WIDE:
        kept.remove(max(kept, key=lambda step: width([step])))
    return kept


def long_forces(steps: list[Step], derivation: Derivation, said: Words) -> Iterator[Block]:
    """Forces that have no room in a table, each with the torques that a shown step takes; in full notes with all. Of two that are
    opposite the second is known."""
    shown = [step for step in derivation.steps if step.id in said.shown]
    net = [step for step in shown if step.phrase.startswith("torque.net")]
    taken = [(t.rows(step.statement)[0].items[0].name, [b.name for b in step.slots["bodies"].slots["bodies"]]) for step in net]
    about = {step.id.partition(".")[2] for step in shown if step.rule == "work" or step.phrase in EACH_BODY}
    told: set[t.Node] = set()
    for step in steps:
        body, (vector, *torques) = step.slots["body"].name, t.rows(step.statement)
        rest = "_".join(torques[0].items[0].name.split("_")[2:])
        points = {row: row.items[0].name.removesuffix(f"_{rest}") for row in torques}
        needed = {points[row] for row in torques if any(n.startswith(points[row]) and body in on for n, on in taken)}
        needed |= {"tau_cm"} if about & {body, step.id.partition(".")[2]} else set()
        rows = [row for row in torques if points[row] in needed]
        rows = [*(() if t.neg(vector.items[0]) in told else (vector,)), *rows]
        told.add(vector.items[0])
        rows = list(t.rows(step.statement)) if said.is_full else rows
        yield Display(rows[0] if len(rows) == 1 else t.Relations(tuple(rows)), said.prefix + step.id)


def _entry(step: Step, origins: list[str], pose: DrawnPose, said: Words) -> Iterator[Inlines]:
    rows, by = t.rows(step.statement), step.slots["by"]
    every = list(pose.study.origins)
    torques = rows[-1 - len(every) :]
    yield (Math(rows[0]),) if len(rows) > len(torques) else (Math(step.slots["force"]),)
    kind = "turns" if len(rows) == len(torques) else "acts"
    variant = "many" if len(pose.study.system.bodies) > 1 else "one"
    yield said.say(
        f"forces.{kind}",
        body=said.body(step.slots["body"].name),
        by=said.say(f"party.{by}") if said.has(f"party.{by}") else said.say("plain", text=BodyRef(by)),
        at=_at(step.slots["where"], step.slots["body"].name, pose, said),
        variant=variant,
    )
    yield from ((Math(torques[place].items[-1]),) for place in (0, *(1 + every.index(label) for label in origins)))


def forces_told(steps: list[Step], derivation: Derivation, said: Words) -> list[Inlines]:
    """The forces on the only body with where they act, for a sentence."""
    pose, short = DrawnPose(derivation.study), in_one_table(steps, derivation, said)
    found = []
    for step in steps:
        what, acts, _ = _entry(step, [], pose, said)
        found.append((*(what if step in short else (Math(step.slots["force"]),)), Text(" ("), *acts, Text(")")))
    return found


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


def on_several(derivation: Derivation) -> bool:
    """Whether works are done on more than one body, also such as are zero."""
    bodies = (step.slots.get("body") for step in derivation.steps if step.rule == "work")
    return len({body.name for body in bodies if body is not None}) > 1


def works_table(steps: list[Step], said: Words, *, several: bool) -> Table:
    """Both works of each force as integrals, with unknown forces as symbols; of `several` bodies each says on which it acts."""
    rows = tuple((whose(step, several, said), *_halves(step)) for step in steps)
    align = "pll" if several else "lll"
    return Table(_header(said), rows, said.say("caption.works"), align, said.prefix + "table.works")


def _header(said: Words) -> tuple[Inlines, ...]:
    return tuple(said.say(f"header.{key}") for key in ("force", "translational", "rotational"))


def whose(step: Step, several: bool, said: Words) -> Inlines:
    """A force, and among several bodies on which it acts: it is not its opposite."""
    force = step.slots["force"]
    return said.say("forces.on", force=force, body=step.slots["body"]) if several else (Math(force),)


def _halves(step: Step) -> tuple[Inlines, ...]:
    """The two works with their symbols; a half that there is not is zero."""
    found = {"theta" if row.items[0].name.startswith("cal_W_theta") else "T": row for row in t.rows(step.statement)}
    return tuple(
        (Math(t.equation(found[half].items[0], found[half].items[-1])),) if half in found else (Math(t.ZERO),)
        for half in ("T", "theta")
    )


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
    values = [t.rows(halves[half].statement)[0].items[-1] if half in halves else t.ZERO for half in ("T", "theta")]
    return (whose(step, several, said), *((Math(value),) for value in values))


# ---


MOST_ROWS = 6  # formulas under one number
MOST_LINES = 12
COLUMN = 36.0  # em: about the width of a page


class Teller:
    """Says steps one after the other: what was said before is said shorter, what was shown is referred to."""

    def __init__(self, said: Words) -> None:
        self.said = said
        self.before: set[str] = set()

    def steps(self, steps: Iterable[Step]) -> Iterator[Block]:
        """Sentence and formula in turn."""
        for step in steps:
            yield from self.step(step)

    def step(self, step: Step) -> Iterator[Block]:
        """The sentence of a step and its formula; only a sentence if the formula was shown already."""
        known = self.said.same.get(step.id)
        text = self.sentence(step, f"{step.phrase}_known" if known else step.phrase, **step.slots)
        if text:
            yield Paragraph(text)
        if known is None:
            yield display(step, self.said)
        yield from self.conditions([step])

    def conditions(self, steps: Sequence[Step]) -> Iterator[Block]:
        """As long as what is not implied by the declared signs and ranges the formulas hold."""
        yield from self._owed(steps, (node for step in steps for node in self.said.owed.get(step.id, ())))

    def own_conditions(self, steps: Sequence[Step]) -> Iterator[Block]:
        """The same of what a sentence alone says."""
        duties = (duty for step in steps if step.certificate for duty in step.certificate.verdict.open_obligations)
        yield from self._owed(steps, (duty.relation for duty in duties))

    def _owed(self, steps: Sequence[Step], nodes: Iterable[t.Node]) -> Iterator[Block]:
        if owed := merged(nodes):
            yield Paragraph(self.said.say("obligation.told", conditions=list(owed), count=len(steps)))

    def sentence(self, step: Step, key: str, **slots: Any) -> Inlines:
        """What is said before a step, in the variant for a second time if there is one."""
        found = known_key(key, self.said)
        if found is None:
            return ()
        if self.said.has(f"{found}_unseen") and any(self.said.are_unseen(value) for value in slots.values()):
            found = f"{found}_unseen"
        again = f"{found}_again"
        chosen = again if found in self.before and self.said.has(again) else found
        self.before.add(found)
        known = self.said.same.get(step.id)
        slots |= {"first": StepRef(known)} if known else {}
        text = self.said.say(chosen, **slots)
        return text if any(not isinstance(i, Text) or i.text.strip() for i in text) else ()

    def together(self, steps: Sequence[Step], key: str, **slots: object) -> Iterator[Block]:
        """Steps of one kind under one sentence and one number; a single one in its own words."""
        if len(steps) < 2:
            yield from self.steps(steps)
            return
        yield Paragraph(self.said.say(key, ground=Said(steps=steps), count=len(steps), **slots))
        yield from (joined(group, self.said) for group in _in_groups(steps, self.said))
        yield from self.conditions(steps)


def known_key(key: str, said: Words) -> str | None:
    """The key, or that of “other” of its kind; None where nothing is said."""
    if said.has(key):
        return key
    other = key.rsplit(".", 1)[0] + ".other"
    return other if said.has(other) else None


def display(step: Step, said: Words) -> Display:
    """The formula of a step, numbered, boxed if it is a result."""
    return Display(step.statement, said.prefix + step.id, True, step.is_result)


def _in_groups(steps: Sequence[Step], said: Words) -> list[list[Step]]:
    """The steps in their order, as many under one number as have room there."""
    groups: list[list[Step]] = []
    for step in steps:
        group = [*groups[-1], step] if groups else []
        if group and len(group) <= MOST_ROWS and sum(len(lines(s.statement, said.notation, COLUMN)) for s in group) <= MOST_LINES:
            groups[-1] = group
        else:
            groups.append([step])
    return groups


def joined(steps: Sequence[Step], said: Words) -> Display:
    """The formulas of several steps below each other, with one number."""
    rows = tuple(row for step in steps for row in t.rows(step.statement))
    first, *others = (said.prefix + step.id for step in steps)
    return Display(t.Relations(rows), first, True, all(step.is_result for step in steps), also=tuple(others))


def by_kind(steps: Iterable[Step], kinds: Sequence[str]) -> list[list[Step]]:
    """The steps in groups whose phrases begin with these, in this order; all others before."""
    groups: list[list[Step]] = [[] for _ in range(len(kinds) + 1)]
    for step in steps:
        found = (k for k, kind in enumerate(kinds, 1) if f"{step.phrase}.".startswith(f"{kind}."))
        place = next(found, 0)
        groups[place].append(step)
    return groups


def is_constant(step: Step, derivation: Derivation) -> bool:
    """Is a force the same all along the motion?"""
    return is_steady(Said(derivation.study, step))
