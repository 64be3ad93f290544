"""The general theory for Rocq: any body, of which sums over its particles are known to be linear, and nothing else."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from rbpsym.chapters.theory_ground import VECTORS
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import names_in
from rbpsym.frozen import Frozen, replace
from rbpsym.kernel.claim import TIME
from rbpsym.kernel.components import START, Components
from rbpsym.kernel.reading import Meant, Read, read
from rbpsym.kernel.rocq import LONGEST, REFUSED, Terms, identifier
from rbpsym.proof.step import Lesson, Step

PARTICLE = frozenset(("xi", "eta", "f_x", "f_y"))  # the place in the body, the force per mass
DENSITY = {"p_prime": "v_prime", "F_ext": "F_ext_i"}  # per mass
CONSTANTS = ("M", "I_cm", "C_p_q")
ANY = "any'body"
BODY = ("R_cm_x", "R_cm_y", "V_cm_x", "V_cm_y", "A_cm_x", "A_cm_y", "varphi", "omega", "alpha",
        "r_x", "r_y", "F_ext_i_x", "F_ext_i_y")  # as `motion` has them; fmt: skip
POINTS = {"s": "omega", "r_p": "omega", "r_q": "omega", "s_2": "omega_2"}  # of the body, and one of another
OTHER = {"R_2_x": "V_2_x", "R_2_y": "V_2_y", "varphi_2": "omega_2"}  # how that moves
STEADY = ("F_x", "F_y", *OTHER.values())


def moving(name: str) -> bool:
    """All letters but the moments and the distance of two particles are functions of the time."""
    return name not in CONSTANTS and not name.endswith(START)


def each(name: str) -> bool:
    """Whether a letter belongs to each particle."""
    base = name.removesuffix("_x").removesuffix("_y")
    return base in VECTORS and bool(set().union(*map(names_in, VECTORS[base].components())) & PARTICLE)


def outside(node: t.Node) -> set[str]:
    """The letters of a formula but those that sums over the particles bind."""
    if isinstance(node, t.BodyIntegral):
        return set()
    return {node.name} if isinstance(node, t.Sym) else set().union(*map(outside, t.children(node)))


def is_each(node: t.Node) -> bool:
    """Whether a formula is one of each particle."""
    return any(map(each, outside(node)))


def _turns(name: str) -> bool:
    return not any(VECTORS[name].components()[:2]) if name in VECTORS else name.startswith("varphi")


def plain(node: t.Node) -> t.Node:
    """The formula in words that have terms: works as integrals over the time, sums over forces as those over particles."""
    if isinstance(node, t.Deriv) and node.wrt == "m":
        assert isinstance(node.of, t.Vec)
        return t.Vec(DENSITY[node.of.name])
    node = t.mapped(node, plain)
    if isinstance(node, t.Sum):
        return t.BodyIntegral(node.term)
    if isinstance(node, t.PathIntegral):
        speed = t.Deriv(node.path)
        return _work(t.Dot(node.integrand, speed) if node.product == "dot" else t.Mul((node.integrand, speed)))
    if isinstance(node, t.Integral):
        return _work(t.Mul((node.integrand, t.Deriv(t.Sym(node.var)))))
    return t.Sqrt(t.Dot(node.arg, node.arg)) if isinstance(node, t.Abs) else node


def _work(power: t.Node) -> t.Node:
    return t.Integral(power, TIME, t.ZERO, t.Sym(TIME))


class TheoryTerms(Terms):
    """Terms of the theory: letters of each particle; sums and rates bind all that they are functions of."""

    def term(self, node: t.Node) -> str:
        """The term of a scalar tree."""
        if isinstance(node, t.BodyIntegral):
            return f"(total mean (fun p : particle => fun t : R => {self.at('t').term(node.integrand)}) {self.time})"
        if isinstance(node, t.Deriv):
            head, bound, of = ("rate", "p : particle => fun ", "p ") if is_each(node.of) else ("Derive", "", "")
            return f"({head} (fun {bound}t : R => {self.at('t').term(node.of)}) {of}{self.time})"
        if isinstance(node, t.Sym) and each(node.name):
            return f"({identifier(node.name)} p {self.time})"
        return super().term(node)


class Sense(Meant):
    """What such a term is to be read as."""

    particle: Read = ("letter", "p")

    def of(self, node: t.Node) -> Read:
        """A tree."""
        if isinstance(node, t.BodyIntegral):
            return ("of", ("letter", "total"), ("letter", "mean"), self.inner(node.integrand, of_each=True), self.time)
        if isinstance(node, t.Deriv):
            whole = self.inner(node.of, of_each=is_each(node.of))
            return ("of", ("letter", "rate"), whole, self.particle, self.time) if is_each(node.of) else (
                "of", ("letter", "Derive"), whole, self.time)  # fmt: skip
        if isinstance(node, t.Sym) and each(node.name):
            return ("of", ("letter", identifier(node.name)), self.particle, self.time)
        return super().of(node)

    def inner(self, node: t.Node, *, of_each: bool) -> Read:
        """A function of the time, of each particle's if that is said."""
        own = [("letter", f"#{self.depth + place}") for place in range(1 + of_each)]
        bound = replace(self, particle=own[0] if of_each else self.particle, time=own[-1], depth=self.depth + len(own))
        return ("fun", ("fun", bound.of(node))) if of_each else ("fun", bound.of(node))


