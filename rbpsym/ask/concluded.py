"""What was found about parameters, as an answer with its steps: those of the quantities in it, and the one that concludes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from rbpsym.ask.asked import Asked
from rbpsym.ask.certified import LETTER, certified
from rbpsym.ask.finding import Finding, doubts, ground
from rbpsym.ask.found import Answer
from rbpsym.ask.question import SUPERLATIVES, Question
from rbpsym.ask.seen import AskedPhase, never_told
from rbpsym.ask.senses import narrowed, of_sense
from rbpsym.ask.special import left_open
from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import scalars_equal
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, all_of, undecided
from rbpsym.errors import there
from rbpsym.expr import tree as t
from rbpsym.field import depends_on, derivative
from rbpsym.mechanics.demands import Demand, possible, settle
from rbpsym.mechanics.pushing import asked as asked_of_start
from rbpsym.mechanics.roots import zeros
from rbpsym.present.forms import present
from rbpsym.proof.checks.of_steps import guarded
from rbpsym.proof.context import Context
from rbpsym.proof.draft import Draft
from rbpsym.proof.rules import RULES
from rbpsym.proof.step import Certificate, Step

OPS = ("=", "<", ">", "<=", ">=")


def concluded(world: AskedPhase, text: str, found: Finding, letter: str = LETTER) -> Answer:
    """The answer, called by the letter if it is no parameter: PROVED if what was found is, and the quantities in it are
    what is said of them."""
    draft, used = Draft(world.study), {(q.text, q.phase): (q, one) for q, one in world.used}
    kept = [pair for pair in used.values() if pair[1].moment or pair[1].told or pair[1].named != pair[1].values]
    stem = f"{letter}_" if found.symbol and letter != LETTER else f"{letter if '_' not in letter else LETTER}_".lower()
    names = [stem.rstrip("_")] if len(kept) == 1 else [f"{stem}{number}" for number in range(1, len(kept) + 1)]
    quantities: list[Answer] = []
    for pair, own in zip(kept, names, strict=True):
        taken = [row[0].name for one in quantities for row in t.relations(one.steps[-1].statement) if isinstance(row[0], t.Sym)]
        quantities.append(certified(world.asked, *pair, own, is_ground=True, apart=taken))
    name = found.symbol or (found.place or ("",))[0]
    more = [] if found.met else [demand for demand in world.demands if not depends_on(demand.value, name)]
    there, open_ = left_open(world, found)
    more = [*more, *there]
    if more:
        found = replace(found, valid=possible((*found.valid, *more), world.motion.assumptions, never_told(text)))
    found = _not_contradicted(found, world.motion.assumptions)
    nodes = tuple(draft.show(value, factor=True, met=found.valid) for value in found.values)
    letters = {}
    if found.form is not None:
        letters = {question.text: draft.show(one.values[0], factor=True) for question, one in world.used}
        letters |= {pair[0].text: _as_letter(draft, told) for pair, told in zip(kept, quantities, strict=True)}
    steps, said = _steps(quantities)
    more_steps = (*(_slope(draft, found, quantities[0]) if said == ["quantity.1"] else ()), *found.steps)
    cites = dict.fromkeys((*said, *(step.id for step in more_steps[-1:])))
    last = replace(_last(draft, found, nodes, letter, letters), cites=tuple(cites))
    last = replace(last, phrase="ask.found.turns") if more_steps != found.steps else last
    return Answer(
        Question(text, found.symbol or text),
        world.study,
        found.values,
        nodes,
        all_of([last.certificate.verdict, *map(undecided, open_), *(one.verdict for one in quantities)]),
        "",
        draft.asked(found.valid),
        (*steps, *more_steps, *([last] if nodes and found.grounds else [])),
        symbol=found.symbol,
        relation=found.relation,
        says=found.says,
        holds_so=found.holds,
        each=tuple(draft.asked(demands) for demands in found.asked) if any(found.asked) else (),
        equation=None if found.equation is None else draft.show(found.equation, factor=True),
        conclusion=last,
        grounds=tuple(map(ground, found.grounds)),
        derivations=tuple(part for one in quantities for part in one.derivations),
        at=None if found.place is None or found.place[1] is None else (found.place[0], draft.show(found.place[1])),
    )


def _not_contradicted(found: Finding, given: Assumptions) -> Finding:
    """Without the values whose own conditions contradict those of all."""
    if found.relation == "between" or not len(found.values) == len(found.asked) > 1:
        return found
    left = [settle((*found.valid, *demands), given) for demands in found.asked]
    kept = [k for k, demands in enumerate(left) if demands is not None]
    if len(kept) in (0, len(left)):
        return found
    grounds = tuple(found.grounds[k] for k in kept) if found.parted else found.grounds
    values, asked = tuple(found.values[k] for k in kept), tuple(found.asked[k] for k in kept)
    found = replace(found, values=values, asked=asked, grounds=grounds)
    return replace(found, valid=there(left[kept[0]]), asked=()) if len(kept) == 1 else found


def _steps(quantities: list[Answer]) -> tuple[list[Step], list[str]]:
    """The steps of all quantities, each once; what a quantity is, by its own number, if no step says that value already; and
    the ids of the steps that say what the quantities are."""
    steps: dict[object, Step] = {}
    said: list[str] = []
    for number, told in enumerate(quantities, 1):
        for step in told.steps:
            if step.id != "answer":
                steps.setdefault(step.statement, step)
                continue
            known = next((one for one in told.steps[:-1] if _value(step) in (_value(one), *_sides(one))), None)
            own = replace(step, id=f"quantity.{number}", phrase="ask.quantity", is_result=False)
            said.append(steps[known.statement].id if known else steps.setdefault(step.statement, own).id)
    return [*steps.values()], said


def _slope(draft: Draft, found: Finding, quantity: Answer) -> Iterator[Step]:
    """How the quantity that is extreme within a range grows there: the slope that vanishes where it is so."""
    if found.rule != "extreme" or not found.symbol or found.grounds[0][1]["at_end"]:
        return
    letter, extreme = _as_letter(draft, quantity), found.grounds[0][1]
    value = draft.context.value(letter)
    if isinstance(letter, t.Sym) and scalars_equal(value, extreme["value"], extreme["given"]).is_proved:
        name, slope = found.symbol, draft.show(derivative(value, found.symbol), factor=True)
        yield draft.add("slope", "identity", t.equation(t.Deriv(letter, name), slope), "ask.slope", name=t.Sym(name))


def _value(step: Step) -> t.Node:
    """What its statement comes to; a system as it is."""
    return step.statement.items[-1] if isinstance(step.statement, t.Chain) else step.statement


def _sides(step: Step) -> Iterator[t.Node]:
    """What the rows of its statement come to."""
    return (row[-1] for row in t.relations(step.statement))


def _as_letter(draft: Draft, told: Answer) -> t.Node:
    """The letter of a quantity, with the value that its step states; that itself where it has no letter."""
    rows = [*t.relations(told.steps[-1].statement)]
    letter, value = rows[0][0], rows[-1][-1]
    return draft.define(letter.name, draft.context.value(value)) if isinstance(letter, t.Sym) else value


def _last(draft: Draft, found: Finding, nodes: tuple[t.Node, ...], name: str, letters: Mapping[str, t.Node]) -> Step:
    """The step that states what was found: it follows by the rules of its grounds, or from a step of a chapter."""
    letter = t.Sym(found.symbol or draft.free(name))
    ops = (">", "<") if found.relation == "between" else (found.relation if found.relation in OPS else "=",) * len(nodes)
    rows = [t.relation(letter, op, node) for op, node in zip(ops, nodes, strict=True)]
    if found.form is not None:
        draft.define(letter.name, found.values[0])
        rows = [t.equation(letter, t.renamed(found.form, letters), nodes[0])]
    statement = t.ZERO if not rows else rows[0] if len(rows) == 1 else t.Relations(tuple(rows))
    verdict = all_of([*([found.verdict] if found.verdict else []), *_verdicts(draft.context, found, rows), *doubts(found)])
    step = ground(found.grounds[0] if found.grounds else ("identity", {}), statement)
    checks = tuple(dict.fromkeys(check.__name__ for rule, _ in found.grounds for check in RULES[rule]))
    return replace(step, is_result=True, obligations=draft.asked(found.valid), certificate=Certificate(checks, verdict))


def _verdicts(context: Context, found: Finding, rows: Sequence[t.Chain]) -> Iterator[Verdict]:
    """What the rules say of each row that is stated; nothing is proved without one."""
    yield from (step.certificate.verdict for step in found.steps)
    if not (found.grounds or found.steps):
        yield undecided("no rule says so")
    seeing = [one for one in found.grounds if one[0] == found.rule]
    seen_by = [(one,) for one in found.grounds] if found.parted else [seeing] * len(rows)
    for row, grounds in zip(rows, seen_by, strict=True) if found.grounds else ():
        checks = ((RULES[one[0]][0], ground(one, row)) for one in grounds)
        said = [guarded(partial(check, context, step)) for check, step in checks]
        yield next((verdict for verdict in said if verdict.is_proved), said[0])


Part = tuple[AskedPhase, Finding]
ONE_SENSE = "in the motion of the other sense it may be otherwise"


def beyond(world: AskedPhase, name: str) -> tuple[Asked, int] | None:
    """The problem with the parameter where what slips at the start does so the other way, or where the motion sets out
    otherwise, which it does for greater (1) or lesser (-1) values; None where that does not depend on it, or is declared."""
    problem, given = world.asked.problem, world.asked.first.assumptions
    quantity = next((each for each in problem.parameters if each.name == name), None)
    starts = asked_of_start(world.asked.first) if quantity is not None else ()
    slips = [value for element, what, value in starts if what == "slip" and element.values.get("slip") == "auto"]
    ways = of_sense(world.asked, world.senses)
    moments = [demand.value for demand in (*world.demands, *ways) if demand.op == ">"]
    if quantity is None:
        return None
    for value in (*slips, *moments):
        ends = [end for end in zeros(value, name) if sign(end, given).kind == "positive"] if depends_on(value, name) else []
        top = given.range_of(name)[1]
        ends = [end for end in ends if top is None or settle([Demand(top - end)], given) is not None]
        side = {"positive": "upper", "negative": "lower"}.get(sign(derivative(value, name), given).kind or "")
        if len(ends) == 1 and side and sign(value, given).kind is None and getattr(quantity, side) is None:
            end, is_below = present(ends[0]), side == "lower"
            other = replace(quantity, lower=end) if is_below else replace(quantity, upper=end)
            return Asked(narrowed(problem, other)), 1 if is_below else -1
    return None


def joined(text: str, here: Part, there: Part, way: int, letter: str) -> Answer:
    """The answer from what was found with the one sense and with the other one, which it has for greater (1) or
    lesser (-1) values."""
    (world, first), (_, second) = here, there
    if first.is_none and second.is_none:
        firm = tuple(demand for demand in first.valid if not depends_on(demand.value, first.symbol))
        return concluded(world, text, replace(first, valid=firm, met=True), letter)
    best = SUPERLATIVES.get(text.partition(" ")[0], 0)
    is_beyond = best == way and first.relation == second.relation == "=" and second.values
    if first.is_none or is_beyond:
        return concluded(there[0], text, second, letter)
    made = concluded(world, text, first, letter)
    if second.is_none or (best == -way and first.relation == "=" and first.values):
        return made
    if first.rule == second.rule == "vanishes_for":
        return _both(made, concluded(there[0], text, second, letter))
    return replace(made, verdict=all_of((made.verdict, undecided(ONE_SENSE))))


def either(text: str, here: Part, there: Part, letter: str) -> Answer:
    """The values from what was found with a start on one side, and on the other one."""
    made, second = concluded(here[0], text, here[1], letter), there[1]
    if second.is_none and second.verdict is not None and second.verdict.is_proved:
        return made
    if second.values and second.rule == here[1].rule:
        return _both(made, concluded(there[0], text, second, letter))
    return replace(made, verdict=all_of((made.verdict, undecided(ONE_SENSE))))


def _both(first: Answer, second: Answer) -> Answer:
    """The values of both, each under its conditions."""
    each = [(*one.valid, *own) for one in (first, second) for own in one.each or ((),) * len(one.values)]
    steps = tuple(replace(step, id=f"other.{step.id}") for step in second.steps if step not in first.steps)
    return replace(
        first,
        values=(*first.values, *second.values),
        nodes=(*first.nodes, *second.nodes),
        verdict=all_of((first.verdict, second.verdict)),
        valid=(),
        each=tuple(each) if any(each) else (),
        steps=(*first.steps, *steps),
    )
