"""What a careful author would not let stand in a printed formula, found in its display tree."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from math import gcd

from rbpsym.expr import tree as t


def factors(node: t.Node) -> tuple[t.Node, ...]:
    node = node.arg if isinstance(node, t.Neg) else node
    return node.factors if isinstance(node, t.Mul) else (node,)


def base(node: t.Node) -> t.Node:
    return node.base if isinstance(node, t.Pow) else node


def exponent(node: t.Node) -> Fraction | int:
    return node.exponent.value if isinstance(node, t.Pow) and isinstance(node.exponent, t.Num) else 1


def bases(node: t.Node) -> set[t.Node]:
    return {base(factor) for factor in factors(node) if not isinstance(factor, t.Num)}


def terms(node: t.Node) -> tuple[t.Node, ...]:
    return node.terms if isinstance(node, t.Add) else (node,)


def has(node: t.Node, kind: type) -> bool:
    return any(isinstance(part, kind) for part in t.walk(node))


def number(node: t.Node) -> int:
    """The whole number before a product, with what all terms of its sums have in common."""
    found = 1
    for factor in factors(node):
        if isinstance(factor, t.Num):
            found *= factor.value if factor.value == int(factor.value) else 1
        elif isinstance(factor, t.Add) and not has(factor, t.Div):
            found *= gcd(*(int(number(term)) for term in factor.terms))
    return abs(int(found))


def is_physical(node: t.Node) -> bool:
    """A sum of masses or of moments of inertia, which keeps its terms as they are: M₁ + M₂ + M_p/2, m ℓ²/3 + M ℓ²."""
    return isinstance(node, t.Add) and not any(map(t.is_negative, node.terms)) and all(map(_is_mass_like, node.terms))


def _is_mass_like(term: t.Node) -> bool:
    term = term.num if isinstance(term, t.Div) and isinstance(term.den, t.Num) else term
    symbols = [f for f in factors(term) if not isinstance(f, t.Num)]
    return all(isinstance(base(f), t.Sym) for f in symbols) and sum(exponent(f) == 1 for f in symbols) == 1


# --- what is looked for


def nested_below(node: t.Node) -> bool:
    """A fraction in a denominator (but in a sum of masses or moments of inertia)."""
    if not isinstance(node, t.Div):
        return False
    return any(has(factor, t.Div) and not is_physical(factor) for factor in factors(node.den))


def fractions_on_both_sides_of_a_bracket(node: t.Node) -> bool:
    """(1/ℓ)(3 κ/(M ℓ) - g): a parameter divides within the brackets and before them."""
    before = [f for f in factors(node) if isinstance(f, t.Div) and has(f.den, t.Sym)]
    sums = [f for f in factors(node) if isinstance(f, t.Add)]
    inside = (part for s in sums for term in s.terms for part in factors(term) if isinstance(part, t.Div))
    return isinstance(node, t.Mul) and bool(before) and any(_divides_by_parameter(part) for part in inside)


def _divides_by_parameter(part: t.Div) -> bool:
    letters = (base(f).name for f in factors(part.den) if isinstance(base(f), t.Sym))
    return any(name != "pi" and not name.startswith("s_") for name in letters)  # the length of a spring is no parameter


def needless_one(node: t.Node) -> bool:
    """1 · x, or -1 · x."""
    return isinstance(node, t.Mul) and any(isinstance(f, t.Num) and abs(f.value) == 1 for f in node.factors)


def double_minus(node: t.Node) -> bool:
    """--x, -(-a - b), a product with a negative factor."""
    if isinstance(node, t.Neg):
        return t.is_negative(node.arg) or (isinstance(node.arg, t.Add) and t.is_negative(node.arg.terms[0]))
    return isinstance(node, t.Mul) and any(map(t.is_negative, node.factors))


def all_negative_bracket(node: t.Node) -> bool:
    """(-a - b) c."""
    sums = [f for f in factors(node) if isinstance(f, t.Add)] if isinstance(node, t.Mul) else []
    return any(all(map(t.is_negative, found.terms)) for found in sums)


def uncancelled(node: t.Node) -> bool:
    """The same factor, or a whole number, above and below."""
    if not isinstance(node, t.Div):
        return False
    return bool(bases(node.num) & bases(node.den)) or gcd(number(node.num), number(node.den)) > 1


def square_below_root(node: t.Node) -> bool:
    """√(4 a² b)."""
    if not isinstance(node, t.Sqrt):
        return False
    parts = (node.arg.num, node.arg.den) if isinstance(node.arg, t.Div) else (node.arg,)
    return any(_is_square(factor) for part in parts for factor in factors(part)) and len(factors(node.arg)) < 4


def _is_square(factor: t.Node) -> bool:
    if isinstance(factor, t.Num):
        return any(factor.value % (k * k) == 0 for k in range(2, 40))
    return exponent(factor) > 1 and isinstance(base(factor), (t.Sqrt, t.Add))


def root_over_its_radicand(node: t.Node) -> bool:
    """√(3 g ℓ)/ℓ."""
    if not isinstance(node, t.Div):
        return False
    return bool(_in_roots(node.num) & bases(node.den)) or bool(_in_roots(node.den) & bases(node.num))


def _in_roots(node: t.Node) -> set[t.Node]:
    return {found for f in factors(node) if isinstance(base(f), t.Sqrt) for found in bases(base(f).arg)}


def leading_minus_below(node: t.Node) -> bool:
    """x/(-a + b), x/(-a)."""
    if not isinstance(node, t.Div):
        return False
    return any(t.is_negative(terms(base(f))[0]) for f in factors(node.den)) or t.is_negative(node.den)


def factor_twice(node: t.Node) -> bool:
    """a a, √a √b, 2 · 3."""
    if not isinstance(node, t.Mul):
        return False
    found = Counter("number" if isinstance(f, t.Num) else base(f) for f in node.factors)
    return max(found.values()) > 1 or sum(isinstance(f, t.Sqrt) for f in node.factors) > 1


def two_fractions(node: t.Node) -> bool:
    """(a/b)(c/d); ½ (M s/ℓ) v² and the factors of an integral may stand so."""
    found = [f for f in factors(node) if isinstance(f, t.Div)] if isinstance(node, t.Mul) else []
    return len(found) > 1 and found[0] != t.Div(t.ONE, t.TWO) and not has(node, t.Integral)


def untold_tangent(node: t.Node) -> bool:
    """sin² β/cos β."""
    if not isinstance(node, t.Div):
        return False
    above, below = ([f for f in factors(part) if isinstance(base(f), t.Fn)] for part in (node.num, node.den))
    return any(_is_tangent(a, b) for a in above for b in below)


def _is_tangent(above: t.Node, below: t.Node) -> bool:
    return {base(above).name, base(below).name} == {"sin", "cos"} and (
        base(above).arg == base(below).arg and exponent(above) >= exponent(below)
    )


SUSPICIONS: Mapping[str, Callable[[t.Node], bool]] = {
    found.__name__: found
    for found in (
        nested_below,
        fractions_on_both_sides_of_a_bracket,
        needless_one,
        double_minus,
        all_negative_bracket,
        uncancelled,
        square_below_root,
        root_over_its_radicand,
        leading_minus_below,
        factor_twice,
        two_fractions,
        untold_tangent,
    )
}


def suspicions(node: t.Node) -> Iterator[tuple[str, t.Node]]:
    """What is suspicious, and the part of the formula that is."""
    for part in t.walk(node):
        for name, is_suspicious in SUSPICIONS.items():
            if is_suspicious(part):
                yield name, part