class ShownClaim(Frozen):
    """A claim of a step, and what it may use, by names."""

    name: str
    premises: tuple[str, ...]


class Theory:
    """The lemmas of a lesson's steps. claims: propositions by name; granted: what a step says, with what its text takes for
    granted; no step is refused: what has no term is an error."""

    integrals: Mapping[str, t.Node] = {}
    refused: Mapping[str, str] = {}

    def __init__(self, lesson: Lesson) -> None:
        self.moving = moving
        self.components = Components(_turns, moving)
        self.terms, self.sense = TheoryTerms(moving, {}, {}), Sense(self)  # type: ignore[arg-type]  # of a source it needs no more
        self.letters: dict[str, None] = {}
        self.met: set[t.Node] = set()
        self.claims: dict[str, str] = {}
        self.granted: dict[str, list[str]] = {}
        self.lemmas = {step.id: [*self._lemmas(step)] for step in lesson.steps}

    def _lemmas(self, step: Step) -> Iterator[ShownClaim]:
        where = t.rows(step.data["where"]) if "where" in step.data else ()
        granted = [*self._named(f"{step.id}.w", ((row.items[0], row.items[1]) for row in where))]
        links = [(row.items[0], item, not place) for row in t.rows(step.statement) for place, item in enumerate(row.items[1:])]
        own = [isinstance(first, t.Sym | t.Vec) and first not in self.met and is_next for first, _, is_next in links]
        granted += self._named(f"{step.id}.d", (link[:2] for link, is_own in zip(links, own, strict=True) if is_own))
        goals = [*self._named(f"{step.id}.", (link[:2] for link, is_own in zip(links, own, strict=True) if not is_own))]
        self.met |= {part for part in t.walk(step.statement) if isinstance(part, t.Sym | t.Vec)}
        self.granted[step.id] = [*granted, *goals]
        before = (*(name for id in step.premises for name in self.granted[id]), *granted)
        yield from (ShownClaim(name, before) for name in goals)

    def _named(self, id: str, pairs: Iterable[tuple[t.Node, t.Node]]) -> Iterator[str]:
        """The propositions that some equations are, by components."""
        each_part = (part for left, right in pairs for part in self.components.equations(plain(left), plain(right)))
        for place, part in enumerate(each_part, 1):
            name, told = identifier(f"{id}{place}"), [self.terms.term(side) for side in part]
            if [*map(read, told)] != [*map(self.sense.of, part)]:
                raise RbpsymError("what was written does not read as what was meant")
            self.letters |= dict.fromkeys(n.removesuffix(START) for side in part for n in sorted(t.names(side)))
            head = "forall p : particle, " if any(map(is_each, part)) else ""
            self.claims[name] = f"{head}forall t : R, {' = '.join(told)}"
            yield name

    def _opening(self) -> Iterator[str]:
        yield "Require Import Body Particles. Open Scope R_scope.\nSection Theory."
        yield "Variable particle : Type. Variable mean : (particle -> R) -> R."
        points = [f"{point}_{axis}" for point in POINTS for axis in "xy"]
        for name in dict.fromkeys((*BODY, *points, *OTHER, *STEADY, *self.letters)):
            if name != TIME:
                kind = "particle -> R -> R" if each(name) else "R -> R" if moving(name) else "R"
                yield f"Variable {identifier(name)} : {kind}."
        of = [f"motion {' '.join(BODY)}", *(f"turns {turn} {point}_x {point}_y" for point, turn in POINTS.items())]
        of += [*(f"moves {name} {rate}" for name, rate in OTHER.items()), *(f"steady {name}" for name in STEADY)]
        yield " /\\ ".join(("Definition any'body : Prop := sums mean", *of)) + "."

    def text(self, without: Collection[str] = (), *, trial: bool = False) -> str:
        """The Rocq source; on `trial`, each lemma that is not accepted only says so and nothing is kept."""
        lines = [*self._opening(), *(f"Definition {name} : Prop := {said}." for name, said in self.claims.items())]
        kept = [lemma for lemmas in self.lemmas.values() for lemma in lemmas if lemma.name not in without]
        for lemma in kept:
            script = f"timeout {LONGEST} (unfold {', '.join(dict.fromkeys((ANY, lemma.name, *lemma.premises)))}; theory)"
            end = f'first [solve [{script}] | idtac "{REFUSED}{lemma.name}"]. Abort' if trial else f"{script}. Qed"
            lines.append(f"Lemma {lemma.name}'holds : {' -> '.join((ANY, *lemma.premises, lemma.name))}.\nProof. {end}.")
        whole = ", ".join((*(f"{lemma.name}'holds" for lemma in kept), "held_rigidly", "all_turn_alike"))
        lines += [] if trial else [f"Definition all'of'it := ({whole}).", "Print Assumptions all'of'it."]
        return "\n".join([*lines, "End Theory.", ""])
