"""Printed formulas made ready to be read and evaluated: dimensions of their symbols; integrals, sums and derivatives.

By dimensions an ambiguous formula is read. An integral along the motion from the start to now is a quantity that is zero
at the start and whose rate is known: ∫f dq grows at f q̇, whatever unknown forces f may hold. A sum over particles is
the sum over the points at which the external forces act.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial
from math import comb, prod

from rbpsym.claims.ground import Glossary, Ground
from rbpsym.claims.model import Setting
from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.domain import conditions, faults, obligations, pole
from rbpsym.decide.verdict import Witness
from rbpsym.errors import LimitError, RbpsymError, ReadError, Undecided
from rbpsym.expr import tree as t
from rbpsym.expr.limits import number_of
from rbpsym.expr.symbol_table import SymbolTable
from rbpsym.field import EX, EY, NOTHING, Scalar, Space, Vector, depends_on, is_zero, names_in, short, substitute, symbol
from rbpsym.field.evaluate import Meanings, scalar, space_derivative, time_derivative, value, vector
from rbpsym.field.integration import definite
from rbpsym.mechanics.motion import along_motion
from rbpsym.present.forms import present
from rbpsym.quantities import ENERGY, Dimension
from rbpsym.quantity.bound import Bound, World


def with_dimensions(words: Glossary, setting: Setting, world: World) -> SymbolTable:
    """The table of a glossary that chooses readings by the dimensions of its symbols, looked up when asked for."""
    arrows_first = sorted(setting.symbols.items(), key=lambda item: not words.names[item[0]][1])
    phrases = {words.names[latex][0]: meaning.phrase for latex, meaning in arrows_first}
    return replace(
        words.table,
        faults=_judge(phrases, world),
        varies=partial(_varies, phrases, world),
        directed=lambda name: (found := _bound(phrases.get(name), world)) is not None and found.in_plane,
    )


def _bound(phrase: str | None, world: World) -> Bound | None:
    """What a phrase means; None where nothing is known."""
    with suppress(RbpsymError, ZeroDivisionError):
        return world.bound(phrase) if phrase is not None else None
    return None


def _varies(phrases: Mapping[str, str], world: World, name: str) -> bool:
    """May the quantity of a name change during the motion?"""
    found = _bound(phrases.get(name), world)
    if found is None:
        return True
    if found.kind != "value" or found.vector is not None or found.scalar is None:
        return found.kind != "constant"
    motion = world.motion
    return phrases[name] == "t" or any(
        depends_on(found.scalar, other)
        for names in (motion.scope.rates, motion.ledger, motion.unsettled, motion.lawless)
        for other in names
    )


def _judge(phrases: Mapping[str, str], world: World) -> Callable[[t.Node], int]:
    known: dict[str, Dimension | None] = {}

    def judged(node: t.Node) -> int:
        for name in t.names(node) - known.keys():
            known[name] = _of_phrase(phrases.get(name), world)
        return faults(node, {name: found for name, found in known.items() if found is not None})

    return judged


def _of_phrase(phrase: str | None, world: World) -> Dimension | None:
    """None where nothing is known."""
    if (found := _bound(phrase, world)) is None:
        return None
    with suppress(RbpsymError, ZeroDivisionError):
        return dimension_of_bound(found, {**world.dimensions, **dict.fromkeys(world.motion.ledger, ENERGY)})
    return None


def dimension_of_bound(found: Bound, known: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of a meaning; None for one that has no value yet, or is zero. Raises DimensionError."""
    parts = (found.scalar,) if found.vector is None else (*found.vector.plane.parts.values(), found.vector.z)
    return next((dimension_of(present(part), known) for part in parts if part), None)


def prepared(node: t.Node, ground: Ground) -> t.Node:
    """The formula with its integrals and sums replaced by quantities that the scope knows."""
    early = EARLY.get(type(node))
    if early is not None:
        return early(node, ground)
    node = t.mapped(node, lambda part: prepared(part, ground))
    late = LATE.get(type(node))
    return late(node, ground) if late else node


