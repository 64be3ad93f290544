"""Where the forces balance: every factor counts, and a coordinate may stay arbitrary."""

from rbpsym.algebra.normal import is_zero, same
from rbpsym.algebra.scalar import symbol
from rbpsym.algebra.trig import sine
from rbpsym.mechanics.roots import common_zeros

K, L, R, W, X, Y, Z = (symbol(name) for name in ("k", "l", "r", "w", "x", "y", "z"))


def test_a_product_vanishes_with_each_of_its_factors():
    """r sin θ = 0 was once solved by r = 0 alone, and the elastic pendulum had no place of rest."""
    found = common_zeros([R * sine(symbol("theta")), K * (R - L) - W], ("r", "theta")).found
    assert any(is_zero(at["theta"]) and same(at["r"], L + W / K) for at in found)


def test_what_floats_freely_may_rest_anywhere():
    [at] = common_zeros([K * (Y - X - L), K * (X - 2 * Y + Z), K * (Z - Y - L)], ("x", "y", "z")).found
    [free] = {"x", "y", "z"} - at.keys()
    assert free == "z" and same(at["x"], Z - 2 * L) and same(at["y"], Z - L)
