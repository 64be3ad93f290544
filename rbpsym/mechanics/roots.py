"""Where a function of coordinates vanishes: factor by factor, in closed form where there is one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import gcd

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.inverses import angle_of_sine, angle_of_tangent
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.field import NOTHING, ONE, PI, Poly, Scalar, atoms, factors, generator, inverse, is_zero, short, shorten
from rbpsym.field.calculus import atom_depends, depends_on, derivative, function, substitute
from rbpsym.field.normal import normal
from rbpsym.field.roots import simplified_root
from rbpsym.frozen import Frozen, field

At = dict[str, Scalar]  # where coordinates are
HALF = Fraction(1, 2)


def numerator_factors(value: Scalar) -> list[Poly]:
    """The irreducible factors of the numerator that hold a non-constant, without multiplicity."""
    poly = shorten(value.num)
    if not poly.terms:
        return []
    low = tuple((i, min(0, *(dict(m).get(i, 0) for m in poly.terms))) for i in poly.atoms())
    cleared = poly.scaled(1, inverse(tuple(item for item in sorted(low) if item[1])))
    _, powers = cleared.content()
    rest = cleared.scaled(1, inverse(powers))
    if _is_irreducible(rest):
        return [generator(index) for index, _ in powers] + ([rest] if len(rest) > 1 else [])
    return [factor for factor, _ in factors(cleared)[1]]


def factors_in(value: Scalar, *names: str) -> list[Scalar]:
    """The factors of the numerator in some coordinates, each of which `factor_zeros` solves wholly or not at all.

    What does not split with sines of several multiples of an angle may do so in those of the angle itself:
    sin 2θ cos θ - k cos θ sin θ cos 2θ vanishes with cos θ, and elsewhere.
    """
    found: list[Scalar] = []
    for factor in map(Scalar, numerator_factors(value)):
        mixed = any(len(_angles(factor, name)) > 1 for name in names)
        parts = [Scalar(part) for part in numerator_factors(Scalar(normal(factor.num)))] if mixed else []
        found += parts if len(parts) > 1 else [factor]
    found = [factor for factor in found if any(depends_on(factor, name) for name in names)]
    return [factor for k, factor in enumerate(found) if factor not in found[:k]]


def _is_irreducible(poly: Poly) -> bool:
    """One term, or a x + B with a single term a (that has no factor in common with B, since the content is out)."""
    if len(poly) < 2:
        return True
    parts = (poly.by_power(index) for index in poly.atoms())
    return any(set(part) == {0, 1} and len(part[1]) == 1 for part in parts)


def zeros(value: Scalar, name: str, given: Assumptions | None = None) -> list[Scalar]:
    """Values of the coordinate (angles in (-π, π]) at which the function vanishes, as far as closed forms go."""
    found: list[Scalar] = []
    for factor in numerator_factors(value):
        for root in factor_zeros(Scalar(factor), name, given):
            if not any(is_zero(root - old) for old in found):
                found.append(root)
    return found


def factor_zeros(factor: Scalar, name: str, given: Assumptions | None = None) -> list[Scalar]:
    """The zeros of one irreducible factor; with a root of the coordinate in it where what is `given` tells which they are."""
    if not depends_on(factor, name):
        return []
    rooted = [i for i in factor.num.atoms() if atoms.atom(i).kind == "root" and atom_depends(i, name)]
    if rooted:
        return [] if given is None else _rooted_zeros(factor, rooted[0], name, given)
    slope = derivative(factor, name)
    if not depends_on(slope, name):
        return [-(substitute(factor, {name: NOTHING}) / slope)]
    bend = derivative(slope, name)
    if not depends_on(bend, name):
        return _solve_quadratic(bend / 2, *(substitute(value, {name: NOTHING}) for value in (slope, factor)))
    return _trig_zeros(factor, name)


def _rooted_zeros(factor: Scalar, index: int, name: str, given: Assumptions) -> list[Scalar]:
    """Those of a + b √x among the zeros of a² - b² x; none where one of these has no closed form, or may be none of them."""
    parts = {k: Scalar(part) for k, part in factor.num.by_power(index).items()}
    if set(parts) != {0, 1}:
        return []
    squared = [one for one in factors_in(parts[0] ** 2 - parts[1] ** 2 * atoms.atom(index).arg, name) if depends_on(one, name)]
    found = [[neat(place, given) for place in factor_zeros(one, name, given)] for one in squared]
    signs = [(place, sign(neat(substitute(factor, {name: place}), given), given)) for places in found for place in places]
    is_whole = all(found) and all(side.kind == "zero" or side.is_nonzero for _, side in signs)
    return [place for place, side in signs if side.kind == "zero"] if is_whole else []


def period(factor: Scalar, name: str) -> Scalar | None:
    """After what the factor takes its values again, if the coordinate occurs within sines and cosines alone, and their roots."""
    rates: list[Scalar] = []
    inner = [i for i in factor.atoms() if atom_depends(i, name)]
    for index in inner:
        atom = atoms.atom(index)
        if atom.kind == "root":
            inner += [i for i in Scalar(atom.arg).atoms() if atom_depends(i, name)]
            continue
        rate = derivative(Scalar(atom.arg), name) if atom.kind in ("cos", "sin") else None
        if rate is None or depends_on(rate, name):
            return None
        rates.append(rate)
    ratios = [Fraction(ratio) for rate in rates if (ratio := (rate / rates[0]).number()) is not None]
    if not ratios or len(ratios) < len(rates):
        return None
    shared = Fraction(gcd(*(ratio.numerator * 720 // ratio.denominator for ratio in ratios)), 720)
    return PI * 2 / (rates[0] * shared)


def _solve_quadratic(a: Scalar, b: Scalar, c: Scalar) -> list[Scalar]:
    """Zeros of a x² + b x + c (whether they are real is seen where they are used)."""
    spread = simplified_root(short(b * b - a * c * 4), lambda name: False)
    return [(spread * side - b) / (a * 2) for side in (1, -1)]


def _trig_zeros(factor: Scalar, name: str) -> list[Scalar]:
    """Zeros of a cos A + b sin A + d with A = rate × coordinate + phase."""
    angles = _angles(factor, name)
    if len(angles) != 1:
        return _other_forms(factor, name, angles)
    [angle] = angles
    rate = derivative(Scalar(angle), name)
    if depends_on(rate, name):
        return []
    cos, sin = (atoms.intern(kind, angle) for kind in ("cos", "sin"))
    phase = substitute(Scalar(angle), {name: NOTHING})
    return [_principal((solution - phase) / rate) for solution in _waves(factor.num, cos, sin, name)]


def _angles(factor: Scalar, name: str) -> set[Poly]:
    """The angles in its sines and cosines that depend on a coordinate."""
    waves = (atoms.atom(i) for i in factor.num.atoms())
    return {wave.arg for wave in waves if wave.kind in ("cos", "sin") and depends_on(Scalar(wave.arg), name)}


def _waves(poly: Poly, cos: int, sin: int, name: str) -> list[Scalar]:
    """Angles at which a polynomial in cos A and sin A vanishes: linear in both, or quadratic in one."""
    parts = _linear_parts(poly, cos, sin)
    if parts is not None:
        return [] if any(depends_on(part, name) for part in parts) else _solve_wave(*parts)
    for base, other, kind in ((cos, sin, "acos"), (sin, cos, "asin")):
        powers = _quadratic_parts(poly, base, other)
        if powers and not any(depends_on(part, name) for part in powers):
            if slope := _tangent(*powers, kind):
                return [slope, -slope, PI - slope, slope - PI]
            solutions = [_angle(kind, value) for value in _solve_quadratic(*powers)]
            return [way for first in solutions for way in (first, -first if kind == "acos" else PI - first)]
    return []


def _tangent(a: Scalar, b: Scalar, c: Scalar, kind: str) -> Scalar | None:
    """The acute angle with a u² + c = 0 for its cosine (or sine) u by its tangent, where that is shorter."""
    rest = short(a + c)
    if not is_zero(b) or len(rest.num) >= len(short(a).num):
        return None
    ratio = short(-(rest / c) if kind == "acos" else -(c / rest))
    return function("atan", simplified_root(ratio, lambda name: False))


def _quadratic_parts(poly: Poly, base: int, other: int) -> tuple[Scalar, Scalar, Scalar] | None:
    """(a, b, c) of a u² + b u + c in u = cos A, with sin² A = 1 - u² (or the other way round)."""
    mixed = poly.by_power(other)
    if set(mixed) - {0, 2}:
        return None
    square = generator(base) * generator(base)
    plain = mixed.get(0, Poly({})) + mixed.get(2, Poly({})) * (ONE - square)
    powers = plain.by_power(base)
    if set(powers) - {0, 1, 2} or 2 not in powers:
        return None
    return Scalar(powers[2]), Scalar(powers.get(1, Poly({}))), Scalar(powers.get(0, Poly({})))


def _other_forms(factor: Scalar, name: str, angles: set[Poly]) -> list[Scalar]:
    """The same in base angles, where several multiples of one angle occur."""
    if len(angles) < 2:
        return []
    image = normal(factor.num)
    return [] if image == factor.num else zeros(Scalar(image), name)


def _linear_parts(poly: Poly, cos: int, sin: int) -> tuple[Scalar, Scalar, Scalar] | None:
    """(a, b, d) of a cos + b sin + d, None if it is not of that form."""
    by_cos = poly.by_power(cos)
    if set(by_cos) - {0, 1}:
        return None
    a, rest = by_cos.get(1, Poly({})), by_cos.get(0, Poly({}))
    by_sin = rest.by_power(sin)
    if set(by_sin) - {0, 1} or sin in a.atoms():
        return None
    return Scalar(a), Scalar(by_sin.get(1, Poly({}))), Scalar(by_sin.get(0, Poly({})))


def _solve_wave(a: Scalar, b: Scalar, d: Scalar) -> list[Scalar]:
    """Angles at which a cos A + b sin A + d = 0; where none of these vanishes, by u = tan(A/2)."""
    if not d:
        if not a:
            return [NOTHING, PI]
        if not b:
            return [PI * HALF, PI * -HALF]
        base = _angle("atan", -(a / b))
        return [base, base + PI]
    if not b:
        base = _angle("acos", -(d / a))
        return [base, -base]
    if not a:
        base = _angle("asin", -(d / b))
        return [base, PI - base]
    if is_zero(a + d):
        return [NOTHING, function("atan", b / a) * 2]
    if is_zero(a - d):
        return [PI, function("atan", a / b) * -2]
    if sum(len(part.num) + len(part.den) for part in (a, b, d)) > LONG:
        return []
    return [function("atan", half) * 2 for half in _solve_quadratic(d - a, b * 2, a + d)]


def _angle(kind: str, value: Scalar) -> Scalar:
    """An angle with a cosine (acos), sine (asin) or, up to π, a tangent (atan): the one whose that is, or its opposite."""
    for way in (1, -1):
        found = (angle_of_tangent if kind == "atan" else angle_of_sine)(value * way)
        if found is not None:
            return PI * HALF - found * way if kind == "acos" else found * way
    return function(kind, value)


LONG = 6  # three terms with nothing but one below their bars: what is longer tells nobody where it vanishes


def _principal(value: Scalar) -> Scalar:
    """A plain multiple of π brought into (-π, π]."""
    number = (value / PI).number()
    if number is None:
        return value
    reduced = -((-Fraction(number) + 1) % 2 - 1)
    return PI * reduced


Spread = Callable[[str, Scalar, Scalar | None], Sequence[Scalar]]


class Places(Frozen):
    """Assignments of names at which all values vanish; `open_` are factors that may vanish elsewhere too."""

    found: list[At] = field(default_factory=list)
    open_: list[Scalar] = field(default_factory=list)


def common_zeros(
    values: Sequence[Scalar],
    names: Sequence[str],
    most: int = 32,
    spread: Spread = lambda name, root, period: (root,),
    given: Assumptions | None = None,
) -> Places:
    """Where all values vanish, found one equation at a time.

    A name that is left out may have any value there, and others may be given in terms of it. `spread` makes of a zero
    and the period of its factor all that are meant.
    """
    places = Places()
    _search(list(values), tuple(names), {}, places, most, spread, given)
    return places


def _search(
    values: list[Scalar], names: Sequence[str], at: At, places: Places, most: int, spread: Spread, given: Assumptions | None
) -> None:
    values = [value for value in values if not is_zero(value)]
    if not values:
        if at and not any(at.keys() == old.keys() and all(is_zero(at[n] - old[n]) for n in at) for old in places.found):
            places.found.append(dict(at))
        return
    for value in sorted(values, key=lambda v: (sum(depends_on(v, n) for n in names), len(v.num))):
        ways, left = _ways(value, [name for name in names if name not in at], names, spread, given)
        for image in ways:
            if len(places.found) < most:
                fixed = {n: substitute(v, image) for n, v in at.items()} | image
                others = [substitute(v, fixed) for v in values if v is not value]  # which vanishes by its root
                _search(others, names, fixed, places, most, spread, given)
        if ways or not left:
            places.open_.extend(left)
            return
    places.open_.append(values[0])


def _ways(
    value: Scalar, open_: Sequence[str], names: Sequence[str], spread: Spread, given: Assumptions | None
) -> tuple[list[At], list[Scalar]]:
    """How each factor can vanish, solved for one of the names that are open: r sin θ by r = 0, θ = 0 and θ = π;
    and the factors that are not solved."""
    found, left = list[At](), list[Scalar]()
    for factor in factors_in(value, *open_):
        solved = ((name, [root for root in zeros(factor, name, given) if _is_plain_in(root, names)]) for name in open_)
        name, roots = next((item for item in solved if item[1]), ("", []))
        found += [{name: place} for root in roots for place in spread(name, root, period(factor, name))]
        left += [] if roots else [factor]
    return found, left


def _is_plain_in(value: Scalar, names: Sequence[str]) -> bool:
    """Whether the coordinates occur in it as they are, not within functions.

    An angle atan(f(q)) put into sin and cos leads to nested roots, which end in no closed form.
    """
    inside = [i for i in value.atoms() if atoms.atom(i).kind != "symbol"]
    return not any(atom_depends(index, name) for index in inside for name in names)
