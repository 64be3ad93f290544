"""Which words may stand beside what was found: each of them with what a rule must have decided."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rbpsym.ask.finding import FOR_NONE, NO_SUCH, Finding
from rbpsym.equality.verdict import Verdict, undecided

Data = Mapping[str, Any]
Decided = Callable[[Data], bool]
Row = Mapping[str, Decided]  # a rule -> whether its data decide it

QUOTED, OF_IT = re.compile("“[^”]*”"), r"[^;]+"


def _always(data: Data) -> bool:
    return True


def _holds(way: bool) -> Decided:
    """What holds on the whole way, or is violated there; of the opposite the other way round."""
    return lambda data: data["holds"] is (way is not data.get("opposite", False))


def _hangs(opposite: bool) -> Decided:
    """What holds where its conditions do."""
    return lambda data: data["holds"] is None and data.get("opposite", False) is opposite


def _kept(way: bool) -> Decided:
    return lambda data: data["kept"] is way


FOR_ALL: Row = {"least_on_way": lambda data: data["holds"] is True, "no_change": lambda data: data["best"].number() == 0}
FOR_NO: Row = {"least_on_way": lambda data: data["holds"] is False, "vanishes_for": lambda data: not data["places"]}
EMPTY: Row = {**FOR_NO, "greatest_of": _always}
BOUND: Row = {"holds_for": _always}
GROWS: Row = {"limit": lambda data: data["order"] < 0}
GOES: Row = {"limit": lambda data: data["order"] > 0}
BEYOND: Row = {"no_change": lambda data: data["best"].number() == 0}

SAID: Mapping[str, Row] = {
    "yes": {"least_on_way": _holds(True), "equilibrium": _always, "vanishing": _always},
    "no": {"least_on_way": _holds(False), "equilibrium": _always, "vanishing": _always, "stays": _always},
    "yes where this is met(, else no)?": {"least_on_way": _hangs(False), "vanishing": _always},
    "no where this is met(, else yes)?": {"least_on_way": _hangs(True)},
    f"(yes|no): “…” does not depend on {OF_IT}": {"no_change": _always},
    f"(yes|no): “…” depends on {OF_IT}": {"changes": _always},
    "(yes|no): “…” is conserved": {"kept_or_not": _kept(True)},
    "(yes|no): “…” changes": {"kept_or_not": _kept(False)},
    f"{NO_SUCH} {OF_IT}: “…” holds for none in its range": EMPTY,
    f"(else )?“…” holds for every {OF_IT}|“…” holds for all values {OF_IT}": FOR_ALL,
    f"else {NO_SUCH} {OF_IT}": FOR_NO,
    f"“…” {FOR_NONE} {OF_IT}": FOR_NO,
    f"{OF_IT} is the only zero of this in its range": {"one_zero": _always},
    f"every smaller {OF_IT} does: it holds for {OF_IT} < {OF_IT}": {"holds_for": lambda data: data["ends"][1] is None},
    f"every larger {OF_IT} does: it holds for {OF_IT} > {OF_IT}": {"holds_for": lambda data: data["ends"][-1] is None},
    f"every such {OF_IT} does": {rule: lambda data: bool(data.get("opposite")) for rule in ("holds_for", "one_zero")},
    f"at this {OF_IT} itself it does not hold|with this {OF_IT} itself, {OF_IT} is approached and never reached": BOUND,
    f"else “…” holds for {OF_IT} [<>] {OF_IT}": BOUND,
    "beyond it the motion is not the one that is stated|there a contact is lost|there it slips": BEYOND,
    f"no (largest|least) value is reached: {OF_IT} is approached as {OF_IT}": {"extreme": lambda data: bool(data["at_end"])},
    f"there is none: “…” has no bound as {OF_IT}": GROWS,
    "“…” grows beyond all bounds, as this": GROWS,
    f"the limit is 0|“…” vanishes as {OF_IT}": GOES,
    f"“…” is the same for every {OF_IT}": {"no_change": _always},
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
    row = next((row for words, row in SAID.items() if re.fullmatch(words, clause)), {})
    return any(row[rule](data) for rule, data in grounds if rule in row)
