"""Answer text -> tree, typed plainly, in Unicode or in LaTeX; the first of the two questions: is it valid?"""

from __future__ import annotations

from rbpsym.errors import Place, ReadError
from rbpsym.notation import tree as t
from rbpsym.notation.infix import read_infix, read_relation
from rbpsym.notation.latex_reader import read_latex
from rbpsym.teaching.grading.book import Book
from rbpsym.teaching.grading.standard import EULER, MADE, standard
from rbpsym.teaching.grading.typed import checked_length, is_latex, plain, unframed, with_decimal_points

Read = t.Node
_HINT = "Enter one formula, for example with * for products and sqrt( ) for roots."


def read_formula(text: str, book: Book) -> t.Node:
    """The tree of an answer: an expression, or a Chain for one with = signs.

    Raises ReadError, LimitError (with a caret) for what is no valid answer.
    """
    told = unframed(checked_length(text))
    if not told:
        raise ReadError("there is no answer", instead=_HINT)
    has_euler = EULER not in book.names and EULER not in book.typed
    node = _latex(told, book) if is_latex(told) else _typed(told, book, has_euler)
    return _equations_only(standard(node, book.typed, has_euler), told)


def _typed(text: str, book: Book, has_euler: bool) -> t.Node:
    made = plain(text, book)
    symbols = book.names | ({EULER} if has_euler else frozenset())
    read = read_relation if any(sign in made for sign in "=<>≤≥≠≈~") else read_infix
    return read(made, symbols, functions=MADE)


def _latex(text: str, book: Book) -> t.Node:
    node = read_latex(with_decimal_points(text, book.language), book.table)
    if isinstance(node, t.System):
        raise ReadError("several formulas stand here", instead=_HINT)
    return node


def _equations_only(node: t.Node, text: str) -> t.Node:
    if isinstance(node, t.Chain) and set(node.ops) - {"=", "~"}:
        raise ReadError("an inequality is no answer here", instead="Enter the result.", place=Place(text=text[:200]))
    return node
