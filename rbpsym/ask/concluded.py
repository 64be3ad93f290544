"""What was found about parameters, as an answer with its steps: those of the quantities in it, and the one that concludes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rbpsym.algebra.calculus import depends_on
from rbpsym.ask.answer import Answer
from rbpsym.ask.certified import LETTER, certified
from rbpsym.ask.finding import Finding
from rbpsym.ask.question import Question
from rbpsym.ask.seen import Scene
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.rules import RULES
from rbpsym.derivation.step import Certificate, Step
from rbpsym.equality.verdict import all_of, undecided
from rbpsym.mechanics.demands import settle
from rbpsym.notation import tree as t

LASTING = "if the contacts and the friction last so far, which is not decided"
OPS = ("=", "<", ">", "<=", ">=")


def concluded(world: Scene, text: str, found: Finding, letter: str = LETTER) -> Answer:
    """The answer, called by the letter if it is no parameter: PROVED if what was found is, and the quantities in it are
    what is said of them."""
    draft, quantities = Draft(world.study), {question.text: (question, one) for question, one in world.used}
    kept = [pair for pair in quantities.values() if pair[1].moment or pair[1].told or pair[1].named != pair[1].values]
    stem = f"{letter}_".lower() if "_" not in letter else letter.lower()
    names = [stem.rstrip("_")] if len(kept) == 1 else [f"{stem}{number}" for number in range(1, len(kept) + 1)]
    grounds = [certified(world.asked, *pair, name, is_ground=True) for pair, name in zip(kept, names, strict=True)]
    name = found.symbol or (found.place or ("",))[0]
    more = [] if found.met else [demand for demand in world.demands if not depends_on(demand.value, name)]
    left = settle((*found.valid, *more), world.motion.assumptions)
    found = replace(found, valid=(*found.valid, *more) if left is None else left) if more else found
    doubts = [] if found.symbol else map(undecided, world.doubts)
    nodes = tuple(draft.show(value, factor=True, met=found.valid) for value in found.values)
    last = tuple(_last(draft, found, nodes, letter))
    return Answer(
        Question(text, found.symbol or text),
        world.study,
        found.values,
        nodes,
        all_of([found.verdict, *doubts, *(ground.verdict for ground in grounds)]),
        "",
        draft.asked(found.valid),
        (*_steps(grounds), *last),
        symbol=found.symbol,
        relation=found.relation,
        says="; ".join(filter(None, (found.says, LASTING if found.symbol and world.doubts else ""))),
        holds_so=found.holds,
        each=tuple(draft.asked(demands) for demands in found.asked) if any(found.asked) else (),
        equation=None if found.equation is None else draft.show(found.equation, factor=True),
        at=None if found.place is None or found.place[1] is None else (found.place[0], draft.show(found.place[1])),
    )


def _steps(grounds: list[Answer]) -> Iterator[Step]:
    """The steps of all quantities, each once; what a quantity is, by its own number, if no step says that value already."""
    seen: set[object] = set()
    for number, ground in enumerate(grounds, 1):
        for step in ground.steps:
            if step.id != "answer" and step.statement not in seen:
                yield step
            if step.id == "answer" and not any(_value(step) == _value(other) for other in ground.steps[:-1]):
                yield replace(step, id=f"quantity.{number}", phrase="ask.quantity", is_result=False)
            seen.add(step.statement)


def _value(step: Step) -> t.Node:
    """What its statement comes to; a system as it is."""
    return step.statement.items[-1] if isinstance(step.statement, t.Chain) else step.statement


def _last(draft: Draft, found: Finding, nodes: tuple[t.Node, ...], name: str) -> Iterator[Step]:
    """The step that states what was found, if a rule checked it and it is a formula."""
    letter = t.Sym(found.symbol or draft.free(name))
    if not found.rule or not nodes:
        return
    rows = [t.relation(letter, found.relation if found.relation in OPS else "=", node) for node in nodes]
    if found.relation == "between":
        rows = [t.relation(letter, op, node) for op, node in zip((">", "<"), nodes, strict=True)]
    statement = rows[0] if len(rows) == 1 else t.System(tuple(rows))
    certificate = Certificate(tuple(check.__name__ for check in RULES[found.rule]), found.verdict)
    obligations = draft.asked(found.valid)
    yield Step("answer", found.rule, statement, "ask", "ask.found", data=found.data, is_result=True,
               obligations=obligations, certificate=certificate)  # fmt: skip
