"""A claim decided: its formula is read, and every link of its chain gets an outcome."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from rbpsym.algebra.scalar import Scalar
from rbpsym.algebra.vector import Space
from rbpsym.equality.verdict import Kind, Verdict, all_of
from rbpsym.errors import LimitError, RbpsymError, Undecided
from rbpsym.notation import tree as t
from rbpsym.notation.latex_reader import read_latex
from rbpsym.notation.text import to_text
from rbpsym.verify import claims_decide as d
from rbpsym.verify.claims_bound import World
from rbpsym.verify.claims_dimensions import with_dimensions
from rbpsym.verify.claims_given import premises, relations, told, under
from rbpsym.verify.claims_ground import Glossary, Ground, Question, glossary, grounded, with_own_symbols
from rbpsym.verify.claims_integrals import valued
from rbpsym.verify.claims_model import EXPECTATIONS, Claim, Link, Outcome, Printed, Result, Setting, told_of, worst

CONSTANTS = frozenset({"const", "constant", "konst", "cte", "constante", "cst", "konstante"})
OUTCOMES = {Kind.PROVED: Outcome.PROVED, Kind.REFUTED: Outcome.REFUTED, Kind.UNDECIDED: Outcome.UNDECIDED}
Study = Callable[[str], World]


@dataclass(frozen=True)
class Checker:
    """Claims of one file, decided in their order.

    world: finds the world of a setting. memory: what claims of a setting defined. draws: with MathML.
    """

    world: Callable[[Setting], World]
    diagnose: Callable[[t.Node, Claim, Ground], str] | None = None
    memory: dict[str, dict[str, Scalar | Space]] = field(default_factory=dict)
    draws: bool = False

    def check(self, claim: Claim, printed: Printed | None = None) -> Result:
        """The result of a claim; `printed` is the formula as another text has it."""
        begun = time.perf_counter()
        result = self._result(claim, printed or claim.printed)
        expected = self._is_expected(claim, result)
        return replace(result, expected=expected, seconds=time.perf_counter() - begun)

    def check_safely(self, claim: Claim, printed: Printed | None = None) -> Result:
        """The result of a claim; a formula that can't be read is a result too."""
        try:
            return self.check(claim, printed)
        except RbpsymError as error:
            return unread(claim, str(error))

    def _is_expected(self, claim: Claim, result: Result) -> bool:
        right = not claim.right or result.right in ("PROVED", "DEFINITION")
        return right and result.outcome in EXPECTATIONS[claim.expect]

    def _result(self, claim: Claim, printed: Printed | None) -> Result:
        latex = printed.latex if printed else ""
        blank = Result(file="", latex=latex, outcome=Outcome.NOT_COMPUTED, detail=claim.not_computed, **told_of(claim))
        if claim.not_computed or printed is None:
            return blank
        claim = replace(claim, setting=with_own_symbols(claim.setting, self.world(claim.setting)))
        words = glossary(claim.setting.symbols)
        words = self.reading(words, claim.setting)
        node = read(printed, words)
        right = read(claim.right, words) if claim.right else None
        ground = self.ground(claim.setting, words, *filter(None, (node, right)))
        links = tuple(self.links(node, claim, ground))
        right = self._right(right, claim, ground) if right else ""
        form = claim.right.latex if claim.right else ""
        outcome = worst([link.outcome for link in links])
        return replace(blank, outcome=outcome, links=links, right=right, right_latex=form)

    def reading(self, words: Glossary, setting: Setting) -> Glossary:
        """The glossary with the dimensions of its symbols, by which an ambiguous formula is read."""
        return replace(words, table=with_dimensions(words, setting, self.world(setting)))

    def ground(self, setting: Setting, words: Glossary, *nodes: t.Node) -> Ground:
        """The ground of some formulas, with what earlier claims of their setting defined."""
        given = [(printed, read(printed, words)) for printed in setting.given]
        names = {name for node in (*nodes, *(node for _, node in given)) for name in used_names(node)}
        ground = grounded(setting, words, self.world(setting), names)
        ground = replace(ground, defined=self.memory.setdefault(setting.name, {}))
        return replace(ground, premises=premises(given, ground)) if given else ground

    def links(self, node: t.Node, claim: Claim, ground: Ground) -> Iterator[Link]:
        """The outcome of each relation that the formula asserts."""
        solved, narrow = told(ground), under(getattr(node, "conditions", ()), ground)
        for relation in relations(node):
            link = narrow(relation, lambda relation, ground: decide(relation, ground, claim.holds))
            link = replace(link, how=", ".join(filter(None, (link.how, solved))))
            if link.outcome is Outcome.REFUTED and self.diagnose and not claim.right:
                link = replace(link, diagnosis=self.diagnose(relation, claim, ground))
            yield replace(link, relation=to_text(relation), mathml=self._drawn(relation))

    def _drawn(self, relation: t.Chain) -> str:
        if not self.draws:
            return ""
        from rbpsym.notation.mathml import to_mathml

        return to_mathml(relation)

    def _right(self, node: t.Node, claim: Claim, ground: Ground) -> str:
        found = [decide(relation, ground, claim.holds) for relation in relations(node)]
        return str(worst([link.outcome for link in found]))


