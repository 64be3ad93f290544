"""The tutor: a student's line is judged at once, in any order, by the steps of the derivation and by the judge of `check`.

Verdicts: “true” (it is a step of the derivation), “true, not used” (it holds, and the derivation does without it), “true, not yet
justified” (a result of which nothing stands above yet), “wrong” (with what seems to be meant), “undecided” and “unread” with
the reason. A hint tells the next step that can be made: its sentence, then its left side, then all of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from rbpsym.derivation.step import STANDARD, Derivation, Step
from rbpsym.document.model import Paragraph
from rbpsym.document.notes import notation_of, words_of
from rbpsym.document.telling import Teller
from rbpsym.document.writers.plain_text import plain_text
from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation
from rbpsym.notation.latex import to_latex
from rbpsym.notation.latex_reader import read_latex
from rbpsym.notation.symbol_table import symbol_table
from rbpsym.notation.text import to_text
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.teaching.grading.ground import GradingGround, ground_of
from rbpsym.teaching.grading.reading import read_formula
from rbpsym.teaching.grading.verdicts import are_equal
from rbpsym.verify.claims_check import Checker, relations
from rbpsym.verify.claims_model import Claim, Outcome, Printed, Setting
from rbpsym.verify.diagnosis import diagnosis

TRUE, UNUSED, UNJUSTIFIED = "true", "true, not used", "true, not yet justified"
WRONG, UNDECIDED, UNREAD = "wrong", "undecided", "unread"
ACCEPTED = frozenset({TRUE, UNUSED, UNJUSTIFIED})
SAYS: Mapping[str, str] = {
    TRUE: "It is a step of the derivation.",
    UNUSED: "It holds; the derivation does without it.",
    UNJUSTIFIED: "It is a result; write a line from which it follows, too.",
}
VERDICTS: Mapping[Outcome, str] = {
    Outcome.PROVED: UNUSED, Outcome.DEFINITION: UNUSED, Outcome.REFUTED: WRONG, Outcome.UNDECIDED: UNDECIDED,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Judged:
    """A line with its verdict, what is said of it, and the id of the step that it is (else "")."""

    line: str
    verdict: str
    says: str = ""
    step: str = ""


@dataclass(frozen=True)
class Tutor:
    """The tutor of one derivation. Lines are LaTeX, or typed plainly: `theta_ddot = -3*g/(4*ell)*cos(theta)`."""

    derivation: Derivation
    language: str = "en"
    known: dict[str, tuple[str, str, str]] = field(default_factory=dict)

    @cached_property
    def notation(self) -> Notation:
        """How the problem's names are printed."""
        return notation_of(self.derivation, self.language)

    @cached_property
    def steps(self) -> dict[str, Step]:
        """The proved steps of the derivation by id, in their order."""
        return {step.id: step for step in self.derivation.steps if step.certificate and step.certificate.verdict.is_proved}

    @cached_property
    def _lines(self) -> dict[str, tuple[str, ...]]:
        """The ids of the steps that a printed line is or holds."""
        found: dict[str, tuple[str, ...]] = {}
        for id, step in self.steps.items():
            for line in {self._printed(row): row for row in (step.statement, *relations(step.statement))}:
                found[line] = (*found.get(line, ()), id)
        return found

    @cached_property
    def _ground(self) -> GradingGround:
        return ground_of(self.derivation.study, self.language)

    @cached_property
    def _checker(self) -> Checker:
        world = ProblemWorld(self.derivation.study)
        return Checker(lambda _: world, diagnosis)

    def _printed(self, node: t.Node) -> str:
        """The LaTeX of a formula without spaces."""
        return "".join(to_latex(node, self.notation).split())

    def judge(self, line: str, before: Iterable[str] = ()) -> Judged:
        """The verdict on a line; `before` are the student's lines above it. No line raises an error."""
        if line not in self.known:
            self.known[line] = self._judged(line)
        verdict, says, id = self.known[line]
        if id and self._lacks_reasons(self.steps[id], before):
            verdict, says = UNJUSTIFIED, SAYS[UNJUSTIFIED]
        return Judged(line, verdict, says, id)

    def _lacks_reasons(self, step: Step, before: Iterable[str]) -> bool:
        """Is it a result that rests on other steps, of which none stands above?"""
        reasons = {id for id in step.reasons if id in self.steps}
        return step.is_result and bool(reasons) and not reasons & self.written(before)

    def written(self, lines: Iterable[str]) -> set[str]:
        """The ids of the steps that these lines are, and of what these rest on."""
        done, found = [self.judge(line).step for line in lines], set[str]()
        while done:
            if (id := done.pop()) and id not in found and id in self.steps:
                found.add(id)
                done += (*self.steps[id].reasons, *self._lines[self._printed(self.steps[id].statement)])
        return found

    def _judged(self, line: str) -> tuple[str, str, str]:
        """(verdict, what is said, the step) without regard to the lines above."""
        if ids := self._lines.get("".join(line.split())):
            return TRUE, SAYS[TRUE], ids[0]
        try:
            read = self._read(line)
        except RbpsymError as error:
            return UNREAD, str(error), ""
        if not isinstance(read, (t.Chain, t.System)):
            return UNREAD, "This is no equation: write what it equals.", ""
        if ids := self._lines.get(self._printed(read)) or self._same(read):
            return TRUE, SAYS[TRUE], ids[0]
        return *self._decided(read), ""

    def _read(self, line: str) -> t.Node:
        """The tree of a line: first with the letters of the derivation, else as answers are read."""
        if "\\" not in line:
            return read_formula(line, self._ground.book)
        names = {name for step in self.steps.values() for name in t.names(step.statement)}
        return read_latex(line, symbol_table(sorted(names), self.notation))

    def _same(self, read: t.Node) -> tuple[str, ...]:
        """The first step that says the same quantity to be the same value in another form."""
        if not isinstance(read, t.Chain) or read.ops != ("=",) or not isinstance(read.items[0], t.Sym):
            return ()
        for id, step in self.steps.items():
            ends = step.statement.items if isinstance(step.statement, t.Chain) else ()
            if ends and ends[0] == read.items[0] and self._equal(ends[-1], read.items[1]):
                return (id,)
        return ()

    def _equal(self, one: t.Node, other: t.Node) -> bool:
        try:
            return are_equal(one, other, self._ground).is_proved
        except RbpsymError:
            return False

    def _decided(self, read: t.Node) -> tuple[str, str]:
        """What the judge of `check` says."""
        name = self.derivation.study.problem.name
        claim = Claim("line", Setting(name, problem=name), Printed(to_latex(read, self.notation)))
        result = self._checker.check_safely(claim)
        verdict = VERDICTS.get(result.outcome, UNREAD)
        if verdict == UNREAD and t.names(read) - {"pi"} <= self._ground.book.names:
            return self._as_an_answer(read)
        if verdict in SAYS:
            return verdict, SAYS[verdict]
        details = [link.detail for link in result.links if link.outcome not in (Outcome.PROVED, Outcome.DEFINITION)]
        return verdict, result.diagnosis or "; ".join(filter(None, (*details, result.detail)))

    def _as_an_answer(self, read: t.Node) -> tuple[str, str]:
        """What the judge of `grade` says, who knows names that students give: I, α, ω of the only body."""
        found = [are_equal(*row.items, self._ground) for row in relations(read) if row.ops == ("=",)]
        if not found or not all(verdict.is_proved or verdict.is_refuted for verdict in found):
            return UNDECIDED, "; ".join(verdict.reason for verdict in found if verdict.reason)
        wrong = next((verdict for verdict in found if verdict.is_refuted), None)
        return (WRONG, str(wrong)) if wrong else (UNUSED, SAYS[UNUSED])

    # --- hints

    def next_step(self, lines: Iterable[str]) -> Step | None:
        """The first step of standard notes that is not written, and whose reasons are or need none; None at the end."""
        done = self.written(lines)
        open_steps = [step for id, step in self.steps.items() if step.level <= STANDARD and id not in done]
        ready = (step for step in open_steps if {id for id in step.reasons if id in self.steps} <= done)
        return next(ready, open_steps[0] if open_steps else None)

    def hint(self, lines: Iterable[str] = (), depth: int = 1) -> str:
        """Of the next step: its sentence (1), its left side too (2), or all of it (3)."""
        step = self.next_step(lines)
        if step is None:
            return "All steps of the derivation are written."
        said = words_of(self.derivation, frozenset(self.steps), self.language)
        blocks = [block for block in Teller(said).step(step) if isinstance(block, Paragraph)]
        told = [plain_text(block.inlines, self.notation, self.language) for block in blocks]
        ends = step.statement.items if isinstance(step.statement, t.Chain) else (step.statement,)
        more = {2: [f"{to_text(ends[0], self.notation)} = …"], 3: [to_text(step.statement, self.notation)]}
        return " ".join([*told, *more.get(min(depth, 3), [] if told else [f"{to_text(ends[0], self.notation)} = …"])])

    def record(self, lines: Iterable[str]) -> dict[str, Any]:
        """What is handed in: the problem, each line with its verdict, how many steps stand."""
        judged = list(self._in_turn(tuple(lines)))
        rows = [{"line": one.line, "verdict": one.verdict, "says": one.says} for one in judged]
        return {"problem": self.derivation.study.problem.name, "lines": rows, "steps": len({one.step for one in judged} - {""})}

    def _in_turn(self, lines: tuple[str, ...]) -> Iterator[Judged]:
        for place, line in enumerate(lines):
            yield self.judge(line, lines[:place])
