"""What the steps and facts of a derivation say, as claims about functions of time, neutral of any prover."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Vector, cartesian, names_in, short, symbol
from rbpsym.field.roots import without_roots_below
from rbpsym.kernel.begins import event, letters_then
from rbpsym.kernel.claim import Proposition, SaidByStep, letter, tree_of
from rbpsym.kernel.components import Components, started
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.system import Force
from rbpsym.proof.mass import power
from rbpsym.proof.step import Derivation, Step


class ClaimSource:
    """The claims of a derivation's steps and facts, by id."""

    def __init__(self, derivation: Derivation) -> None:
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
            return [self._at_event(claim) for claim in (more(self, step, claims) if more else claims)]
        except (RbpsymError, LookupError) as error:
            self.unsaid[step.id] = str(error) if isinstance(error, RbpsymError) else "its data are not read yet"
            return []

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


TIME = "t"
AHEAD = Proposition(t.Sym(TIME), t.ZERO, "more")
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
        yield from _by_first(source, step, row)
        return
    yield Proposition(row.items[0], t.Sym(f"{name}_dot"), "rate")
    yield Proposition(row.items[0], started(right, source.moving), "start")


DEFINED: Mapping[str, Callable[[ClaimSource, Step, t.Chain], Iterator[Proposition]]] = {
    "tied": _by_rate, "motion_of_mode": lambda source, step, row: iter(()),
    "statement": _by_place, "potential": _by_place, "torque": _by_forces, "value_along": _by_place, "value_then": _by_place,
}  # fmt: skip


