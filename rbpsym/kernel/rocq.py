"""Claims and their proofs as Rocq text, terms over the reals in them: one section a problem, one lemma a claim."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.frozen import Frozen, field, replace
from rbpsym.kernel.certificates import Have, KnownEquation, Lemma, Multiples, Proof
from rbpsym.kernel.claim import FUNCTIONS, TIME, Proposition, is_along_time, tree_of
from rbpsym.kernel.claims import ClaimSource
from rbpsym.kernel.components import START

RESERVED = frozenset((
    "R", "t", "u", "x", "y", "E", "sin", "cos", "sqrt", "PI", "RInt", "is_derive", "continuous", "trig", "less", "ta", "tb",
    "as", "at", "cofix", "else", "end", "exists", "fix", "for", "forall", "fun", "if", "in", "let", "match", "mod", "return",
    "then", "using", "where", "with", "Begin", "Prop", "Set", "Type",
))  # fmt: skip


def identifier(name: str) -> str:
    """A name that Rocq reads as one word and that means nothing else there; different names stay different."""
    word = "".join(c if c.isalnum() or c == "_" else "'" for c in name)
    return f"{word}_" if word.rstrip("_") in RESERVED else word


class Terms(Frozen):
    """How letters are written: `moving` are functions of time; `time` is the moment; `bound` what stands for others.

    `integrals`: the integral that a letter of ours stands for. `speeds`: the speed of each coordinate.
    """

    moving: Callable[[str], bool]
    speeds: Mapping[str, str]
    integrals: Mapping[str, t.Integral]
    time: str = "t"
    bound: Mapping[str, str] = field(default_factory=dict)

    def at(self, time: str) -> Terms:
        """The same at another moment."""
        return replace(self, time=time)

    def term(self, node: t.Node) -> str:
        """The Rocq term of a scalar tree. Raises RbpsymError for a node that no term was found for."""
        if type(node) not in TERMS:
            raise RbpsymError(f"{type(node).__name__.lower()} has no term in Rocq")
        return TERMS[type(node)](self, node)

    def symbol(self, node: t.Sym) -> str:
        """A letter: a constant, a function at the moment or at the start, a bound variable."""
        name = node.name
        if name in self.bound:
            return self.bound[name]
        if name.endswith(START):
            return self.at("0").symbol(t.Sym(name.removesuffix(START)))
        if name == TIME:
            return self.time
        if name in self.integrals:
            return self.integral(self.integrals[name])
        return "PI" if name == "pi" else f"({identifier(name)} {self.time})" if self.moving(name) else identifier(name)

    def integral(self, node: t.Integral) -> str:
        """∫ over the time, or over a coordinate: along time if other functions of time stand in it."""
        if node.var == TIME:
            return f"(RInt (fun u : R => {self.at('u').term(node.integrand)}) {self.term(node.lower)} {self.term(node.upper)})"
        if is_along_time(node, self.moving) and node.var in self.speeds:
            integrand = replace(self, time="u").term(t.Mul((node.integrand, t.Sym(self.speeds[node.var]))))
            return f"(RInt (fun u : R => {integrand}) 0 {self.time})"
        inside = replace(self, bound={**self.bound, node.var: f"x{len(self.bound) or ''}"})
        ends = f"{self.term(node.lower)} {self.term(node.upper)}"
        return f"(RInt (fun {inside.bound[node.var]} : R => {inside.term(node.integrand)}) {ends})"

    def power(self, node: t.Pow) -> str:
        """Powers with whole exponents."""
        exponent = getattr(node.exponent, "value", None)
        if exponent is None or Fraction(exponent).denominator != 1:
            raise RbpsymError("a power with such an exponent has no term in Rocq")
        inner = f"({self.term(node.base)} ^ {abs(exponent)})"
        return inner if exponent >= 0 else f"(/ {inner})"

    def function(self, node: t.Fn) -> str:
        """Sine and cosine, what is a quotient of them, and functions that the prover knows by the same name."""
        if node.name not in QUOTIENTS:
            raise RbpsymError(f"the function {node.name} has no term in Rocq")
        return QUOTIENTS[node.name].format(self.term(node.arg))


QUOTIENTS = {
    **{name: f"({name} {{0}})" for name in FUNCTIONS}, "tan": "(sin {0} / cos {0})", "cot": "(cos {0} / sin {0})",
    "sec": "(/ cos {0})", "csc": "(/ sin {0})",
}  # fmt: skip


def _number(terms: Terms, node: t.Num) -> str:
    value = Fraction(node.value)
    whole = str(value.numerator) if value >= 0 else f"(- {-value.numerator})"
    return whole if value.denominator == 1 else f"({whole} / {value.denominator})"


TERMS: dict[type, Callable[[Terms, Any], str]] = {
    t.Num: _number,
    t.Sym: Terms.symbol,
    t.Add: lambda terms, node: "(" + " + ".join(map(terms.term, node.terms)) + ")",
    t.Neg: lambda terms, node: f"(- {terms.term(node.arg)})",
    t.Mul: lambda terms, node: "(" + " * ".join(map(terms.term, node.factors)) + ")",
    t.Div: lambda terms, node: f"({terms.term(node.num)} / {terms.term(node.den)})",
    t.Pow: Terms.power,
    t.Fn: Terms.function,
    t.Sqrt: lambda terms, node: f"(sqrt {terms.term(node.arg)})",
    t.Group: lambda terms, node: terms.term(node.arg),
    t.Integral: Terms.integral,
}


SIGNS = {"positive": "0 < {0}", "nonnegative": "0 <= {0}", "nonzero": "{0} <> 0"}
LONGEST = 120  # seconds for one proof
OWN = "qrmz"  # with a number: what is noted in a proof
TIMES = "forall t : R, ta < t < tb -> "
REFUSED = "not accepted: "
RELATIONS = {"equal": "{left} = {right}", "more": "{right} < {left}", "least": "{right} <= {left}", "differ": "{left} <> {right}"}


class Writer(Frozen):
    """How one problem is written."""

    source: ClaimSource
    terms: Terms

    def opening(self) -> Iterator[str]:
        """Parameters with their signs, and the motion: functions of time with derivatives on an open interval."""
        system, signs = self.source.system, self.source.study.assumptions.signs
        yield "Require Import Prelude. Open Scope R_scope.\nSection Problem."
        for name, sign in signs.items():
            if name == TIME:
                continue
            yield f"Variable {identifier(name)} : R."
            if sign in SIGNS:
                yield f"Hypothesis above'{name} : {SIGNS[sign].format(identifier(name))}."
        yield "Variables ta tb : R. Hypothesis Begin : ta < 0 < tb."
        names = [*self.source.rates, *system.accelerations]
        yield from (f"Variable {identifier(name)} : R -> R." for name in names)
        for name, rate in self.source.rates.items():
            of, to = identifier(name), self.terms.term(tree_of(rate))
            yield f"Hypothesis rate'{name} : {TIMES}is_derive {of} t {to}."
        for name in dict.fromkeys([*system.accelerations, *system.unknowns]):
            yield from () if name in names else (f"Variable {identifier(name)} : R -> R.",)
            yield f"Hypothesis steady'{name} : {TIMES}continuous {identifier(name)} t."

    def letters(self, claims: Iterable[Proposition]) -> Iterator[str]:
        """Declarations of the letters in some claims."""
        told = {*self.source.rates, *self.source.system.accelerations, *self.source.system.unknowns, "pi"}
        told |= {*self.source.study.assumptions.signs, TIME}
        found = dict.fromkeys(n for claim in claims for n in sorted(_names(claim)) if n not in told)
        for name in found:
            yield f"Variable {identifier(name)} : R{' -> R' if self.source.moving(name) else ''}."

    def said(self, claim: Proposition) -> str:
        """The proposition of a claim."""
        if claim.kind == "start":
            return self.relation(replace(claim, kind="equal"), "0")
        bound = self.of_each(claim.var)
        if claim.kind == "slope":
            place, right = self.terms.term(claim.place), self.terms.term(claim.right)
            return f"is_derive (fun x : R => {bound.terms.term(claim.left)}) {place} ({right})"
        if claim.var:
            return f"forall x : R, {bound.relation(claim)}"
        given = "".join(f"{self.relation(item)} -> " for item in claim.given)
        return TIMES + given + self.relation(claim)

    def of_each(self, var: str) -> Writer:
        """The same where a letter is bound."""
        return replace(self, terms=replace(self.terms, bound={var: "x"})) if var else self

    def relation(self, claim: Proposition, time: str = "t") -> str:
        """The relation at a moment."""
        left, right = (self.terms.at(time).term(side) for side in (claim.left, claim.right))
        if claim.kind == "rate":
            return f"is_derive (fun t : R => {self.terms.term(claim.left)}) t ({right})"
        return RELATIONS[claim.kind].format(left=left, right=right)

    # --- lemmas

    def lemma(self, item: Lemma) -> str:
        """The lemma with its proof."""
        return f"Lemma {item.name}'holds : {self.statement(item)}.\nProof. {self.script(item)}. Qed."

    def trial(self, item: Lemma) -> str:
        """The same, only tried: a proof that is not accepted says the name of the lemma."""
        proof = f"first [solve [{self.script(item)}] | idtac \"{REFUSED}{item.name}\"]"
        return f"Lemma {item.name}'holds : {self.statement(item)}.\nProof. {proof}. Abort."

    def statement(self, item: Lemma) -> str:
        """The claim from the premises."""
        return "".join(f"{name} -> " for name in item.premises) + item.name

    def script(self, item: Lemma) -> str:
        """The proof as one tactic."""
        enter = [f"unfold {', '.join([item.name, *item.premises])}", *(f"intros p_{name}" for name in item.premises)]
        starts = [f"p_{name}" for name, claim in item.premises.items() if claim.kind == "start"]
        haves = [self.have(have, _finish(starts)) for have in item.proof.steps]
        haves += [f"clear p_{have.source}" for have in item.proof.steps if have.how == "unique"]
        lines = ";\n  ".join([*enter, *haves, self.end(item.claim, item.proof, _finish(starts))])
        return f"timeout {LONGEST} ({lines})"

    def end(self, claim: Proposition, proof: Proof, finish: str) -> str:
        """From what was shown on the way to the claim."""
        if claim.kind == "slope":
            close = f"{self.less(proof.multiples, '0')}cbv beta; rewrite ?Rmult_0_l, ?Rplus_0_r; {finish}"
            return f"eapply D_eq; [der | apply lin0; {close}]"
        enter = "; ".join(["intros t Ht", *(f"intros g{place}" for place, _ in enumerate(claim.given, 1))])
        close = self.less(proof.multiples) + finish
        if claim.kind == "rate":
            assert proof.like is not None
            like, by = proof.like
            was = f"intros u Hu; apply lin0; {self.less(by, 'u')}{finish}"
            alike = f"apply (alike ta tb _ (fun t : R => {self.terms.term(like)})); [{was} | exact Ht |]"
            return f"{enter}; {alike}; eapply D_eq; [der | apply lin0; {close}]"
        if proof.parts:
            parts = " ".join(map(self.terms.term, proof.parts))
            way, sign = ("above", "pos") if claim.kind == "more" else ("at_least", "nng")
            return f"{enter}; apply ({way} _ _ {parts}); [apply lin0; {close} | {sign} | nng]"
        if proof.factor is not None:
            return f"{enter}; apply (cancel ({self.terms.term(proof.factor)})); [pos | {close}]"
        return f"{enter}; apply lin0; {close}"

    def less(self, multiples: Multiples, time: str = "t") -> str:
        """The tactics that take multiples of known equations off."""
        at = self.terms.at(time)
        parts = [(factor, self.reference(known, time)) for factor, known in multiples.known]
        parts += [(factor, f"trig {at.term(angle)}") for factor, angle in multiples.circles]
        return "".join(f"apply (less {at.term(factor)} _ _ ({shown})); " for factor, shown in parts)

    def reference(self, known: KnownEquation, time: str) -> str:
        """A known equation at a moment."""
        if known.name.startswith("g") and known.name[1:].isdigit():
            return known.name
        name = known.name if known.name[0] in OWN and known.name[1:].isdigit() else f"p_{known.name}"
        at = "0 Begin" if "0" in (known.when, time) else f"{time} H{time}"
        return " ".join((name, at, *(part if part[1:].isdigit() else f"(p_{part} {at})" for part in known.by)))

    def have(self, have: Have, finish: str) -> str:
        """An assertion on the way."""
        given = "".join(f" g{place}" for place, _ in enumerate(have.claim.given, 1))
        enter = "intros x" if have.claim.var else f"intros t Ht{given}"
        shown = HAVES[have.how](self.of_each(have.claim.var), have, finish)
        return f"assert ({have.name} : {self.said(have.claim)}) by ({enter}; {shown})"

    def _flat(self, have: Have, finish: str) -> str:
        rate = f"intros u Hu; eapply D_eq; [der | {self.less(have.multiples, 'u')}{finish}]"
        body = self.terms.term(have.claim.left)
        begin = f"cbv beta; rewrite ?RInt_none; {self.less(have.begin, '0')}{finish}"
        return f"apply (flat ta tb (fun t : R => {body}) Begin); [{rate} | {begin} | exact Ht]"

    def _course(self, have: Have, finish: str) -> str:
        assert have.inner is not None
        both, turns = (have, have.inner), ("0", "1", *map(self.terms.term, have.parts))
        named = [f"(fun t : R => {self.terms.term(each.claim.left)})" for each in both]
        named += [f"(fun _ : R => {turn})" for turn in turns]
        way = "intros u Hu; eapply D_eq; [der | cbv beta; apply lin0; {}{}]"
        shown = [way.format(self.less(each.multiples, "u"), finish) for each in both] + ["intros; cont"] * len(turns)
        shown += [f"cbv beta; rewrite ?RInt_none; {self.less(each.begin, '0')}{finish}" for each in both]
        return f"apply (only_one ta tb {' '.join(named)} Begin); [{' | '.join(shown)} | exact Ht]"

    def _still(self, have: Have, finish: str) -> str:
        shown = f"intros u Hu; cbv beta; {self.less(have.multiples, 'u')}{finish}"
        was = self.terms.at("u").term(have.of)
        return f"apply (still ta tb (fun u : R => {was}) t); [{shown} | exact Ht | eapply D_eq; [der | fld]]"

    def _unique(self, have: Have, finish: str) -> str:
        alike = ""
        for like in have.parts:
            was = f"intros u Hu; apply lin0; {self.less(have.multiples, 'u')}{finish}"
            alike = f"apply (alike ta tb _ (fun t : R => {self.terms.term(like)})); [{was} | exact Ht |]; "
        return f"apply (alone _ t _ _ (p_{have.source} t Ht)); clear p_{have.source}; {alike}eapply D_eq; [der | fld]"

    def _sum(self, have: Have, finish: str) -> str:
        return "first [apply sin_of | apply cos_of | apply sin_off | apply cos_off]; lra"

    def _sign(self, have: Have, finish: str) -> str:
        return f"{_bounds(have)}pose proof PI_RGT_0; apply {_head(have.claim)}_gt_0; ends"

    def _gap(self, have: Have, finish: str) -> str:
        return f"{_bounds(have)}lra" if have.source else "constant"

    def _positive(self, have: Have, finish: str) -> str:
        """± the formula is a positive one and one that is not negative."""
        above, others = map(self.terms.term, have.parts)
        way = "above _ _" if have.how != "nonzero" else "beyond _" if have.of == have.claim.left else "below _"
        return f"apply ({way} {above} {others}); [apply lin0; {self.less(have.multiples)}{finish} | first [pos | over0] | nng]"

    def _divisor(self, have: Have, finish: str) -> str:
        """A multiple of it does not vanish."""
        whole, by = map(self.terms.term, have.parts)
        return f"apply (divisor {whole} {by}); [pos | {self.less(have.multiples)}{finish}]"

    def _rooted(self, have: Have, finish: str) -> str:
        """The square of a root is what stands below it."""
        return f"apply root2; {f'apply Rlt_le; {self._positive(have, finish)}' if have.parts else 'nng'}"

    def _same_root(self, have: Have, finish: str) -> str:
        """One root is a multiple of another."""
        return "apply root_is; [nng | rewrite ?Rpow_mult_distr, ?root2 by nng; fld]"

    def _integral(self, have: Have, finish: str) -> str:
        """By an antiderivative; an integral inside is replaced by its value first."""
        return self.primitive(have, {})

    def primitive(self, have: Have, bound: Mapping[str, str]) -> str:
        """The tactics of an integral between what is bound outside of it."""
        x = f"x{len(bound) or ''}"
        inside = {**bound, _head(have.claim): x}
        body = replace(self.terms, bound=inside).term(have.of)
        found = f"apply (RInt_by (fun {x} : R => {body})); [intros; eapply D_eq; [der | fld] | intros; cont | cbv beta; fld]"
        for plain in have.parts:
            found = f"apply (RInt_in (fun {x} : R => {replace(self.terms, bound=inside).term(plain)})); [between; fld | {found}]"
        if have.inner is None:
            return found
        value = replace(self.terms, bound=inside).term(have.inner.claim.right)
        return f"apply (RInt_on (fun {x} : R => {value})); [intros {x}; {self.primitive(have.inner, inside)} | {found}]"


def _bounds(have: Have) -> str:
    """What the ranges say at the moment."""
    given = "".join(f" g{place}" for place, _ in enumerate(have.claim.given, 1))
    return "".join(f"pose proof (p_{name} t Ht{given}); " for name in have.source.split())


def _head(claim: Proposition) -> str:
    """The function that stands on the left, or the variable of the integral there."""
    assert isinstance(claim.left, t.Fn | t.Integral)
    return claim.left.name if isinstance(claim.left, t.Fn) else claim.left.var


HAVES = {
    "flat": Writer._flat, "course": Writer._course, "still": Writer._still, "unique": Writer._unique, "sign": Writer._sign,
    "gap": Writer._gap, "integral": Writer._integral, "nonzero": Writer._positive, "positive": Writer._positive,
    "sum": Writer._sum, "root": Writer._rooted, "multiple root": Writer._same_root, "factor": Writer._divisor,
}  # fmt: skip


def _finish(starts: Sequence[str]) -> str:
    return f"cbv beta; rewrite ?{', ?'.join(starts)}; rewrite ?RInt_none; fld" if starts else "fld"


def _names(claim: Proposition) -> set[str]:
    inner = [claim.left, claim.right, claim.place]
    bound = {part.var for node in inner for part in t.walk(node) if isinstance(part, t.Integral)} | {claim.var}
    found = {n.removesuffix(START) for node in inner for n in t.names(node)}
    return {n for n in found - bound if n} | {n for item in claim.given for n in _names(item)}
