"""The explorer's own script, run by Node without a page, and the derivation's numbers beside it."""

from __future__ import annotations

import json
import math
import subprocess
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from rbpsym.explorer.page import FOLDER, Model, as_json, model
from rbpsym.mechanics import energy
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.study import Study
from rbpsym.pictures.figures.outlines import OUTLINES
from rbpsym.statement.model import Problem

ASK = """
const MOTIONS = MODELS.map((model) => new Motion(model, model.data.numbers.map((one) => one.value), CHANGE));
const asked = TIMES.flatMap((share) => MOTIONS.map((motion) => {
  const moment = motion.at(share * motion.duration), out = moment.out, data = moment.data;
  const named = (places) => Object.fromEntries(Object.entries(places).map(([name, place]) => [name, out[place]]));
  const momenta = Object.keys(data.origins).flatMap((o) => data.bodies.map((b) => [b.name, o, ...momentum(moment, b.name, o)]));
  return {
    first: motion.frames.findLast((frame) => frame.phase === 0)?.time ?? 0,
    end: motion.end, ended: motion.data.phases[0].endedBy ?? null,
    duration: motion.duration, frames: motion.frames.length, time: moment.time, local: moment.local,
    phase: moment.phase,
    began: motion.frames[motion.frames.length - 1].began, unfit: motion.unfit && motion.unfit.kind,
    q: named(data.coordinates), v: named(data.speeds), a: named(data.accelerations),
    R: named(data.unknowns), works: Object.fromEntries(motion.works.map((key, k) => [key, moment.works[k]])),
    K: [translation(moment), rotation(moment)], U: potential(moment), momenta,
    box: boxOfMotion(motion),
    blows: motion.blows.map((one) => ({ lost: one.lost, parts: one.parts.map((p) => p.value), arrows: one.arrows.length })),
    lost: motion.lost(moment.time),
  };
}));
console.log(JSON.stringify(asked, (key, value) => (typeof value === "number" && !Number.isFinite(value) ? null : value)));
"""
STAND_INS = (
    f'const OUTLINES = {as_json(OUTLINES)}; const document = {{ documentElement: {{ lang: "en" }} }};'
    "const WORDS = new Proxy({}, { get: (_, name) => String(name) });"
)


def run(
    found: Model, shares: tuple[float, ...] = (0.0, 0.37, 0.8), change: str = "AS_STATED", seconds: float = 0.0
) -> list[dict[str, Any]]:
    """What the script says at shares of the recorded motion, or of so many seconds; `change`: what a reader changes."""
    scripts = [(FOLDER / f"{name}.js").read_text() for name in ("numbers", "motion", "loose", "shapes", "drawing", "readings")]
    ask = ASK.replace("CHANGE", change).replace("motion.duration)", f"{seconds})" if seconds else "motion.duration)")
    text = "\n".join([STAND_INS, f"const MODELS=[{found.script}];const TIMES={list(shares)};", *scripts, ask])
    done = subprocess.run(["node", "-"], input=text, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def explored(problem: Problem) -> Model:
    """The model of a problem."""
    return model(problem, "en")


def state_numbers(found: Model, moment: Mapping[str, Any]) -> dict[str, float]:
    """The names of a problem with the numbers that the page shows."""
    numbers = {one["name"]: one["value"] for one in found.data["numbers"]}
    numbers |= moment["q"]
    numbers |= {f"{name}_dot": value for name, value in moment["v"].items()}
    return numbers | {"t": moment["local"]}


def derived(study: Study, numbers: Mapping[str, float]) -> Iterator[tuple[str, float]]:
    """(what, number) of everything that the page shows at a state, from the derivation."""
    known = dict(numbers)
    for name, value in accelerations(study, known).items():
        known[name] = value
        yield f"a {name.removesuffix('_ddot')}", value
    for name, value in study.dynamics.reactions.items():
        yield f"R {name}", number(value, known)
    for place, value in enumerate(study.kinetic):
        yield f"K {place}", number(value, known)
    for name, origin in study.origins.items():
        for body, state in study.system.bodies.items():
            yield f"L_orbital {body} {name}", number(energy.orbital_momentum(state, origin), known)
            yield f"L_spin {body} {name}", number(energy.spin_momentum(state), known)


def accelerations(study: Study, known: Mapping[str, float]) -> dict[str, float]:
    """From the closed formulas, or from M q̈ = f where there are none."""
    dynamics = study.dynamics
    if dynamics.accelerations is not None:
        return {name: number(value, known) for name, value in dynamics.accelerations.items()}
    matrix = [[number(entry, known) for entry in row] for row in dynamics.mass_matrix]
    found = np.linalg.solve(matrix, [number(value, known) for value in dynamics.forcing])
    return dict(zip(study.system.accelerations, found.tolist(), strict=True))


def told(moment: Mapping[str, Any]) -> dict[str, float]:
    """The same from the page."""
    found = {f"a {name}": value for name, value in moment["a"].items()}
    found |= {f"R {name}": value for name, value in moment["R"].items()}
    found |= {f"K {place}": value for place, value in enumerate(moment["K"])}
    for body, origin, orbital, spin in moment["momenta"]:
        found |= {f"L_orbital {body} {origin}": orbital, f"L_spin {body} {origin}": spin}
    return found


def close(one: float, other: float, scale: float = 1.0) -> bool:
    """Equal to 1e-6 of their size (or of a scale for what is zero)."""
    return math.isclose(one, other, rel_tol=1e-6, abs_tol=1e-7 * max(1.0, scale))
