"""A derivation is asked for: its steps to be put in order, its blanks to be filled in, one of its steps to be explained."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial

from rbpsym.chapters.methods.net_work import HALVES
from rbpsym.document.model import Block, Display, Paragraph
from rbpsym.document.needless import is_struck
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, is_zero, substitute
from rbpsym.frozen import Frozen
from rbpsym.proof.step import Step
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench, sentence
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.lines import WEIGHTS, Gap, gaps, gist, has_value, lines_to, piece, precedence, shares
from rbpsym.teaching.model import Anticipated, AskedQuantity, Blank, BlanksKey, Criterion, ExplanationKey, Item, OrderKey
from rbpsym.teaching.papers.blocks import LETTERS
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, claims, meaning, printed
from rbpsym.teaching.spoilers import wanted as wanted_values
from rbpsym.teaching.target import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

# --- order: steps of a derivation to be put in order; the graph of the derivation says which orders are right


FEWEST, MOST, TRIALS = 4, 6, 20


def orders(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a result that several steps lead to."""
    fits = lambda x: bool(x.step) and _is_long(bench, x)  # noqa: E731
    for target in wanted(bench, wish, fits, f"fewer than {FEWEST} steps lead to it, or they may stand in any order"):
        yield _order_of(bench, wish, target)


def _is_long(bench: ProblemBench, target: Target) -> bool:
    steps = lines_to(bench, target.step, MOST)
    pairs = precedence(bench, [s.id for s in steps])
    return len(steps) >= FEWEST and len(pairs) >= len(steps) - 1 and len({s.statement for s in steps}) == len(steps)


def _order_of(bench: ProblemBench, wish: Wish, target: Target) -> Prepared:
    steps = lines_to(bench, target.step, MOST)

    def make(setting: ItemSetting) -> Item | None:
        key = _shuffled(bench, steps, setting.draws)
        if key is None:
            return None
        first = () if wish.level else spoken(setting.said, "hint.order", letter=LETTERS[key.sample[0]])
        prompt = (Paragraph((*spoken(setting.said, "ask.order", left=target.left), *first)),)
        solution = (Display(s.statement, numbered=False) for s in steps)
        return wish.item(setting, bench.asked(target), prompt, key, 2, solution=solution)

    return Prepared("order", target, (), make, content=_printing(bench, [s.statement for s in steps]))


def _shuffled(bench: ProblemBench, steps: tuple[Step, ...], draws: Draws) -> OrderKey | None:
    """The steps in an order that is wrong."""
    for _ in range(TRIALS):
        order = draws.shuffled(range(len(steps)))
        before = frozenset(precedence(bench, [steps[k].id for k in order]))
        sample = tuple(order.index(k) for k in range(len(steps)))
        key = OrderKey(tuple(piece(steps[k]) for k in order), before, sample)
        if not key.accepts(tuple(range(len(steps)))):
            return key
    return None


def _printing(bench: ProblemBench, statements: Sequence[t.Node]) -> Content:
    return Content(claims(statements) | printed(bench.study, statements))


# --- fill in: a derivation with blanks at the steps that matter, from much help to none


class Help(Frozen):
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


