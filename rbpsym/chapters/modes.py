"""Normal modes about a stable position of rest: linear equations, characteristic equation, frequencies, shapes.

M q̈ = -C q̇ - K (q - q₀). Where no speeds occur, q - q₀ = A cos ϑt solves it if det(K - λ M) = 0 with λ = ϑ², and
then (K - λ M) A = 0; else see `decay`. Meriam & Kraige, Dynamics, 8; Goldstein, 6.2.
"""

from __future__ import annotations

from dataclasses import replace

from rbpsym.chapters import decay
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, is_zero, root, short, symbol, total
from rbpsym.mechanics.elimination import determinant
from rbpsym.mechanics.oscillation import Equilibrium, amplitudes
from rbpsym.present.forms import present
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import FULL, STANDARD

LAMBDA = "lamda"
LONGEST, LONGEST_RATIO, LONGEST_SIZE = 120, 30, 40


def write(draft: Draft, item: Equilibrium, place: int, *, whole: bool = False) -> None:
    """The steps for one place of rest; `whole`: long shapes too."""
    _equations(draft, item, place)
    if item.nature.proved == "minimum":
        _stability(draft, item, place)
    if item.linear.is_damped:
        decay.write(draft, item, place)
    elif item.frequencies_squared:
        _characteristic(draft, item, place)
        _frequencies(draft, item, place, whole=whole)


def _equations(draft: Draft, item: Equilibrium, place: int) -> None:
    """Σ M_ij q̈_j ≈ -Σ C_ij q̇_j - Σ K_ij (q_j - q_j0), row by row.

    A coordinate that may have any value in the equilibrium pulls at nothing but through the q_j0 of the others.
    """
    names, rows, linear = draft.study.system.independent, [], item.linear
    for inertias, drags, stiffnesses in zip(linear.inertia, linear.damping, linear.stiffness, strict=True):
        left = [draft.show(m * symbol(f"{n}_ddot")) for n, m in zip(names, inertias, strict=True) if m]
        right = [draft.show(-(c * symbol(f"{n}_dot"))) for n, c in zip(names, drags, strict=True) if not is_zero(c)]
        pulls = {n: k for n, k in zip(names, stiffnesses, strict=True) if n in item.at and not is_zero(k)}
        right += [_pull(draft, k, n, item) for n, k in pulls.items()]
        rows.append(t.relation(t.add(*left), "~", t.add(*right)))
    draft.add(f"linear.{place}", "linear_system", t.Relations(tuple(rows)), "oscillations.linear_system",
              level=STANDARD if all(length(row) <= LONGEST for row in rows) else FULL,
              premises=[f"equilibrium.{place}", *draft.those(*(f"motion.{name}" for name in names))],
              data=item.facts, obligations=draft.asked(item.valid))  # fmt: skip


def _pull(draft: Draft, stiffness: Scalar, name: str, item: Equilibrium) -> t.Node:
    """-k (q - q₀), with a sign that is read off."""
    there = item.at.get(name, NOTHING)
    deviation = t.Group(t.add(t.Sym(name), t.neg(draft.show(there)))) if there else t.Sym(name)
    shown = draft.show(stiffness)
    around = t.Group(shown) if isinstance(shown, t.Add) else shown
    return t.mul(shown.arg, deviation) if isinstance(shown, t.Neg) else t.neg(t.mul(around, deviation))


def _stability(draft: Draft, item: Equilibrium, place: int) -> None:
    """The leading minors of K over the coordinates that are not arbitrary are positive."""
    kept = [k for k, name in enumerate(draft.study.system.independent) if name in item.at]
    matrix = tuple(tuple(item.stiffness[i][j] for j in kept) for i in kept)
    minors = [determinant(tuple(row[:k] for row in matrix[:k])) for k in range(1, len(kept) + 1)]
    rows = [t.relation(draft.show(minor, factor=True), ">", t.ZERO) for minor in minors]
    draft.add(f"stability.{place}", "minors", t.system(rows), "oscillations.minors", level=FULL,
              premises=[f"equilibrium.{place}"], count=len(rows), data=item.facts)  # fmt: skip


