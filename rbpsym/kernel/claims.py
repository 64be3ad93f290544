"""What the steps and facts of a derivation say, as claims about functions of time, neutral of any prover."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Vector, cartesian, names_in, symbol
from rbpsym.kernel.asserted import MORE
from rbpsym.kernel.begins import event, letters_then
from rbpsym.kernel.claim import AHEAD, TIME, Proposition, SaidByStep, is_along_time, letter, tree_of
from rbpsym.kernel.components import Components, started
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.system import Force
from rbpsym.present.forms import present
from rbpsym.proof.forms import lettered
from rbpsym.proof.step import Derivation, Step


def spelled_out(derivation: Derivation) -> Derivation:
    """With the roots themselves where a derivation prints letters for them."""
    roots = {name: present(derivation.letters.scalars[name]) for name in lettered(derivation.steps)}
    return replace(derivation, steps=tuple(_spelled(step, roots) for step in derivation.steps)) if roots else derivation


def _spelled(step: Step, roots: Mapping[str, t.Node]) -> Step:
    verdict = step.certificate.verdict
    duties = tuple(replace(duty, relation=t.renamed(duty.relation, roots)) for duty in verdict.obligations)
    certificate = replace(step.certificate, verdict=replace(verdict, obligations=duties))
    return replace(step, statement=t.renamed(step.statement, roots), certificate=certificate)


class ClaimSource:
    """The claims of a derivation's steps and facts, by id."""

    def __init__(self, derivation: Derivation) -> None:
        derivation = spelled_out(derivation)
        self.derivation, self.study, self.letters = derivation, derivation.study, derivation.letters
        self.system = self.study.system
        self.rates = self.system.scope.rates
        self.steps = {step.id: step for step in derivation.steps}
        self.components = Components(self._turns, self.moving)
        self.integrals: dict[str, t.Integral] = {}  # for which a letter stands
        self.circular: dict[str, t.Fn | t.Sqrt | t.Group] = {}  # sines, cosines, roots and gaps that are letters
        self.unsaid: dict[str, str] = {}
        self.own: dict[str, str] = {}  # of a step what its claim says anew: no premise of it
        self.then = {name: tree_of(value) for name, value in letters_then(derivation).items()}
        self.event = event(derivation)
        self._defined: set[str] = set()
        self._introduced: set[t.Node] = set()
        self.said: dict[str, SaidByStep] = {}
        for step in derivation.steps:
            self.said[step.id] = self._said(step)

    def _turns(self, name: str) -> bool:
        return name in self.letters.vectors and not any(self.letters.vectors[name].components()[:2])

    @cached_property
    def constants(self) -> frozenset[str]:
        """The parameters."""
        return frozenset(self.study.assumptions.signs) - {TIME}

    @cached_property
    def _moving(self) -> frozenset[str]:
        names = {*self.rates, *(n for rate in self.rates.values() for n in names_in(rate)), *self.system.unknowns}
        vectors = self.letters.vectors
        names |= {*self.system.dependent, TIME, *self.letters.works, *vectors, *(f"{n}_{a}" for n in vectors for a in "xy")}
        return frozenset(names - self.constants)

    def moving(self, name: str) -> bool:
        """Whether a letter stands for a function of time."""
        if name in self._moving or name in self._defined or name.endswith(RATE):
            return True
        value = self.letters.scalars.get(name)
        return value is not None and bool(self._moving & names_in(value))

    def moves(self, names: Iterable[str]) -> None:
        """Letters of which nothing is known but that they change with time."""
        self._defined.update(names)

    # --- steps

    def _said(self, step: Step) -> SaidByStep:
        own = [row for row in t.chains(step.statement) if self._introduces(step, row)]
        self._introduced |= {part for part in t.walk(step.statement) if isinstance(part, t.Sym | t.Vec)}
        try:
            definitions = [claim for row in own for claim in DEFINED.get(step.rule, _first_or_place(row))(self, step, row)]
        except RbpsymError as error:
            self.unsaid[step.id] = str(error)
            return SaidByStep()
        for claim in definitions:
            if claim.kind == "equal" and isinstance(claim.left, t.Sym) and any(map(self.moving, t.names(claim.right))):
                self._defined.add(claim.left.name)
        return SaidByStep(tuple(definitions), tuple(self._asserted(step)))

    def _at_event(self, claim: Proposition) -> Proposition:
        """The claim; one with letters of the moment at which the phase ends is made of any time at which the event holds."""
        if not self.then.keys() & (t.names(claim.left) | t.names(claim.right)):
            return claim
        if self.event is None:
            raise RbpsymError("such an end of a phase has no words yet")
        left, right = (t.renamed(side, self.then) for side in (claim.left, claim.right))
        there = (Proposition(tree_of(self.event), t.ZERO), AHEAD)
        return replace(claim, left=left, right=right, given=(*claim.given, *there))

    def _asserted(self, step: Step) -> list[Proposition]:
        """What a step claims; nothing, with the reason in `unsaid`, where the exporter has no words for it."""
        claims = [claim for row in t.chains(step.statement) for claim in self.row(row)]
        claims = [claim for claim in claims if claim.kind != "equal" or claim.left != claim.right] or claims[:1]
        more = MORE.get(step.rule)
        try:
            return [self._at_event(claim) for claim in self._begun(more(self, step, claims) if more else claims)]
        except (RbpsymError, LookupError) as error:
            self.unsaid[step.id] = str(error) if isinstance(error, RbpsymError) else "its data are not read yet"
            return []

    def _begun(self, claims: list[Proposition]) -> list[Proposition]:
        """And an integral that is one over the time begins where the motion does."""
        parts = (part for claim in claims for side in (claim.left, claim.right) for part in t.walk(side))
        along = {part.var: part for part in parts if isinstance(part, t.Integral) and is_along_time(part, self.moving)}
        begun = (Proposition(started(t.Sym(name), self.moving), along[name].lower) for name in along if name in self.rates)
        return [*claims, *begun]

    def _introduces(self, step: Step, row: t.Chain) -> bool:
        """Whether the letter that stands first is met here for the first time."""
        name = getattr(row.items[0], "name", "")
        by, _ = self.letters.introduced.get(name, (step.id, None))
        is_told = name in self.then or by != step.id  # by the event, by laws, by a fact
        return name in self.known and row.items[0] not in self._introduced and "@" not in name and not is_told

    @cached_property
    def ranked(self) -> list[str]:
        """Letters in the order in which they are met: speeds, accelerations, unknown forces, what the steps define."""
        first = [*self.rates, *self.system.accelerations, *self.system.unknowns]
        claims = [claim for said in self.said.values() for claim in said.definitions]
        return list(dict.fromkeys([*first, *(n for c in claims for side in (c.left, c.right) for n in t.names(side))]))

    @cached_property
    def known(self) -> frozenset[str]:
        """All letters that the derivation introduces."""
        return frozenset({*self.letters.scalars, *self.letters.vectors, *self.letters.works})

    def row(self, row: t.Chain) -> Iterator[Proposition]:
        """The claims of a chain: each relation, and across derivatives and integrals that have no value of their own."""
        kept = [(item, op) for item, op in zip(row.items, ("=", *row.ops), strict=True) if not isinstance(item, SILENT)]
        for place, (right, op) in enumerate(kept[1:], 1):
            yield from self.relation(kept[place - 1][0], op, right)
            if isinstance(kept[place - 1][0], t.Deriv) and place > 1:
                yield from self.relation(kept[place - 2][0], op, right)

    def relation(self, left: t.Node, op: str, right: t.Node) -> Iterator[Proposition]:
        """One relation by components."""
        if op == "!=":
            yield Proposition(self.components.plain(left), self.components.plain(right), "differ")
        elif op in ("<", ">", "<=", ">="):
            low, high = (left, right) if op[0] == "<" else (right, left)
            yield Proposition(self.components.plain(high), self.components.plain(low), "more" if op in "<>" else "least")
        elif op != "=":
            return
        else:
            for a, b in self.components.equations(left, right):
                if isinstance(a, t.Deriv):
                    yield Proposition(self._once_less(a), b, "rate")
                elif isinstance(b, t.Deriv):
                    yield Proposition(self._once_less(b), a, "rate")
                else:
                    yield Proposition(a, b)

    def _once_less(self, node: t.Deriv) -> t.Node:
        """What is derived once at the end of d^n/dt^n of a coordinate."""
        of = node.of
        for _ in range(node.order - 1):
            of = tree_of(self.rates[letter(of)])
        return of

    def conditions(self, step: Step) -> tuple[Proposition, ...]:
        """The obligations of a step that no declaration discharges (a step that is told may): its claims hold where these do."""
        told = [self.said[duty.why] for duty in step.certificate.verdict.obligations if duty.why in self.said]
        open_ones = [duty.relation for duty in step.certificate.verdict.open_obligations]
        asked = (claim for node in open_ones for row in t.chains(node) for claim in self.row(row))
        return (*asked, *(replace(claim, given=()) for one in told for claim in one.assertions))

    def forces(self, step: Step) -> list[Force]:
        """The forces of a step, in the letters of those that it introduces or takes from its premises."""
        told = [self.steps[id] for id in (step.id, *step.premises) if id in self.steps and self.steps[id].rule == "torque"]
        letters = {one.data["forces"][0]: t.chains(one.statement)[0].items[0] for one in told if len(one.data["forces"]) == 1}
        named = {force: node.name for force, node in letters.items() if isinstance(node, t.Vec)}
        parts = {force: cartesian(symbol(f"{name}_x"), symbol(f"{name}_y")) for force, name in named.items()}
        return [replace(force, vector=parts.get(force, force.vector)) for force in step.data["forces"]]

    # --- facts

    def fact(self, id: str) -> SaidByStep:
        """What a fact says. Raises KeyError for an id that is none."""
        kind, _, rest = id.partition(".")
        return SaidByStep(tuple(map(self._at_event, FACTS[kind](self, rest))))

    def _law(self, rest: str) -> Iterator[Proposition]:
        if (fact := self.letters.facts.get(f"law.{rest}")) and fact.rows:
            yield from (Proposition(tree_of(row), t.ZERO) for row in fact.rows)
            return
        part, _, body = rest.partition(".")
        for owner, axis, value in newton_euler_rows(self.system):
            if part == "motion" or (body == owner and (axis == "rotation") == (part == "torque")):
                yield Proposition(tree_of(value), t.ZERO)
        yield from (Proposition(tree_of(one.value), t.ZERO) for one in self.system.implicit if part == "motion")

    def _start(self, name: str) -> Iterator[Proposition]:
        for begun in (name, f"{name}_dot"):
            if begun in self.system.scope.start:
                yield Proposition(t.Sym(begun), tree_of(self.system.scope.start[begun]), "start")

    def _range(self, name: str) -> Iterator[Proposition]:
        """Where a motion sets out from an end of an open range, it is within from then on."""
        low, high = self.study.assumptions.ranges[name]
        given = (AHEAD,) if self.system.scope.start.get(name) in (low, high) and name in self.system.scope.start else ()
        if low is not None:
            yield Proposition(t.Sym(name), tree_of(low), "more", given)
        if high is not None:
            yield Proposition(tree_of(high), t.Sym(name), "more", given)

    def meaning(self, letter: str) -> Iterator[Proposition]:
        """What a letter stands for, in coordinates."""
        if letter in self.then:
            return
        if letter in self.letters.works:
            yield Proposition(t.Sym(letter), tree_of(self.letters.works[letter]), "rate")
            yield Proposition(t.Sym(letter), t.ZERO, "start")
        elif letter in self.letters.vectors:
            for axis, value in zip("xyz", self.letters.vectors[letter].components(), strict=True):
                if axis in self.components.axes(t.Vec(letter)):
                    left = self.components.part(t.Vec(letter), axis)
                    yield from () if tree_of(value) == left else (Proposition(left, tree_of(value)),)
        else:
            yield Proposition(t.Sym(letter), tree_of(self.letters.scalars[letter]))


