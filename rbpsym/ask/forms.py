"""The form of a value that is told, and the sense that numbers give to what has both."""

from __future__ import annotations

import math

from rbpsym.algebra.normal import is_rooted
from rbpsym.algebra.present import present
from rbpsym.algebra.roots import simplified_root
from rbpsym.algebra.scalar import Scalar
from rbpsym.ask.neat import neat
from rbpsym.derivation.draft import length
from rbpsym.equality.signs import sign
from rbpsym.errors import NoNumber
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.study import Study
from rbpsym.quantity.path import SENSES, even


def shortest(value: Scalar, study: Study) -> Scalar:
    """The value in the shortest of its forms: as it is, with short roots, as one root."""
    if not is_rooted(value.num) and not is_rooted(value.den):
        return value
    given, square = study.assumptions, short(even(value * value))
    forms, way = [value, neat(value, given)], SENSES.get(sign(value, given).kind)
    if way and not is_rooted(square.num) and not is_rooted(square.den):
        forms.append(simplified_root(square, lambda name: given.sign_of(name) == "positive") * way)
    return min(forms, key=lambda form: length(present(form, study.style, factor=True)))


def sense_at_sample(study: Study, push: Scalar) -> int:
    """1 or -1, the sense of a push at the sample numbers; 0 where it has none there."""
    try:
        return int(math.copysign(1, found)) if (found := number(push, sample(study.problem))) else 0
    except NoNumber:
        return 0
