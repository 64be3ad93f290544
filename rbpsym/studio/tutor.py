"""The tutor: a student's line is judged at once, in any order and of any phase, by the steps of the derivation and their checks.

Verdicts: “true” (it is a step of the derivation), “true, not used” (it holds, and the derivation does without it), “true, not yet
justified” (a result of which nothing stands above yet), “wrong” (with what seems to be meant), “undecided” and “unread” with
the reason. A hint tells the next step that can be made: its sentence, then its left side, then all of it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from functools import cached_property
from typing import Any

from rbpsym.decide.verdict import Verdict
from rbpsym.document.model import Paragraph
from rbpsym.document.notes import words_of
from rbpsym.document.phrases import plain
from rbpsym.document.telling import Teller
from rbpsym.document.words import Words
from rbpsym.document.writers.page import plain_text
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.frozen import Frozen, field
from rbpsym.proof.step import STANDARD, Derivation, QuestionRef, Step
from rbpsym.studio.refuting import REASONS
from rbpsym.studio.sheet import PhaseSheet, sheets
from rbpsym.studio.untold import WAYS, told, typed
from rbpsym.teaching.grading.feedback import translated
from rbpsym.teaching.grading.judgement import sentence
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.mathml import to_mathml
from rbpsym.typeset.text import to_text

TRUE, UNUSED, UNJUSTIFIED = "true", "true, not used", "true, not yet justified"
WRONG, UNDECIDED, UNREAD = "wrong", "undecided", "unread"
RANK = {TRUE: 0, UNUSED: 1, UNDECIDED: 2, WRONG: 3, UNREAD: 4}  # what a line is, that is each of these in a phase of its own
LIKELY = frozenset({"root", "times", "sign", "factor", "function", "exponent", "missing"})  # kinds of slips
MOST_TOLD = 120  # characters of a hint
ACCEPTED = frozenset({TRUE, UNUSED, UNJUSTIFIED})
TELLS: Mapping[str, frozenset[str]] = {  # what a sentence asserts of a line: the verdicts with which alone it is said
    **dict.fromkeys(("true", "answer"), frozenset({TRUE})),
    "unused": frozenset({UNUSED}), "unjustified": frozenset({UNJUSTIFIED}),
    **dict.fromkeys(("wrong", "right_terms"), frozenset({WRONG})), "slip": frozenset({WRONG, UNDECIDED}),
    **dict.fromkeys(("undecided", "why", "seems"), frozenset({UNDECIDED})),
    **dict.fromkeys(("no_equation", "letters"), frozenset({UNREAD})),
}  # fmt: skip
NARRATES = frozenset({"in_phase", "principle", "meant", "of", "all_written"})  # the last one is said where `next_step` finds none
PRINCIPLES: Mapping[str, str] = {  # by the rule of a step: what is asked of it where it teaches
    **dict.fromkeys(("constraint", "no_slip", "tied", "taut"), "constraint"),
    "mass_integral": "inertia", "parallel_axis": "inertia", "differentiation": "kinematics", "balance": "momentum",
    **dict.fromkeys(("conservation", "first_integral"), "conservation"),
    **dict.fromkeys(("work_energy", "work_together"), "work"),
    **dict.fromkeys(("jump", "impulse", "restitution"), "impulse"),
}  # fmt: skip


class Judged(Frozen):
    """A line with its verdict, what is said of it, the id of the step that it is (else ""), and its principle (else "")."""

    line: str
    verdict: str
    says: str = ""
    step: str = ""
    principle: str = ""


class Tutor(Frozen):
    """The tutor of one derivation. Lines are LaTeX, or typed plainly: `theta_ddot = -3*g/(4*ell)*cos(theta)`."""

    derivation: Derivation
    language: str = "en"
    known: dict[str, tuple[str, str, str]] = field(default_factory=dict)

    @cached_property
    def sheets(self) -> Mapping[str, PhaseSheet]:
        """The phases by their names; the first is ""."""
        return sheets(self.derivation, self.language)

    @property
    def notation(self) -> Notation:
        """How the problem's names are printed."""
        return self.sheets[""].notation

    @cached_property
    def steps(self) -> dict[str, Step]:
        """The proved steps of all phases by id, in their order."""
        return {id: step for sheet in self.sheets.values() for id, step in sheet.steps.items()}

    @cached_property
    def letters(self) -> list[str]:
        """The names of the statement that a student will type, as they are typed."""
        problem = self.derivation.study.problem
        moving = [f"{c.name}{tail}" for c in problem.coordinates for tail in ("", "_dot", "_ddot")]
        own = [problem.notation.get(name, name) for name in moving]
        return [*(q.name for q in problem.parameters), *own, *self.derivation.study.system.unknowns, *self.sheets[""].named]

    def shown(self, line: str) -> str:
        """A line as it is printed (MathML); "" where it can't be read."""
        for sheet in self.sheets.values():
            with suppress(RbpsymError):
                return to_mathml(sheet.ways(line).trees[0], self.notation)
        return ""

    # --- judging

    def judge(self, line: str, before: Iterable[str] = ()) -> Judged:
        """A line with those that were written above it."""
        line = line.strip()
        if line not in self.known:
            self.known[line] = self._judged(line)
        verdict, says, id = self.known[line]
        reasons = self._reasons(id) if id and self.steps[id].is_result else set()
        if reasons and not reasons & self.written(before):  # a result that rests on other steps, of which none stands above
            verdict, says = UNJUSTIFIED, self._told(UNJUSTIFIED, "unjustified")
        return Judged(line, verdict, says, id, PRINCIPLES.get(self.steps[id].rule, "") if id else "")

    def _say(self, key: str, **slots: object) -> str:
        return plain(f"tutor.{key}", self.language, **slots)

    def _told(self, verdict: str, key: str, **slots: object) -> str:
        """A sentence that asserts something, with the verdict for which it does. Raises ValueError for another one."""
        if verdict not in TELLS[key.partition(".")[0]]:
            raise ValueError(f"“{key}” is not said of what is {verdict}")
        return self._say(key, **slots)

    def _reasons(self, id: str) -> set[str]:
        """The steps on which one rests."""
        head = id[: id.index(".") + 1] if id.startswith("phase") else ""
        return {found for one in self.steps[id].reasons for found in (one, head + one) if found in self.steps}

    def written(self, lines: Iterable[str]) -> set[str]:
        """The ids of the steps that these lines are, and of what these rest on."""
        shown, found = tuple(lines), set[str]()
        done = [id for line in shown for id in (self.judge(line).step, *self._printed(line))]
        while done:
            if (id := done.pop()) and id not in found and id in self.steps:
                found.add(id)
                done += (*self._reasons(id), *self._printed(self.sheets[""].line(self.steps[id].statement)))
        return found

    def _printed(self, line: str) -> Iterator[str]:
        """The steps that are printed so, or hold it as a row, in whatever phase."""
        text = "".join(line.split())
        return (id for sheet in self.sheets.values() for id in sheet.printed.get(text, ()))

    def _judged(self, line: str) -> tuple[str, str, str]:
        """(verdict, what is said, the step) without regard to the lines above, of the phase in which it fits best.

        It is wrong if it is so in all phases in which it can be read.
        """
        found = []
        for name in self.sheets:
            found.append(self._in_phase(line, name))
            if found[-1][0] == TRUE:
                break
        return min(found, key=self._weight)

    def _in_phase(self, line: str, phase: str) -> tuple[str, str, str]:
        sheet = self.sheets[phase]
        where = f" {self._say('in_phase', phase=phase)}" if phase else ""
        if ids := sheet.printed.get("".join(line.split())):
            return TRUE, self._told(TRUE, "true") + where, ids[0]
        try:
            ways = sheet.ways(line)
        except RbpsymError as error:
            return UNREAD, self._unread(error), ""
        if not isinstance(ways.trees[0], (t.Chain, t.Relations)):
            return UNREAD, self._told(UNREAD, "no_equation"), ""
        found = [self._best(tree, sheet, where) for tree in ways.trees]
        best = next((place for place, one in enumerate(found) if one[0] in ACCEPTED), 0)  # else the usual one is meant
        verdict, says, id = found[best]
        if ways.error is None:
            return verdict, says, id
        if verdict == UNDECIDED:
            return UNREAD, self._unread(ways.error), ""
        return verdict, f"{says} {self._say('meant', letters=to_text(ways.trees[best], self.notation))}", id

    def _best(self, tree: t.Node, sheet: PhaseSheet, where: str) -> tuple[str, str, str]:
        """What a line is in that meaning of its letters in which it fits best."""
        found = [(self._decided(read, sheet, where), read) for read in sheet.readings(tree)]
        if len(found) > 1 and all(one[0] == WRONG for one, _ in found):
            return min(found, key=lambda one: sheet.slip(one[1]).kind not in LIKELY)[0]
        return min((one for one, _ in found), key=self._weight)

    def _weight(self, one: tuple[str, str, str]) -> tuple[int, bool]:
        """The less, the better it fits, and the more is said of it."""
        return RANK[one[0]], one[1] == self._say("wrong")

    def _meant(self, read: t.Node) -> str:
        """For what letters are taken that nobody told."""
        said, where = Words(self.language, self.derivation.study.problem), dict[str, str]()
        for letter, body, of in told(read):
            if of == "asked":
                asked = said.word(QuestionRef(self.sheets[""].asked[f"{letter}.{body}.{of}"]))
                where[letter] = plain_text(asked, self.notation, self.language)
                continue
            point = of.rstrip("-")
            place = (
                self._say(f"of.{of}") if of in WAYS else self._say(f"of.{'clockwise' if of != point else 'about'}", point=point)
            )
            where[to_text(t.Sym(letter), self.notation)] = ", ".join(filter(None, (said.body(body), place if of else "")))
        return (
            f" {self._say('meant', letters=', '.join(f'{letter} ({words})' for letter, words in where.items()))}" if where else ""
        )

    def _decided(self, read: t.Node, sheet: PhaseSheet, where: str) -> tuple[str, str, str]:
        """What a line is in one of its meanings."""
        where += self._meant(read)
        if id := sheet.step_of(read):
            return TRUE, self._told(TRUE, "true") + where, id
        found = sheet.holds(read)
        if found.is_proved:
            if any(name.endswith(".asked") for name in t.names(read)):
                return TRUE, self._told(TRUE, "answer") + where, ""
            return UNUSED, self._told(UNUSED, "unused") + where, ""
        verdict, says, id = self._refused(read, sheet, found)
        return verdict, says + (self._meant(read) if verdict == WRONG else ""), id

    def _unread(self, error: RbpsymError) -> str:
        """What could not be read; of many letters those of the statement."""
        names = ", ".join(self.letters) if len(error.instead) > MOST_TOLD else ""
        instead = self._told(UNREAD, "letters", letters=names) if names else self._sentence(error.instead)
        return f"{self._sentence(error.what)} {instead}".strip()

    def _refused(self, read: t.Node, sheet: PhaseSheet, found: Verdict) -> tuple[str, str, str]:
        """What a line that was not proved seems to mean: it is wrong if a state of the motion refutes it."""
        slip = sheet.slip(read)
        part = to_text(typed(slip.part), self.notation) if slip.part is not None else ""
        verdict = WRONG if found.is_refuted else UNDECIDED
        told = self._told(verdict, f"slip.{slip.kind}", part=part, by=slip.by) if slip.kind else ""
        if verdict == UNDECIDED:
            seems = (self._told(verdict, "seems"), told) if told else ()
            why = self._told(verdict, f"why.{found.reason}") if found.reason in REASONS else self._sentence(found.reason)
            return verdict, " ".join((*seems, self._told(verdict, "undecided"), why)), ""
        if slip.right and not slip.kind:
            told = " ".join(filter(None, (told, self._told(verdict, "right_terms", count=slip.right, of=slip.terms))))
        return verdict, told or self._told(verdict, "wrong"), ""

    def _sentence(self, words: str) -> str:
        """What the readers and checks say, as a sentence of the student's language."""
        told = translated(words, self.language)
        return sentence(f"{told[:1].upper()}{told[1:]}") if told else ""

    def principles(self) -> list[dict[str, str]]:
        """[{key, words}]: the principles of this derivation, among which one is asked for."""
        found = sorted({PRINCIPLES[step.rule] for step in self.steps.values() if step.rule in PRINCIPLES})
        return [{"key": key, "words": self._say(f"principle.{key}")} for key in found] if len(found) > 1 else []

    # --- hints

    def next_step(self, lines: Iterable[str]) -> Step | None:
        """The first step of standard notes that is not written, and whose reasons are or need none; None at the end."""
        done = self.written(lines)
        open_steps = [(id, step) for id, step in self.steps.items() if step.level <= STANDARD and id not in done]
        ready = (step for id, step in open_steps if self._reasons(id) <= done)
        return next(ready, open_steps[0][1] if open_steps else None)

    def hint(self, lines: Iterable[str] = (), depth: int = 1) -> tuple[str, str]:
        """Of the next step: its sentence (1), its left side too (2), or all of it (3); then its line, too."""
        step = self.next_step(lines)
        if step is None:
            return self._say("all_written"), ""
        own = next(one.derivation for one in self.sheets.values() if step in one.steps.values())
        words = words_of(own, frozenset(step.id for step in own.steps), self.language)
        blocks = [block for block in Teller(words).step(step) if isinstance(block, Paragraph)]
        said = " ".join(" ".join(plain_text(one.inlines, self.notation, self.language) for one in blocks).split())
        rows = step.statement.rows if isinstance(step.statement, t.Relations) else (step.statement,)
        left = ", ".join(f"{to_text(row.items[0], self.notation)} {row.ops[0]} …" for row in rows if isinstance(row, t.Chain))
        shown = to_text(step.statement, self.notation) if depth >= 3 else left if depth == 2 or not said.endswith(".") else ""
        # a sentence that the formula ends has its left side at once
        return f"{said[:1].upper()}{said[1:]} {shown}".strip(), to_latex(step.statement, self.notation) if depth >= 3 else ""

    def record(self, lines: Iterable[str]) -> dict[str, Any]:
        """What is handed in: the problem, each line with its verdict, how many of all steps of standard notes stand."""
        written = tuple(lines)
        judged = [self.judge(line, written[:place]) for place, line in enumerate(written)]
        rows = [{"line": one.line, "verdict": one.verdict, "says": one.says} for one in judged]
        shown = sum(step.level <= STANDARD for step in self.steps.values())
        steps = len({one.step for one in judged} - {""})
        problem = self.derivation.study.problem
        title = problem.title.get(self.language) or problem.name
        return {"problem": problem.name, "title": title, "lines": rows, "steps": steps, "all": shown}
