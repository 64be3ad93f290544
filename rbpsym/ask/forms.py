"""The form of a value that is told, what is a square taken out of its roots, and the sense that numbers give to what has both."""

from __future__ import annotations

from rbpsym.decide.rooted import neat, rationalised
from rbpsym.decide.signs import sign
from rbpsym.field import Scalar, has_roots, is_rooted, root, short, with_exponentials_joined
from rbpsym.field.normal import in_one_angle
from rbpsym.mechanics.numbers import floating
from rbpsym.mechanics.pushing import begins, begun_numbers
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.draft import length
from rbpsym.quantity.path import even


def shortest(value: Scalar, study: Study) -> Scalar:
    """The value in the shortest of its forms: as it is, with short roots, as one root."""
    value = in_one_angle(with_exponentials_joined(value))
    if not has_roots(value):
        return value
    given, square = study.assumptions, short(even(value * value))
    forms, way = [value, neat(value, given), rationalised(neat(value, given))], sign(value, given).sense
    if way and not is_rooted(square.num) and not is_rooted(square.den):
        forms.append(neat(root(square), given) * way)
    return min(forms, key=lambda form: length(present(form, study.style, factor=True)))


def sense_stated(study: Study, push: Scalar) -> int:
    """1 or -1, the sense of a push by what the statement supposes of the start; 0 where that does not tell it."""
    ratios = (push / demand.value for demand in begins(study) if demand.op != "!=" and demand.value)
    return next((found for ratio in ratios if (found := sign(short(ratio), study.assumptions).sense)), 0)


def sense_at_sample(study: Study, push: Scalar) -> int:
    """1 or -1, the sense of a push at the first sample numbers at which it begins as stated; 0 where it has none there."""
    found = floating(push, begun_numbers(study))
    return (found > 0) - (found < 0)
