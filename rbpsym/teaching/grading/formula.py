"""Judging a formula: valid? equal to the key? else the student's own error carried on, a known slip, a near miss."""

from __future__ import annotations

from collections.abc import Callable

from rbpsym.decide.dimensions import a, dimension_of
from rbpsym.decide.equal import scalars_equal
from rbpsym.decide.verdict import Verdict
from rbpsym.errors import DimensionError, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, atoms
from rbpsym.frozen import Frozen, replace
from rbpsym.teaching.grading import judgement as j
from rbpsym.teaching.grading.ground import GradingGround
from rbpsym.teaching.grading.judgement import Judgement, Remark, Status
from rbpsym.teaching.grading.quantity import agrees, rounded, without_number
from rbpsym.teaching.grading.reading import meanings, read_all, read_formula
from rbpsym.teaching.grading.verdicts import OUTSIDE, are_equal, divides_by_zero, value_of
from rbpsym.teaching.model import Anticipated

EARNING = (Status.RIGHT, Status.CARRIED, Status.UNFINISHED)


class Sought(Frozen):
    """What a formula is compared with: the key, the left side it belongs to, the names it may hold, known
    wrong values, and the values that follow from the student's own earlier answers."""

    value: t.Node
    ground: GradingGround
    left: t.Node | None = None
    names: frozenset[str] = frozenset()
    anticipated: tuple[Anticipated, ...] = ()
    carried: tuple[t.Node, ...] = ()

    @property
    def allowed(self) -> frozenset[str]:
        """Names that may stand in the answer."""
        return self.names | t.names(self.value) | {"pi"}

    @property
    def target(self) -> str:
        """The symbol that is asked for, if it is one that the key does not hold."""
        name = self.left.name if isinstance(self.left, t.Sym) else ""
        return "" if name in t.names(self.value) else name


def judge_formula(text: str, sought: Sought) -> Judgement:
    """The judgement on a typed formula. Errors of the student are judgements, never exceptions."""
    if not text.strip():
        return j.EMPTY
    text, number = without_number(text, sought.ground.book)
    try:
        found = _in_all_meanings(read_formula(text, sought.ground.book), sought)
    except RbpsymError as error:
        found = j.invalid(error)
    found = found if found.status in EARNING else _in_all_ways(text, sought, found)
    agreed = number is None or found.status is not Status.RIGHT or agrees(number, sought.value, sought.ground)
    return found if agreed else found.with_remark("number beside")


def _in_all_meanings(read: t.Node, sought: Sought) -> Judgement:
    """The judgement on the first thing that an answer may mean and that earns something; else on what it usually means."""
    judged = (judge_tree(way, sought) for way in meanings(read, sought.allowed, sought.ground.scope.scalars))
    usual = next(judged)
    return usual if usual.status in EARNING else next((other for other in judged if other.status in EARNING), usual)


def _in_all_ways(text: str, sought: Sought, usual: Judgement) -> Judgement:
    """The judgement on what can be read in several ways, if one of them alone can be meant, or it does not matter.

    Where it only matters how far a root or the argument of a function goes, the reading that is right is meant.
    usual: the judgement on the usual reading, which stands where there is no other.
    """
    try:
        ways = read_all(text, sought.ground.book)
    except RbpsymError as error:
        return j.invalid(error) if usual.status is Status.INVALID else usual
    if len(ways.trees) < 2:
        return usual
    kept = [k for k, tree in enumerate(ways.trees) if _fits(tree, sought)] or list(range(len(ways.trees)))
    sound, is_parted = [ways.trees[k] for k in kept], len({ways.parted[k] for k in kept}) > 1
    found = [judge_tree(tree, sought) for tree in sound]
    statuses = {judgement.status for judgement in found}
    best = next((status for status in EARNING if status in statuses), None)
    if len(statuses) > 1 and (best is None or is_parted):
        return j.invalid(ways.error)
    place = next((k for k, judgement in enumerate(found) if judgement.status is best), 0)
    return found[place].with_remark("read as", formula=sound[place]) if kept[place] and best else found[place]


def _fits(read: t.Node, sought: Sought) -> bool:
    """Has it, so read, the dimension of the key on every side, as far as that is known?"""
    if _right_side(read, sought) is None:
        return True
    return all(_dimension_remark(side, sought) is None for side in _sides(read) if not _is_left(side, sought))