def _matrix(item: Equilibrium, value: Scalar) -> tuple[tuple[Scalar, ...], ...]:
    rows = zip(item.stiffness, item.inertia, strict=True)
    return tuple(tuple(k - value * m for k, m in zip(a, b, strict=True)) for a, b in rows)


def _characteristic(draft: Draft, item: Equilibrium, place: int) -> None:
    """det(K - λ M) = 0."""
    style = replace(draft.study.style, moving=draft.study.style.moving | {LAMBDA})
    shown = present(determinant(_matrix(item, symbol(LAMBDA))), style, factor=True)
    draft.add(f"characteristic.{place}", "secular", t.equation(shown, t.ZERO), "oscillations.characteristic",
              level=STANDARD if length(shown) <= LONGEST else FULL, premises=[f"linear.{place}"], letter=t.Sym(LAMBDA),
              data=item.facts)  # fmt: skip


def _frequencies(draft: Draft, item: Equilibrium, place: int, *, whole: bool) -> None:
    """Squares of the frequencies, the slowest first, and the shapes of the modes."""
    rows, found = [], item.frequencies_squared
    for k, square in enumerate(found, 1):
        letter = _name(draft, "vartheta", place, k)
        draft.context.scalars[letter] = root(square)
        rows.append(t.equation(t.Pow(t.Sym(letter), t.TWO), draft.show(square, factor=True)))
    draft.add(f"modes.{place}", "normal_modes", t.system(rows), "oscillations.modes", count=len(rows), is_result=True,
              premises=[f"characteristic.{place}"], data=item.facts)  # fmt: skip
    made = [amplitudes(item, square) for square in found] if len(item.stiffness) > 1 else []
    shapes = [shape for shape in made if shape is not None]
    ratios = [ratio for shape in shapes for ratio in shape]
    if len(shapes) == len(found) and (whole or all(length(draft.show(ratio, factor=True)) <= LONGEST_RATIO for ratio in ratios)):
        for k, (square, shape) in enumerate(zip(found, shapes, strict=True), 1):
            _shape(draft, item, place, k, square, shape)


def _name(draft: Draft, letter: str, place: int, k: int) -> str:
    """ϑ_k, with the place before it if there are several stable ones."""
    several = sum(item.stable is True for item in draft.study.equilibria) > 1
    return draft.free(f"{letter}_{place}{k}" if several else f"{letter}_{k}")


def _shape(draft: Draft, item: Equilibrium, place: int, k: int, square: Scalar, shape: tuple[Scalar, ...]) -> None:
    """The ratios of the amplitudes of the coordinates in one mode, and their size if its mass Σ M_ij A_i A_j is 1."""
    names = draft.study.system.independent
    letters = [_name(draft, f"A_{name}", place, k) for name in names]
    pairs = ((m, a, b) for row, a in zip(item.inertia, shape, strict=True) for m, b in zip(row, shape, strict=True))
    size = short(1 / total(m * a * b for m, a, b in pairs))
    draft.context.scalars.update(zip(letters, (root(size) * ratio for ratio in shape), strict=True))
    first = next(k for k, ratio in enumerate(shape) if not is_zero(ratio))
    others = [k for k in range(len(shape)) if k != first]
    rows = [t.equation(t.Div(t.Sym(letters[k]), t.Sym(letters[first])), draft.show(shape[k], factor=True)) for k in others]
    sized = t.equation(t.Pow(t.Sym(letters[first]), t.TWO), draft.show(size, factor=True))
    is_short = length(sized) <= LONGEST_SIZE
    kind = f"{'sized' if is_short else 'plain'}{'_all' if len(others) > 1 else ''}"
    draft.add(f"shape.{place}.{k}", "mode_shape", t.system([*rows, sized] if is_short else rows), f"oscillations.shape.{kind}",
              premises=[f"modes.{place}"], frequency=t.Sym(_name(draft, "vartheta", place, k)), first=t.Sym(names[first]),
              second=t.Sym(names[others[0]]), data={**item.facts, "square": square, "order": (first, *others)})  # fmt: skip
