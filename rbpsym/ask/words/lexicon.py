"""What the bodies, points, forces, coordinates and letters of a problem may be called, each phrase with all that it may mean."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from itertools import permutations

from rbpsym.ask.asked import struck_phases
from rbpsym.ask.named import ELEMENTS, KINDS, PARAMETERS, SHAPES, SIDES, SURFACES, joined, may_be
from rbpsym.ask.named import PLAIN as TOO_PLAIN
from rbpsym.expr import tree as t
from rbpsym.quantities import LENGTH, MASS, NUMBER, TIME, Dimension
from rbpsym.quantity.bound import without_articles
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Element, Line, PointRef, Problem
from rbpsym.statement.paths import tensions

Phrases = Mapping[tuple[str, ...], tuple[str, ...]]
SHAPE_WORDS = tuple(SHAPES.split("|"))
RESTING = ("pivot", "pin", "weld", "clamp")  # what holds a point both ways
TOUCHING = ("contact", "touch", "rolling", "sticking")  # what pushes along a normal
DRAWN = ("spring", "torsion-spring", "string")
PULLING = ("string", "link", "pull")
# what holds or pushes: the words for it, and the kinds of elements that these may mean
ROLES: Mapping[str, tuple[str, tuple[str, ...]]] = {
    "normal force":
        ("normal force|normal reaction|normal|contact force|support force|normal reaction force|load|wheel load|axle load",
         TOUCHING),
    "tension": ("tension|tensile force|pull|tension force", PULLING),
    "friction":
        ("friction|friction force|frictional force|force of friction|static friction|force of static friction", TOUCHING),
    "force":
        ("reaction|reaction force|support reaction|force|pivot reaction|pivot force|axle force|axle reaction|joint force|"
         "joint reaction|tangential force|pin force|hinge force|bearing force|bearing reaction|hinge reaction|tooth force",
         (*RESTING, *TOUCHING, *PULLING, "spring", "torsion-spring", "damper", "rotary-damper", "gear", "slider", "guide")),
}  # fmt: skip
CURVED = "circle|hoop|loop|dome|bowl|sphere|cylinder|hill|peg|corner|edge|incline|slope|wire|step|ramp"
OF_LETTERS = (
    "angle", "speed", "velocity", "force", "couple", "torque", "mass", "length", "distance", "height", "coefficient",
    "power", "radius", "pull", "push", "weight", "spring stiffness", "angle of incline", "moment",
    "acceleration", "angular velocity", "angular speed", "stiffness", "spring constant", "load", "time",
)  # fmt: skip
OF_DIMENSION: Mapping[Dimension, tuple[str, ...]] = {
    MASS * LENGTH / TIME**2: ("force", "pull", "push", "horizontal force", "applied force"),
    MASS * LENGTH**2 / TIME**2: ("couple", "torque", "moment"),
    LENGTH / TIME: ("speed", "velocity", "initial speed", "initial velocity", "launch speed", "speed of projection"),
    LENGTH / TIME**2: ("acceleration", "deceleration"),
    MASS / TIME**2: ("stiffness", "spring constant", "spring stiffness"),
    NUMBER / TIME: ("initial angular velocity", "initial spin", "angular velocity", "angular speed"),
}
SLOPES = (
    "angle",
    "slope",
    "inclination",
    "incline",
    "angle of incline",
    "angle of slope",
    "angle of inclination",
    "angle of plane",
    "steepness",
)
FEET = ("axle", "axles", "end", "foot", "wheel", "wheels", "edge", "corner", "roller", "support", "leg", "hinge", "pad")
GUIDES = "slot|groove|guide|wire|rail|tube|track"  # what leads a point
GROUND = "ground|floor|table|tabletop|road|track|surface|plane|support|rail|rails|belt"


RANKED = ("first", "second", "third", "upper", "lower", "left", "right", "inner", "outer", "front", "rear", "small", "large")


class Lexicon:
    """The phrases of a problem, by the name under which a grammar reads them."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        stages = (problem, *(phase.problem for phase in problem.phases))
        later = (e for stage in stages[1:] for e in (*stage.constraints, *stage.interactions) if e.kind in DRAWN)
        first = (*problem.constraints, *problem.interactions)
        self.elements = [*{e.name: e for e in (*later, *first)}.values()]  # what draws may begin to act in a later phase
        self.blows = [(phase.name, e) for phase in problem.phases for e in phase.impulses]
        struck = struck_phases(problem)
        self.struck = problem.phases[struck[0] - 1].name if len(struck) == 1 else ""  # the phase that the only blow begins
        self.it = ""  # whom “it” means in the question that is read
        self.of: dict[str, dict[tuple[str, ...], list[str]]] = defaultdict(lambda: defaultdict(list))
        for add in (self._bodies, self._coordinates, self._letters, self._points, self._held, self._phases):
            add()
        for phrase, names in [*self.of["Several"].items()]:
            for one, other in permutations(names) if len(names) == 2 else ():
                self.of["Pair"][phrase].append(f"{one} to {other}")

    def _add(self, kind: str, phrase: str, name: str) -> None:
        words = tuple(phrase.replace("-", " ").split()) if " " in phrase else (phrase,)
        if name not in (known := self.of[kind][words]):
            known.append(name)

    def _bodies(self) -> None:
        titled = {word.removesuffix("s") for word in re.findall(r"[a-z]{3,}s\b", self.problem.title.get("en", "").lower())}
        masses = [body.mass.name for body in self.problem.bodies if isinstance(body.mass, t.Sym)]
        for body in self.problem.bodies:
            own = {body.name, body.name.replace("-", " "), body.name.replace("_", " ")}
            own |= {body.name.capitalize()} if len(body.name) > 2 else set()
            meaning = without_articles(body.meaning)
            own |= {meaning} if meaning and meaning not in TOO_PLAIN else set()
            kinds = [word for words, shapes in KINDS.items() if body.shape.kind in shapes for word in words.split("|")]
            lone = [word for words, shapes in KINDS.items() for word in words.split("|")
                    if body.shape.kind in shapes and sum(b.shape.kind in shapes for b in self.problem.bodies) == 1]  # fmt: skip
            if len(self.problem.bodies) == 1:
                lone += ["body", "object", "mass", *(word for word in SHAPE_WORDS if word in kinds)]
            mass = body.mass.name if isinstance(body.mass, t.Sym) and masses.count(body.mass.name) == 1 else ""
            if mass:
                own |= {mass, f"mass {mass}", *(f"{word} {mass}" for word in kinds), *self._meant(mass, "mass of ")}
            for name in own:
                self._add("Body", name, body.name)
            for word in (word for word in SHAPE_WORDS if may_be(body, word)):
                self._add("Body", f"{body.name} {word}", body.name)
                self._add("Body", f"{word} {body.name}", body.name)
            shaped = [word for word in SHAPE_WORDS if may_be(body, word)]
            for word in (
                *(f"each {word}" for word in (*shaped, body.name, "body", "mass")),
                "weights",
                *(f"{word}s" for word in shaped),
            ):
                if len(self.problem.bodies) > 1:
                    self._add("Each", word, body.name)
            for word in (
                "bodies",
                "masses",
                "two bodies",
                *(f"{two}{word}s" for word in (*kinds, body.name) for two in ("", "two ")),
            ):
                if len(self.problem.bodies) > 1:
                    self._add("Each", word, body.name)
            for word in lone:
                if word not in self.problem.body_names:
                    self._add("Body", word, body.name)
            for noun in titled if body.name in RANKED else ():  # of “Two pucks on a string” the one that is called “second”
                self._add("Body", f"{body.name} {noun}", body.name)

    def _meant(self, letter: str, before: str) -> Iterator[str]:
        meaning = next((q.meaning for q in self.problem.parameters if q.name == letter), "")
        if meaning.startswith(before):
            of = without_articles(meaning.removeprefix(before).removeprefix("the "))
            yield from [of] if of and not of.startswith("of ") else []

    def _coordinates(self) -> None:
        for coordinate in self.problem.coordinates:
            name, meaning = coordinate.name, without_articles(coordinate.quantity.meaning)
            nouns = ("angle", "position", "coordinate", "distance", "displacement", "height", "length")
            own = [meaning] if meaning and meaning not in TOO_PLAIN else []
            for phrase in (name, *(f"{noun} {name}" for noun in nouns), *own):
                self._add("Coord", phrase, name)
        self._add("Coord", "t", "t")

    def _letters(self) -> None:
        for q in self.problem.parameters:
            meaning = without_articles(q.meaning)
            own = [] if meaning in ("", *TOO_PLAIN) else [meaning]
            for phrase in (q.name, *(f"{noun} {q.name}" for noun in OF_LETTERS), *own):
                self._add("Par", phrase, q.name)
        stated = (*self.elements, *(e for _, e in self.blows))
        for words, keys in PARAMETERS.items():
            values = {v.name for e in stated for key in keys if isinstance(v := e.values.get(key), t.Sym)}
            if words.startswith("coefficient"):
                values = {v for v in values if self.problem.dimensions.get(v) == NUMBER}
            for phrase in {words.replace("(?:kinetic|sliding)", kind) for kind in ("kinetic", "sliding")}:
                for value in sorted(values):
                    self._add("Par", phrase, value)

        for value in {v.name for e in stated if "damper" in e.kind and isinstance(v := e.values.get("coefficient"), t.Sym)}:
            for phrase in ("damping", "damping coefficient", "damping constant", "coefficient of damping"):
                self._add("Par", phrase, value)
        free = [q for q in self.problem.parameters if q.name != "g"]
        for dimension, nouns in OF_DIMENSION.items():  # “the force” by the only letter that is one
            names = [q.name for q in free if q.dimension == dimension]
            for noun in nouns if len(names) == 1 else ():
                self._add("Chosen" if "speed" in noun or "velocity" in noun or "spin" in noun else "Par", noun, names[0])
        lines = [line for e in self.elements if isinstance(line := e.values.get("line"), Line)]
        leaning = {name for line in lines for name in {*t.names(line.a), *t.names(line.b)} & {q.name for q in free}}
        for noun in SLOPES if len(leaning) == 1 else ():
            self._add("Chosen" if noun == "angle" else "Par", noun, next(iter(leaning)))

    def _points(self) -> None:
        counted: dict[str, list[str]] = defaultdict(list)
        for body in self.problem.bodies:
            for point in (*body.points, "cm"):
                full = f"{body.name}.{point}"
                self._add("Point", full, full)
                for name in self.called("Body", body.name):
                    self._add("Point", f"{point} of {name}", full)
                counted[point].append(full)
            centre = f"{body.name}.{'center' if 'center' in body.points else 'cm'}"
            for name in self.called("Body", body.name):
                for word in ("centre", "center", "middle", "midpoint"):
                    self._add("Point", f"{word} of {name}", centre)
                for word in ("centre of mass", "center of mass", "centre of gravity", "center of gravity"):
                    self._add("Point", f"{word} of {name}", f"{body.name}.cm")
            if len(self.problem.bodies) == 1:
                for word, point in (("centre", centre), ("center", centre), ("centre of mass", f"{body.name}.cm"),
                                    ("center of mass", f"{body.name}.cm"), ("mass centre", f"{body.name}.cm")):  # fmt: skip
                    self._add("Point", word, point)
        for point, places in counted.items():
            if len(places) == 1 and point not in ("cm", "start", "end", "center"):
                self._add("Point", point, places[0])
                for noun in ("point", "end", "corner"):
                    self._add("Point", f"{noun} {point}", places[0])
        for name in ("O", *self.problem.points):
            self._add("Point", name, name)
            self._add("Point", f"point {name}", name)
        for e in self.elements:
            if e.kind in RESTING and isinstance(at := e.values.get("at") or e.values.get("center"), PointRef):
                for word in ("pivot", "hinge", "axle", "axis", "pin", "bearing"):
                    self._add("Point", word, at.label)

    def called(self, kind: str, name: str) -> list[str]:
        """The phrases for what has a name."""
        return [" ".join(words) for words, names in self.of[kind].items() if name in names]

    def _held(self) -> None:
        for e in self.elements:
            self._add("Element", e.name, e.name)
            for name in unknowns_of(e) if e in self.problem.constraints else ():
                self._add("Force", name, name)
            self._add("Force", e.name, e.name)
            self._add("Force", f"force {e.name}", e.name)
            for words, kinds in ELEMENTS.items():
                if e.kind in kinds:
                    for word in words.split("|"):
                        for phrase in (word, f"{word} {e.name}", f"{e.name} {word}"):
                            self._add("Element", phrase, e.name)
                        for other in joined(e):
                            for phrase in (f"{other} {word}", f"{word} at {other}", f"{word} on {other}", f"{word} of {other}"):
                                self._add("Element", phrase, e.name)
            size = next((v.name for v in e.values.values() if isinstance(v, t.Sym) and e in self.problem.interactions), None)
            if size and e.kind in ("force", "couple", "pull"):
                self._add("Force", size, e.name)
            for word in self.grounds(e):
                self._add("Contact", word, e.name)
            for word in (
                ("tensions",) if e.kind == "string" else ("normal forces", "normal reactions") if e.kind in TOUCHING else ()
            ):
                for name in tensions(e) if e.kind == "string" else (f"normal force {e.name}",):
                    self._add("Several", word, name)
            for word in GUIDES.split("|") if e.kind in ("slider", "guide") else ():
                self._add("Element", word, e.name)
            for other in joined(e) & {*self.problem.body_names} if e.kind in TOUCHING else ():
                for phrase in self.called("Body", other):
                    self._add("Contact", phrase, e.name)
            for other in joined(e) - {*self.problem.body_names}:
                for phrase in (other, f"point {other}", *self.called("Point", other)):
                    self._add("Contact", phrase, e.name)
            for part in e.values.values():
                if isinstance(part, PointRef) and part.body:
                    for phrase in (*self.called("Point", f"{part.body}.{part.point}"), *([part.point] if part.point else [])):
                        self._add("Contact", phrase, e.name)
                    for side in {*(part.point or "").split("_")} & {*SIDES}:
                        for noun in FEET:
                            self._add("Contact", f"{side} {noun}", e.name)

    def grounds(self, e: Element) -> Iterator[str]:
        """The words for what a body touches that does not move."""
        line = e.values.get("line")
        if isinstance(line, Line) and not e.values.get("of"):
            yield from (word for words, fits in SURFACES.items() if fits(line) for word in words.split("|"))
            yield from ["horizontal", "edge", "corner", "step", "peg", *GROUND.split("|")]
        elif e.kind in TOUCHING and not e.values.get("of"):
            yield from (*GROUND.split("|"), *CURVED.split("|"))

    def _phases(self) -> None:
        for phase in self.problem.phases:
            kind = "Blow" if phase.impulses else "Begin"
            stem = re.sub(r"(?<=\w{3})(?:ed|ing|e?s|e)$", "", phase.name.split("-")[0])
            for form in ("", "e", "s", "es", "ed", "ing"):  # the parachute “opens”, “has opened”: the phase “opened”
                self._add("Begun", stem + form, phase.name)
            for phrase in (phase.name, phase.name.replace("-", " "), f"phase {phase.name}"):
                self._add(kind, phrase, phase.name)
                self._add("Phase", phrase, phase.name)
        for _, e in self.blows:
            struck = (phrase for body in joined(e) & {*self.problem.body_names} for phrase in self.called("Body", body))
            for word in (e.name, *self.grounds(e), *struck):
                self._add("Struck", word, e.name)

    def knows(self, word: str) -> bool:
        """Whether a word begins a phrase of the problem."""
        return any(phrase[0] == word for known in self.of.values() for phrase in known)

    def finders(self, kinds: Iterable[str]) -> dict[str, Phrases]:
        """The phrases by kind, each a tuple of words."""
        return {kind: {words: tuple(names) for words, names in self.of[kind].items()} for kind in kinds}
