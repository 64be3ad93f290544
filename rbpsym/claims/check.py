"""A claim decided: its formula is read, and every link of its chain gets an outcome.

Beside a claim are assumed premises, each solved for one quantity, and the conditions of its display.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

from rbpsym.claims import decide as d
from rbpsym.claims.conditions import asserted, is_state, relations, under
from rbpsym.claims.ground import EqualityQuestion, Glossary, Ground, glossary, grounded, with_own_symbols
from rbpsym.claims.integrals import NoValueError, as_vector, valued, with_dimensions
from rbpsym.claims.model import EXPECTATIONS, Claim, Link, Outcome, Printed, Result, Setting, told_of, worst
from rbpsym.claims.respelling import Change, equated, respellings
from rbpsym.decide.points import names_of
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Kind, Verdict, all_of, refuted
from rbpsym.errors import LimitError, RbpsymError, ReadError, Undecided, WorkSpent
from rbpsym.expr import tree as t
from rbpsym.expr.latex.reader import read_latex
from rbpsym.field import NOTHING, Scalar, Space, depends_on, derivative, granted, substitute, symbol
from rbpsym.frozen import Frozen, field, replace
from rbpsym.present.forms import present
from rbpsym.quantity.bound import World
from rbpsym.typeset.text import to_text

# what a value may not be, by the declared sign of its name
CONTRADICTS = {
    "positive": frozenset(("zero", "negative", "nonpositive")), "nonnegative": frozenset(("negative",)),
    "nonzero": frozenset(("zero",)),
}  # fmt: skip
HOLDS = (Outcome.PROVED, Outcome.DEFINITION)


def premises(given: Iterable[tuple[Printed, t.Node]], ground: Ground) -> dict[str, Scalar]:
    """What the given relations make of one quantity each, in their order.

    A work that is given to be zero has the power zero. Raises ReadError for what can't be solved for one quantity,
    or only so that it contradicts a declared sign.
    """
    found: dict[str, Scalar] = {}
    for printed, relation in ((printed, relation) for printed, node in given for relation in relations(node)):
        try:
            name, value = _solved(relation, ground, found)
        except RbpsymError as error:
            raise ReadError(error.what, instead=error.instead, place=printed.place) from None
        found = {known: substitute(old, {name: value}) for known, old in found.items()} | {name: value}
    return found


def _solved(relation: t.Chain, ground: Ground, found: dict[str, Scalar]) -> tuple[str, Scalar]:
    """(the quantity that a given relation is solved for, its value): one that stands in it, before any other."""
    question, declared = EqualityQuestion(ground), ground.motion.assumptions
    left, right = (valued(side, ground) for side in relation.items)
    if relation.ops != ("=",) or isinstance(left, Space) or isinstance(right, Space):
        raise ReadError("only an equation between numbers can be given")
    gap = left - right
    moving = any(depends_on(gap, name) for name in (*ground.motion.ledger, *ground.motion.starts))
    gap = substitute(question.seen(question.rate(gap) if moving else gap, "motion"), found)
    alone = [ground.generator(side.name) for side in relation.items if isinstance(side, t.Sym)]
    printed = sorted(filter(None, (ground.generator(name) for name in t.names(relation))))
    refused = ""
    for name in dict.fromkeys((*alone, *printed, *names_of([gap]))):
        if name is None or name in ground.motion.scope.rates or name.endswith(("_dot", "_ddot")):
            continue
        slope = derivative(gap, name)
        if not slope or depends_on(slope, name):
            continue
        value = -(substitute(gap, {name: NOTHING}) / slope)
        is_limit = name in alone and not value  # m = 0, said of a mass, is a limit
        kind = sign(value, declared).kind
        if is_limit or kind not in CONTRADICTS.get(declared.sign_of(name), ()):
            return name, value
        refused = refused or f"this makes {to_text(t.Sym(name))} {kind}, which is declared {declared.sign_of(name)}"
    raise ReadError(refused or "what is given can't be solved for one quantity")


def told(ground: Ground) -> str:
    """What each premise was solved for, in words."""
    pairs = ((t.Sym(name.strip()), present(value)) for name, value in ground.premises.items())
    return " and ".join(f"given {to_text(t.equation(*pair))}" for pair in pairs)


if TYPE_CHECKING:
    from rbpsym.claims.diagnosis import Diagnosis
    from rbpsym.claims.theory import TheoryWorld

CONSTANTS = frozenset({"const", "constant", "konst", "cte", "constante", "cst", "konstante"})
MOST_REPAIR = 400_000  # products of terms for what a formula seems to mean
Neighbours = Mapping[t.Chain, bool]  # relations beside one in its chain, which share a side with it, and whether they hold
NOBODY: Neighbours = MappingProxyType({})
OUTCOMES = {Kind.PROVED: Outcome.PROVED, Kind.REFUTED: Outcome.REFUTED, Kind.UNDECIDED: Outcome.UNDECIDED}


class Checker(Frozen):
    """Claims of one file, decided in their order.

    world: finds the world of a setting. memory: what claims of a setting defined. draws: with MathML. witnesses: are
    they asked for?
    """

    world: Callable[[Setting], World]
    diagnose: Callable[[t.Chain, Claim, Ground, Neighbours], Diagnosis] | None = None
    memory: dict[str, dict[str, Scalar | Space]] = field(default_factory=dict)
    draws: bool = False
    witnesses: bool = True

    def check(self, claim: Claim, printed: Printed | None = None) -> Result:
        """The result of a claim; `printed` is the formula as another text has it."""
        begun = time.perf_counter()
        result = self._result(claim, printed or claim.printed)
        expected = self._is_expected(claim, result)
        return replace(result, expected=expected, seconds=time.perf_counter() - begun)

    def check_safely(self, claim: Claim) -> Result:
        """The result of a claim; a formula that can't be read is a result too."""
        try:
            return self.check(claim)
        except RbpsymError as error:
            return unread(claim, str(error), self.respelled(claim, claim.printed, error))

    def respelled(self, claim: Claim, printed: Printed | None, error: RbpsymError) -> tuple[Link, ...]:
        """What seems to be meant where a formula can't be read: the first change of its text with which it is proved."""
        if printed is None or not isinstance(error, ReadError) or not self.diagnose:
            return ()
        names = {**claim.setting.symbols, **with_own_symbols(claim.setting, self.world(claim.setting)).symbols}
        return self._meant(claim, Link("", Outcome.UNREAD, detail=error.what), respellings(printed.latex, error, names))

    def _meant(self, claim: Claim, link: Link, changes: Iterable[Change]) -> tuple[Link, ...]:
        """The link with the first change of the formula's text with which all of it is proved."""
        plain = replace(self, diagnose=None, witnesses=False, memory={name: {**known} for name, known in self.memory.items()})
        for fix, words in changes:
            with suppress(RbpsymError, WorkSpent), granted(MOST_REPAIR):
                if plain._result(claim, Printed(fix)).outcome is Outcome.PROVED:
                    return (replace(link, diagnosis=words, fix=fix),)
        return ()

    def _is_expected(self, claim: Claim, result: Result) -> bool:
        right = not claim.right or result.right in ("PROVED", "DEFINITION")
        return right and result.outcome in EXPECTATIONS[claim.expect]

    def _result(self, claim: Claim, printed: Printed | None) -> Result:
        latex = printed.latex if printed else ""
        blank = Result(file="", latex=latex, outcome=Outcome.NOT_COMPUTED, detail=claim.not_computed, **told_of(claim))
        if claim.not_computed or printed is None:
            return blank
        claim = replace(claim, setting=with_own_symbols(claim.setting, self.world(claim.setting)))
        node, ground = self.opened(claim, printed)
        intended = read(claim.right, ground.glossary) if claim.right else None
        links = tuple(self.links(node, claim, ground, latex))
        wrong = [k for k, link in enumerate(links) if link.outcome is Outcome.REFUTED and self.diagnose]
        if len(wrong) > 1 and (meant := self._meant(claim, links[wrong[0]], equated(latex))):
            links = (*links[: wrong[0]], *meant, *links[wrong[0] + 1 :])
        right = self._right(intended, claim, ground) if intended else ""
        form = claim.right.latex if claim.right else ""
        outcome = worst([link.outcome for link in links])
        return replace(blank, outcome=outcome, links=links, right=right, right_latex=form)

    def opened(self, claim: Claim, printed: Printed | None) -> tuple[t.Node, Ground]:
        """The formula of a claim as it is read, and the ground on which it is decided. Raises ReadError with its place."""
        setting = with_own_symbols(claim.setting, self.world(claim.setting))
        words = self.reading(glossary(setting.symbols), setting)
        nodes = [read(one, words) for one in (printed, claim.right) if one is not None]
        return nodes[0], self.ground(setting, words, *nodes)

    def tree(self, claim: Claim, printed: Printed) -> t.Node:
        """The formula of a claim, or another one in its symbols, as it is read. Raises ReadError with its place."""
        setting = with_own_symbols(claim.setting, self.world(claim.setting))
        return read(printed, self.reading(glossary(setting.symbols), setting))

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

    def links(self, node: t.Node, claim: Claim, ground: Ground, latex: str = "") -> Iterator[Link]:
        """The outcome of each relation that the formula asserts."""
        solved, rows = told(ground), [*asserted(node)]
        known: dict[t.Chain, Link] = {}
        shown: dict[t.Chain, set[t.Chain]] = {}

        def decided(relation: t.Chain, where: Ground = ground) -> Link:
            if where is not ground:
                return decide(relation, where, claim.holds, witnesses=self.witnesses)
            if relation not in known:
                known[relation] = decide(relation, where, claim.holds, witnesses=self.witnesses)
            return known[relation]

        def is_open(link: t.Chain) -> bool:
            return is_state(link, ground) and decided(link).outcome not in HOLDS

        begun = {one for _, _, sources in rows for one in sources}
        for place, (relation, conditions, sources) in enumerate(rows):
            if not sources and relation in begun and is_open(relation):
                continue  # it is said of what follows from it only
            opened = [one for one in sources if is_open(one) and not (one in shown and shown[one] <= {*sources})]
            link = under((*conditions, *opened), relation, ground, decided)
            if link.outcome in HOLDS:
                shown[relation] = {*opened}
            link = replace(link, how=", ".join(filter(None, (link.how, solved))))
            if link.outcome in (Outcome.REFUTED, Outcome.UNDECIDED) and self.diagnose and not claim.right:
                near = (one for one, _, _ in rows if one is not relation and {*map(id, one.items)} & {*map(id, relation.items)})
                with suppress(RbpsymError, ZeroDivisionError):  # of what else the motion would have to be known
                    found = self.diagnose(relation, claim, ground, {one: decided(one).outcome in HOLDS for one in near})
                    fix = self._fix(latex, place, relation, found.relation, claim) if found.relation and latex else ""
                    link = replace(link, diagnosis=found.words, fix=fix)
            yield replace(link, relation=to_text(relation), mathml=self._drawn(relation))

    def _fix(self, latex: str, place: int, relation: t.Chain, repaired: t.Chain, claim: Claim) -> str:
        """The formula with one relation repaired, if that relation is proved as it is read again."""
        from rbpsym.claims.diagnosis_edits import corrected

        words = self.reading(glossary(claim.setting.symbols), claim.setting)
        written = corrected(latex, relation, repaired, {name: latex for latex, (name, _) in words.names.items()})
        try:
            again = read(Printed(written), words)
            ground = self.ground(claim.setting, words, again)
            found = [decide(one, ground, claim.holds, witnesses=False) for one in relations(again)]
        except RbpsymError:
            return ""
        return written if written and len(found) > place and found[place].outcome is Outcome.PROVED else ""

    def _drawn(self, relation: t.Chain) -> str:
        if not self.draws:
            return ""
        from rbpsym.typeset.mathml import to_mathml

        return to_mathml(relation)

    def _right(self, node: t.Node, claim: Claim, ground: Ground) -> str:
        found = [decide(relation, ground, claim.holds) for relation in relations(node)]
        return str(worst([link.outcome for link in found]))