def judge_tree(read: t.Node, sought: Sought) -> Judgement:
    """The judgement on an answer that was read."""
    answer = _right_side(read, sought)
    found = _equation(read, sought) if answer is None and isinstance(read, t.Chain) else _judged(answer or read, sought)
    if found.status is Status.UNDECIDED and any(divides_by_zero(part, sought.ground) for part in _sides(read)):
        return Judgement(Status.INVALID, remarks=(Remark("zero division"),))
    if found.status is Status.RIGHT and isinstance(read, t.Chain):
        return _with_chain(found, read, sought)
    return found


def _sides(read: t.Node) -> tuple[t.Node, ...]:
    return read.items if isinstance(read, t.Chain) else (read,)


def _right_side(read: t.Node, sought: Sought) -> t.Node | None:
    """The last side beside the one that is asked for; None if the equation does not name it."""
    if not isinstance(read, t.Chain):
        return read
    if _is_turned(read, sought):
        return read.items[0]
    kept = [side for side in read.items if not _is_left(side, sought)]
    if len(kept) == len(read.items) and not _is_plain_chain(read, sought):
        return None
    return kept[-1] if kept else read.items[0]


def _is_left(side: t.Node, sought: Sought) -> bool:
    return sought.left is not None and (side == sought.left or _bare(side) == _bare(sought.left))


def _is_plain_chain(read: t.Chain, sought: Sought) -> bool:
    """Is no left side known, so that a symbol before the first sign = is taken for it?"""
    return sought.left is None and isinstance(read.items[0], t.Sym)


def _is_turned(read: t.Chain, sought: Sought) -> bool:
    """Is no left side known, and does the symbol stand last: 3g/(2ℓ) = α?"""
    last = read.items[-1]
    alone = isinstance(last, t.Sym) and last.name not in sought.allowed and not isinstance(read.items[0], t.Sym)
    return sought.left is None and alone


def _bare(node: t.Node) -> t.Node:
    while isinstance(node, t.Group):
        node = node.arg
    return node


def _with_chain(found: Judgement, read: t.Chain, sought: Sought) -> Judgement:
    """A chain with a side that is not equal to the result is remarked upon."""
    first = 1 if _is_plain_chain(read, sought) else 0
    sides = [side for side in read.items[first:-1] if not _is_left(side, sought)]
    odd = any(are_equal(side, sought.value, sought.ground).is_refuted for side in sides)
    return found.with_remark("chain") if odd else found


def _judged(answer: t.Node, sought: Sought) -> Judgement:
    if sought.target and sought.target in t.names(answer):
        return j.wrong("circular", name=t.Sym(sought.target))
    verdict = are_equal(answer, sought.value, sought.ground)
    if verdict.is_proved:
        return j.RIGHT
    for look in LOOKS:
        found = look(answer, sought)
        if found is not None:
            return replace(found, witness=verdict.witness)
    if not verdict.is_refuted:
        return j.undecided(verdict.reason)
    return replace(j.wrong(), witness=verdict.witness)


# --- what else an answer may be, each tried in turn


def _carried(answer: t.Node, sought: Sought) -> Judgement | None:
    for own in sought.carried:
        if _is_worth_carrying(own, sought) and are_equal(answer, own, sought.ground).is_proved:
            return Judgement(Status.CARRIED, j.ALL, (Remark("carried"),))
    return None


def _is_worth_carrying(own: t.Node, sought: Sought) -> bool:
    """Guard: what follows from the own answer is not zero, has the right dimension, and holds what the key holds."""
    value, key = (value_of(side, sought.ground) for side in (own, sought.value))
    if value is None or key is None or not value or (value.number() is not None and key.number() is None):
        return False
    return _dimension_remark(own, sought) is None


def _unfinished(answer: t.Node, sought: Sought) -> Judgement | None:
    """True on the motion, but with names that the result should not hold."""
    extra = sorted(t.names(answer) - sought.allowed - set(sought.ground.scope.scalars))
    if not extra or not sought.ground.has_motion:
        return None
    own, key = (value_of(side, sought.ground) for side in (answer, sought.value))
    if own is None or key is None:
        return None
    for depth in (sought.ground.on_motion, sought.ground.along):
        if _is_same(depth, own, key, sought.ground):
            slots = {"names": tuple(t.Sym(name) for name in extra)}
            return Judgement(Status.UNFINISHED, j.HALF, (Remark("unfinished", slots),))
    return None


