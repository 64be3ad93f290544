"""Exact arithmetic: the field of rational functions in quantities, sines, cosines and roots."""

from rbpsym.field.atoms import symbol_name
from rbpsym.field.calculus import atom_names, depends_on, derivative, function, inside, names_in, rate_along, root, substitute
from rbpsym.field.effort import apart, ask_for_more, at_most, granted, in_all, kept, remembered, spend
from rbpsym.field.evaluate import BARE, Meanings, Value, at_start, rate, space_derivative, time_derivative, value
from rbpsym.field.exponentials import is_exponential, with_exponentials_joined, with_squares
from rbpsym.field.normal import (
    Bases,
    bases_of,
    has_roots,
    in_bases,
    is_rooted,
    is_zero,
    reduce_roots,
    reduce_squares,
    same,
    short,
    shorten,
    tidy,
)
from rbpsym.field.poly import ONE, UNIT, ZERO, Coefficient, Monomial, Poly, accumulate, generator, inverse, times
from rbpsym.field.ring import factors
from rbpsym.field.roots import simplified_root, with_image, with_root_taken_out, without_even_roots, without_roots_below
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, generator_of, lift, name_of, quotient, show, symbol, total
from rbpsym.field.trig import PI_TERM, cosine, sine
from rbpsym.field.vector import EX, EY, ORIGIN, QUARTER, Space, Vector, cartesian, polar
