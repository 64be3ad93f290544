"""The worksheet: what stands on one student's paper, and the key to it.

Everything is a value. A formula is a display tree everywhere (`expr.tree`), prose is inlines of
the document tree (`document.model`); a number is a `Measure`, exact as it is printed. Formats
(`formats.EXPORTERS`) and grading read this model and nothing else.

A blank in a formula is the symbol `blank_name(n)`, printed as a small numbered box; its answer is a
`Blank` of the key. What a misconception makes of a quantity is an `Anticipated` value: the options of
a choice, the comments of the marks and the response trees of a learning platform all come from it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from rbpsym.document.model import Block, Inlines
from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.tree import Node, Sym
from rbpsym.frozen import Frozen, field
from rbpsym.quantities import NUMBER, Dimension
from rbpsym.statement.model import Problem

KINDS = ("fill-in", "choose", "order", "find-the-slip", "signs", "formula", "number", "compare", "explain")
BLANK = "□"


def blank_name(number: int) -> str:
    """The name of the symbol that stands for the blank `number` (from 1) in a formula."""
    return f"{BLANK}_{number}"


def blank(number: int) -> Sym:
    """The blank `number` (from 1) as a part of a formula."""
    return Sym(blank_name(number))


class Measure(Frozen):
    """A number as it is printed: exact value in `unit` ("m/s^2", "deg", "" for a pure number).

    `digits` counts the significant figures: 2.50 m is Measure(Fraction(5, 2), "m", 3).
    """

    value: Fraction
    unit: str = ""
    digits: int = 3


class Tolerance(Frozen):
    """When a number counts as right: within `relative` of the exact value; `digits` are asked for,
    from `digits - fewer` to `digits + more` of them are accepted; fewer cost half of their share where they say less."""

    relative: Fraction = Fraction(1, 100)
    digits: int = 3
    fewer: int = 1
    more: int = 1


class AskedQuantity(Frozen):
    """The quantity that an item asks for, and where its derivation shows it.

    quantity: id within the problem ("acceleration.theta", "work.T.N_w.ladder"); name: its symbol as
    a tree; problem: key of `Worksheet.problems`; step: id of the step that gives it ("" if none does);
    dimension: of the quantity.
    """

    problem: str
    quantity: str
    name: Node
    dimension: Dimension = NUMBER
    step: str = ""


class Slip(Frozen):
    """A misconception at work in one problem: `name` is a key of `misconceptions.MISCONCEPTIONS`.

    `slots` fill the phrase of its feedback (`slip_feedback`); `first_wrong` is the id of the first step
    of the right derivation that the misconception spoils ("" if none shows it), `shown` what that step states.
    `also`: other slips that give the very same wrong answer.
    """

    name: str
    slots: Mapping[str, Any] = field(default_factory=dict)
    first_wrong: str = ""
    shown: Node | None = None
    also: tuple[Slip, ...] = ()

    @property
    def phrase(self) -> str:
        """The key of its feedback in the teaching phrases."""
        return f"misconception.{self.name}.feedback"


class Anticipated(Frozen):
    """A wrong answer that a slip leads to: as a formula, as a number at the student's numbers, or both.

    Each was REFUTED against the key and against the others of its item, has the dimension of the
    key, and its number differs from theirs in print.
    """

    slip: Slip
    formula: Node | None = None
    number: Measure | None = None


def wrong_formulas(anticipated: Iterable[Anticipated]) -> tuple[tuple[Node, Slip], ...]:
    """Those that are formulas, each with its slip."""
    return tuple((known.formula, known.slip) for known in anticipated if known.formula is not None)


class Criterion(Frozen):
    """A line of a rubric: what earns `points`; `formula` is the relation that it looks for, if one."""

    points: Fraction
    text: Inlines
    formula: Node | None = None


class FollowOn(Frozen):
    """How an answer follows from an earlier one, for error carried forward.

    `formula` gives the answer (in SI units, angles in radians) where the symbol `name` stands for
    the student's own answer to the item `item` (the blank `blank` of it, from 1; 0 for the item's only answer).
    `beside`: further (item, name) whose own answers stand in it too.
    """

    item: str
    name: str
    formula: Node
    blank: int = 0
    beside: tuple[tuple[str, str], ...] = ()


# --- keys


class FormulaKey(Frozen):
    """A formula in the quantities `names` (with the problem's assumptions and on its constraints).

    `left` is the left side that stands printed before the answer. `anticipated`: known wrong answers.
    """

    value: Node
    left: Node
    names: tuple[str, ...] = ()
    anticipated: tuple[Anticipated, ...] = ()
    follows: tuple[FollowOn, ...] = ()


class NumberKey(Frozen):
    """A number with unit. `measure` is the key as it is printed, `exact` the value in SI units
    (angles in radians); `formula` the value as a formula, `given` the numbers that go into it, by name.

    `units` are units that may be meant, the printed one first (other units of the same dimension are right too).
    """

    measure: Measure
    exact: float
    formula: Node
    left: Node
    given: Mapping[str, Measure]
    tolerance: Tolerance = Tolerance()
    units: tuple[str, ...] = ()
    anticipated: tuple[Anticipated, ...] = ()
    follows: tuple[FollowOn, ...] = ()


class Option(Frozen):
    """One of the answers to choose from, with the slip that makes it (None for the right one).

    `content` is what is printed; `formula` the same as a tree where it is a formula, `number` where it is a number.
    """

    content: Inlines
    slip: Slip | None = None
    formula: Node | None = None
    number: Measure | None = None


class ChoiceKey(Frozen):
    """Options in the order in which they are printed; `right` is the place of the right one (from 0)."""

    options: tuple[Option, ...]
    right: int


class LinePiece(Frozen):
    """A step to be put in order, or a line of a derivation: its step's id, what it says, and why."""

    id: str
    statement: Node
    reason: Inlines = ()


class OrderKey(Frozen):
    """Pieces as printed (shuffled). `before` holds pairs of places (i, j) from 0: the piece i must come
    before the piece j; every order that keeps them is right. `sample` is one right order of places."""

    pieces: tuple[LinePiece, ...]
    before: frozenset[tuple[int, int]]
    sample: tuple[int, ...]

    def accepts(self, order: tuple[int, ...]) -> bool:
        """Whether an order of all places keeps the graph."""
        place = {piece: at for at, piece in enumerate(order)}
        if len(place) != len(self.pieces) or set(place) != set(range(len(self.pieces))):
            return False
        return all(place[i] < place[j] for i, j in self.before)


class SlipKey(Frozen):
    """Lines of a derivation in which the one at place `wrong` (from 0) is the slip; later lines carry it on.

    `corrected` is what that line should say, `slip` the misconception that made it.
    """

    lines: tuple[LinePiece, ...]
    wrong: int
    corrected: Node
    slip: Slip


SIGNS = ("+", "-", "0")


class SignRow(Frozen):
    """A force on a body: the signs ("+", "-", "0") of its works W_T and W_θ over the motion.

    `cancels` names the group of rows whose works cancel in the sum ("" if they don't).
    """

    force: Node
    body: str
    label: Inlines
    translational: str
    rotational: str
    cancels: str = ""


class SignsKey(Frozen):
    """The table of signs; `rows` in the printed order."""

    rows: tuple[SignRow, ...]


class Blank(Frozen):
    """The answer to one blank, numbered from 1 as it is printed; `anticipated` as in `FormulaKey`."""

    number: int
    value: Node
    points: Fraction = Fraction(1)
    step: str = ""
    anticipated: tuple[Anticipated, ...] = ()


class BlanksKey(Frozen):
    """All blanks of a fill-in item. `names`: quantities that an answer may hold."""

    blanks: tuple[Blank, ...]
    names: tuple[str, ...] = ()


class ComparisonKey(ChoiceKey):
    """Which of two variants is greater in what is asked: `options` are "first", "second", "same" in words. The item's
    rubric is for the why."""


class ExplanationKey(Frozen):
    """An open question: `sample` is an answer that gets all points; the item's rubric says what for."""

    sample: tuple[Block, ...]


Key = FormulaKey | NumberKey | ChoiceKey | OrderKey | SlipKey | SignsKey | BlanksKey | ComparisonKey | ExplanationKey


# --- items and worksheets


class Item(Frozen):
    """One task: `id` is unique on the worksheet ("1", "2", ...), `kind` one of KINDS.

    prompt: what is printed; key: the answer; solution: the way to it, at the student's numbers;
    rubric: how the points are split (may be empty: all or nothing); level: 0 much help .. 3 none;
    space: centimetres of paper for the answer.
    """

    id: str
    kind: str
    prompt: tuple[Block, ...]
    key: Key
    asked: AskedQuantity
    points: Fraction = Fraction(1)
    rubric: tuple[Criterion, ...] = ()
    solution: tuple[Block, ...] = ()
    level: int = 1
    space: Fraction = Fraction(2)


class Part(Frozen):
    """The tasks about one problem: its statement with a figure, the student's numbers, the items.

    `place` holds the coordinate (by name) at which the motion is looked at, where something is asked along it.
    """

    problem: str
    title: Inlines
    statement: tuple[Block, ...]
    given: Mapping[str, Measure]
    items: tuple[Item, ...]
    solution: tuple[Block, ...] = ()
    place: Mapping[str, Measure] = field(default_factory=dict)


class Student(Frozen):
    """Who works on it: a key that is unique in the roster, and the name to print."""

    id: str
    name: str = ""


class Worksheet(Frozen):
    """One student's paper with its key. `code` is the form code, printed on the paper."""

    name: str
    title: Inlines
    language: str
    code: str
    parts: tuple[Part, ...]
    problems: Mapping[str, Problem]
    notation: Notation = DEFAULT
    student: Student | None = None
    introduction: tuple[Block, ...] = ()

    @property
    def items(self) -> tuple[Item, ...]:
        """All items in the printed order."""
        return tuple(item for part in self.parts for item in part.items)

    @property
    def points(self) -> Fraction:
        """The most that can be had."""
        return sum((item.points for item in self.items), Fraction(0))

    def item(self, id: str) -> Item:
        """The item of an id (KeyError if there is none)."""
        return {item.id: item for item in self.items}[id]

    def part_of(self, id: str) -> Part:
        """The part to which an item belongs (KeyError if there is none)."""
        return {item.id: part for part in self.parts for item in part.items}[id]