def unread(claim: Claim, why: str) -> Result:
    """The result of a claim that can't be read."""
    latex = claim.printed.latex if claim.printed else ""
    return Result(file="", latex=latex, outcome=Outcome.UNREAD, detail=why, **told_of(claim))


def read(printed: Printed, words: Glossary) -> t.Node:
    """The tree of a printed formula. Raises ReadError with its place."""
    return read_latex(printed.latex, words.table, place=printed.place)


def used_names(node: t.Node) -> set[str]:
    """Names of symbols in a formula, variables of integrals and derivatives among them."""
    variables = {getattr(part, key) for part in t.walk(node) for key in ("var", "wrt") if hasattr(part, key)}
    return t.names(node) | variables


def decide(relation: t.Chain, ground: Ground, depth: str = "", *, witnesses: bool = True) -> Link:
    """The outcome of one relation; what can't be computed is said, never passed."""
    try:
        return _decided(relation, ground, Question(ground, depth, witnesses))
    except (Undecided, LimitError) as error:
        return Link(relation, Outcome.UNDECIDED, detail=error.what)
    except RbpsymError as error:
        return Link(relation, Outcome.NOT_COMPUTED, detail=error.what)
    except ZeroDivisionError:
        return Link(relation, Outcome.UNDECIDED, detail="a denominator is identically zero")


def _decided(relation: t.Chain, ground: Ground, question: Question) -> Link:
    left, right = relation.items
    [op] = relation.ops
    for one, other in ((left, right), (right, left)):
        special = SPECIAL.get(_kind(one, ground)) if op == "=" else None
        if special:
            return special(relation, one, other, question)
    compare = d.RELATIONS.get(op)
    if compare is None:
        return Link(relation, Outcome.NOT_COMPUTED, detail=f"“{op}” is no relation between values")
    a, b = valued(left, ground), valued(right, ground)
    if op not in ("=", "!=") and (isinstance(a, Space) or isinstance(b, Space)):
        return Link(relation, Outcome.NOT_COMPUTED, detail="vectors are not greater or smaller than each other")
    verdict = compare(a, b, op, question)
    return _link(relation, _on_both_roads(verdict, relation, op, question))


def _link(relation: t.Chain, verdict: Verdict) -> Link:
    witness = verdict.witness
    detail = str(witness) if witness is not None else verdict.reason
    return Link(relation, OUTCOMES[verdict.kind], verdict.how, detail)


def _on_both_roads(verdict: Verdict, relation: t.Chain, op: str, question: Question) -> Verdict:
    """The general theory is decided a second time, for a body of three particles."""
    world = question.ground.world
    if not verdict.is_proved or not hasattr(world, "second_road"):
        return verdict
    return all_of([verdict, _second(relation, op, question)])


def _second(relation: t.Chain, op: str, question: Question) -> Verdict:
    ground = question.ground
    world = ground.world.second_road
    phrases = ground.world.shared
    bounds = {key: world.bound(_phrase_of(found, phrases)) for key, found in ground.bounds.items()}
    other = Ground(world, ground.glossary, bounds, {k: v for k, v in ground.defined.items() if k[:6] != "value "})
    if ground.premises:
        return Verdict(Kind.PROVED, how="from what is given")
    left, right = relation.items
    return d.RELATIONS[op](valued(left, other), valued(right, other), op, Question(other, "", False))


def _phrase_of(bound: object, phrases: dict) -> str:
    return next(phrase for phrase, found in phrases.items() if found is bound)


def _kind(node: t.Node, ground: Ground) -> str:
    if isinstance(node, t.Word):
        return "constant" if node.text.rstrip(".").lower() in CONSTANTS else "value"
    return ground.kind(node.name) if isinstance(node, (t.Sym, t.Vec)) else "value"


def _constant(relation: t.Chain, one: t.Node, other: t.Node, question: Question) -> Link:
    value = valued(other, question.ground)
    parts = value.components() if isinstance(value, Space) else (value,)
    return _link(relation, all_of(d.constant_value(part, question) for part in parts))


def _loose(relation: t.Chain, one: t.Node, other: t.Node, question: Question) -> Link:
    value, same = (valued(node, question.ground) for node in (other, one))
    return _link(relation, d.up_to_constant(value, same, question))


def _defines(relation: t.Chain, one: t.Node, other: t.Node, question: Question) -> Link:
    """The relation says what a new symbol means."""
    if one.name in t.names(other):
        return Link(relation, Outcome.NOT_COMPUTED, detail="the symbol is defined by itself")
    question.ground.defined[one.name] = valued(other, question.ground)
    return Link(relation, Outcome.DEFINITION, "it defines its symbol")


SPECIAL = {"constant": _constant, "up to a constant": _loose, "defined here": _defines}