def unread(claim: Claim, why: str, links: tuple[Link, ...] = ()) -> Result:
    """The result of a claim that can't be read, with what seems to be meant."""
    latex, links = claim.printed.latex if claim.printed else "", tuple(replace(link, detail=why) for link in links)
    return Result(file="", latex=latex, outcome=Outcome.UNREAD, detail=why, links=links, **told_of(claim))


def read(printed: Printed, words: Glossary) -> t.Node:
    """The tree of a printed formula. Raises ReadError with its place."""
    return read_latex(printed.latex, words.table, place=printed.place)


def used_names(node: t.Node) -> set[str]:
    """Names of symbols in a formula, variables of integrals and derivatives among them."""
    variables = {getattr(part, key) for part in t.walk(node) for key in ("var", "wrt") if hasattr(part, key)}
    return t.names(node) | variables


def decide(relation: t.Chain, ground: Ground, depth: str = "", *, witnesses: bool = True) -> Link:
    """The outcome of one relation; what can't be computed is said, never passed. What is false of d/dθ along the motion may be
    meant of ∂/∂θ, and what is false with a constant that nobody knows may hold with another."""
    found = _outcome(relation, ground, depth, witnesses)
    free = sorted(name for name in t.names(relation) if ground.kind(name) == "constant")
    if found.outcome is Outcome.REFUTED and free and not any(_kind(side, ground) in SPECIAL for side in relation.items):
        return replace(found, outcome=Outcome.UNDECIDED, detail=f"it is not said which value {to_text(t.Sym(free[0]))} has")
    if found.outcome is Outcome.REFUTED and (loose := _with_partials(relation)) != relation:
        meant = _outcome(loose, ground, depth, False)
        if meant.outcome is Outcome.PROVED:
            return replace(found, outcome=Outcome.UNDECIDED, detail="it is true with ∂ in place of d")
    return found


