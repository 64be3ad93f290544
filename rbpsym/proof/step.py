"""A step of a derivation, and the derivation: a graph of steps with their certificates."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import KW_ONLY
from typing import Any

from rbpsym.decide.verdict import PROVED, Verdict, undecided
from rbpsym.expr.tree import Chain, Node
from rbpsym.frozen import Frozen, Late, field
from rbpsym.mechanics.study import Study
from rbpsym.showing import Shown
from rbpsym.statement.course import Course, CoursePart

BRIEF, STANDARD, FULL = 1, 2, 3
FACTS = ("law.", "start.", "range.", "shape.", "def.")  # how the ids of facts begin (`facts.Fact`)


class StepRef(Frozen):
    """A mention of another step ("from (7)") as an argument of a phrase."""

    id: str


class BodyRef(Frozen):
    """A mention of a body as an argument of a phrase ("the rod")."""

    name: str


class QuestionRef(Frozen):
    """A mention of a question that the problem asks, as an argument of a phrase."""

    text: str


class PhraseRef(Frozen):
    """A phrase as an argument of another phrase."""

    key: str
    slots: Mapping[str, Any] = field(default_factory=dict)


def bodies_named(names: Iterable[str]) -> PhraseRef:
    """A mention of one body or of several ("the rod and the disk") as an argument of a phrase."""
    bodies = [BodyRef(name) for name in names]
    return PhraseRef("bodies", {"bodies": bodies, "count": len(bodies)})


class Certificate(Frozen):
    """What was checked for a step, by which checkers, with what outcome."""

    checks: tuple[str, ...]
    verdict: Verdict


UNCHECKED = Certificate((), undecided("it was not checked"))


class Step(Shown):
    """One step.

    rule: name in `rules.RULES`. premises: ids of the steps and facts from which it follows, none of which can be
    left out. cites: steps that it tells the reader of beside these. statement: a relation, a
    chain or a system, all asserted. phrase and slots: the sentence that says why. chapter:
    where it belongs. level: from which detail on it is shown (1 brief .. 3 full). is_result:
    shown in a box. obligations: conditions under which it holds (trees).
    """

    id: str
    rule: str
    statement: Node
    chapter: str
    phrase: str
    slots: Mapping[str, Any] = field(default_factory=dict)
    premises: tuple[str, ...] = Late(())  # type: ignore[assignment]
    _: KW_ONLY
    cites: tuple[str, ...] = Late(())  # type: ignore[assignment]
    level: int = STANDARD
    is_result: bool = False
    obligations: tuple[Chain, ...] = ()
    data: Mapping[str, Any] = field(default_factory=dict)
    certificate: Certificate = UNCHECKED

    @property
    def reasons(self) -> tuple[str, ...]:
        """Ids of the steps that it rests on or tells of (its premises but the facts, and what it cites)."""
        return tuple(id for id in (*self.premises, *self.cites) if not id.startswith(FACTS))


class Skipped(Frozen):
    """A method that does not apply, with the reason as a phrase."""

    method: str
    phrase: str
    slots: Mapping[str, Any] = field(default_factory=dict)


class Derivation(Shown):
    """The steps of a problem in reading order; ids are unique, premises come before.

    `agreement`: verdicts on the independent roads by name; `simulation`: the oracle's report
    or None; `phases`: those that follow the first; `letters`: the `Context` that says what each letter means.
    """

    study: Study
    steps: tuple[Step, ...]
    skipped: tuple[Skipped, ...] = ()
    agreement: Mapping[str, Verdict] = field(default_factory=dict)
    simulation: Any = None
    lagrange: Verdict | None = None
    phases: tuple[DerivedPhase, ...] = ()
    letters: Any = field(default=None, compare=False, repr=False)

    @property
    def all_steps(self) -> tuple[Step, ...]:
        """The steps of all phases."""
        later = (step for phase in self.phases for step in (*phase.begins, *phase.derivation.steps))
        return (*self.steps, *later)

    def step(self, id: str) -> Step:
        """The step of an id, "phase2.motion.theta" say for one of a later phase (KeyError if there is none)."""
        later = {
            f"phase{number}.{step.id}": step
            for number, phase in enumerate(self.phases, 2)
            for step in (*phase.begins, *phase.derivation.steps)
        }
        return {**later, **{step.id: step for step in self.steps}}[id]

    def show(self, *ids: str) -> Excerpt:
        """Some of its steps, which show themselves in a notebook as the notes print them."""
        for id in ids:
            self.step(id)
        return Excerpt(self, ids)

    def chapter(self, name: str) -> tuple[Step, ...]:
        """The steps of a chapter."""
        return tuple(step for step in self.steps if step.chapter == name)

    def _agreements(self) -> tuple[Verdict, ...]:
        """Whether the methods agree, phase by phase."""
        return (*self.agreement.values(), *(v for phase in self.phases for v in phase.derivation.agreement.values()))

    def summary(self) -> dict[str, Any]:
        """Counts of verdicts and the outcome of the independent roads."""
        kinds = Counter(str(step.certificate.verdict.kind) for step in self.all_steps)
        error = None if self.simulation is None else self.simulation.max_relative_error
        return {
            "steps": len(self.all_steps),
            "proved": kinds["PROVED"],
            "refuted": kinds["REFUTED"],
            "undecided": kinds["UNDECIDED"],
            "methods": {name: str(verdict.kind) for name, verdict in self.agreement.items()},
            "methods_agree": all(verdict.kind is PROVED for verdict in self._agreements()),
            "lagrange": None if self.lagrange is None else str(self.lagrange.kind),
            "simulation": None if error is None else {"max_relative_error": error},
            "left_out": [{"what": item.method, "why": item.phrase.removeprefix("skipped.")} for item in self.skipped],
        }


class DerivedPhase(Frozen):
    """A later phase: its name, the steps from the end of the one before to its start, its own derivation; `letters` of the
    former, as in a derivation."""

    name: str
    event: str
    begins: tuple[Step, ...]
    derivation: Derivation
    letters: Any = field(default=None, compare=False, repr=False)


class Excerpt(Shown):
    """Some steps of a derivation, by their ids."""

    derivation: Derivation
    ids: tuple[str, ...]


class Lesson(Shown):
    """Steps that belong to no single problem: the general theory, or a comparison of two problems.

    kind: "theory" or "comparison"; slots are what its introduction may mention; notation as
    in a problem.
    """

    kind: str
    name: str
    steps: tuple[Step, ...]
    slots: Mapping[str, Any] = field(default_factory=dict)
    notation: Mapping[str, str] = field(default_factory=dict)
    title: Mapping[str, str] = field(default_factory=dict)


class DerivedCourse(Shown):
    """A course with the derivations of its problems by name, and its lessons part by part.

    formulas: those of its own texts, all of them proved, by the id of the claim and the LaTeX text ("" for the claim's own).
    """

    course: Course
    derivations: Mapping[str, Derivation]
    lessons: Mapping[CoursePart, Lesson]
    formulas: Mapping[tuple[str, str], Node] = field(default_factory=dict)
