"""Letters that students use untold: F, a, v, p, x, y of a body along a direction; τ, I, L about a point, ω, α, m of a body.
A force that is known but as a vector (the friction of what slips) is so, too, its component or its magnitude.

What such a letter stands for is what makes the line true; all letters of a line are of the same body, direction and point, as
far as nothing else stands behind a dash (`a_x`, `tau_cm`, `v_disk`). F and τ are the sums of those on the body.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import product

from rbpsym.decide.rooted import neat
from rbpsym.expr import tree as t
from rbpsym.field import EX, EY, NOTHING, ORIGIN, Scalar, Vector, is_zero, names_in, root, symbol
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState

ALONG, ABOUT, BARE = frozenset("Favp"), frozenset(("tau", "I", "L")), frozenset(("x", "y", "m", "M", "omega", "alpha"))
SUM = ("net", "res", "tot")  # may stand behind a sum
AXES: Mapping[str, Vector] = {"x": EX, "y": EY}
WAYS = ("way", "across", *AXES, "size")
MOST = 48  # readings of a line


class Untold(Frozen):
    """The letters of one phase; `taken` are those that mean something there."""

    study: Study
    taken: frozenset[str]

    @cached_property
    def names(self) -> frozenset[str]:
        """How they may be typed."""
        tails = (*self.study.system.bodies, *AXES, *self._points, *SUM)
        stems = ALONG | ABOUT | BARE | self._forces
        return frozenset((*stems, *(f"{stem}_{tail}" for stem in stems for tail in tails))) - self.taken

    @cached_property
    def _forces(self) -> frozenset[str]:
        return frozenset(force.name for force in self.study.system.forces if force.vector) - self.taken

    @cached_property
    def _points(self) -> tuple[str, ...]:
        return ("cm", *self.study.origins)

    @cached_property
    def values(self) -> Mapping[str, Scalar]:
        """What there is, called by letter, body, and direction or point."""
        found: dict[str, Scalar] = {}
        tied = self.study.system.tied()
        rates = [tied.get(f"{c.name}_dot", symbol(f"{c.name}_dot")) for c in self.study.problem.coordinates]
        for name, body in self.study.system.bodies.items():
            own = [force for force in self.study.system.forces if force.on == name]
            clockwise = any(body.omega and is_zero(body.omega + rate) for rate in rates)
            for way, along in self._directions(body).items():
                vectors = {
                    "F": (f.vector for f in own),
                    "a": [body.acceleration],
                    "v": [body.velocity],
                    "p": [body.velocity * body.mass],
                    **{force.name: [force.vector] for force in own if force.name in self._forces},
                }
                found |= {
                    f"{letter}.{name}.{way}": sum((one.dot(along) for one in all), NOTHING) for letter, all in vectors.items()
                }
            sized = {"v": body.velocity, **{force.name: force.vector for force in own if force.name in self._forces}}
            found |= {f"{a}.{name}.size": neat(root(one.dot(one)), self.study.assumptions) for a, one in sized.items()}
            for point in self._points:
                place = self.study.origins.get(point, body.center)
                away = body.center - place
                torque = sum((force.torque(place) for force in own), NOTHING)
                turns = away.cross(body.velocity) * body.mass + body.moment * body.omega
                found |= {f"tau.{name}.{point}": torque, f"L.{name}.{point}": turns}
                if clockwise:
                    found |= {f"tau.{name}.{point}-": -torque, f"L.{name}.{point}-": -turns}
                if not names_in(away.dot(away)) & {*self.study.system.coordinates}:
                    found[f"I.{name}.{point}"] = body.moment + body.mass * away.dot(away)
            found |= {f"omega.{name}.": body.omega, f"alpha.{name}.": body.alpha}
            found |= {f"x.{name}.": body.center.x, f"y.{name}.": body.center.y, f"m.{name}.": body.mass, f"M.{name}.": body.mass}
        return found

    def _directions(self, body: BodyState) -> Mapping[str, Vector]:
        """The axes; along and across its way, where one coordinate tells how far it went."""
        free = self.study.system.independent
        step = body.velocity.derivative(f"{free[0]}_dot") if len(free) == 1 else ORIGIN
        size = step.dot(step)
        if is_zero(size) or names_in(size) & {*self.study.system.coordinates}:
            return AXES
        way = step * neat(root(size), self.study.assumptions).inverse()
        return {"way": way, "across": way.turned(), **AXES}

    def readings(self, read: t.Node) -> Iterator[t.Node]:
        """The line in each of its meanings, its letters called as in `values`."""
        letters, seen = (
            sorted({part.name for part in t.walk(read) if isinstance(part, t.Sym)} & self.names),
            set[tuple[str, ...]](),
        )
        points = tuple(
            f"{point}{sense}" for sense in ("", "-") for point in self._points
        )  # counter-clockwise; as its angle grows
        for of in product(self.study.system.bodies, WAYS, points):
            called = tuple(self._called(name, *of) for name in letters)
            if called not in seen and len(seen) < MOST and self.values.keys() >= {*called}:
                seen.add(called)
                yield t.renamed(read, {name: t.Sym(own) for name, own in zip(letters, called, strict=True)})
        if not seen:
            yield read

    def _called(self, name: str, body: str, way: str, point: str) -> str:
        force = next((one for one in self._forces if f"{name}_".startswith(f"{one}_")), name.partition("_")[0])
        stem, tail = force, name[len(force) + 1 :]
        body, way = (tail if tail in known else own for known, own in ((self.study.system.bodies, body), (AXES, way)))
        point = tail + point[len(point.rstrip("-")) :] if tail in self._points else point
        of = way if stem in ALONG | self._forces else point.rstrip("-") if stem == "I" else point if stem in ABOUT else ""
        return f"{stem}.{body}.{of}"


def typed(read: t.Node) -> t.Node:
    """The letters as they were typed, but for what stood behind a dash."""
    return t.renamed(read, {name: t.Sym(name.partition(".")[0]) for name in t.names(read) if "." in name})


def told(read: t.Node) -> list[tuple[str, str, str]]:
    """(letter, body, direction or point) of each of its untold letters."""
    return [(*name.split("."),) for name in sorted(t.names(read)) if name.count(".") == 2]  # type: ignore[misc]