RATE = "'"  # ends the name of what is the rate of a letter
SILENT = (t.PathIntegral, t.BodyIntegral)
FACTS: Mapping[str, Callable[[ClaimSource, str], Iterator[Proposition]]] = {
    "law": ClaimSource._law,
    "start": ClaimSource._start,
    "range": ClaimSource._range,
    "shape": lambda source, rest: iter(()),
    "def": ClaimSource.meaning,
}


def _by_first(source: ClaimSource, step: Step, row: t.Chain) -> Iterator[Proposition]:
    """The letter is what stands next to it: a rate, an integral along the path, a formula."""
    items = row.items
    items = items[:1] + items[2:] if isinstance(items[1], t.BodyIntegral) else items
    if isinstance(items[1], t.PathIntegral):
        yield from _along(source, items[0], items[1])
    else:
        yield from source.relation(items[0], "=", items[1])


def _along(source: ClaimSource, work: t.Node, node: t.PathIntegral) -> Iterator[Proposition]:
    """A work grows at the power, in which the rate of the path is a letter of its own, and is 0 at the start."""
    path = node.path
    if node.product == "dot":
        pairs = [(source.components.part(path, axis), source.components.part(node.integrand, axis)) for axis in "xy"]
    else:
        pairs = [(source.components.plain(path), source.components.plain(node.integrand))]
    pairs = [(place, force) for place, force in pairs if place != t.ZERO]
    if not all(isinstance(place, t.Sym) for place, _ in pairs):
        raise RbpsymError("a work along a path that is no letter is not written yet")
    rates = [t.Sym(letter(place) + RATE) for place, _ in pairs]
    yield from (Proposition(place, rate, "rate") for (place, _), rate in zip(pairs, rates, strict=True))
    yield Proposition(work, t.add(*(t.Mul((force, rate)) for (_, force), rate in zip(pairs, rates, strict=True))), "rate")
    yield Proposition(work, t.ZERO, "start")