def _with_partials(node: Any) -> Any:
    node = t.mapped(node, _with_partials)
    return replace(node, partial=True) if isinstance(node, t.Deriv) and node.wrt != "t" else node


def _outcome(relation: t.Chain, ground: Ground, depth: str, witnesses: bool) -> Link:
    try:
        return _decided(relation, ground, EqualityQuestion(ground, depth, witnesses))
    except NoValueError as error:
        return _link(relation, refuted(error.what, error.witness))
    except (Undecided, LimitError) as error:
        return Link(relation, Outcome.UNDECIDED, detail=error.what)
    except RbpsymError as error:
        return Link(relation, Outcome.NOT_COMPUTED, detail=error.what)
    except ZeroDivisionError:
        return Link(relation, Outcome.UNDECIDED, detail="a denominator is identically zero")


def _decided(relation: t.Chain, ground: Ground, question: EqualityQuestion) -> Link:
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
    gained = _gained(relation, ground)
    if gained in (NOTHING, Space()):
        return _link(relation, _on_both_roads(compare(a, b, op, question), relation, op, question))
    scalars = [one for one in (gained, a, b) if isinstance(one, Scalar)]
    if op == "=" and len(scalars) == 3 and d.is_constant(scalars[0], question, ("identity",)):
        return _link(relation, d.up_to_constant(scalars[1], scalars[2], question))
    return Link(relation, Outcome.UNDECIDED, detail="a symbol is known up to a constant only, on which this depends")


