"""Exact arithmetic: the field of rational functions in quantities, sines, cosines and roots."""

from rbpsym.algebra.atoms import symbol_name
from rbpsym.algebra.calculus import atom_names, depends_on, derivative, function, inside, names_in, rate_along, root, substitute
from rbpsym.algebra.effort import apart, ask_for_more, at_most, granted, in_all, kept, remembered, spend
from rbpsym.algebra.evaluate import BARE, Scope, Value, at_start, rate, space_derivative, time_derivative, value
from rbpsym.algebra.exponentials import is_exponential, with_exponentials_joined, with_squares
from rbpsym.algebra.grouping import perfect_power
from rbpsym.algebra.normal import (
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
from rbpsym.algebra.poly import ONE, UNIT, ZERO, Coefficient, Monomial, Poly, accumulate, generator, inverse, times
from rbpsym.algebra.present import atom_node
from rbpsym.algebra.ring import factors
from rbpsym.algebra.roots import simplified_root, with_image, with_root_taken_out, without_even_roots, without_roots_below
from rbpsym.algebra.scalar import NOTHING, PI, UNITY, Scalar, generator_of, lift, name_of, quotient, show, symbol, total
from rbpsym.algebra.signs import positive_first
from rbpsym.algebra.style import COEFFICIENT, OTHER, PLAIN, Style, split
from rbpsym.algebra.trig import PI_TERM, cosine, sine
from rbpsym.algebra.vector import EX, EY, ORIGIN, QUARTER, Space, Vector, cartesian, polar
