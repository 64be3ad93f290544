"""Lines of a derivation for tasks: which steps matter, what may be left out of them, which come first, what each earns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from rbpsym.expr import tree as t
from rbpsym.expr.places import Path, put
from rbpsym.frozen import Frozen
from rbpsym.proof.draft import length
from rbpsym.proof.step import STANDARD, Step
from rbpsym.teaching.bench import ProblemBench, needed
from rbpsym.teaching.model import LinePiece, blank
from rbpsym.teaching.spoilers import meaning

# what a step does -> how much it matters to understand it (0: never asked)
WEIGHTS: Mapping[str, int] = {rule: weight for weight, rules in {
    5: ("parallel_axis", "angular_momentum"),
    4: ("torque", "work", "workless", "kinetic_energy"),
    3: ("mass_integral", "balance", "combination", "potential", "first_integral"),
    2: ("differentiation", "conservation", "solution", "identity", "linearization"),
    1: ("substitution", "work_done"),
}.items() for rule in rules}  # fmt: skip
LARGEST_BLANK = 40  # parts of a formula that one has to write


def lines_to(bench: ProblemBench, step: str, most: int) -> tuple[Step, ...]:
    """The steps that lead to a step, those that a lecture would show, each line once, at most so many; not the ledger of all
    forces, with their torques about every point."""
    found = bench.way_to(step, 3 * most)
    first: dict[t.Node, Step] = {}
    for s in found:
        if s.level <= STANDARD and s.rule not in ("constraint", "statement") and s.chapter != "forces":
            first.setdefault(s.statement, s)
    return tuple(first.values())[-most:]


def piece(step: Step) -> LinePiece:
    """A step as a piece."""
    return LinePiece(step.id, step.statement)


def precedence(bench: ProblemBench, ids: list[str]) -> set[tuple[int, int]]:
    """Pairs of places (i, j): by the graph the step i is needed, directly or not, for the step j."""
    by_id = {s.id: s for s in bench.derivation.steps}
    needed = {id: set(_ancestors(by_id, id)) for id in ids}
    return {(i, j) for j, id in enumerate(ids) for i, other in enumerate(ids) if other in needed[id]}


def _ancestors(by_id: Mapping[str, Step], id: str) -> Iterator[str]:
    seen, front = set(), [id]
    while front:
        for premise in needed(by_id[front.pop()]):
            if premise not in seen:
                seen.add(premise)
                front.append(premise)
                yield premise


# --- what may be blanked


class Gap(Frozen):
    """A part of a statement that may be left out: the path to it, and what stands there, its sign with it.

    `along` is the direction that stands behind the sign of a vector, and stays.
    """

    path: Path
    node: t.Node
    is_term: bool = False
    along: t.Node | None = None

    def left_out(self, statement: t.Node, number: int) -> t.Node:
        """The statement with the blank of this number in its place."""
        found: t.Node = put(statement, self.path, blank(number) if self.along is None else t.Mul((blank(number), self.along)))
        return found


def gaps(statement: t.Node) -> list[Gap]:
    """Right sides of a statement that have a scalar value, and the terms of sums on both sides."""
    rows = (
        [((("rows", k),), row) for k, row in enumerate(statement.rows)]
        if isinstance(statement, t.Relations)
        else [((), statement)]
    )
    found: list[Gap] = []
    for path, row in rows:
        if isinstance(row, t.Chain) and set(row.ops) == {"="} and len(row.items) > 1:
            for place, side in enumerate(row.items[:-1]):  # the spin part of a balance, or of L = (.. + ..) k = I ω
                found += [gap for gap in _in_side((*path, ("items", place)), side) if gap.is_term]
            found += _in_side((*path, ("items", len(row.items) - 1)), row.items[-1])
    return found


def _in_side(path: Path, node: t.Node) -> Iterator[Gap]:
    """The side itself, or (of a vector along k) its factor; then the terms of a sum."""
    inner, bare, along, negative = _without_direction(path, node)
    if _is_plain(bare):
        yield Gap(path, t.neg(bare) if negative else bare, along=along)
    if isinstance(bare, t.Add):
        for k, term in enumerate(bare.terms):
            if _is_plain(term.arg if isinstance(term, t.Neg) else term):
                yield Gap((*inner, ("terms", k)), term, is_term=True)


def _without_direction(path: Path, node: t.Node) -> tuple[Path, t.Node, t.Node | None, bool]:
    """A side without direction, brackets and sign, and the way to it if it is a sum; the direction; was there a minus?"""
    along, negative = None, False
    while True:
        if isinstance(node, t.Mul) and isinstance(node.factors[-1], t.Unit):
            along, path = node.factors[-1], (*path, ("factors", 0))
            node = t.mul(*node.factors[:-1])
        elif isinstance(node, (t.Group, t.Neg)):
            negative ^= isinstance(node, t.Neg)
            path, node = (*path, ("arg", None)), node.arg
        else:
            return path, node, along, negative


VECTORS = (t.Vec, t.Unit, t.Cross, t.PathIntegral, t.BodyIntegral, t.Delta, t.Word, t.Sum)


def _is_plain(node: t.Node) -> bool:
    """Something to write down: neither a number, nor a bare name, nor a vector, nor too long."""
    if isinstance(node, (t.Num, t.Sym)) or any(isinstance(part, VECTORS) for part in t.walk(node)):
        return False
    return length(node) <= LARGEST_BLANK


def has_value(bench: ProblemBench, node: t.Node) -> bool:
    """Whether a part means something outside its step: only quantities of the problem are in it."""
    return meaning(bench.study, node) is not None


# --- how points are shared out among the lines of a rubric


HALF = Fraction(1, 2)


def shares(points: Fraction, weights: Sequence[int]) -> list[Fraction]:
    """Points in proportion to weights, in half points where they can be: the greatest remainders are rounded up.

    Every line earns something as long as there are enough halves; what is no multiple of a half is shared exactly.

    >>> [str(x) for x in shares(Fraction(4), [4, 5, 3])]
    ['3/2', '3/2', '1']
    """
    exact = [points * weight / sum(weights) for weight in weights]
    halves = points / HALF
    if halves.denominator != 1 or halves < len(weights):
        return exact
    found = [max(1, int(part / HALF)) for part in exact]
    while sum(found) != halves:
        step = 1 if sum(found) < halves else -1
        fitting = [k for k in range(len(found)) if step > 0 or found[k] > 1]
        place = max(fitting, key=lambda k: (step * (exact[k] / HALF - found[k]), -k))
        found[place] += step
    return [count * HALF for count in found]


def gist(statement: t.Node) -> list[t.Node]:
    """A statement row by row, each without what stands between its first and its last side."""
    rows = t.rows(statement)
    equal = [isinstance(row, t.Chain) and set(row.ops) == {"="} for row in rows]
    return [t.equation(row.items[0], row.items[-1]) if plain else row for row, plain in zip(rows, equal, strict=True)]
