"""Claims of papers for Rocq: each PROVED formula as a lemma from the laws, the starts and the ranges of its problem alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from rbpsym.claims.check import CONSTANTS
from rbpsym.claims.conditions import relations
from rbpsym.claims.ground import Ground
from rbpsym.claims.integrals import prepared
from rbpsym.claims.model import CERTIFIED, Result
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Scalar
from rbpsym.frozen import Frozen, field
from rbpsym.kernel.certify import Written, lemma_of, named
from rbpsym.kernel.claim import Proposition, SaidByStep, tree_of
from rbpsym.kernel.claims import ClaimSource
from rbpsym.kernel.components import started
from rbpsym.kernel.coqc import AXIOMS, Report, compiled
from rbpsym.mechanics.study import Study
from rbpsym.proof.context import Context
from rbpsym.proof.facts import facts_of
from rbpsym.proof.step import Derivation

NO_COQC = "there is no coqc (apt: coq libcoq-coquelicot)"
KINDS = {"=": "equal", "<": "more", ">": "more"}


class Filed(Frozen):
    """A formula that waits for coqc, by its place among all."""

    ground: Ground
    node: t.Node
    latex: str


class Notary(Frozen):
    """Takes formulas that are proved, and says of all together what coqc says. folder: where that is kept."""

    folder: Path | None = None
    filed: list[Filed] = field(default_factory=list)

    def __call__(self, ground: Ground, node: t.Node, latex: str) -> str:
        """Files a formula; what stands in its result until it is settled."""
        self.filed.append(Filed(ground, node, latex))
        return f"filed {len(self.filed) - 1}"

    def settled(self, results: Iterable[Result]) -> list[Result]:
        """The results, with what coqc says of those that were filed."""
        found = list(results)
        told: dict[str, str] = {}
        worlds = {id(item.ground.world): item.ground.world for item in self.filed}
        for key in worlds:
            told |= self._judged({f"filed {n}": item for n, item in enumerate(self.filed) if id(item.ground.world) == key})
        return [replace(result, rocq=told.get(result.rocq, result.rocq)) for result in found]

    def _judged(self, filed: dict[str, Filed]) -> dict[str, str]:
        """Certified, or why not, of formulas about one motion."""
        study = getattr(next(iter(filed.values())).ground.world, "study", None)
        if not isinstance(study, Study):
            return dict.fromkeys(filed, "the general theory is not written for Rocq")
        try:
            whole = written_of(study, filed)
            report = compiled(whole, self.folder)
        except RbpsymError as error:
            return dict.fromkeys(filed, str(error))
        return {key: report.refused.get(key, judged(replace(report, refused={}))) for key in filed}


def written_of(study: Study, filed: dict[str, Filed]) -> Written:
    """The lemmas of some formulas about one motion."""
    read = {key: _read(item) for key, item in filed.items()}
    works = dict(next(iter(filed.values())).ground.motion.ledger)
    letters = Context(study, facts=dict(facts_of(study)), works=works)
    found = Written(ClaimSource(Derivation(study, (), letters=letters)))
    common, further = _facts(found.source, works)
    for place, (key, item) in enumerate(filed.items(), 1):
        try:
            node = read[key]
            if isinstance(node, RbpsymError):
                raise node
            assumed = {name: tree_of(value) for name, value in item.ground.premises.items()}
            constant = {name: value for name, value in assumed.items() if name in found.source.constants}
            given = [Proposition(t.Sym(name), value) for name, value in assumed.items() if name not in constant]
            found.source.moves(f"{name} " for (name, _), bound in item.ground.bounds.items() if bound.kind == "unknown")
            claims = common | named(f"given{place}", SaidByStep(tuple(given)))
            own = named(f"claim{place}", SaidByStep(assertions=tuple(_claims(node, item.ground, found.source))))
            known = (_put(claims, constant, f"'at{place}"), _put(further, constant, f"'at{place}"))
            own = _put(own, constant, "")
            found.lemmas[key] = [lemma_of(found, name, claim, (), known) for name, claim in own.items()]
        except (RbpsymError, ZeroDivisionError) as error:
            found.refused[key] = str(error)
    return found


def _read(item: Filed) -> t.Node | RbpsymError:
    """The formula with its integrals as quantities (which enters their rates in the ledger)."""
    try:
        return prepared(item.node, item.ground)
    except RbpsymError as error:
        return error


def _facts(source: ClaimSource, works: dict[str, Scalar]) -> tuple[dict[str, Proposition], dict[str, Proposition]]:
    """What is known of the motion: laws, starts, works; and its ranges."""
    facts = source.letters.facts
    ids = [id for id, fact in facts.items() if id == "law.motion" or fact.kind == "start"]
    common = {name: claim for id in ids for name, claim in named(id, source.fact(id)).items()}
    for name in works:
        common |= named(f"def.{name}", SaidByStep(tuple(source.meaning(name))))
    further: dict[str, Proposition] = {}
    for id in (id for id, fact in facts.items() if fact.kind == "range"):
        further |= named(id, source.fact(id))
    return common, further


def _put(claims: dict[str, Proposition], values: Mapping[str, t.Node], mark: str) -> dict[str, Proposition]:
    """Claims at some values of parameters, named so: m = 0 is a limit, and beside m > 0 everything would follow from it."""
    return {f"{name}{mark}": _at(claim, values) for name, claim in claims.items()} if values else claims


def _at(claim: Proposition, values: Mapping[str, t.Node]) -> Proposition:
    given = tuple(_at(item, values) for item in claim.given)
    return replace(claim, left=t.renamed(claim.left, values), right=t.renamed(claim.right, values), given=given)


# --- what a formula says


def _claims(node: t.Node, ground: Ground, source: ClaimSource) -> Iterator[Proposition]:
    """The claims of a formula, in the letters of the problem."""
    conditions = getattr(node, "conditions", ())
    given = tuple(c for part in conditions for link in relations(part) for c in _link(link, ground, source))
    found = [claim for link in relations(node) for claim in _link(link, ground, source)]
    if not found:
        raise RbpsymError("it says nothing but what a symbol means")
    yield from (replace(claim, given=given) for claim in found)


def _link(link: t.Chain, ground: Ground, source: ClaimSource) -> Iterator[Proposition]:
    (left, right), [op] = link.items, link.ops
    if op not in KINDS:
        raise RbpsymError(f"“{op}” has no words for Rocq yet")
    for one, other in ((left, right), (right, left)):
        kind = _kind(one, ground) if op == "=" else "value"
        if kind == "defined here":
            return
        if kind in ("constant", "up to a constant"):
            value = _meant(other, ground) if kind == "constant" else t.Add((_meant(other, ground), t.Neg(_meant(one, ground))))
            for part, _ in source.components.equations(value, t.ZERO):
                yield Proposition(part, started(part, source.moving))
            return
    sides = [_meant(side, ground) for side in (left, right)]
    if op == "=":
        if t.ZERO not in sides and len({bool(source.components.axes(side)) for side in sides}) == 2:
            raise RbpsymError("a vector and a number are equated")
        yield from source.relation(sides[0], "=", sides[1])
    else:
        low, high = sides if op == "<" else reversed(sides)
        yield Proposition(high, low, "more")


def _kind(node: t.Node, ground: Ground) -> str:
    if isinstance(node, t.Word):
        return "constant" if node.text.rstrip(".").lower() in CONSTANTS else "value"
    return ground.kind(node.name) if isinstance(node, t.Sym | t.Vec) else "value"


def _meant(node: t.Node, ground: Ground) -> t.Node:
    """A formula with symbols replaced by what they stand for."""
    scope = ground.scope
    if isinstance(node, t.Vec):
        if node.name not in scope.vectors:
            raise RbpsymError(f"the vector {node.name} has no components here")
        parts = zip("xyz", scope.vectors[node.name].components(), strict=True)
        return t.add(*(t.Mul((tree_of(value), t.Unit(axis))) for axis, value in parts if value))
    if isinstance(node, t.Sym):
        value = scope.scalars.get(node.name)
        return node if value is None else tree_of(value)
    if isinstance(node, t.Cross):
        return _crossed(_meant(node.left, ground), _meant(node.right, ground))
    if isinstance(node, t.Deriv):
        return _derived(node, _meant(node.of, ground), ground)
    return t.mapped(node, lambda part: _meant(part, ground))


def _crossed(left: t.Node, right: t.Node) -> t.Node:
    """A product of vectors in the plane; with one along the axis it would not stand along the axis."""
    units = {part.axis for side in (left, right) for part in t.walk(side) if isinstance(part, t.Unit)}
    if "z" in units:
        raise RbpsymError("a product with a vector along the axis has no words for Rocq yet")
    return t.Cross(left, right)


def _derived(node: t.Deriv, of: t.Node, ground: Ground) -> t.Node:
    """The rate of a coordinate is a letter; that of a formula stays a derivative."""
    rates: Any = ground.scope.rates
    for order in range(node.order, 0, -1):
        if node.wrt != "t" or not isinstance(of, t.Sym) or of.name not in rates:
            if order > 1 or node.wrt != "t":
                raise RbpsymError("such a derivative has no words for Rocq yet")
            return t.Deriv(of)
        of = tree_of(rates[of.name])
    return of


def judged(report: Report) -> str:
    """What is said of a whole derivation: certified, or which steps are not."""
    if report.axioms is None:
        return NO_COQC
    if not {*report.axioms} <= AXIOMS:
        return "it rests on further axioms"
    left = ", ".join([*report.refused][:3]) + (" …" if len(report.refused) > 3 else "")
    return CERTIFIED if not report.refused else f"{len(report.refused)} of {report.steps} steps are not: {left}"