def _gained(relation: t.Chain, ground: Ground) -> Scalar | Space:
    """By how much the sides are further apart if a constant is added to what is known up to a constant only."""
    loose = {name for name in t.names(relation) if ground.kind(name) == "up to a constant"}
    if not loose:
        return NOTHING
    more = {key: replace(one, scalar=one.number + symbol("C_0")) for key, one in ground.bounds.items() if key[0] in loose}
    grounds = (replace(ground, bounds={**ground.bounds, **more}), ground)
    far, near = (valued(t.add(relation.items[0], t.Neg(relation.items[1])), one) for one in grounds)
    return far - near if isinstance(far, Scalar) and isinstance(near, Scalar) else as_vector(far) - as_vector(near)


def _link(relation: t.Chain, verdict: Verdict) -> Link:
    witness = verdict.witness
    detail = str(witness) if witness is not None else verdict.reason
    return Link(relation, OUTCOMES[verdict.kind], verdict.how, detail)


def _on_both_roads(verdict: Verdict, relation: t.Chain, op: str, question: EqualityQuestion) -> Verdict:
    """The general theory is decided a second time, for a body of three particles."""
    world = question.ground.world
    if not verdict.is_proved or not hasattr(world, "second_road"):
        return verdict
    return all_of([verdict, _second(relation, op, question)])


def _second(relation: t.Chain, op: str, question: EqualityQuestion) -> Verdict:
    ground, theory = question.ground, cast("TheoryWorld", question.ground.world)
    bounds = {key: theory.again(found) for key, found in ground.bounds.items()}
    other = Ground(theory.second_road, ground.glossary, bounds, {k: v for k, v in ground.defined.items() if k[:6] != "value "})
    if ground.premises:
        return Verdict(Kind.PROVED, how="from what is given")
    left, right = relation.items
    return d.RELATIONS[op](valued(left, other), valued(right, other), op, EqualityQuestion(other, "", False))


def _kind(node: t.Node, ground: Ground) -> str:
    if isinstance(node, t.Word):
        return "constant" if node.text.rstrip(".").lower() in CONSTANTS else "value"
    return ground.kind(node.name) if isinstance(node, (t.Sym, t.Vec)) else "value"


def _constant(relation: t.Chain, one: Any, other: t.Node, question: EqualityQuestion) -> Link:
    value = valued(other, question.ground)
    parts = value.components() if isinstance(value, Space) else (value,)
    return _link(relation, all_of(d.constant_value(part, question) for part in parts))


def _defines(relation: t.Chain, one: Any, other: t.Node, question: EqualityQuestion) -> Link:
    """The relation says what a new symbol means."""
    if one.name in t.names(other):
        return Link(relation, Outcome.NOT_COMPUTED, detail="the symbol is defined by itself")
    question.ground.defined[one.name] = valued(other, question.ground)
    return Link(relation, Outcome.DEFINITION, "it defines its symbol")


SPECIAL = {"constant": _constant, "defined here": _defines}