def _is_same(change: Callable[[Scalar], Scalar], own: Scalar, key: Scalar, ground: GradingGround) -> bool:
    try:
        return scalars_equal(change(own), change(key), ground.assumptions).is_proved
    except OUTSIDE:
        return False


def _slip(answer: t.Node, sought: Sought) -> Judgement | None:
    for known in sought.anticipated:
        if known.formula is not None and are_equal(answer, known.formula, sought.ground).is_proved:
            return Judgement(Status.WRONG, remarks=j.slip_remarks(known.slip), slip=known.slip)
    return None


def _dimension(answer: t.Node, sought: Sought) -> Judgement | None:
    remark = _dimension_remark(answer, sought)
    return Judgement(Status.WRONG, remarks=(remark,)) if remark else None


def _dimension_remark(answer: t.Node, sought: Sought) -> Remark | None:
    known = sought.ground.dimensions
    if not (t.names(answer) | t.names(sought.value)) - {"pi"} <= set(known):
        return None
    try:
        wanted = dimension_of(sought.value, known)
    except DimensionError:
        return None
    try:
        found = dimension_of(answer, known)
    except DimensionError as error:
        return Remark("dimensions", {"why": error.what})
    value = value_of(answer, sought.ground)
    is_zero = not value if value is not None else divides_by_zero(answer, sought.ground)
    return None if found == wanted or is_zero else Remark("dimension", {"found": a(found), "wanted": a(wanted)})


def _near_miss(answer: t.Node, sought: Sought) -> Judgement | None:
    """A sign or a rational factor off; the factor is read off one point, and then proved."""
    ratio = sought.ground.sampling.ratio(answer, sought.value)
    if ratio is None or not t.names(sought.value) - {"pi"}:
        return None
    if not are_equal(answer, t.Mul((t.Num(ratio), sought.value)), sought.ground).is_proved:
        return None
    return j.wrong("sign") if ratio == -1 else j.wrong("factor", factor=t.Num(ratio))


LOOKS = (_carried, _slip, _unfinished, _dimension,
         lambda answer, sought: rounded(answer, sought.value, sought.ground), _near_miss)  # fmt: skip


# --- an equation that is not solved for what is asked


def _equation(read: t.Chain, sought: Sought) -> Judgement:
    """An equation that determines the quantity rightly, but is not solved for it, is unfinished."""
    if sought.left is None and any(are_equal(side, sought.value, sought.ground).is_proved for side in read.items):
        return Judgement(Status.INVALID, remarks=(Remark("equation"),))  # of what it is a result is not known
    if not sought.target or sought.target not in t.names(read) or len(read.items) != 2:
        return j.wrong("other side", left=sought.left) if sought.left is not None else j.wrong("equation")
    solved = value_of(sought.value, sought.ground)
    unfinished = Judgement(Status.UNFINISHED, j.HALF, (Remark("unsolved", {"left": sought.left}),))
    if solved is None:
        return j.undecided(UNSOLVED)
    found, is_linear = determined(read, sought.target, solved, sought.ground), linear_parts(read, sought.target, sought.ground)
    if not isinstance(found, Verdict):
        return found
    if found.is_refuted:
        return replace(j.wrong(), witness=found.witness)
    return unfinished if found.is_proved and is_linear else j.undecided(UNSOLVED)


UNSOLVED = "the equation is not solved for what is asked"


def determined(equation: t.Chain, name: str, solved: Scalar, ground: GradingGround) -> Verdict | Judgement:
    """Whether an equation of two sides holds where a symbol has this value; a judgement if it does for every value."""
    left, right = equation.items
    if are_equal(left, right, ground).is_proved:
        return j.wrong("identity")
    return are_equal(left, right, replace(ground, scope=ground.scope.with_scalars({name: solved})))


def gap(equation: t.Chain) -> t.Node:
    """Left less right."""
    return t.Add((equation.items[0], t.Neg(equation.items[1])))


def linear_parts(equation: t.Chain, name: str, ground: GradingGround) -> tuple[Scalar, Scalar] | None:
    """(a, b), where an equation says that a times a symbol plus b is zero; None where it is not linear in it."""
    value, index = value_of(gap(equation), ground), atoms.intern("symbol", name)
    parts = value.num.by_power(index) if value is not None and index not in value.den.atoms() else {}
    if not {1} <= set(parts) <= {0, 1}:
        return None
    return Scalar(parts[1]), Scalar(parts[0]) if 0 in parts else NOTHING
