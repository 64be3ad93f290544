"""The phrases of the general theory: any rigid body, driven by any three external forces.

The body is known by its mass moments; the forces F₁, F₂, F₃ act at its points s₁, s₂, s₃ and give
it, by Newton's and Euler's laws, A = ΣF/M and α = Σ s×F/I_cm. F₁ is conservative. About a fixed
axis, F₃ is the force of the axis, acting at O. Every relation is decided a second time for a
body of three particles.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym import quantities as dimensions
from rbpsym.chapters import theory_ground as theory
from rbpsym.decide.assumptions import Assumptions
from rbpsym.errors import StatementError, Undecided
from rbpsym.field import NOTHING, Meanings, Scalar, Space, atoms, cartesian, kept, space_derivative, symbol
from rbpsym.field.calculus import atom_depends, depends_on, substitute
from rbpsym.field.roots import without_even_roots
from rbpsym.frozen import Frozen, field, replace
from rbpsym.quantity.bound import Bound, Motion, axial, number, plane
from rbpsym.statement.source import did_you_mean

ALPHA, OMEGA, MASS, MOMENT = theory.ALPHA, theory.OMEGA, theory.MASS, theory.MOMENT
COUNT = 3
POSITIVE = Assumptions({"M": "positive", "I_cm": "positive"})


DIMENSIONS = {
    "M": dimensions.MASS, "I_cm": dimensions.MASS * dimensions.LENGTH**2, "E_p": dimensions.ENERGY,
    "theta": dimensions.NUMBER, "omega": dimensions.TIME**-1, "alpha": dimensions.TIME**-2,
    **dict.fromkeys(("X", "Y", "xi", "eta", *(f"s{k}_{a}" for k in range(1, COUNT + 1) for a in "xy")), dimensions.LENGTH),
    **dict.fromkeys(("X_dot", "Y_dot"), dimensions.SPEED), **dict.fromkeys(("X_ddot", "Y_ddot"), dimensions.ACCELERATION),
    **dict.fromkeys((f"F{k}_{a}" for k in range(1, COUNT + 1) for a in "xy"), dimensions.FORCE),
}  # fmt: skip
DIMENSIONS |= {f"{name}_start": found for name, found in DIMENSIONS.items()}
LAWLESS = frozenset({"alpha", "X_ddot", "Y_ddot", *(f"F{k}_{axis}" for k in range(1, COUNT + 1) for axis in "xy")})


def _pair(name: str) -> Space:
    return Space(cartesian(symbol(f"{name}_x"), symbol(f"{name}_y")))


def _turning(name: str) -> dict[str, Scalar]:
    return {f"{name}_x": -(OMEGA * symbol(f"{name}_y")), f"{name}_y": OMEGA * symbol(f"{name}_x")}


class TheoryWorld(Frozen):
    """The theory; `fixed_axis`: the body turns about the origin; `particles`: the second road."""

    fixed_axis: bool = False
    particles: bool = False
    shared: dict[str, Bound] = field(default_factory=dict)
    symbols: Mapping[str, str] = field(default_factory=dict)
    dimensions: Mapping[str, dimensions.Dimension] = field(default_factory=lambda: DIMENSIONS)

    @kept
    def rates(self) -> Mapping[str, Scalar]:
        """Time derivatives of all that varies."""
        return {**self._kinematics, "theta": OMEGA, "E_p": -self._power(0, "both")}

    @kept
    def motion(self) -> Motion:
        """What is true of its motion."""
        start = {name: symbol(f"{name}_start") for name in self.rates}
        scope = Meanings({}, {}, self.rates, start, self._over_mass)
        return Motion(
            scope,
            POSITIVE,
            self._moved,
            {},
            ("omega", "X_dot", "Y_dot"),
            frozenset(f"{name}_start" for name in start),
            lawless=LAWLESS,
            is_free=True,
        )

    def _over_mass(self, integrand: Scalar, body: str) -> Scalar:
        """∫ f dm of a polynomial f in the place of the mass element. Raises Undecided for any other f."""
        integrand = without_even_roots(integrand)
        for index in {*integrand.num.atoms(), *integrand.den.atoms()}:
            if atoms.symbol_name(index) is None and any(atom_depends(index, name) for name in ("xi", "eta")):
                raise Undecided("the integrand over the body is no polynomial in the place of the mass element")
        if any(depends_on(Scalar(integrand.den), name) for name in ("xi", "eta")):
            raise Undecided("the integrand over the body is no polynomial in the place of the mass element")
        try:
            return (theory.by_particles if self.particles else theory.by_moments)(integrand, body)
        except KeyError:
            raise Undecided("moments of the mass beyond the second are not known") from None

    def _moved(self, value: Scalar) -> Scalar:
        value = substitute(value, self._laws)
        return substitute(value, self._images) if self.particles else value

    @kept
    def _laws(self) -> Mapping[str, Scalar]:
        turn = sum((self.levers[k].cross(self.forces[k]).z for k in range(COUNT)), NOTHING)
        if self.fixed_axis:
            about = sum((self.arms[k].cross(self.forces[k]).z for k in range(COUNT - 1)), NOTHING)
            return {"alpha": about / (MOMENT + MASS * self.place.dot(self.place))}
        push = sum((force for force in self.forces), Space())
        x, y, _ = push.components()
        return {"X_ddot": x / MASS, "Y_ddot": y / MASS, "alpha": turn / MOMENT}

    @kept
    def _images(self) -> Mapping[str, Scalar]:
        mass = sum((m for m, _, _ in theory.PARTICLES), NOTHING)
        return {"M": mass, "I_cm": sum((m * (x * x + y * y) for m, x, y in theory.PARTICLES), NOTHING)}

    # --- the quantities

    @kept
    def place(self) -> Space:
        """Position of the centre of mass."""
        return Space(cartesian(symbol("X"), symbol("Y")))

    def _derived(self, value: Space) -> Space:
        return space_derivative(value, Meanings(rates=self._kinematics))

    @kept
    def _kinematics(self) -> Mapping[str, Scalar]:
        place = (
            {"X": -(OMEGA * symbol("Y")), "Y": OMEGA * symbol("X")}
            if self.fixed_axis
            else {"X": symbol("X_dot"), "Y": symbol("Y_dot"), "X_dot": symbol("X_ddot"), "Y_dot": symbol("Y_ddot")}
        )
        turning = {name: rate for k in range(1, COUNT + 1) for name, rate in _turning(f"s{k}").items()}
        return {**place, **turning, "omega": ALPHA, "xi": -(OMEGA * symbol("eta")), "eta": OMEGA * symbol("xi")}

    @kept
    def velocity(self) -> Space:
        """Velocity of the centre of mass."""
        return self._derived(self.place)

    @kept
    def acceleration(self) -> Space:
        """Acceleration of the centre of mass."""
        return self._derived(self.velocity)

    @kept
    def levers(self) -> tuple[Space, ...]:
        """Where the forces act, from the centre of mass."""
        free = [_pair(f"s{k}") for k in range(1, COUNT + 1)]
        return (*free[:-1], -self.place) if self.fixed_axis else tuple(free)

    @kept
    def arms(self) -> tuple[Space, ...]:
        """Where the forces act, from the origin."""
        return tuple(self.place + lever for lever in self.levers)

    @kept
    def forces(self) -> tuple[Space, ...]:
        """The external forces; about a fixed axis the last is what the axis exerts."""
        free = [_pair(f"F{k}") for k in range(1, COUNT + 1)]
        if not self.fixed_axis:
            return tuple(free)
        return (*free[:-1], self.acceleration * MASS - free[0] - free[1])

    def _power(self, k: int, part: str) -> Scalar:
        push = self.forces[k].dot(self.velocity)
        turn = self.levers[k].cross(self.forces[k]).z * OMEGA
        return {"translational": push, "rotational": turn, "both": push + turn}[part]

    def power(self, which: str, part: str) -> Scalar:
        """The power of the conservative, the other or all forces."""
        chosen = {"conservative": (0,), "non-conservative": range(1, COUNT), "all": range(COUNT)}[which]
        return sum((self._power(k, part) for k in chosen), NOTHING)

    def bound(self, phrase: str) -> Bound:
        """What a phrase means. Raises StatementError."""
        text = " ".join(phrase.split())
        make = PHRASES.get(text)
        if make is None:
            raise StatementError(f"“{text}” means nothing in the general theory", instead=did_you_mean(text, PHRASES))
        if text not in self.shared:
            self.shared[text] = make(self)
        return self.shared[text]

    @kept
    def second_road(self) -> TheoryWorld:
        """The same theory of a body of three particles."""
        return replace(self, particles=True, shared={})

    def again(self, bound: Bound) -> Bound:
        """What a phrase of this theory means on the second road."""
        return self.second_road.bound(next(phrase for phrase, found in self.shared.items() if found is bound))


ELEMENT = Space(cartesian(theory.XI, theory.ETA))


def _torque(world: TheoryWorld, about_center: bool) -> Bound:
    levers = world.levers if about_center else world.arms
    return axial(sum((r.cross(f).z for r, f in zip(levers, world.forces, strict=True)), NOTHING))


def _kinetic(world: TheoryWorld, part: str) -> Scalar:
    push, turn = MASS * world.velocity.dot(world.velocity) / 2, MOMENT * OMEGA * OMEGA / 2
    return {"translational": push, "rotational": turn, "both": push + turn}[part]


def _about_axis(world: TheoryWorld) -> Scalar:
    return MOMENT + MASS * world.place.dot(world.place)


def _velocity_of_element(world: TheoryWorld) -> Space:
    return world.velocity + Space(z=OMEGA).cross(ELEMENT)


def _works() -> dict[str, Callable[[TheoryWorld], Bound]]:
    """work of all forces; translational and rotational work of some of them."""
    forces = {f"the {which} forces": which for which in ("conservative", "non-conservative")}
    forces |= {"the forces": "all", "a force": "conservative"}
    tails = {"": "both", ", translational": "translational", ", rotational": "rotational"}

    def work(which: str, part: str) -> Callable[[TheoryWorld], Bound]:
        return lambda w: number(w.motion.work(w.power(which, part)))

    return {f"work of {words}{tail}": work(which, part) for words, which in forces.items() for tail, part in tails.items()}


PHRASES: Mapping[str, Callable[[TheoryWorld], Bound]] = {
    "mass": lambda w: number(MASS),
    "moment of inertia about the centre of mass": lambda w: number(MOMENT),
    "moment of inertia about the axis": lambda w: number(_about_axis(w)),
    "position of the centre of mass": lambda w: plane(w.place),
    "velocity of the centre of mass": lambda w: plane(w.velocity),
    "acceleration of the centre of mass": lambda w: plane(w.acceleration),
    "linear momentum": lambda w: plane(w.velocity * MASS),
    "position of a mass element": lambda w: replace(plane(w.place + ELEMENT), points=w.arms),
    "position of a mass element from the centre of mass": lambda w: replace(plane(ELEMENT), points=w.levers),
    "position of a point of the body": lambda w: plane(w.arms[0]),
    "position of another point of the body": lambda w: plane(w.arms[1]),
    "velocity of a mass element": lambda w: plane(_velocity_of_element(w)),
    "momentum of a mass element": lambda w: Bound(density=_velocity_of_element(w)),
    "external force": lambda w: Bound(points=w.forces),
    "position of the external force": lambda w: Bound(points=w.arms),
    "angle": lambda w: axial(symbol("theta")),
    "start of the angle": lambda w: axial(symbol("theta_start")),
    "angular velocity": lambda w: axial(OMEGA),
    "angular acceleration": lambda w: axial(ALPHA),
    "angular momentum": lambda w: axial(w.place.cross(w.velocity).z * MASS + MOMENT * OMEGA),
    "net force": lambda w: plane(sum((force for force in w.forces), Space())),
    "net torque": lambda w: _torque(w, False),
    "net torque about the centre of mass": lambda w: _torque(w, True),
    "kinetic energy": lambda w: number(_kinetic(w, "both")),
    "kinetic energy, translational": lambda w: number(_kinetic(w, "translational")),
    "kinetic energy, rotational": lambda w: number(_kinetic(w, "rotational")),
    "kinetic energy about the axis": lambda w: number(_about_axis(w) * OMEGA * OMEGA / 2),
    "rotational work about the axis": lambda w: number(w.motion.work(_torque(w, False).number * OMEGA)),
    "magnitude of position of a mass element": lambda w: replace(plane(w.place + ELEMENT), vector=None),
    "potential energy": lambda w: number(symbol("E_p")),
    "a constant": lambda w: Bound(kind="constant"),
    "unknown": lambda w: Bound(kind="unknown"),
    "defined here": lambda w: Bound(kind="defined here"),
    **_works(),
}