def _by_place(source: ClaimSource, step: Step, row: t.Chain) -> Iterator[Proposition]:
    """What the mechanics makes of the statement."""
    yield from source.meaning(letter(row.items[0]))


def _by_forces(source: ClaimSource, step: Step, row: t.Chain) -> Iterator[Proposition]:
    """A force as its law gives it, a torque by components about its point."""
    name = letter(row.items[0])
    if not name.startswith("tau_"):
        yield from source.meaning(name)
        return
    about = (point for point in sorted(source.study.origins, key=len, reverse=True) if name.startswith(f"tau_{point}_"))
    origin = source.study.origins.get(next(about, ""), step.data["origin"])
    yield Proposition(t.Sym(name), t.Add((t.ZERO, *(_torque(force, origin) for force in source.forces(step)))))


def _torque(force: Force, origin: Vector) -> t.Node:
    x, y, dx, dy = map(tree_of, (force.point.x, force.point.y, origin.x, origin.y))
    arms = t.Add((x, t.Neg(dx))), t.Add((y, t.Neg(dy)))
    fx, fy = tree_of(force.vector.x), tree_of(force.vector.y)
    return t.Add((t.Mul((arms[0], fy)), t.Neg(t.Mul((arms[1], fx))), tree_of(force.couple)))


def _first_or_place(row: t.Chain) -> Callable[[ClaimSource, Step, t.Chain], Iterator[Proposition]]:
    """What is said of a letter once only is no definition of it: else nothing would be asserted."""
    return _by_place if len(row.items) == 2 and not isinstance(row.items[1], SILENT) else _by_first


def _by_rate(source: ClaimSource, step: Step, row: t.Chain) -> Iterator[Proposition]:
    """What rolling or a string ties has its speed as its rate, and is 0 where what it is tied to says so."""
    name, right = letter(row.items[0]), row.items[-1]
    rates = [source.steps[id].rule in ("no_slip", "taut") for id in step.premises if id in source.steps]
    if not any(rates) or name not in source.system.dependent:
        yield from _first_or_place(row)(source, step, row)
        return
    yield Proposition(row.items[0], t.Sym(f"{name}_dot"), "rate")
    yield Proposition(row.items[0], started(right, source.moving), "start")


DEFINED: Mapping[str, Callable[[ClaimSource, Step, t.Chain], Iterator[Proposition]]] = {
    "tied": _by_rate, "motion_of_mode": lambda source, step, row: iter(()),
    "statement": _by_place, "potential": _by_place, "torque": _by_forces, "value_along": _by_place, "value_then": _by_place,
}  # fmt: skip
