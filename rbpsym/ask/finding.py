"""What was found for a question about parameters: values or a region, with what it rests on."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from rbpsym.ask.asked import Asked
from rbpsym.ask.found import Found
from rbpsym.chapters.impulses import hand_over
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.verdict import Verdict, all_of, undecided
from rbpsym.errors import there
from rbpsym.expr.tree import ZERO, Node
from rbpsym.field import Scalar, names_in
from rbpsym.frozen import Frozen
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.study import Study
from rbpsym.proof.checks.of_steps import guarded, weakest
from rbpsym.proof.context import Context
from rbpsym.proof.rules import RULES
from rbpsym.proof.step import Derivation, Step, StepRef
from rbpsym.statement.model import Problem


class Finding(Frozen):
    """symbol: what was asked for ("" for a plain value). values: of it, each with what it asks for beyond `valid`.

    relation: how the symbol stands to the one value: "=", "<", ">", "<=", ">=", "between" two, or "approaches". says: a
    sentence instead of a value, or beside it. equation: what vanishes at the symbol where it has no closed form. place: where
    an extremum lies, (name, place). holds: yes or no. met: what the moments
    ask for stands in `valid` already. grounds: how it was checked, rules of derivations with their data, the first of which
    see what is stated; parted: each value is stated by its own ground; form: how it is made of other quantities; steps: of a
    chapter, the last of which says it. Without a verdict, it is what these find; without any of them, nothing is proved.
    """

    verdict: Verdict | None = None
    symbol: str = ""
    values: tuple[Scalar, ...] = ()
    relation: str = "="
    valid: tuple[Demand, ...] = ()
    asked: tuple[tuple[Demand, ...], ...] = ()
    says: str = ""
    equation: Scalar | None = None
    place: tuple[str, Scalar | None] | None = None
    holds: bool | None = None
    met: bool = False
    grounds: tuple[tuple[str, Mapping[str, Any]], ...] = ()
    parted: bool = False
    form: Node | None = None
    steps: tuple[Step, ...] = ()

    @property
    def rule(self) -> str:
        """The rule that sees what is stated; "" without one."""
        return self.grounds[0][0] if self.grounds else ""

    @property
    def is_none(self) -> bool:
        """Whether no value of the symbol does."""
        return not self.values and any(said in self.says for said in (NO_SUCH, FOR_NONE))


NO_SUCH, FOR_NONE, FOR_EVERY = "there is no such", "holds for no values", "holds for all values"


NOWHERE = Study(Problem("", {}, (), (), ()))  # for checks that look at their data alone


def checked(rule: str, study: Study = NOWHERE, /, **data: Any) -> dict[str, Any]:
    """The verdict of the checks of a rule, with the rule and its data, as parts of a finding."""
    context = Context(study)
    verdict = weakest(guarded(partial(check, context, ground((rule, data)))) for check in RULES[rule])
    return {"verdict": verdict, "grounds": ((rule, data),)}


def kept_said(
    values: Iterable[Scalar], along: str | None, places: Sequence[Scalar | None], given: Assumptions, *, holds: bool
) -> dict[str, Any]:
    """That all values are nowhere negative, or that one of them is negative at one of the places, checked."""
    parts = tuple((value, place, value) for value in values for place in places or (None,))
    return checked("least_on_way", parts=parts, along=along, given=given, holds=holds)


def ground(of: tuple[str, Mapping[str, Any]], statement: Node = ZERO) -> Step:
    """A rule and its data as a step."""
    said = "divides" if of[0] == "holds_for" and of[1].get("opposite") else of[0]
    return Step("answer", of[0], statement, "ask", f"ask.found.{said}", data=of[1])


def together(*parts: Finding) -> dict[str, Any]:
    """What checked several findings, as parts of one."""
    return {"verdict": all_of(there(one.verdict) for one in parts), "grounds": tuple(g for one in parts for g in one.grounds)}


Data = Mapping[str, Any]
Decided = Callable[[Data], bool]
Row = Mapping[str, Decided]  # a rule -> whether its data decide it

QUOTED, OF_IT, NAME = re.compile("“[^”]*”"), r"[^;]+", r"(?P<name>\w+)"


def _itself(data: Data) -> bool:
    """The rule decides what is said, of the very name."""
    return True


def _stable(way: bool) -> Decided:
    """Whether what is proved of a place is what was asked for, or the opposite."""
    return lambda data: data["proved"] != "open" and ((data["proved"] != "unstable") is not data["opposite"]) is way


def _vanishes(data: Data) -> bool:
    """What has to be positive, or to be passed, is zero there."""
    return not data["names"] and data["best"].number() == 0


def _one_sided(side: int) -> Decided:
    """There is a bound on this side (1: the lower one) alone, as the sentence says."""
    return lambda data: data["ends"][side] is not None and data["ends"][-side] is None and not data.get("opposite")


def _holds(way: bool) -> Decided:
    """What holds on the whole way, or is violated there; of the opposite the other way round."""
    return lambda data: data["holds"] is (way is not data.get("opposite", False))


def _hangs(opposite: bool) -> Decided:
    """What holds where its conditions do."""
    return lambda data: data["holds"] is None and data.get("opposite", False) is opposite


def _kept(way: bool) -> Decided:
    return lambda data: data["kept"] is way


FOR_ALL: Row = {"least_on_way": _holds(True), "no_change": lambda data: data["best"].number() == 0}
FOR_NO: Row = {"least_on_way": _holds(False), "vanishes_for": lambda data: not data["places"]}
GROWS: Row = {"limit": lambda data: data["order"] < 0}
GOES: Row = {"limit": lambda data: data["order"] > 0}
BEYOND: Row = {"no_change": _vanishes}

SAID: Mapping[str, Row] = {
    "yes": {"least_on_way": _holds(True), "equilibrium": _stable(True), "vanishing": lambda data: not data["open"]},
    "no": {"least_on_way": _holds(False), "equilibrium": _stable(False), "stays": lambda data: not data["until"]},
    "yes where this is met(, else no)?": {"least_on_way": _hangs(False), "vanishing": lambda data: data["open"]},
    "no where this is met(, else yes)?": {"least_on_way": _hangs(True)},
    f"((yes|no): )?“…” does not depend on {NAME}": {"no_change": _itself},
    f"(yes|no): “…” depends on {NAME}": {"changes": _itself},
    "(yes|no): “…” is conserved": {"kept_or_not": _kept(True)},
    "(yes|no): “…” changes": {"kept_or_not": _kept(False)},
    f"{NO_SUCH} {NAME}: “…” holds for none in its range": FOR_NO,
    f"(else )?“…” holds for every {OF_IT}|“…” holds for all values {OF_IT}": FOR_ALL,
    f"else {NO_SUCH} {OF_IT}": FOR_NO,
    f"“…” {FOR_NONE} {OF_IT}": FOR_NO,
    f"{NAME} is the only zero of this in its range": {"one_zero": _itself},
    f"every smaller {NAME} does: it holds for {OF_IT} < {OF_IT}": {"holds_for": _one_sided(-1)},
    f"every larger {NAME} does: it holds for {OF_IT} > {OF_IT}": {"holds_for": _one_sided(1)},
    f"every such {NAME} does": {rule: lambda data: bool(data.get("opposite")) for rule in ("holds_for", "one_zero")},
    f"at this {OF_IT} itself it does not hold": BEYOND,
    f"with this {OF_IT} itself, {OF_IT} is approached and never reached": {"approached": _itself},
    f"else “…” holds for {NAME} < {OF_IT}": {"holds_for": _one_sided(-1)},
    f"else “…” holds for {NAME} > {OF_IT}": {"holds_for": _one_sided(1)},
    f"as {OF_IT} grows": dict.fromkeys(("holds_for", "extreme", "least_on_way", "one_zero"), _itself),
    f"“…” holds for {NAME} [<>] {OF_IT}, too": {"least_on_way": _holds(True)},
    "beyond it the motion is not the one that is stated|there a contact is lost|there it slips": BEYOND,
    f"no (largest|least) value is reached: {OF_IT} is approached as {OF_IT}": {"extreme": lambda data: bool(data["at_end"])},
    f"there is none: “…” has no bound as {OF_IT}": GROWS,
    "“…” grows beyond all bounds, as this": GROWS,
    f"the limit is 0|“…” vanishes as {OF_IT}": GOES,
    f"“…” is the same for every {NAME}": {"no_change": _itself},
    f"only {OF_IT} has the same": {"vanishes_for": lambda data: len(data["places"]) == 1},
    "“…” is negative: its magnitude is meant": {"least_on_way": lambda data: data["holds"] is True},
}


def doubts(found: Finding) -> Iterator[Verdict]:
    """UNDECIDED for each clause of what is said beside the values that no rule decides; "yes" is said of what holds."""
    grounds = [*found.grounds, *((step.rule, step.data) for step in found.steps[-1:])]
    says = QUOTED.sub("“…”", found.says)
    clauses = [clause for clause in says.split("; ") if clause and not _is_told(clause, grounds)]
    if found.holds is not None and re.match("(yes|no)\\b", says) and says.startswith("yes") is not found.holds:
        clauses.append(says)
    yield from (undecided(f"no rule says “{clause}”") for clause in clauses)


def _is_told(clause: str, grounds: list[tuple[str, Data]]) -> bool:
    found, row = next(((said, row) for words, row in SAID.items() if (said := re.fullmatch(words, clause))), (None, {}))
    name = found and found.groupdict().get("name")
    return any(row[rule](data) and _is_of(name, data) for rule, data in grounds if rule in row)


def _is_of(name: str | None, data: Data) -> bool:
    """Whether it is the name in the clause of which the rule tells, if it tells of one."""
    known = data.get("names", (data["name"],) if "name" in data else None)
    return name is None or known is None or name in known


# what a phase begins with, by the ids of the steps that say so: the first of each row that was made
BEGINS = (("moment", "place"), ("state.place",), ("after.speeds", "state.speed"))


def before(asked: Asked, place: int, found: Found) -> tuple[tuple[str, ...], tuple[Step, ...], list[Derivation]]:
    """The steps by which the phases up to this one begin, as far as the value rests on them or they ask for something; the
    ids of those that say with what this one begins; and the steps with their letters. An id says which phase begins."""
    begun: tuple[str, ...] = ()
    each: list[Derivation] = []
    steps: list[Step] = []
    for k, phase in enumerate(asked.problem.phases[:place], 1):
        draft = hand_over(k, phase, asked.stage(k - 1), asked.stage(k))
        made = {step.id: step for step in draft.steps}
        said = [next((id for id in row if id in made), "") for row in BEGINS]
        ends = [*filter(None, said if k < place else _used(found, said))]
        kept = needed([*made.values()], *ends, *(id for id, step in made.items() if step.obligations))
        names = {id: f"phase{k + 1}.{id}" for id in made}
        each.append(Derivation(draft.study, kept, letters=draft.context))
        steps += [resting_on(begun, _renamed(step, names)) for step in kept]
        begun = tuple(names[id] for id in ends)
    return begun, tuple(steps), each


def resting_on(begun: tuple[str, ...], step: Step) -> Step:
    """The step with the steps that say how its phase begins, if it is about this."""
    is_about = step.id == "answer" or any(id.startswith("start.") for id in step.premises) or step.rule == "end_state"
    return replace(step, cites=(*step.cites, *begun)) if is_about else step


def _renamed(step: Step, names: Mapping[str, str]) -> Step:
    premises, cites = (tuple(names.get(id, id) for id in ids) for ids in (step.premises, step.cites))
    slots = {slot: _mentioned(value, names) for slot, value in step.slots.items()}
    return replace(step, id=names[step.id], premises=premises, cites=cites, slots=slots)


def _mentioned(value: Any, names: Mapping[str, str]) -> Any:
    """What a slot of a phrase holds, with the new names of the steps that it mentions."""
    if isinstance(value, list):
        return [_mentioned(one, names) for one in value]
    return StepRef(names.get(value.id, value.id)) if isinstance(value, StepRef) else value


def _used(found: Found, said: Sequence[str]) -> list[str]:
    """Of what is said of the time, the places and the speeds with which a phase begins, that on which the value rests."""
    if found.moment is None or found.moment.how != "start" or found.study.at_start or found.works or found.told:
        return [*said]
    system = found.study.system
    names = {name for value in found.named for name in names_in(found.study.on_motion(value))}
    kinds = ({"t"}, {*system.coordinates}, {f"{name}_dot" for name in system.coordinates})
    return [id for id, kind in zip(said, kinds, strict=True) if names & kind]


def needed(steps: list[Step], *ends: str) -> tuple[Step, ...]:
    """The steps from which those of these ids follow, with them, in their order."""
    known, wanted = {step.id: step for step in steps}, [*ends]
    found: set[str] = set()
    while wanted:
        id = wanted.pop()
        if id in known and id not in found:
            found.add(id)
            wanted += known[id].reasons
    return tuple(step for step in steps if step.id in found)