def blanks(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a result whose derivation has something to leave out."""
    if wish.level not in LEVELS:
        raise wish.error(f"there is no level {wish.level}", "levels go from 0 (much help) to 3 (none).")
    fits = lambda x: bool(x.step) and bool(_blanked(bench, x, wish.level)[1])  # noqa: E731
    for target in wanted(bench, wish, fits, "its derivation has no step with something to leave out"):
        yield _blanks_of(bench, wish, target)


def _blanks_of(bench: ProblemBench, wish: Wish, target: Target) -> Prepared:
    steps, chosen = _blanked(bench, target, wish.level)
    statements, answers = _with_blanks(bench, steps, chosen)
    names = tuple(sorted({n for item in answers for n in t.names(item.value)}))
    how = LEVELS[wish.level]

    def make(setting: ItemSetting) -> Item:
        prompt = Paragraph(spoken(setting.said, "ask.fill-in", count=len(answers), left=target.left, last=len(answers)))
        each = wish.worth(len(answers)) / len(answers)
        blanks = tuple(Blank(a.number, a.value, each, a.step, a.anticipated) for a in answers)
        key = ("fill-in", target.id, wish.level, setting.said.language)
        lines = bench.once(key, lambda: tuple(_lines(bench, setting, steps, statements, how.reasons)))
        solution = (Display(step.statement, numbered=False) for step in steps if step.id in chosen)
        answer = BlanksKey(blanks, names)
        return wish.item(setting, bench.asked(target), (prompt, *lines), answer, len(answers), solution=solution)

    asked = [step for step in steps if step.id in chosen]
    prints = claims(s.statement for s in steps if s not in asked) | printed(bench.study, statements.values())
    asks = claims(s.statement for s in asked) | wanted_values(bench.study, (item.value for item in answers))
    return Prepared("fill-in", target, (), make, content=Content(prints, asks))


def _blanked(bench: ProblemBench, target: Target, level: int) -> tuple[tuple[Step, ...], dict[str, list[Gap]]]:
    """The steps shown and, by id, what is left out: from the steps that matter most, nothing that stands elsewhere."""
    how = LEVELS[level]
    steps = lines_to(bench, target.step, how.lines)
    found = {step.id: _gaps_of(bench, step, how) if WEIGHTS.get(step.rule, 0) else [] for step in _ranked(steps)}
    instead = {id: [] if how.terms else _terms_beside(bench, steps, id) for id, own in found.items() if own}
    while True:
        chosen, left = {}, how.blanks
        for id, open_ones in found.items():
            if open_ones and left:
                chosen[id] = open_ones[:left]
                left -= len(chosen[id])
        statements, _ = _with_blanks(bench, steps, chosen)
        shown = bench.given.prints | printed(bench.study, statements.values(), t.walk)  # a vector line may lead to it
        told: dict[str, list[Gap]] = {id: [] for id in chosen}
        before: dict[t.Node, str] = {}
        for step, gap in [(each, gap) for each in steps for gap in chosen.get(each.id, ())]:
            is_handed_on = before.get(gap.node) in step.reasons  # one answer fills one blank
            told[step.id] += [gap] if is_handed_on or wanted_values(bench.study, [gap.node]) & shown else []
            before[gap.node] = step.id
        if not any(told.values()):
            solved = _solved(bench, steps, chosen)
            told = {step.id: chosen[step.id] for step in steps if step.id in chosen and _follows(bench, step, solved)}
        if not any(told.values()):
            return steps, chosen
        found = {id: [gap for gap in own if gap not in told.get(id, ())] for id, own in found.items()}
        found |= {id: instead.pop(id) for id, own in found.items() if not own and id in instead}


def _solved(bench: ProblemBench, steps: tuple[Step, ...], chosen: Mapping[str, list[Gap]]) -> dict[str, Scalar]:
    """The accelerations and forces for which equations are solved in lines that have no blank."""
    shown = (row for step in steps if step.rule == "solution" and step.id not in chosen for row in t.rows(step.statement))
    named = {row.items[0].name: meaning(bench.study, row.items[-1]) for row in shown if isinstance(row.items[0], t.Sym)}
    return {name: value for name, value in named.items() if isinstance(value, Scalar)}


def _follows(bench: ProblemBench, step: Step, solved: Mapping[str, Scalar]) -> bool:
    """Do these solutions, put into an equation, give back a side of it that is left out?"""
    chains = (row for row in t.rows(step.statement) if isinstance(row, t.Chain))
    ends = [tuple(meaning(bench.study, row.items[place]) for place in (0, -1)) for row in chains]
    left = [first - last for first, last in ends if isinstance(first, Scalar) and isinstance(last, Scalar)]
    return any(not is_zero(value) and is_zero(substitute(value, solved)) for value in left)


def _ranked(steps: tuple[Step, ...]) -> list[Step]:
    """What matters most first, and one step of each kind before a second one of a kind."""
    again = {s.id: sum(other.rule == s.rule for other in steps[:place]) for place, s in enumerate(steps)}
    return sorted(steps, key=lambda s: (again[s.id], -WEIGHTS.get(s.rule, 0)))


def _gaps_of(bench: ProblemBench, step: Step, how: Help) -> list[Gap]:
    """A term of each sum where there is much help (the last: the spin part, the shift of the axis), else whole sides."""
    found = [gap for gap in gaps(step.statement) if has_value(bench, gap.node)]
    terms = [gap for gap in found if gap.is_term]
    sides = [gap for gap in found if not gap.is_term]
    if how.terms and terms:
        return terms[-1:]
    return sides[-1:] if how.terms else sides or terms


def _terms_beside(bench: ProblemBench, steps: tuple[Step, ...], id: str) -> list[Gap]:
    """A term of a step whose sides stand elsewhere."""
    statement = next(step.statement for step in steps if step.id == id)
    return [gap for gap in gaps(statement) if gap.is_term and has_value(bench, gap.node)][-1:]


def _with_blanks(
    bench: ProblemBench, steps: tuple[Step, ...], chosen: Mapping[str, list[Gap]]
) -> tuple[dict[str, t.Node], list[Blank]]:
    """Statements by id, and the answers, numbered in reading order."""
    statements: dict[str, t.Node] = {}
    answers: list[Blank] = []
    for step in steps:
        statement = step.statement
        for gap in chosen.get(step.id, ()):
            answers.append(Blank(len(answers) + 1, gap.node, step=step.id, anticipated=_anticipated(bench, step, gap)))
            statement = gap.left_out(statement, len(answers))
        statements[step.id] = statement
    return statements, answers


def _anticipated(bench: ProblemBench, step: Step, gap: Gap) -> tuple[Anticipated, ...]:
    """Known slips, where the blank is the whole right side of a quantity that has some."""
    found = next((x for x in bench.targets.values() if x.step == step.id), None)
    if found is None or gap.is_term or isinstance(step.statement, t.Relations):
        return ()
    return tuple(Anticipated(d.slip, d.formula) for d in bench.pool.of(found))


def _lines(
    bench: ProblemBench, setting: ItemSetting, steps: tuple[Step, ...], statements: Mapping[str, t.Node], reasons: bool
) -> Iterator[Block]:
    for before, step in zip(("", *(step.id for step in steps)), steps, strict=False):
        is_said = step.phrase not in GOES_ON or before in step.reasons
        why = sentence(bench, step, setting.said) if reasons and is_said else ()
        if why:
            yield Paragraph(why)
        yield Display(statements[step.id], numbered=False)


GOES_ON = ("kinematics.velocity", "kinematics.speed")  # “its time derivative”: of the line before


# --- explain: an open question about a step, with a rubric of what the derivation uses there


# rule -> how interesting a “why” it is; others are not asked
STATICS = 2  # of a balance of what is at rest
QUESTIONS = {"workless": 3, "work_energy": 2, "combination": 3, "conservation": 2, "torque": 1, "parallel_axis": 1,
             "jump": 3, "kept_until": 3}  # fmt: skip
KEPT = ("jump", "kept_until")  # they rest on what no force does, not on other steps,
SOLVED = ("solution", "end_state")  # and give these away
STATES = ("kinematics", "inertia", "momentum")
MOST_PREMISES = 3
CONCLUSION = 3  # the least weight of putting the premises together, on the scale of `lines.WEIGHTS`


def explanations(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a step that has a reason and premises; `about` names ids of steps."""
    struck = is_struck(bench.study)  # of a motion that ends at its start only what is true of each state
    reasoned = (s for s in bench.derivation.steps if _interest(s) and (s.rule in KEPT or _premises(bench, s)))
    given = () if bench.study.system.independent else ("work", "energy")  # of a motion that is given its forces are asked about
    steps = [s for s in reasoned if s.chapter not in given and (not struck or s.chapter in STATES)]
    named = [s for s in steps if not wish.about or any(s.id == a or s.id.startswith(f"{a}.") for a in wish.about)]
    if not named and wish.at is not None:
        ids = ", ".join(s.id for s in steps)
        raise wish.error(
            f"“{bench.name}” has no step “{', '.join(wish.about)}” to be explained",
            f"steps that can be asked: {ids}." if ids else "choose another kind of task.",
        )
    for step in sorted(named, key=lambda s: -_interest(s)):
        make = partial(_explanation, bench, wish, step)
        solved = [s.statement for s in bench.derivation.steps if s.rule in SOLVED and step.rule in KEPT and step.id in s.reasons]
        yield Prepared("explain", None, (), make, _printing(bench, (step.statement, *solved)), step.id)


def _interest(step: Step) -> int:
    """How interesting it is; of the works only a result (equal halves) is asked for, of what is at rest why torques balance
    about a point; the ledger of the forces is no line of an argument, nor is that nothing works where nothing changes."""
    if step.phrase.startswith("statics."):
        return STATICS if "forces" in step.slots["silent"].slots else 0
    if step.chapter == "forces" or (step.rule == "work_energy" and any(t.ZERO in row.items for row in t.rows(step.statement))):
        return 0
    return 3 if step.rule == "work" and step.is_result else QUESTIONS.get(step.rule, 0)


def _premises(bench: ProblemBench, step: Step) -> list[Step]:
    """What it stands on, the last first named; at most so many."""
    return [bench.derivation.step(id) for id in step.reasons][:MOST_PREMISES]


def _explanation(bench: ProblemBench, wish: Wish, step: Step, setting: ItemSetting) -> Item:
    premises = _premises(bench, step)
    usual, sample = 2 + len(premises), tuple(_sample(bench, setting, step, premises))
    prompt = (Paragraph(spoken(setting.said, "ask.explain")), Display(step.statement, numbered=False))
    asked = AskedQuantity(bench.name, step.id, t.Sym("W"), step=step.id)
    rubric = _rubric(setting, step, premises, wish.worth(usual))
    return wish.item(setting, asked, prompt, ExplanationKey(sample), usual, rubric=rubric, solution=sample, space=5)


def _sample(bench: ProblemBench, setting: ItemSetting, step: Step, premises: list[Step]) -> Iterator[Paragraph | Display]:
    for premise in premises:
        yield Display(_that_counts(premise, step), numbered=False)
    why = sentence(bench, step, setting.said)
    if why:
        yield Paragraph(why)
    yield Display(step.statement, numbered=False)


def _rubric(setting: ItemSetting, step: Step, premises: list[Step], points: Fraction) -> Iterator[Criterion]:
    """A line for the principle, one for each thing that it stands on and one for putting them together, by how much each
    step matters."""
    earned = shares(points, [*map(_weight, premises), 1, max(CONCLUSION, _weight(step))])
    principle = spoken(setting.said, f"principle.{step.rule}")
    yield Criterion(earned[-2], spoken(setting.said, "rubric.principle", principle=principle))
    for share, premise in zip(earned, premises, strict=False):
        uses = spoken(setting.said, "rubric.uses", statements=gist(_that_counts(premise, step)))
        yield Criterion(share, uses, premise.statement)
    yield Criterion(earned[-1], spoken(setting.said, "rubric.concludes"))


def _that_counts(premise: Step, step: Step) -> t.Node:
    """The rows of a premise that a step is about: of both works of a force only that of the half of which it speaks, of a
    force in the ledger what it is, and not its torques about points of which there is no talk."""
    told = _halves(step.statement)
    rows = [row for row in t.rows(premise.statement) if _halves(row) <= told][: 1 if premise.chapter == "forces" else None]
    return t.Relations(tuple(rows)) if len(rows) > 1 else rows[0] if rows else premise.statement


def _halves(node: t.Node) -> set[str]:
    """Of which works it speaks, of translation or rotation."""
    return {half for half, _ in HALVES for name in t.names(node) if name.startswith(f"cal_W_{half}_")}


def _weight(step: Step) -> int:
    return max(1, WEIGHTS.get(step.rule, 0))
