"""Fill in: a derivation with blanks at the steps that matter, from much help to none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from rbpsym.derivation.step import Step
from rbpsym.document.model import Block, Display, Paragraph
from rbpsym.notation import tree as t
from rbpsym.notation.places import put
from rbpsym.teaching.bench import Bench, Prepared, Setting, sentence
from rbpsym.teaching.lines import WEIGHTS, Gap, gaps, has_value, is_negated, lines_to
from rbpsym.teaching.model import Anticipated, Blank, BlanksKey, Item, blank
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, claims
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken


@dataclass(frozen=True, slots=True)
class Help:
    """How much a level helps: steps shown, blanks at most, single terms rather than sides, reasons told."""

    lines: int
    blanks: int
    terms: bool
    reasons: bool


LEVELS: Mapping[int, Help] = {
    0: Help(5, 2, True, True),
    1: Help(6, 4, True, True),
    2: Help(6, 6, False, True),
    3: Help(7, 12, False, False),
}


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a result whose derivation has something to leave out."""
    if wish.level not in LEVELS:
        raise wish.error(f"there is no level {wish.level}", "levels go from 0 (much help) to 3 (none).")
    fits = lambda x: bool(x.step) and bool(_blanked(bench, x, wish.level)[1])  # noqa: E731
    for target in wanted(bench, wish, fits, "its derivation has no step with something to leave out"):
        yield _prepared(bench, wish, target)


def _prepared(bench: Bench, wish: Wish, target: Target) -> Prepared:
    steps, chosen = _blanked(bench, target, wish.level)
    statements, answers = _with_blanks(bench, steps, chosen)
    names = tuple(sorted({n for item in answers for n in t.names(item.value)}))
    how = LEVELS[wish.level]

    def key_of(setting: Setting) -> tuple[str, ...]:
        return ("fill-in", target.id, str(wish.level), setting.language)

    def make(setting: Setting) -> Item:
        prompt = Paragraph(spoken(setting.said, "ask.fill-in", count=len(answers), left=target.left, last=len(answers)))
        each = wish.worth(len(answers)) / len(answers)
        blanks = tuple(Blank(a.number, a.value, each, a.step, a.anticipated) for a in answers)
        lines = bench.once(key_of(setting), lambda: tuple(_lines(bench, setting, steps, statements, how.reasons)))
        solution = (Display(step.statement, numbered=False) for step in steps if step.id in chosen)
        key = BlanksKey(blanks, names)
        return wish.item(setting, bench.asked(target), (prompt, *lines), key, len(answers), solution=solution)

    asked = [step for step in steps if step.id in chosen]
    content = Content(claims(s.statement for s in steps if s not in asked), claims(s.statement for s in asked))
    return Prepared("fill-in", target, (), make, content=content)


def _blanked(bench: Bench, target: Target, level: int) -> tuple[tuple[Step, ...], dict[str, list[Gap]]]:
    """The steps shown and, by id, what is left out: from the steps that matter most."""
    how = LEVELS[level]
    steps = lines_to(bench, target.step, how.lines)
    ranked = _ranked(steps)
    chosen: dict[str, list[Gap]] = {}
    left = how.blanks
    for step in ranked:
        found = _gaps_of(bench, step, how) if WEIGHTS.get(step.rule, 0) else []
        if found and left:
            chosen[step.id] = found[:left]
            left -= len(chosen[step.id])
    return steps, chosen


def _ranked(steps: tuple[Step, ...]) -> list[Step]:
    """What matters most first, and one step of each kind before a second one of a kind."""
    again = {s.id: sum(other.rule == s.rule for other in steps[:place]) for place, s in enumerate(steps)}
    return sorted(steps, key=lambda s: (again[s.id], -WEIGHTS.get(s.rule, 0)))


def _gaps_of(bench: Bench, step: Step, how: Help) -> list[Gap]:
    """A term of each sum where there is much help (the last: the spin part, the shift of the axis), else whole sides."""
    found = [gap for gap in gaps(step.statement) if has_value(bench, gap.node)]
    terms = [gap for gap in found if gap.is_term]
    sides = [gap for gap in found if not gap.is_term]
    if how.terms and terms:
        return terms[-1:]
    return sides[-1:] if how.terms else sides or terms


def _with_blanks(bench: Bench, steps: tuple[Step, ...], chosen: Mapping[str, list[Gap]]):
    """Statements by id, and the answers, numbered in reading order."""
    statements, answers = {}, []
    for step in steps:
        statement = step.statement
        for gap in chosen.get(step.id, ()):
            answers.append(Blank(len(answers) + 1, gap.node, step=step.id, anticipated=_anticipated(bench, step, gap)))
            statement = put(statement, gap.path, blank(len(answers)))
        statements[step.id] = statement
    return statements, answers


def _anticipated(bench: Bench, step: Step, gap: Gap) -> tuple[Anticipated, ...]:
    """Known slips, where the blank is the whole right side of a quantity that has some."""
    found = next((x for x in bench.targets.values() if x.step == step.id), None)
    if found is None or gap.is_term or isinstance(step.statement, t.System):
        return ()
    is_turned = is_negated(step.statement, gap.path)
    return tuple(Anticipated(d.slip, _as_gap(d.formula, is_turned)) for d in bench.pool.of(found))


def _as_gap(formula: t.Node, is_turned: bool) -> t.Node:
    """The formula, its sign changed where the minus stands printed before the blank."""
    return t.neg(formula) if is_turned else formula


def _lines(
    bench: Bench, setting: Setting, steps: tuple[Step, ...], statements: Mapping[str, t.Node], reasons: bool
) -> Iterator[Block]:
    for step in steps:
        why = sentence(bench, step, setting.said) if reasons else ()
        if why:
            yield Paragraph(why)
        yield Display(statements[step.id], numbered=False)
