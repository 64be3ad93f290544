"""A derivation being written: steps are added, bound to the least premises, checked and given their certificates."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import cache, partial
from typing import Any

from rbpsym.decide.equal import proofs_alone, scalars_equal
from rbpsym.decide.rooted import Senses, neat
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, Space, Vector, apart, ask_for_more, at_most, has_roots, tidy
from rbpsym.field.poly import generator
from rbpsym.frozen import replace
from rbpsym.mechanics.demands import Demand, assuming
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.present.pulls import by_pulls
from rbpsym.proof.assertions import settled, told
from rbpsym.proof.checks.of_steps import NOT_BY_NUMBERS
from rbpsym.proof.context import DECIDED, DENIED, EXACT, Context
from rbpsym.proof.facts import MOTION, facts_of
from rbpsym.proof.forms import Forms
from rbpsym.proof.grounds import Said
from rbpsym.proof.letters import fixed, introduce, introducers
from rbpsym.proof.rules import examined
from rbpsym.proof.step import STANDARD, UNCHECKED, Certificate, Skipped, Step

TELLS_MOTION = ("solution", "first_integral", "substitution")  # rules of steps that say what the motion is
SIGNED = ("vanishing", "equilibrium")  # rules that decide signs on ranges: costly where they fail
MOST_LAWS = 6  # of so many single laws it is tried whether they do


def bound(context: Context, step: Step, named: Iterable[str]) -> Step:
    """The step with its certificate, the least premises, and what else its author cites.

    Where nothing is owed, the least are sought when somebody looks at them: the letters mean then what they mean now.
    """
    named = tuple(dict.fromkeys(named))
    with proofs_alone():
        found, granted = _proved(context, step, named)
    context.rests[step.id] = frozenset(introducers(context, [step.statement])) | fixed(context)
    if found is UNCHECKED:
        *_, widest = _levels(context, step, named)
        found, _ = examined(context, step, widest)
        return replace(step, premises=named, certificate=found)
    seen = replace(context, steps={id: context.steps[id] for id in granted if id in context.steps},
                   **{name: dict(getattr(context, name)) for name in ("scalars", "vectors", "works", "moments")})  # fmt: skip
    least = cache(partial(_least, seen, step, granted, is_free=not found.verdict.obligations))
    late: Any = {"premises": lambda: least()[1], "cites": lambda: tuple(id for id in named if id not in least()[1])}
    return replace(step, **late, certificate=least()[0] if found.verdict.obligations else found)


def _proved(context: Context, step: Step, named: tuple[str, ...]) -> tuple[Certificate, tuple[str, ...]]:
    """The first certificate that proves it, with the premises that it used; sets that numbers deny come last."""
    for trust in (DENIED, EXACT):
        for level in _levels(context, step, named):
            found, used = examined(context, step, level, by_numbers=trust)
            if not found.verdict.is_proved and found.verdict != NOT_BY_NUMBERS and trust == DENIED:  # fewer may be seen through
                quick, used = examined(context, step, level, by_numbers=DECIDED)
                if quick.verdict.is_proved:
                    level = _irredundant(context, step, _of(level, used), DECIDED, is_free=False)
                    found, used = examined(context, step, level)
            if found.verdict.is_proved:
                return found, _of(level, used)
    return UNCHECKED, ()


def _least(context: Context, step: Step, granted: tuple[str, ...], *, is_free: bool) -> tuple[Certificate, tuple[str, ...]]:
    """Those of the premises without which it is not proved: by numbers, and where these mislead by the long way.

    With `is_free` it must owe nothing: a premise that spares a condition is needed.
    """
    with apart(), at_most(MOST_PRODUCTS), proofs_alone():
        for trust in (DECIDED, EXACT):
            kept = _irredundant(context, step, granted, trust, is_free=is_free)
            found, used = examined(context, step, kept)
            if _is_fine(found, is_free=is_free) and used.issuperset(kept):
                break
    return found, kept


def _is_fine(found: Certificate, *, is_free: bool) -> bool:
    return found.verdict.is_proved and not (is_free and found.verdict.obligations)


def _levels(context: Context, step: Step, named: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Sets of premises to try, from what is nearest to the whole of the laws; ranges where more or less is asserted."""
    ranges = tuple(id for id, fact in context.facts.items() if fact.kind == "range")
    laws = [id for id, fact in context.facts.items() if fact.kind == "law" and fact.subject]
    letters = introducers(context, [step.statement])
    said = introducers(context, [context.steps[id].statement for id in named if id in context.steps])
    works = {id for name, (id, _) in context.introduced.items() if name in context.works}
    told = [id for id, other in context.steps.items() if other.rule in TELLS_MOTION]
    near = (*named, *letters, *sorted(fixed(context)))
    quiet = [id for id in said if id not in works]
    few = [*quiet, *laws] if len(laws) <= MOST_LAWS else []
    steps_up: tuple[Iterable[str], ...] = ((), quiet, said, few, (*said, *told), (MOTION,), (*said, *told, MOTION))
    if step.rule in SIGNED or any(op != "=" for _, op, _ in t.relations(step.statement)):
        steps_up = tuple((*more, *ranges) for more in ((), (*said, *told), (*said, *told, MOTION)))
    tried = set()
    for more in (*steps_up, (*said, *told, MOTION, *ranges)):
        level = tuple(dict.fromkeys((*near, *more)))
        if frozenset(level) not in tried:
            tried.add(frozenset(level))
            yield level