def _injected(found: Scalar | Space, ground: Ground) -> t.Node:
    """A value as a name of its own."""
    table = ground.defined
    name = next((n for n, v in table.items() if v == found and n.startswith("value ")), f"value {len(table)}")
    table[name] = found
    return t.Vec(name) if isinstance(found, Space) else t.Sym(name)


def _path(node: t.PathIntegral, ground: Ground) -> t.Node:
    scope = ground.scope
    force, path = value(node.integrand, scope), value(node.path, scope)
    along = _rate(path, ground)
    if isinstance(force, Space) and isinstance(along, Space):
        return _injected(ground.motion.work(force.dot(along)), ground)
    if isinstance(force, Space) or isinstance(along, Space):
        raise ReadError("a vector and a scalar are multiplied under the integral")
    return _injected(ground.motion.work(force * along), ground)


def _rate(found: Scalar | Space, ground: Ground) -> Scalar | Space:
    """d/dt. Raises Undecided for a quantity of which no rate is known."""
    settled = ground.motion.settled
    if isinstance(found, Scalar):
        return _speed(found, ground)
    parts = {angle: settled(length) for angle, length in found.plane.parts.items()}
    return space_derivative(Space(Vector(parts), settled(found.z)), ground.scope)


def _speed(found: Scalar, ground: Ground) -> Scalar:
    if len(found.num) > MOST_DERIVED:
        raise LimitError(f"the derivative of an expression of more than {MOST_DERIVED} terms is not carried out")
    return time_derivative(ground.motion.settled(found), ground.scope)


def _integral(node: t.Integral, ground: Ground) -> t.Node:
    scope = ground.scope
    name = ground.generator(node.var)
    _refuse_poles(node if name is None else replace(node, var=name), ground)
    inside = scalar(node.integrand, scope)
    lower, upper = scalar(node.lower, scope), scalar(node.upper, scope)
    if name is None:
        return _injected(_over(scope.scalars[node.var], inside, lower, upper, ground), ground)
    if _is_settled(inside, name, ground):
        done = definite(inside, name, lower, upper)
        if done is not None:
            return _injected(done, ground)
    return _injected(_along(inside, name, lower, upper, ground), ground)


class NoValueError(Undecided):
    """An integral through a pole: no relation with it holds. `witness` is a point at which it lies between the ends."""

    def __init__(self, witness: Witness) -> None:
        super().__init__("the integrand has a pole between the ends of the integral")
        self.witness = witness


def _refuse_poles(node: t.Integral, ground: Ground) -> None:
    """Raises NoValueError where there is a pole, Undecided where it is not known that there is none."""
    given = ground.motion.assumptions
    within = [one for one in conditions(node, ground.scope) if one.between is not None]
    if (witness := pole(within, given)) is not None:
        raise NoValueError(witness)
    if not all(duty.is_discharged for duty in obligations(within, given)):
        raise Undecided("whether the integrand has a value everywhere between the ends is not known")


def _over(place: Scalar, inside: Scalar, lower: Scalar, upper: Scalar, ground: Ground) -> Scalar:
    """An integral over something composed (s = Rφ), from the start to now or back."""
    begin = substitute(place, ground.scope.start)
    for first, last, sign in ((begin, place, 1), (place, begin, -1)):
        if is_zero(lower - first) and is_zero(upper - last):
            return ground.motion.work(inside * _speed(place, ground)) * sign
    raise Undecided("the variable of this integral is no coordinate, and it does not go from the start to now")


def _is_settled(inside: Scalar, name: str, ground: Ground) -> bool:
    """Is the integrand a function of the variable and of constants alone?"""
    moving = [other for other in ground.scope.rates if other != name]
    return not any(depends_on(inside, other) for other in (*moving, *ground.motion.lawless))


