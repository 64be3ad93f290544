"""Find the slip: a derivation with one wrong step, made by a misconception and carried through."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from rbpsym.document.model import Display, Inlines, Paragraph
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, replace
from rbpsym.proof.draft import length
from rbpsym.proof.step import Step
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench
from rbpsym.teaching.lines import gist, lines_to, piece, precedence
from rbpsym.teaching.misconceptions.model import sign_of
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.model import Item, Slip, SlipKey
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, claims, printed
from rbpsym.teaching.spoilers import wanted as wanted_values
from rbpsym.teaching.target import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

MOST, FEWEST = 7, 3
ENOUGH = 3  # slips to draw from for one quantity
TRIES = 6  # wrong studies that are told for it at most
SHORT = frozenset({"mass_integral"})  # rules of which only the result is told
SPLITS = frozenset({"angular_momentum", "kinetic_energy"})  # rules that tell the spin part apart


class Told(Frozen):
    """A slip, the lines that it leads to, the right ones, and the place of the first that is wrong."""

    slip: Slip
    lines: tuple[Step, ...]
    right: tuple[Step, ...]
    first: int

    @property
    def corrected(self) -> t.Node:
        """What the wrong line should say."""
        return self.right[self.first].statement


def prepare(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a result that a slip on the way spoils."""
    fits = lambda x: bool(x.step) and any(True for _ in _candidates(bench, x, wish))  # noqa: E731
    for target in wanted(bench, wish, fits, "no misconception that reads well spoils a step on the way to it"):
        found = tuple(_told(bench, target, wish))
        if found:
            yield _prepared(bench, wish, target, found)


def _candidates(bench: ProblemBench, target: Target, wish: Wish) -> Iterator[int]:
    """Places of the wrong studies that change the target and can be told as a derivation."""
    for place, own in enumerate(wrong.misconception for wrong in bench.pool.wrongs):
        if own.tells is not None and target.kind in own.about and own.name in (wish.misconceptions or (own.name,)):
            yield place


def _told(bench: ProblemBench, target: Target, wish: Wish) -> Iterator[Told]:
    """Slips with their lines: equal to the right ones up to the wrong line, the result different."""
    tried = (_with_slip(bench, target, place) for place in islice(_candidates(bench, target, wish), TRIES))
    return islice(filter(None, tried), ENOUGH)


def _with_slip(bench: ProblemBench, target: Target, place: int) -> Told | None:
    wrong = bench.pool.wrongs[place]
    hidden = MISCONCEPTIONS[wrong.misconception.name].tells or frozenset()
    usual = [s for s in lines_to(bench, target.step, MOST) if s.chapter not in hidden]
    lines = bench.pool.retold(place).steps(s.id for s in usual) if len(usual) >= FEWEST else None
    if lines is None:
        return None
    moments = [state.moment for state in wrong.study.system.bodies.values() if state.moment]  # a negative one: a shift was taken
    short = SHORT | (SPLITS if any(sign_of(wrong.study, moment) < 0 for moment in moments) else frozenset())  # off, none writes
    shown, right = (tuple(brief(step, short) for step in row) for row in (lines, usual))
    first = next((k for k, (a, b) in enumerate(zip(shown, right, strict=True)) if a.statement != b.statement), None)
    if first is None or shown[-1].statement == right[-1].statement or not _reads_well(shown[first], right[first]):
        return None
    told = Told(bench.pool.slip(place), shown, right, first)
    return told if _is_the_only_one(bench, told) else None


def _is_the_only_one(bench: ProblemBench, told: Told) -> bool:
    """Whether every later line that is wrong follows from the first wrong one, by the graph of the derivation."""
    follows = precedence(bench, [step.id for step in told.right])
    pairs = zip(told.lines, told.right, strict=True)
    wrong = [place for place, (line, right) in enumerate(pairs) if line.statement != right.statement]
    return all((told.first, place) in follows for place in wrong if place != told.first)


def brief(step: Step, rules: frozenset[str]) -> Step:
    """A step of some rules without what stands between its first and its last side.

    Who takes the formula of another shape does not carry out the integral.
    """
    rows = gist(step.statement)
    return replace(step, statement=rows[0]) if step.rule in rules and len(rows) == 1 else step


def _reads_well(wrong: Step, right: Step) -> bool:
    """The wrong line is one that a student would write: not “= 0” for what matters, not much longer than the right one."""
    ends = [row.items[-1] for row in t.rows(wrong.statement) if isinstance(row, t.Chain)]
    is_empty = t.ZERO in ends and wrong.rule in ("mass_integral", "parallel_axis", "differentiation")
    return not is_empty and length(wrong.statement) <= 2 * length(right.statement) + 6


def _prepared(bench: ProblemBench, wish: Wish, target: Target, found: tuple[Told, ...]) -> Prepared:
    def make(setting: ItemSetting) -> Item:
        told = setting.draws.one_of(found)
        slip = told.slip
        asks = spoken(setting.said, "ask.find-the-slip", left=target.left)
        prompt = (Paragraph((*asks, *_hint(setting, wish, slip))),)
        key = SlipKey(tuple(map(piece, told.lines)), told.first, told.corrected, slip)
        solution = (Paragraph(spoken(setting.said, slip.phrase, **slip.slots)), Display(told.corrected, numbered=False))
        return wish.item(setting, bench.asked(target), prompt, key, 3, solution=solution, space=2)

    return Prepared("find-the-slip", target, (), make, content=_content(bench, found))


def _hint(setting: ItemSetting, wish: Wish, slip: Slip) -> Inlines:
    """With much help: which slip to look for."""
    if wish.level:
        return ()
    title = spoken(setting.said, f"misconception.{slip.name}.title")
    return spoken(setting.said, "hint.slip", title=title)


def _content(bench: ProblemBench, found: tuple[Told, ...]) -> Content:
    """Right lines are printed, the right one for the wrong one is asked for; later lines show what was left as it is."""
    study = bench.study
    lines = claims(step.statement for told in found for step in told.lines)
    right = claims(step.statement for told in found for step in told.right)
    asked = claims(told.corrected for told in found)
    answers = [row.items[-1] for told in found for row in t.rows(told.corrected) if isinstance(row, t.Chain)]
    values = printed(study, {step.statement for told in found for step in told.lines})
    return Content((lines & right) - asked | values, asked | wanted_values(study, answers))
