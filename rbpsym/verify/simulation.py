"""The simulation oracle: the statement integrated in maximal coordinates, with multipliers.

Every body has its own x, y and φ; each constraint is a condition on accelerations with its
unknown force as multiplier; all of it is built from the statement, nothing of the symbolic
solution is used in it. The derived accelerations, unknown forces, squares of speeds, works and
the first integral are then compared with it: at generic states, along a motion from a generic
state, and along the motion from the declared start.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.algebra.vector import Vector
from rbpsym.mechanics import energy
from rbpsym.mechanics.dynamics import Dynamics
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.mechanics.work import ForceWork
from rbpsym.verify.simulation_bench import Bench, Derived, SimulationReport

Momenta = Mapping[str, tuple[Vector, Scalar]]


def simulate(
    system: System,
    dynamics: Dynamics,
    *,
    integral: Scalar | None = None,
    squares: Mapping[str, Scalar] | None = None,
    along: Mapping[str, Scalar] | None = None,
    works: Iterable[ForceWork] = (),
    momenta: Momenta | None = None,
    numbers: Mapping[str, float] | None = None,
) -> SimulationReport:
    """Runs the simulation and compares. `momenta`: fixed points with the angular momentum about them;
    `numbers`: for parameters, instead of sample numbers. Raises NotApplicable, with a sentence, for a kind of
    constraint or interaction that the simulation does not know, or a start that can't be found."""
    derived = Derived(system, dynamics, integral, squares or {}, along or {}, known_works(works), momenta or {})
    bench = Bench(derived, numbers)
    bench.compare_generic_states()
    bench.compare_motion(bench.generic, from_start=False)
    bench.placement.mechanism.clock = 0.0
    declared = bench.declared_start()
    if declared is not None:
        bench.compare_motion(declared, from_start=True)
    return bench.report()


def simulate_study(study: Study, numbers: Mapping[str, float] | None = None) -> SimulationReport:
    """Everything that a study derives, put to the test. Raises as `simulate`."""
    return simulate(
        study.system,
        study.dynamics,
        integral=study.first_integral,
        squares=study.squares,
        along=study.reactions_along_motion,
        momenta=angular_momenta(study),
        numbers=numbers,
    )


def angular_momenta(study: Study) -> dict[str, tuple[Vector, Scalar]]:
    """By origin: where it is, and the derived angular momentum of the whole system about it."""
    states = study.system.bodies.values()
    return {
        name: (origin, sum((energy.orbital_momentum(s, origin) + energy.spin_momentum(s) for s in states), NOTHING))
        for name, origin in study.origins.items()
    }


def known_works(works: Iterable[ForceWork]) -> dict[tuple[str, str, bool], Scalar]:
    """Values of works that are known, by (force, body, whether rotational)."""
    halves = [
        ((item.force, item.on, turning), half.value)
        for item in works
        for turning, half in ((False, item.translational), (True, item.rotational))
    ]
    return {key: value for key, value in halves if value is not None}