def _along(inside: Scalar, name: str, lower: Scalar, upper: Scalar, ground: Ground) -> Scalar:
    """An integral along the motion: from the start to now, back, or between other places."""
    scope = ground.scope
    begin, now = scope.start.get(name), symbol(name)
    if begin is None or name not in scope.rates:
        raise Undecided("this integral is outside the class that is integrated in closed form")
    power = inside * scope.rates[name]
    for first, last, sign in ((begin, now, 1), (now, begin, -1)):
        if is_zero(lower - first) and is_zero(upper - last):
            return ground.motion.work(power) * sign
    known = along_motion(ground.motion.moved(inside), ground.motion.squares)
    done = None if known is None else definite(known, name, lower, upper)
    if done is None:
        raise Undecided("this integral is outside the class that is integrated in closed form")
    return done


def _sum(node: t.Sum, ground: Ground) -> t.Node:
    """Σ over the points at which the external forces act."""
    return t.Add(tuple(prepared(part, ground) for part in _at_points(node.term, ground)))


def _at_points(term: t.Node, ground: Ground) -> list[t.Node]:
    indexed = {part.name for part in t.walk(term) if isinstance(part, t.Vec) and _points(part.name, ground)}
    if not indexed:
        raise ReadError("the sum has no quantity of the single particles", instead="bind one to “external force”.")
    count = min(_points(name, ground) for name in indexed)
    return [_with_index(term, indexed, k) for k in range(count)]


def _points(name: str, ground: Ground) -> int:
    found = ground.bound(name)
    return len(found.points) if found else 0


def _with_index(node: t.Node, names: set[str], k: int) -> t.Node:
    if isinstance(node, t.Vec) and node.name in names:
        return t.Vec(f"{node.name}#{k}")
    return t.mapped(node, lambda part: _with_index(part, names, k))


def _body(node: t.BodyIntegral, ground: Ground) -> t.Node:
    """∫ r × dF is a sum over the forces; ∫ r × dp is ∫ r × v dm; ∫ dF is ΣF."""
    found = next((part for part in t.walk(node.integrand) if isinstance(part, t.Deriv) and part.wrt == "m"), None)
    if found is not None and isinstance(found.of, t.Vec) and _points(found.of.name, ground):
        plain = _without_mass(node.integrand)
        return t.Add(tuple(_at_points(plain, ground)))
    return t.mapped(node, lambda part: prepared(part, ground))


def _without_mass(node: t.Node) -> t.Node:
    if isinstance(node, t.Deriv) and node.wrt == "m":
        return node.of
    return t.mapped(node, _without_mass)


def _derivative(node: t.Deriv, ground: Ground) -> t.Node:
    if node.wrt == "t":
        whole = value(node.of, ground.scope)
        for _ in range(node.order):
            whole = _rate(whole, ground)
        return _injected(whole, ground)
    if node.wrt == "m" and isinstance(node.of, t.Vec) and (bound := ground.bound(node.of.name)) and bound.density:
        return t.Vec(f"{node.of.name}/dm")
    name = ground.generator(node.wrt)
    if name is None:
        raise Undecided("the derivative is with respect to something that is no coordinate, speed or parameter")
    found, rate = _on_motion(scalar(node.of, ground.scope), ground), ground.scope.rates.get(name)
    if node.partial or not _beside(found, name, ground):
        return replace(node, wrt=name, of=_injected(found, ground))
    if rate is None:
        return replace(node, wrt=name, of=_injected(_function_of(name, found, ground), ground))
    for _ in range(node.order):  # with all that changes as the coordinate does
        found = short(_speed(found, ground) / rate)
    return _injected(found, ground)


def _on_motion(found: Scalar, ground: Ground) -> Scalar:
    """The value with the accelerations and unknown forces of the motion, if there are some in it."""
    return ground.motion.moved(found) if names_in(found) & ground.motion.unsettled else found