def _irredundant(context: Context, step: Step, premises: tuple[str, ...], trust: int, *, is_free: bool) -> tuple[str, ...]:
    """Without those that the step is proved without."""
    for id in reversed(premises):
        if id in premises:
            found, used = examined(context, step, tuple(other for other in premises if other != id), by_numbers=trust)
            if _is_fine(found, is_free=is_free):
                premises = _of(premises, used)
    return premises


def _of(premises: tuple[str, ...], used: Collection[str]) -> tuple[str, ...]:
    return tuple(id for id in premises if id in used)


class Draft:
    """Steps so far, with the meanings of the quantities that they define.

    `chapter` is where the next steps belong; steps of phases `before` say in which form quantities are printed.
    """

    def __init__(self, study: Study, before: Iterable[Step] = ()) -> None:
        self.study, self.context = study, Context(study, facts=dict(facts_of(study)))
        self.steps: list[Step] = []
        self.skipped: list[Skipped] = []
        self.forms = Forms(before)
        self.called: tuple[tuple[int, str, Scalar], ...] = ()  # letters of roots that stand in many formulas
        self.chapter = "statement"

    def add(
        self,
        id: str,
        rule: str,
        statement: t.Node,
        phrase: str,
        *,
        premises: Iterable[str] = (),
        level: int = STANDARD,
        is_result: bool = False,
        obligations: tuple[t.Chain, ...] = (),
        data: dict[str, Any] | None = None,
        **slots: Any,
    ) -> Step:
        """Adds a step, checked; its id is made unique.

        `premises` names what a reader should look at, as far as steps of these ids were made; from these, and from the
        facts, those are found that the step needs.
        """
        statement = _without_repeats(statement)
        step = Step(
            self._unique(id, {step.id for step in self.steps}),
            rule,
            statement if self.chapter == "ask" else self.forms.kept(statement, len(self.steps)),
            self.chapter,
            phrase,
            slots,
            level=level,
            is_result=is_result,
            obligations=obligations,
            data=data or {},
        )
        introduce(self.context, step)
        step = self.certified(step, self.those(*premises))
        step = told(step, Said(self.study, steps=self.steps, context=self.context))
        self.steps.append(step)
        self.context.steps[step.id] = step
        return step

    def forget(self, kept: int) -> None:
        """Takes back all steps but the first ones, and the letters that they introduced."""
        gone = {step.id for step in self.steps[kept:]}
        del self.steps[kept:]
        for id in gone:
            del self.context.steps[id]
        for letter in [name for name, (id, _) in self.context.introduced.items() if id in gone]:
            del self.context.introduced[letter]
        self.context.rows.clear()
        self.forms.forget(kept)

    def those(self, *ids: str) -> tuple[str, ...]:
        """Those of the ids of which a step was made."""
        return tuple(id for id in ids if id in self.context.steps or id in self.context.facts)

    def certified(self, step: Step, named: tuple[str, ...]) -> Step:
        """The step with the premises that it needs, and its certificate. Raises LimitError where the whole work is too long."""
        with apart(), at_most(MOST_PRODUCTS):  # what is proved of a step is no work of the method that makes it
            step = bound(self.context, step, named)
        ask_for_more()
        return step

    def _unique(self, id: str, known: set[str]) -> str:
        found, k = id, 2
        while found in known:
            found, k = f"{id}_{k}", k + 1
        return found

    def skip(self, name: str, phrase: str, **slots: Any) -> None:
        """Notes that the method called `name` does not apply, and why."""
        if settled(phrase, Said(self.study)):
            self.skipped.append(Skipped(name, phrase, slots))

    def has(self, id: str) -> bool:
        """Whether a step of that id was made."""
        return any(step.id == id for step in self.steps)

    def show(self, value: Scalar, *, factor: bool = False, met: Iterable[Demand] | None = None) -> t.Node:
        """A value as a display tree in the problem's style; with demands, sums that they make positive are printed so."""
        style, given = self.study.style, self.study.assumptions
        if met is not None:
            style = replace(style, sense=Senses(assuming(given, met, tighter=True)))
        if not has_roots(value):
            return present(value, style, factor=factor)
        if any(index in value.atoms() for index, *_ in self.called):
            return by_pulls(value, replace(style, called=self.called))
        plain, shown = (present(form, style, factor=factor) for form in (value, neat(value, given)))
        return shown if shown == plain or self._is_proved(shown, value) else plain

    def _is_proved(self, form: t.Node, value: Scalar) -> bool:
        return scalars_equal(self.context.value(form), value, self.study.assumptions).is_proved

    def show_brief(self, value: Scalar) -> t.Node:
        """As it is, or with its sums factored where that is much shorter."""
        plain, factored = self.show(value), self.show(value, factor=True)
        return factored if length(factored) <= MUCH_SHORTER * length(plain) else plain

    def show_vector(self, vector: Vector, *, factor: bool = False) -> t.Node:
        """x i + y j, components that vanish left out."""
        parts = [(tidy(vector.x), "x"), (tidy(vector.y), "y")]
        return t.add(*(t.mul(self.show(value, factor=factor), t.Unit(axis)) for value, axis in parts if value))

    def define(self, name: str, value: Scalar) -> t.Sym:
        """Gives a scalar quantity its meaning and returns its symbol."""
        self.context.scalars[name] = value
        return t.Sym(name)

    def call(self, name: str, root: Scalar, slack: Scalar) -> t.Sym:
        """Gives a root, the length of a spring that is slack at another, its letter, by which it is printed from then on."""
        self.called += tuple((index, name, slack) for index in root.atoms() if root.num == generator(index))
        self.forms.meant[name] = root
        return self.define(name, root)

    def define_vector(self, name: str, value: Vector, z: Scalar | None = None) -> t.Vec:
        """Gives a vector quantity its meaning and returns its symbol."""
        self.context.vectors[name] = Space(value, NOTHING if z is None else z)
        return t.Vec(name)

    @property
    def is_single(self) -> bool:
        """Whether the system is one body."""
        return len(self.study.system.bodies) == 1

    def asked(self, demands: Iterable[Demand]) -> tuple[t.Chain, ...]:
        """Conditions on parameters as obligations of a step."""
        return tuple(t.relation(self.show(item.value, factor=True), item.op, t.ZERO) for item in demands)

    def of_body(self, letter: str, body: str) -> str:
        """Name of a body's quantity: R_rod; for the only body R_cm."""
        return self.free(f"{letter}_cm" if self.is_single and letter in OF_CENTER else f"{letter}_{body}")

    def free(self, name: str, mark: str = "b", *, taken: Collection[str] | None = None) -> str:
        """A name that nothing of the problem has (see `Letters.free`)."""
        return self.study.letters.free(name, mark=mark, taken=taken)


MOST_PRODUCTS = 1_000_000  # for the premises of a step and its certificate: five times what the longest of the library takes
MUCH_SHORTER = 0.75
OF_CENTER = ("R", "V", "A", "I", "P", "x", "y")  # quantities of the only body that are those of its centre of mass


def length(node: t.Node) -> int:
    """How long a formula is, in nodes."""
    return sum(1 for _ in t.walk(node))


def acceleration_symbol(name: str) -> t.Sym:
    """The acceleration of a coordinate as a tree."""
    return t.Sym(f"{name}_ddot")


def _without_repeats(statement: t.Node) -> t.Node:
    """a = b = b as a = b, in each row."""
    if isinstance(statement, t.Relations):
        return t.Relations(tuple(_without_repeats(row) for row in statement.rows))
    if not isinstance(statement, t.Chain) or len(statement.items) < 3:
        return statement
    pairs = zip(statement.items, statement.items[1:], statement.ops, strict=False)
    kept = [(item, op) for before, item, op in pairs if op != "=" or item != before]
    return t.Chain((statement.items[0], *(item for item, _ in kept)), tuple(op for _, op in kept))
