"""Exact elimination over the field: linear systems solved without `simplify`.

Rows are scalars, linear in the unknowns and meant to vanish. A pivot is chosen for the
simplest coefficient in the shortest row, so sparse systems (free-body equations) are solved
by substitution; a small dense block is solved by determinants, which stay polynomial.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from rbpsym.field import NOTHING, ONE, UNITY, Scalar, derivative, is_zero, short, substitute, symbol
from rbpsym.field.modular import PRIME, NoImage, value_of
from rbpsym.frozen import Frozen


class Solution(Frozen):
    """values of the unknowns that are determined; `free` ones that are not; `left` the rows
    without unknowns that remain (they must vanish if the system is consistent)."""

    values: dict[str, Scalar]
    free: tuple[str, ...]
    left: tuple[Scalar, ...]


Row = dict[str, Scalar]
CONSTANT = ""


def linear_row(value: Scalar, unknowns: Sequence[str]) -> Row:
    """Coefficients of the unknowns, and the rest under the key ""."""
    row = {name: part for name in unknowns if (part := derivative(value, name))}
    row[CONSTANT] = substitute(value, dict.fromkeys(row, NOTHING)) if row else value
    return row


Ranks = Mapping[str, tuple[bool, ...]]
EQUAL: Ranks = MappingProxyType({})


def solve_linear(rows: Sequence[Scalar], unknowns: Sequence[str], *, keep_free: bool = False, ranks: Ranks = EQUAL) -> Solution:
    """Solves rows = 0 for the unknowns; with `keep_free`, some in terms of those that stay free: these of higher `ranks`."""
    return solve_rows([linear_row(value, unknowns) for value in rows], unknowns, keep_free=keep_free, ranks=ranks)


def solve_rows(rows: list[Row], unknowns: Sequence[str], *, keep_free: bool = False, ranks: Ranks = EQUAL) -> Solution:
    """The same for rows already split into coefficients."""
    rows, done = [_cleaned(row) for row in rows], []
    while True:
        choice = _pivot(rows, unknowns, ranks)
        if choice is None:
            break
        place, name = choice
        pivot = rows.pop(place)
        rows = [_eliminated(row, pivot, name) for row in rows]
        done.append((name, pivot))
    return _back_substituted(done, unknowns, rows, keep_free)


def _cleaned(row: Row) -> Row:
    return {name: part for name, part in row.items() if name == CONSTANT or not is_zero(part)}


def _pivot(rows: list[Row], unknowns: Sequence[str], ranks: Ranks) -> tuple[int, str] | None:
    candidates = [
        (ranks.get(name, ()), len(row), _size(part), order, place, name)
        for place, row in enumerate(rows)
        for order, name in enumerate(unknowns)
        if (part := row.get(name)) is not None
    ]
    return min(candidates)[4:] if candidates else None


def _size(part: Scalar) -> int:
    return (10 * len(part.num) + sum(len(m) for m in part.num.terms) + (100 * len(part.den) if part.den is not ONE else 0))


def _eliminated(row: Row, pivot: Row, name: str) -> Row:
    if name not in row:
        return row
    factor = row[name] / pivot[name]
    result = {}
    for key in row.keys() | pivot.keys():
        if key != name:
            result[key] = short(row.get(key, NOTHING) - factor * pivot.get(key, NOTHING))
    return _cleaned(result)


def _back_substituted(done: list[tuple[str, Row]], unknowns: Sequence[str], rows: list[Row], keep_free: bool) -> Solution:
    values: dict[str, Scalar] = {}
    solved = {name for name, _ in done}
    undetermined = {name for name in unknowns if name not in solved}
    for name, row in reversed(done):
        others = [key for key in row if key not in (name, CONSTANT)]
        if not keep_free and any(key in undetermined for key in others):
            undetermined.add(name)
            continue
        total = row.get(CONSTANT, NOTHING)
        for key in others:
            total = total + row[key] * (values[key] if key in values else symbol(key))
        values[name] = short(-(total / row[name]))
    left = tuple(row[CONSTANT] for row in rows if row.get(CONSTANT))
    return Solution(values, tuple(n for n in unknowns if n in undetermined), left)


Matrix = tuple[tuple[Scalar, ...], ...]


def determinant(matrix: Matrix) -> Scalar:
    """By expansion along the first row (for blocks of up to four)."""
    if not matrix:
        return UNITY
    total = NOTHING
    for column, entry in enumerate(matrix[0]):
        if entry:
            minor = tuple(row[:column] + row[column + 1 :] for row in matrix[1:])
            part = entry * determinant(minor)
            total = total - part if column % 2 else total + part
    return short(total)


def solve_matrix(matrix: Matrix, right: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """x with matrix · x = right, by determinants. Raises ZeroDivisionError for a singular matrix."""
    whole = determinant(matrix)
    if is_zero(whole):
        raise ZeroDivisionError("the determinant vanishes identically")
    found = []
    for column in range(len(matrix)):
        replaced = tuple((*row[:column], value, *row[column + 1 :]) for row, value in zip(matrix, right, strict=True))
        found.append(short(determinant(replaced) / whole))
    return tuple(found)


def blocks(matrix: Matrix) -> list[tuple[int, ...]]:
    """Index sets that the matrix does not couple."""
    left, found = set(range(len(matrix))), []
    while left:
        block, border = set(), {min(left)}
        while border:
            block |= border
            border = {j for i in border for j in left - block if matrix[i][j] or matrix[j][i]}
        found.append(tuple(sorted(block)))
        left -= block
    return found


def residue(value: Scalar) -> int:
    """The image modulo a prime at one point. Raises NoImage (a root, an odd angle) or ValueError
    (a pole there)."""
    return value_of(value.num) * pow(value_of(value.den), -1, PRIME) % PRIME


def is_surely_nonzero_on(value: Scalar, images: Mapping[str, Scalar]) -> bool:
    """Whether a value that is linear in some symbols does not vanish identically when they are these
    (True is a proof, False decides nothing); nothing is multiplied out."""
    row = linear_row(value, tuple(images))
    try:
        parts = (residue(part) * residue(images[name]) for name, part in row.items() if name != CONSTANT)
        return bool((sum(parts) + residue(row[CONSTANT])) % PRIME)
    except (NoImage, ValueError):
        return False