def _beside(found: Scalar, name: str, ground: Ground) -> frozenset[str] | set[str]:
    """What stands beside a coordinate and changes as it does; beside a parameter: speeds, which depend on it along the motion."""
    motion = ground.motion
    if name in motion.speeds:
        return set()
    return names_in(found) & {*(motion.scope.rates if name == "t" or name in motion.scope.rates else motion.speeds)} - {name}


def _function_of(name: str, found: Scalar, ground: Ground, given: Collection[str] = ()) -> Scalar:
    """The value on the motion, as a function of one coordinate or parameter, and of what else is given. Raises Undecided."""
    found = _on_motion(found, ground)
    if not _beside(found, name, ground).difference(given):
        return found
    known = along_motion(ground.motion.moved(found), ground.motion.squares)
    if known is None or _beside(known, name, ground).difference(given):
        raise Undecided(f"it is not known as a function of {name} alone")
    return known


def _renamed(node: t.Bracket | t.Limit, ground: Ground) -> t.Node:
    name = ground.generator(node.var)
    if name is None:
        raise Undecided("the limits are those of something that is no coordinate or parameter")
    return replace(node, var=name, arg=_injected(_function_of(name, scalar(node.arg, ground.scope), ground), ground))


def _at(node: t.At, ground: Ground) -> t.Node:
    """f|_{θ = 0}: the value there; where several symbols have a value too."""
    places, found = {}, value(node.arg, ground.scope)
    for left, op, right in t.relations(node.condition):
        if op != "=" or not isinstance(left, t.Sym):
            raise Undecided("a value can be taken where a symbol has a value")
        name = ground.generator(left.name)
        if name is None:
            raise Undecided("the place is not given by a coordinate or parameter")
        places[name] = scalar(right, ground.scope)

    def there(part: Scalar) -> Scalar:
        if places == {"t": NOTHING}:
            return substitute(_on_motion(part, ground), ground.scope.start)
        return substitute(_function_of(next(iter(places)), part, ground, places), places)

    if not isinstance(found, Space):
        return _injected(there(found), ground)
    x, y, z = map(there, found.components())
    return _injected(Space(EX * x + EY * y, z), ground)


MOST_TERMS, MOST_DERIVED = 1500, 150
PRODUCTS = (t.Mul, t.Div, t.Dot, t.Cross)
EARLY: dict[type, Callable[..., t.Node]] = {t.Sum: _sum, t.BodyIntegral: _body}
LATE: dict[type, Callable[..., t.Node]] = {
    t.PathIntegral: _path, t.Integral: _integral, t.Deriv: _derivative, t.Bracket: _renamed, t.Limit: _renamed, t.At: _at,
}  # fmt: skip


def valued(node: t.Node, ground: Ground) -> Scalar | Space:
    """The value of a printed formula. Raises RbpsymError where it has none."""
    ready, scope = prepared(node, ground), ground.scope
    if _size(ready, scope) > MOST_TERMS:
        raise LimitError(f"multiplied out, the formula has more than {MOST_TERMS} terms")
    return value(ready, scope)


def _size(node: t.Node, scope: Meanings) -> int:
    """About how many terms the formula has when it is multiplied out."""
    if isinstance(node, t.Sym):
        found = scope.scalars.get(node.name)
        return 1 if found is None else max(1, len(found.num)) * len(found.den)
    if isinstance(node, t.Pow):
        count, power = _size(node.base, scope), int(abs(number_of(node.exponent) or Fraction(1)))
        return comb(power + count - 1, count - 1) if count < MOST_TERMS else count
    sizes = [_size(part, scope) for part in t.children(node)]
    if isinstance(node, PRODUCTS):
        return min(prod(sizes), MOST_TERMS + 1)
    return sum(sizes) if isinstance(node, t.Add) else max(sizes, default=1)


def as_vector(found: Scalar | Space) -> Space:
    """A vector; the scalar 0 counts as the zero vector. Raises ReadError for any other scalar."""
    if isinstance(found, Space):
        return found
    if found:
        raise ReadError("a scalar stands where a vector belongs")
    return vector(t.ZERO)
