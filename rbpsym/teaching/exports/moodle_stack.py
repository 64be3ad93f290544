"""STACK questions: a formula is compared by Maxima; the response tree asks for each misconception in turn.

Each question brings tests of its own: the right answer, and every anticipated wrong one, with the
note at which the tree must arrive.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rbpsym.statement.model import Problem
from rbpsym.teaching.exports.bench import Desk
from rbpsym.teaching.exports.names import maxima
from rbpsym.teaching.exports.question import Formulas
from rbpsym.teaching.model import Item


@dataclass(frozen=True, slots=True)
class Node:
    """A node of the response tree: what the answer is compared with, what it then earns, and what is told."""

    against: str
    score: int
    told: str


@dataclass(frozen=True, slots=True)
class Tree:
    """The field of a number with its right formula, its share of the points, and the tree: the right answer first."""

    number: int
    right: str
    share: float
    nodes: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Stack:
    """What a question of STACK has beyond others. tests: for each the node (from 0) at which each tree arrives."""

    variables: str
    trees: tuple[Tree, ...]
    tests: tuple[Mapping[int, int], ...]


def stack(form: Formulas, item: Item, desk: Desk) -> Stack:
    """The trees of all fields, and the tests: the right answers, then each wrong one in its field."""
    trees = tuple(_tree(entry, form.names, desk) for entry in form.entries)
    right = dict.fromkeys((tree.number for tree in trees), 0)
    wrong = ({**right, tree.number: place} for tree in trees for place in range(1, len(tree.nodes)))
    values = "".join(f"ta{tree.number}: {tree.right};\n" for tree in trees)
    return Stack(_assumptions(form.names, desk.worksheet.problems[item.asked.problem]) + values, trees, (right, *wrong))


def _tree(entry, names: Mapping[str, str], desk: Desk) -> Tree:
    """Right? else each misconception; a node that fails leads to the next."""
    known = (Node(maxima(wrong.formula, names), 0, desk.feedback(wrong.slip)) for wrong in entry.wrong)
    first = Node(f"ta{entry.number}", 1, f"<p>{desk.word('right')}</p>")
    return Tree(entry.number, maxima(entry.value, names), float(entry.share), (first, *known))


def _assumptions(names: Mapping[str, str], problem: Problem) -> str:
    """assume(m>0) for what is positive, so that roots are compared as we compare them."""
    positive = [names[q.name] for q in problem.parameters if q.sign == "positive" and q.name in names]
    return f"assume({', '.join(f'{name}>0' for name in positive)});\n" if positive else ""
