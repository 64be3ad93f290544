"""The last sections: the results at a glance, and what was proved by which roads."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import Derivation, Step
from rbpsym.document.model import Block, Callout, Display, ItemList, Paragraph, Section
from rbpsym.document.words import Words


def results_section(derivation: Derivation, said: Words, level: int) -> Section:
    """The boxed results once more, without numbers of their own."""
    results = [step for step in derivation.steps if step.is_result]
    blocks: tuple[Block, ...] = tuple(Display(step.statement, numbered=False) for step in _distinct(results))
    box = Callout("result", said.say("results.intro"), blocks)
    return Section(said.say("section.results"), (box,), said.prefix + "section.results", level)


def _distinct(steps: list[Step]) -> Iterator[Step]:
    seen = []
    for step in steps:
        if step.statement not in seen:
            seen.append(step.statement)
            yield step


def checks_section(derivation: Derivation, said: Words, level: int) -> Section:
    """How many steps are proved, which methods agree, what the oracles say."""
    summary = derivation.summary()
    whole = summary["proved"] == summary["steps"]
    items = [
        said.say("checks.steps" if whole else "checks.some", proved=summary["proved"], count=summary["steps"],
                 refuted=summary["refuted"], undecided=summary["undecided"]),
        *_methods(summary, said), *_oracles(summary, said),
        *(said.say(skipped.phrase, **skipped.slots) for skipped in derivation.skipped),
    ]
    blocks = (Paragraph(said.say("checks.how")), ItemList(tuple(items)))
    return Section(said.say("section.checks"), blocks, said.prefix + "section.checks", level)


def _methods(summary: dict, said: Words) -> Iterator:
    names = [said.say(f"method.{name}") for name in summary["methods"]]
    if len(names) > 1:
        yield said.say("checks.methods" if summary["methods_agree"] else "checks.differ", methods=names)


def _oracles(summary: dict, said: Words) -> Iterator:
    if summary["lagrange"]:
        yield said.say(f"checks.lagrange.{summary['lagrange']}")
    if summary["simulation"]:
        yield said.say("checks.simulation", error=power_of_ten(summary["simulation"]["max_relative_error"]))


def power_of_ten(value: float) -> str:
    """A small number for reading: 3·10⁻¹²."""
    digits, _, exponent = f"{value:.0e}".partition("e")
    raised = str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"{digits}·10{raised}"
