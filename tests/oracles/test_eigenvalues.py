"""What is said of small motions, against the mechanism in maximal coordinates.

About each position of rest the accelerations that the simulation gives are differentiated by differences in all
coordinates and speeds; the eigenvalues of that matrix are compared with what is printed.
"""

from __future__ import annotations

import cmath
import math
from collections import Counter
from itertools import islice

import numpy as np
import pytest

from rbpsym.errors import NotApplicable
from rbpsym.mechanics.study import Study
from rbpsym.oracles.simulation import Bench, Derived
from rbpsym.solve import results
from rbpsym.statement.loader import load_problem
from tests.library.derived import FOLLOWED
from tests.oracles.conftest import DRAWS, SETS
from tests.oracles.sets import Numbers, bounds, drawn
from tests.proof.conftest import FILES

ALL = (*FOLLOWED, "systems/guided-rod", "systems/damped-rod", "systems/cart-rod", "systems/rod-on-strings")
FEW, MANY = 2, 20
MOST_DRAWS = 40  # per set
CLOSE = 1e-6
STEP = 2e-4
STENCIL = ((1, 0.8), (2, -0.2), (3, 4 / 105), (4, -1 / 280))  # central differences of the eighth order
FUNCTIONS = {n: getattr(cmath, n) for n in ("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "pi")}
FUNCTIONS["ln"] = cmath.log


def evaluated(text: str, numbers: dict[str, float]) -> complex:
    return complex(eval(text, {"__builtins__": {}}, {**numbers, **FUNCTIONS}))  # our own output, in a test


def placed(study: Study, item, numbers: Numbers) -> Numbers | None:
    """The coordinates of the place, None if it does not exist for these numbers or lies outside its range."""
    at = dict(numbers)
    try:
        for name, text in item["at"].items():
            value = evaluated(text, numbers)
            if abs(value.imag) > 1e-12:
                return None
            at[name] = value.real
        pairs = ((at[name], *bounds(study, name, at)) for name in item["at"])
        inside = all((low is None or low <= x) and (high is None or x <= high) for x, low, high in pairs)
    except (ValueError, ZeroDivisionError, KeyError):
        return None
    return at if inside else None


def jacobian(study: Study, at: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """(accelerations at rest, the matrix of the first-order system in displacements and speeds)."""
    system = study.system
    bench = Bench(Derived(system, study.dynamics, None, {}, {}, {}, {}), at)
    names, all_names = system.independent, bench.placement.names

    def gained(shift: np.ndarray) -> np.ndarray:
        n = len(names)
        places = {name: at[name] + s for name, s in zip(names, shift[:n], strict=True)}
        start = bench.start(places, dict(zip(names, shift[n:], strict=True)), names)
        balance = bench.equations.at(start.where, start.speed)
        found = bench.placement.accelerations(start.q, start.rates, start.where, start.speed, balance.gained)
        return np.array([found[all_names.index(name)] for name in names])

    n = len(names)
    columns = []
    for k in range(2 * n):
        step = np.zeros(2 * n)
        step[k] = STEP
        columns.append(sum(w * (gained(j * step) - gained(-j * step)) for j, w in STENCIL) / STEP)
    upper = np.hstack([np.zeros((n, n)), np.eye(n)])
    return gained(np.zeros(2 * n)), np.vstack([upper, np.array(columns).T])


def printed(item, numbers) -> tuple[list[complex], bool]:
    """Eigenvalues that are printed, and whether these are all but zeros."""
    polynomial = item["characteristic_polynomial"]
    if polynomial is not None:
        factors = [[evaluated(text, numbers) for text in factor] for factor in polynomial["factors"]]
        found = [complex(root) for factor in factors for root in np.roots(factor)]
        for text in item["eigenvalues"] or ():
            assert min(abs(evaluated(text, numbers) - root) for root in found) < 1e-7 * (1 + max(map(abs, found)))
        return found, True
    squares = [evaluated(text, numbers) for text in item["frequencies_squared"]]
    return [sign * cmath.sqrt(-square) for square in squares for sign in (1, -1)], bool(squares)


def agree(item, study, numbers) -> None:
    problem = study.problem
    rest, matrix = jacobian(study, numbers)
    values = np.linalg.eigvals(matrix)
    scale = max(1e-9, *abs(values))
    where = (problem.name, item["at"], {q.name: numbers[q.name] for q in problem.parameters})
    assert np.abs(rest).max() < CLOSE * max(1.0, scale**2), where
    found, complete = printed(item, numbers)
    tolerance = [max(CLOSE, 1e-9 / max(_apart(values, value), 1e-9)) * scale for value in found]
    for value, close in zip(found, tolerance, strict=True):
        assert min(abs(values - value)) < close, (where, value, values)
    if complete:
        others = [value for value in values if abs(value) > 1e-3 * scale]
        assert all(min(abs(value - mine) for mine in found) < 1e-5 * scale for value in others), (where, found, values)
    growth = values.real.max() / scale
    said = item["stability"]
    assert said != "unstable" or growth > CLOSE, where
    assert said not in ("minimum", "asymptotic") or growth < 1e-3, where  # zeros in pairs are known to half the digits
    assert said != "asymptotic" or all(v.real < 0 for v in values if abs(v) > 1e-3 * scale), where


def _apart(values: np.ndarray, value: complex) -> float:
    """How far, in the scale of all, the two eigenvalues next to a value are from each other: near a double one digits
    are lost."""
    near = sorted(values, key=lambda v: abs(v - value))[:2]
    return abs(near[0] - near[1]) / max(abs(values)) if len(near) == 2 else 1.0


def compared(name: str, sets: int, record) -> None:
    """At so many sets of numbers for each place; a set for which it does not exist is drawn again."""
    study = Study(load_problem(FILES[name]))
    answer, again = results(study)["equilibria"], Counter()
    for item in answer:
        done, source = 0, drawn(study, 2011)
        for numbers in islice(source, MOST_DRAWS * sets):
            at = placed(study, item, numbers)
            if at is None or _undecided(item, at):
                again["a place of rest that does not exist, or next to a bifurcation"] += 1
                continue
            try:
                agree(item, study, at)
            except NotApplicable as reason:
                again[reason.what] += 1
                continue
            done += 1
            if done == sets:
                break
        assert done == sets, (name, item["at"], done)
        record(SETS, done)
    record(DRAWS, dict(again))


@pytest.mark.heavy
@pytest.mark.parametrize("name", ALL)
def test_eigenvalues(name, record_property):
    compared(name, FEW, record_property)


@pytest.mark.thorough
@pytest.mark.parametrize("name", ALL)
def test_eigenvalues_at_many_sets(name, record_property):
    compared(name, MANY, record_property)


def _undecided(item, numbers) -> bool:
    """Next to a bifurcation: a value that decides between stable and unstable is close to 0."""
    text = item["stable_where_positive"]
    return text is not None and abs(evaluated(text, numbers)) < 1e-2


CART = {"m": 1.0, "M": 1.0, "ell": 1.0, "g": 9.8}


@pytest.mark.parametrize(("c", "value"), [(2.0, -0.287 + 4.780j), (50.0, -0.110 + 3.843j)])
def test_the_cart_with_its_damper(c, value):
    """The numbers of the finding: an undamped 4.850 was printed."""
    [item, _] = results(Study(load_problem(FILES["rod-on-damped-cart"])))["equilibria"]
    assert item["frequencies_squared"] == [] and item["stability"] == "asymptotic"
    found, _ = printed(item, {**CART, "c": c})
    assert min(abs(root - value) for root in found) < 6e-4
    assert not any(math.isclose(abs(root.imag), 4.850, abs_tol=2e-2) for root in found)
