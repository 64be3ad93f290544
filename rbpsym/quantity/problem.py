"""A problem as claims see it: its motion, and phrases resolved to its quantities."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from rbpsym.decide.domain import Condition
from rbpsym.decide.points import names_of
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.expr.glyphs import notation_for
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Sym
from rbpsym.field import NOTHING, ORIGIN, QUARTER, Scalar, Space, Vector, kept, polar, substitute, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.geometry import pair, position
from rbpsym.mechanics.phases import known_stages
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState, Force
from rbpsym.quantities import TIME, Dimension
from rbpsym.quantity.bound import Bound, Motion, number, without_articles
from rbpsym.quantity.phrases import EXAMPLES, PHRASES
from rbpsym.quantity.vectors import of_role
from rbpsym.statement.checks import dimensions_with_unknowns
from rbpsym.statement.model import PointRef, Problem
from rbpsym.statement.paths import round_size
from rbpsym.statement.source import did_you_mean
from rbpsym.typeset.latex import to_latex

if TYPE_CHECKING:
    from rbpsym.mechanics.phases import Stage

SYSTEM = ("system", "pendulum")
KINDS = {"a constant": "constant", "unknown": "unknown", "defined here": "defined here"}


class ProblemWorld(Frozen):
    """A problem, its phrases resolved; `answers`: what is found for a phrase that is none of its own, a question."""

    study: Study
    others: Callable[[str], ProblemWorld] | None = None
    answers: Callable[[Study, str], Bound | None] | None = None

    @kept
    def stages(self) -> tuple[Stage, ...]:
        """The phases of the motion that are known, the first included."""
        return known_stages(self.study.problem)[0]

    def named(self, phase: str) -> int:
        """The place of a phase. Raises NotApplicable for one that is not known, StatementError for none at all."""
        (found, reason), names = known_stages(self.study.problem), [each.name for each in self.study.problem.phases]
        place = next((k for k, stage in enumerate(found) if stage.name == phase), None)
        if reason is not None and place is None and phase in names:
            raise reason
        if place is None:
            known = did_you_mean(phase, names, "phases") if names else "the problem has no [[phases]]."
            raise StatementError(f"there is no phase “{phase}”", instead=known)
        return place

    @kept
    def _phases(self) -> dict[int, ProblemWorld]:
        return {}

    def phase(self, place: int) -> ProblemWorld:
        """The world of a phase."""
        if place not in self._phases:
            self._phases[place] = ProblemWorld(self.stages[place].study, self.others, self.answers)
        return self._phases[place]

    @property
    def coordinates(self) -> list[str]:
        """Names of all coordinates."""
        return [coordinate.name for coordinate in self.study.problem.coordinates]

    @kept
    def motion(self) -> Motion:
        """What is true of its motion."""
        study = self.study
        scope = study.system.scope
        coordinates = study.system.independent
        stated = {q.name for q in study.problem.parameters} - {*study.problem.implicit}
        starts = {name for value in scope.start.values() for name in names_of([value])} - stated
        return Motion(
            scope,
            study.assumptions,
            study.on_motion,
            study.squares,
            tuple(f"{n}_dot" for n in coordinates),
            frozenset(starts),
            frozenset((*study.system.unknowns, *study.system.accelerations)),
            frozenset((*study.system.unknowns, *study.system.accelerations)),
            is_tied=bool(study.system.implicit),
            kept=tuple(self._kept),
            pushed=lambda: tuple(Condition(Sym(side.force), ">=", side.value) for side in study.sides),
            energy=study.first_integral,
        )

    @property
    def _kept(self) -> Iterator[Condition]:
        """A coordinate that is tied to others keeps its declared range."""
        for name, value in self.study.system.dependent.items():
            lower, upper = self.study.assumptions.range_of(name)
            if lower is not None:
                yield Condition(Sym(name), ">", value - lower)
            if upper is not None:
                yield Condition(Sym(name), ">", upper - value)

    @kept
    def dependent(self) -> dict[str, Scalar]:
        """Coordinates that the constraints tie to others, with their speeds and accelerations."""
        return self.study.system.tied()

    def bound(self, phrase: str) -> Bound:
        """What a phrase means. Raises StatementError."""
        text = without_articles(" ".join(phrase.split()))
        if text in KINDS:
            return Bound(kind=KINDS[text])
        for pattern, resolve, _ in PHRASES:
            found = re.fullmatch(pattern, text)
            if found:
                return resolve(self, *found.groups())
        return self.expression(text)

    def vector(self, phrase: str) -> Space:
        """The vector that a phrase means; a force by its name alone is that on the first body on which it acts."""
        name = phrase.removeprefix("force ")
        acts = next((force for force in self.study.system.forces if force.name == name and force.vector), None)
        found = self.bound(f"force {name} on {acts.on}" if acts else phrase).vector
        if found is None:
            raise StatementError(f"“{phrase}” is no vector", instead="name a force, a velocity, an acceleration.")
        return found

    @property
    def forces_known(self) -> set[str]:
        """Names of all forces that act on bodies."""
        return {force.name for force in self.study.system.forces}

    def expression(self, text: str) -> Bound:
        """The value of a formula in the names of the problem. Raises StatementError."""
        names = self.names
        try:
            return number(substitute(scalar(read_infix(text, names), self.study.system.scope), self.dependent))
        except RbpsymError:
            if self.answers is not None and (found := self.answers(self.study, text)):
                return found
            hint = did_you_mean(text, [*names, *self.offered], "")
            known = f"write a name ({', '.join(names)}), an expression, or a phrase of docs/ask.md such as “{self.offered[-1]}”."
            what = f"“{text}” means nothing in the problem “{self.study.problem.name}”"
            raise StatementError(what, instead=hint if hint.startswith("did you mean") else known) from None

    @kept
    def offered(self) -> list[str]:
        """The phrases that are offered to who writes something else, with the names of this problem."""
        return self.filled(reversed(EXAMPLES))

    def filled(self, examples: Iterable[str]) -> list[str]:
        """The examples with each name of this problem in its place."""
        system = self.study.system
        forces = list(dict.fromkeys(force.name for force in system.forces))
        points = [f"{body.name}.{point}" for body in self.study.problem.bodies for point in (*body.points, "cm")]
        known = {"BODY.cm": points, "BODY": list(system.bodies), "FORCE": forces, "VALUE": ["0"]}
        known |= {"COORDINATE": list(system.independent)}
        known |= {"PHASE": [phase.name for phase in self.study.problem.phases], "CONTACT": list(system.unknowns)}
        found = list(examples)
        for slot, names in known.items():
            found = [text.replace(slot, name) for text in found for name in (names if slot in text else [""])]
        return found

    @kept
    def names(self) -> list[str]:
        """What an expression may hold."""
        problem, system = self.study.problem, self.study.system
        moving = [c.name for c in problem.coordinates]
        return [
            *(q.name for q in problem.parameters),
            *moving,
            *(f"{n}_dot" for n in moving),
            *(f"{n}_ddot" for n in moving),
            *system.unknowns,
            *(["t"] if system.has_clock else []),
        ]

    @kept
    def symbols(self) -> dict[str, str]:
        """The names as the problem's notation prints them, and as they are printed without it."""
        known = self.names
        drawn = {to_latex(Sym(name), notation_for(known, self.study.problem.notation)): name for name in known}
        return {to_latex(Sym(name), notation_for(known)): name for name in known} | drawn

    @kept
    def dimensions(self) -> dict[str, Dimension]:
        """The dimensions of all names that values hold."""
        return {"t": TIME, **dimensions_with_unknowns(self.study.problem)}

    def body(self, name: str) -> BodyState:
        """A body. Raises StatementError for an unknown name."""
        bodies = self.study.system.bodies
        if name not in bodies:
            raise StatementError(f"there is no body “{name}”", instead=did_you_mean(name, bodies, "bodies"))
        return bodies[name]

    def bodies(self, name: str) -> list[BodyState]:
        """A body, several (“rod and disk”), or all bodies of the system."""
        if name in SYSTEM and name not in self.study.system.bodies:
            return list(self.study.system.bodies.values())
        return [self.body(part) for part in name.split(" and ")]

    @kept
    def turned(self) -> dict[str, Scalar]:
        """By which angles bodies are turned at the moment that is looked at, in letters that do not change with it."""
        return {f"{name}_now": state.pose.angle for name, state in self.study.system.bodies.items()}

    def place(self, name: str | None, of: str = "") -> Vector:
        """The position of a point: O, a named point, body.point (or point alone, `of` a body), body.cm, body(1/3): so far on the
        way from its start to its end, or body.top of a round one: what is there on its rim now. Raises StatementError."""
        return self.held(name, of).substitute(self.turned)

    def held(self, name: str | None, of: str = "") -> Vector:
        """The same as a point of its body, which moves with that while the letters of `turned` stay."""
        problem, system = self.study.problem, self.study.system
        if of in system.bodies and name is not None and name not in (*problem.points, *system.bodies) and "." not in name:
            name = name if name.endswith(")") else f"{of}.{name}"
        if name is not None and name.endswith(")"):
            body, _, part = name[:-1].partition("(")
            first, last = (self.held(f"{body}.{end}") for end in ("start", "end"))
            return first + (last - first) * scalar(read_infix(part, self.names))
        if name is None:
            return ORIGIN
        if name in problem.points:
            return pair(problem.points[name])
        if (held := _held_point(problem, name)) is not None:
            name = held.label
        body, _, point = (name if "." in name else f"{name}.cm").partition(".")
        if body in SYSTEM and body not in system.bodies and point == "cm":
            return self.centre(body)
        state = self.body(body)
        known, radius = [*problem.body(body).points, "cm"], round_size(problem.body(body))
        if point in RIM and point not in known and radius is not None:
            turned = state.pose.angle - symbol(f"{body}_now")
            return self.held(f"{body}.center") + polar(scalar(radius), QUARTER * RIM.index(point) + turned)
        if point not in known:
            raise StatementError(f"“{body}” has no point “{point}”", instead=did_you_mean(point, known, "its points"))
        return position(
            PointRef(name, body, point),
            {b.name: b for b in problem.bodies},
            {n: s.inertia for n, s in system.bodies.items()},
            {state.name: state.pose},
        )

    def centre(self, name: str) -> Vector:
        """The centre of mass of a body, of several, or of all."""
        states = self.bodies(name)
        mass = sum((state.mass for state in states), NOTHING)
        return sum((state.center * (state.mass / mass) for state in states), ORIGIN)

    def forces(self, names: str, on: str) -> list[Force]:
        """The forces of these names on a body, several or the system; "net" means all, "external" those from outside."""
        states = {state.name for state in self.bodies(on)}
        here = [force for force in self.study.system.forces if force.on in states]
        if names in ("net", "external"):
            return [force for force in here if names == "net" or force.by not in states]
        known = {force.name for force in here}
        each = re.split(r",\s*|\s+and\s+", names)
        wanted = [one for name in each for one in ([name] if name in known else of_role(self, name, known) or [name])]
        for name in wanted:
            if name not in known:
                raise StatementError(f"no force “{name}” acts on {on}", instead=did_you_mean(name, known, "forces"))
        return [force for force in here if force.name in wanted]


RIM = ("right", "top", "left", "bottom")  # by quarters of a turn, whatever has been turned there


def _held_point(problem: Problem, name: str) -> PointRef | None:
    """The point of a body that a constraint of that name holds, if no body is called so."""
    found = next((element.values.get("point") for element in problem.constraints if element.name == name), None)
    return found if isinstance(found, PointRef) and found.body and name not in problem.body_names else None
