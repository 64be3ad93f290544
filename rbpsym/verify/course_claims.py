"""What a course says in its author's words: each sentence's claims and formulas are decided before anything is written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from rbpsym.ask.asking import meant_by
from rbpsym.derivation.step import Derivation
from rbpsym.errors import StatementError
from rbpsym.notation import tree as t
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.course import Course
from rbpsym.statement.own_text import OwnFormula, Sentence
from rbpsym.statement.source import did_you_mean
from rbpsym.verify.claims_check import Checker
from rbpsym.verify.claims_loader import claims_within
from rbpsym.verify.claims_model import EXPECTATIONS, Claim, Printed
from rbpsym.verify.claims_run import Worlds

Formulas = Mapping[tuple[str, str], t.Node]
RELATIONS = (t.Chain, t.System)


def decided(course: Course, derivations: Mapping[str, Derivation]) -> Formulas:
    """The formulas of a course's own texts as trees, by the id of their claim and their LaTeX text.

    All of the claims and of the formulas that assert something are proved; else StatementError tells which is not, and where.
    """
    sentences = [sentence for part in course.parts for _, sentence in part.sentences]
    claims = _claims(course)
    used = {id: sentence for sentence in reversed(sentences) for id in sentence.claims}
    for id, sentence in used.items():
        if id not in claims:
            raise sentence.error(f"there is no claim “{id}”", did_you_mean(id, claims, "claims"))
    checker, found = _checker(course, derivations), {}
    for claim in claims.values():
        if claim.id not in used:
            what = f"no text of the course is bound to the claim “{claim.id}”"
            raise StatementError(what, instead=f"write {{claim:{claim.id}}} in a sentence, or drop the claim.", place=claim.place)
        found[claim.id, ""] = node = _proved(checker, claim, claim.printed, used[claim.id])
        if not isinstance(node, RELATIONS):
            what = f"the claim “{claim.id}” asserts nothing: {claim.printed.latex.strip()} is no relation"
            raise StatementError(what, instead="write a relation.", place=claim.place)
    for sentence, claim, formula in _formulas(sentences, claims):
        if (claim.id, formula.latex) not in found:
            found[claim.id, formula.latex] = _proved(checker, claim, Printed(formula.latex, sentence.place), sentence)
    return found


def _claims(course: Course) -> dict[str, Claim]:
    file = claims_within(course.claims, course.file, course.name) if course.claims else None
    claims = {claim.id: claim for claim in file.claims} if file else {}
    for claim in claims.values():
        if claim.expect != "proved" or claim.printed is None:
            what = f"the claim “{claim.id}” of a course is not one that is to be proved"
            raise StatementError(what, instead=r"say what is true: of what is wrong, that a \neq b.", place=claim.place)
    return claims


def _checker(course: Course, derivations: Mapping[str, Derivation]) -> Checker:
    """One that takes the studies of what is derived already."""
    worlds = Worlds(Path(course.file).parent)
    for name, derivation in derivations.items():
        worlds.problems[name] = ProblemWorld(derivation.study, worlds.problem, meant_by)
    return Checker(worlds)


def _formulas(sentences: list[Sentence], claims: Mapping[str, Claim]) -> Iterator[tuple[Sentence, Claim, OwnFormula]]:
    for sentence in sentences:
        yield from ((sentence, claims[sentence.claims[0]], p) for p in sentence.pieces if isinstance(p, OwnFormula))


def _proved(checker: Checker, claim: Claim, printed: Printed, sentence: Sentence) -> t.Node:
    """The tree of a formula; of one that asserts something, once it is proved."""
    node = checker.tree(claim, printed)
    if isinstance(node, RELATIONS):
        result = checker.check(replace(claim, printed=printed))
        if result.outcome not in EXPECTATIONS["proved"]:
            why = "; ".join(filter(None, (result.detail, *(link.detail for link in result.links))))
            told = f"“{sentence.told}” stands by the claim “{claim.id}”, and {printed.latex.strip()} is {result.outcome}"
            instead = "say what is true, or leave the sentence out."
            raise StatementError(f"{told}{': ' if why else ''}{why}", instead=instead, place=claim.place or sentence.place)
    return node