def _conserved(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And it stays what it is at the start."""
    ends = [end for row in t.chains(step.statement) for end in (row.items[0], row.items[-1]) if isinstance(end, t.Sym)]
    return [*claims, *(Proposition(end, started(end, source.moving)) for end in ends)]


def _lost(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And its rate is minus the power of the forces."""
    rate = tree_of(-power(source.system, source.forces(step)))
    return [*claims, Proposition(t.chains(step.statement)[0].items[0], rate, "rate")]


def _at_rest(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    speeds = (name for name in source.rates if name.endswith("_dot"))
    still = tuple(Proposition(t.Sym(name), t.ZERO) for name in dict.fromkeys([*speeds, *source.system.accelerations]))
    return [Proposition(claim.left, claim.right, given=still) for claim in claims]


def _open_rest(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """Where the body is at rest, the equation holds of its place."""
    item = step.data["balance"]
    there = {item.place: t.Sym(item.name)}
    at_rest = _at_rest(source, step, claims)
    return [Proposition(t.renamed(c.left, there), t.renamed(c.right, there), given=c.given) for c in at_rest]


def _equilibrium(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """The equation of rest holds at the place."""
    place = {letter(row.items[0]): row.items[-1] for row in t.chains(step.statement)}
    rest = (id for id, other in source.steps.items() if other.rule == "rest" and id in source.said)
    found = (claim for id in rest for claim in source.said[id].assertions)
    return [Proposition(t.renamed(c.left, place), t.renamed(c.right, place)) for c in found]


def _tangent(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """With the accelerations of the equations of motion, the sides of what is linear are alike at the place in value and
    derivatives."""
    found = []
    for row in t.chains(step.statement):
        solved = {name: t.chains(source.steps[f"motion.{name[:-5]}"].statement)[0].items[-1]
                  for name in t.names(row.items[0]) & set(source.system.accelerations)}  # fmt: skip
        apart = t.Add((t.renamed(row.items[0], solved), t.Neg(row.items[-1])))
        place, moved = _resting(source, step), sorted(filter(source.moving, t.names(apart)))
        place |= {each: t.ZERO for each in moved if each not in place}
        found.append(Proposition(t.renamed(apart, place), t.ZERO))
        for var in moved:
            others = {each: value for each, value in place.items() if each != var}
            found.append(Proposition(t.renamed(apart, others), t.ZERO, "slope", var=var, place=place[var]))
    return found


def _resting(source: ClaimSource, step: Step) -> dict[str, t.Node]:
    """The coordinates at the place of rest; one that may have any value there has a letter of its own."""
    free = {name: t.Sym(f"any_{name}") for name in source.system.independent if name not in step.data["at"]}
    return free | {name: t.renamed(tree_of(value), free) for name, value in step.data["at"].items()}


def _mode(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """If what is linear has a solution of this kind in which a coordinate takes part, the polynomial vanishes."""
    rate, linear = step.slots["letter"], source.steps.get(f"linear.{step.id.partition('.')[2]}")
    if linear is None:
        return claims
    if step.id.startswith(("decay", "damped")):
        return _dying(source, step, claims)
    square = t.Pow(rate, t.TWO)
    speed, gain = {"secular": (t.ZERO, t.Neg(rate)), "polynomial": (rate, square)}.get(step.rule, (t.ZERO, t.Neg(square)))
    source.own[step.id] = f"def.{rate.name}"
    sizes = {name: t.Sym(f"amplitude_{name}") for name in source.system.independent}
    solves = _solves(source, step, sizes, *({n: t.Mul((times, size)) for n, size in sizes.items()} for times in (speed, gain)))
    taking = (Proposition(size, t.ZERO, "differ") for name, size in sizes.items() if f"{name}_ddot" in t.names(linear.statement))
    return [replace(claim, given=(*solves, part)) for claim in claims for part in taking]


def _dying(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """If what is linear has the solutions a e^{-γt} cos ϑt and a e^{-γt} sin ϑt (as they are at t = 0), γ and ϑ are these."""
    name, *others = source.system.independent
    if others:
        raise RbpsymError("a motion of several coordinates that dies out has no words yet")
    rest = step.id.partition(".")[2]
    rate, swing = (source.steps[f"{kind}.{rest}"].slots["letter"] for kind in ("decay", "damped"))
    size = t.Sym(f"amplitude_{name}")
    source.own[step.id] = f"def.{swing.name}"
    slower, turned = t.Neg(t.Mul((rate, size))), t.Mul((swing, size))
    fast = t.Mul((t.Add((t.Pow(rate, t.TWO), t.Neg(t.Pow(swing, t.TWO)))), size))
    cosine = _solves(source, step, {name: size}, {name: slower}, {name: fast})
    sine = _solves(source, step, {name: t.ZERO}, {name: turned}, {name: t.Mul((t.TWO, rate, t.Neg(turned)))})
    given = (*cosine, *sine, Proposition(turned, t.ZERO, "differ"))
    return [replace(claim, given=given) for claim in claims]


def _solves(source: ClaimSource, step: Step, *moved: Mapping[str, t.Node]) -> tuple[Proposition, ...]:
    """That these deviations with these speeds and accelerations solve what is linear."""
    sizes, speeds, gains = moved
    image: dict[str, t.Node] = {name: t.Add((place, sizes[name])) for name, place in _resting(source, step).items()}
    image |= {f"{name}_dot": speed for name, speed in speeds.items()} | {f"{name}_ddot": gain for name, gain in gains.items()}
    rows = t.chains(source.steps[f"linear.{step.id.split('.')[1]}"].statement)
    return tuple(Proposition(t.renamed(row.items[0], image), t.renamed(row.items[-1], image)) for row in rows)


def _modes(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And the polynomial vanishes for each of the values."""
    polynomial = source.steps[f"characteristic.{step.id.partition('.')[2]}"]
    [(left, _, right)] = t.relations(polynomial.statement)
    values = [{polynomial.slots["letter"].name: claim.right} for claim in claims]
    return [*claims, *(Proposition(t.renamed(left, value), t.renamed(right, value)) for value in values)]


def _shape(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """Amplitudes in these ratios, with the frequency of the mode, solve what is linear."""
    first, *others = (source.system.independent[k] for k in step.data["order"])
    size = t.Sym(f"amplitude_{first}")
    sizes: dict[str, t.Node] = {name: t.Mul((claim.right, size)) for name, claim in zip(others, claims, strict=False)}
    sizes[first], gain = size, t.Neg(tree_of(step.data["square"]))
    gains = {name: t.Mul((gain, each)) for name, each in sizes.items()}
    return [*claims[len(others) :], *_solves(source, step, sizes, dict.fromkeys(sizes, t.ZERO), gains)]


def _critical(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """And with it the square of the damped frequency vanishes."""
    [(_, _, square)] = t.relations(source.steps[f"damped.{step.id.partition('.')[2]}"].statement)
    return [*claims, *(Proposition(t.renamed(square, {step.data["name"]: claim.right}), t.ZERO) for claim in claims)]


def _there(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """What a force is where another vanishes."""
    given = source.said[step.data["place"]].assertions[0].given
    return [Proposition(t.Sym(step.data["of"]), claim.right, given=given) for claim in claims]


def _vanishes(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """Where the equation holds the force vanishes."""
    return [Proposition(t.Sym(step.data["force"]), t.ZERO, given=tuple(claims))]


def _stays(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """As long as the force that is lost first is not negative."""
    until = (Proposition(t.Sym(step.data["until"]), t.ZERO, "least"),) if step.data["until"] else ()
    return [replace(claim, given=until) for claim in claims]


def _asked(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """The force is a positive multiple of what is said not to be negative."""
    [(left, op, right)] = t.relations(step.statement)
    force, shown = t.Sym(step.data["force"]), t.add(left, t.neg(right)) if op == ">=" else t.add(right, t.neg(left))
    if shown == force:
        return [Proposition(force, force)]
    said = (row.items[-1] for id in step.premises if id in source.steps for row in t.chains(source.steps[id].statement)
            if row.items[0] == force)  # fmt: skip
    whole = next(map(source.letters.value, said), None) or source.letters.along(symbol(force.name))
    ratio = tree_of(short(without_roots_below(whole / source.letters.value(shown))))
    return [Proposition(force, t.Mul((ratio, shown))), Proposition(ratio, t.ZERO, "more")]


def _then(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    """At the start, or at any time after it at which the event holds."""
    if step.data["moment"].how == "start":
        return [replace(c, left=started(c.left, source.moving), right=started(c.right, source.moving)) for c in claims]
    if step.data["moment"].how != "event" or source.event is None:
        raise RbpsymError("such a moment has no words yet")
    return [replace(claim, given=(Proposition(tree_of(source.event), t.ZERO), AHEAD)) for claim in claims]


def _told(source: ClaimSource, step: Step, claims: list[Proposition]) -> list[Proposition]:
    raise RbpsymError("what a chapter tells has no words for it yet")


MORE: Mapping[str, Callable[[ClaimSource, Step, list[Proposition]], list[Proposition]]] = {
    "conservation": _conserved, "potential": _lost, "rest": _at_rest, "open_balance": _open_rest, "equilibrium": _equilibrium,
    "linearization": _tangent, "linear_system": _tangent, "secular": _mode, "polynomial": _mode, "motion_of_mode": _mode,
    "vanishing": _vanishes, "value_there": _there, "asked": _asked, "value_then": _then, "value_told": _told,
    "normal_modes": _modes, "mode_shape": _shape, "critical": _critical, "stays": _stays,
}  # fmt: skip
