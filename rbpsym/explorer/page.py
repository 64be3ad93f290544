"""The page of the explorer: one or two problems as data and JavaScript, with shell, style and words in one HTML file."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict
from itertools import chain
from pathlib import Path
from typing import Any

from markupsafe import Markup

from rbpsym.document.files import data_folder
from rbpsym.document.phrases import plain
from rbpsym.document.words import Words
from rbpsym.document.writers.html import font
from rbpsym.document.writers.page import shell
from rbpsym.elements.events import EVENTS
from rbpsym.errors import StatementError
from rbpsym.explorer.events import force_labels, label, strikes
from rbpsym.explorer.stage import LAST, Began, PhaseEnding, StagePhase, loose, phase, start_name
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import Scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.languages import part_of
from rbpsym.mechanics.endings import LAWS
from rbpsym.mechanics.numbers import angles, bound, floating, sample
from rbpsym.mechanics.phases import Stage, followable, known_stages
from rbpsym.mechanics.pushing import begun_numbers
from rbpsym.mechanics.study import Study
from rbpsym.pictures.figures.outlines import OUTLINES
from rbpsym.pictures.figures.scene import COLORS
from rbpsym.quantities import ENERGY, NUMBER, TIME, Dimension, Quantity
from rbpsym.statement import units
from rbpsym.statement.curves import is_slot
from rbpsym.statement.model import Coordinate, Element, Problem
from rbpsym.statement.units import unit_text

# --- a problem as the explorer has it: data for JSON, and the functions of its phases as JavaScript


class Model(Frozen):
    """A problem in the explorer; `is_first_phase_only` if its later phases have no closed form."""

    data: dict[str, Any]
    phases: tuple[StagePhase, ...]
    alt: str = ""
    is_first_phase_only: bool = False
    loose: tuple[StagePhase, ...] = ()

    @property
    def script(self) -> str:
        """The model as a JavaScript expression."""
        loose = ",".join(f"{{data:{as_json(part.data)},code:{_functions(part)}}}" for part in self.loose)
        return f"{{data:{as_json(self.data)},code:[{','.join(map(_functions, self.phases))}],loose:[{loose}]}}"


def _functions(part: StagePhase) -> str:
    return f"{{{','.join(f'{json.dumps(name)}:{text}' for name, text in part.code.items())}}}"


def as_json(value: Any) -> str:
    """JSON that may stand in a script element."""
    return json.dumps(value, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")


def model(problem: Problem, language: str) -> Model:
    """The model of a problem, with all its phases where these have a closed form."""
    said = Words(language, problem)
    notation = said.notation
    parts, unknown = known_stages(problem)
    study = parts[0].study
    if any(part.study.at_start for part in parts):
        what = f"the motion of “{problem.name}” can't be followed: it is known at its start alone"
        raise StatementError(what, instead="its speeds, accelerations and forces there are in `rbpsym solve` and in notes.")
    numbers = sliders(study, parts)
    names = tuple(slider.name for slider in numbers)
    _require_start(study, {slider.name: slider.value for slider in numbers})
    phases = tuple(_phase(problem, parts, k, names, notation) for k in range(len(parts)))
    data = {
        "name": problem.name,
        "weighs": not problem.unstated,
        "title": said.title(problem.title) or problem.name,
        "numbers": [_number(slider, notation, said) for slider in numbers],
        "coordinates": {c.name: _coordinate(c, notation, said) for c in problem.coordinates},
        "unknowns": {name: label(t.Sym(name), notation) for part in parts for name in part.study.system.unknowns},
        "forces": {k: v for part in parts[::-1] for k, v in force_labels(part.study.system, notation, said).items()},
        "bodies": {name: said.body(name) for name in problem.body_names},
        "origins": {name: label(t.Sym(name), notation) for name in study.origins},
        "phases": [{**one.data, "name": said.named(parts[k].name) if k else ""} for k, one in enumerate(phases)],
    }
    ends = (parts[0], *parts[1:][-1:])
    free = () if problem.unstated else tuple(filter(None, (loose(part.study, names, _ground(parts)) for part in ends)))
    alt = plain("explorer.picture", language, parts=list(map(said.body, problem.body_names)))
    return Model(data, phases, alt, unknown is not None, free if len(free) == len(ends) else ())


def _require_start(study: Study, numbers: dict[str, float]) -> None:
    """Raises StatementError if the numbers of the example give no start."""
    for name, value in study.system.scope.start.items():
        if not math.isfinite(floating(value, numbers)):
            what = f"with the numbers of the example there is no start: “{name}” has no value"
            raise StatementError(what, instead="give other numbers under [example].")


def _phase(problem: Problem, parts: tuple[Stage, ...], k: int, names: tuple[str, ...], notation: Notation) -> StagePhase:
    """A phase with what strikes at its start, and what ends it."""

    def struck(put: Callable[[Scalar], int]) -> dict[str, Any] | None:
        return strikes(parts[k], problem.phases[k - 1], put, notation) if k else None

    return phase(parts[k].study, names, _ending(problem, parts, k), Began(struck, _ground(parts)))


def _ground(parts: tuple[Stage, ...]) -> tuple[Element, ...]:
    """The fixed lines that are touched in some phase: the floor is there also when nothing stands on it."""
    struck = (e for part in parts if part.began for e in part.began.phase.impulses)
    found = chain((e for part in parts for e in part.study.problem.constraints), struck)
    return tuple(e for e in found if e.values.get("line") is not None and e.values.get("of") is None and not is_slot(e))


def _ending(problem: Problem, parts: tuple[Stage, ...], k: int) -> PhaseEnding:
    """The moment at which a phase ends, if it is known, and the event that is no surprise then."""
    if k + 1 == len(parts):
        return LAST
    ending, began = problem.phases[k], parts[k + 1].began
    shown, gap = EVENTS[ending.event].shown, LAWS[ending.event].gap
    goal = (ending.subject, gap(parts[k].study, ending)) if gap is not None and "reaches" in shown else None
    return PhaseEnding(began.before.time if began else None, tuple((kind, ending.subject) for kind in shown), goal)


def _number(slider: Slider, notation: Notation, said: Words) -> dict[str, Any]:
    found = asdict(slider) | {"symbol": None, "meaning": said.meaning(slider.name, slider.meaning)}
    return {k: v for k, v in found.items() if v is not None} | label(slider.symbol, notation)


def _coordinate(coordinate: Coordinate, notation: Notation, said: Words) -> dict[str, Any]:
    """Letters and units of a coordinate, its speed and its acceleration."""
    name, dimension = coordinate.name, coordinate.quantity.dimension
    angle = dimension == NUMBER
    return {
        "here": label(t.Sym(name), notation),
        "speed": label(t.Sym(f"{name}_dot"), notation),
        "gain": label(t.Sym(f"{name}_ddot"), notation),
        "meaning": said.meaning(name, coordinate.quantity.meaning),
        "unit": "°" if angle else unit_of(dimension),
        "size": DEGREE if angle else 1.0,
        "speedUnit": unit_of(dimension / TIME),
        "gainUnit": unit_of(dimension / TIME / TIME),
    }


# ---


SCRIPTS = ("numbers", "motion", "loose", "shapes", "drawing", "readings", "curves", "layers", "moments",
           "predicting", "sound", "releasing", "controls")  # fmt: skip
FOLDER = Path(__file__).with_name("script")


def explorer(problems: tuple[Problem, ...], language: str = "en") -> str:
    """The explorer of one problem, or of two side by side, as an HTML file.

    Raises StatementError for a statement that does not determine the motion or needs a function
    that browsers do not have.
    """
    models = tuple(model(problem, language) for problem in problems)
    words = part_of("explorer", language)
    return shell(
        "explorer.html",
        autoescape=True,
        language=language,
        words=words,
        title=" · ".join(found.data["title"] for found in models),
        style=Markup((data_folder("templates") / "explorer.css").read_text(encoding="utf-8")),
        colors=Markup(_colors()),
        font=Markup(font()),
        models=models,
        script=Markup(_script(models, words)),
    )


def _colors() -> str:
    """The colours of the figures as variables, light and dark."""
    light, dark = (";".join(f"--{name}:{pair[k]}" for name, pair in COLORS.items()) for k in (0, 1))
    return f":root{{{light}}}@media (prefers-color-scheme:dark){{:root{{{dark}}}}}"


def _script(models: tuple[Model, ...], words: dict[str, str]) -> str:
    """All scripts, the words and the models, closed off from the page."""
    shared = f"const WORDS={as_json(words)},OUTLINES={as_json(OUTLINES)};"
    data = f"{shared}\nconst MODELS=[{','.join(found.script for found in models)}];"
    parts = [(FOLDER / f"{name}.js").read_text(encoding="utf-8") for name in SCRIPTS]
    return "\n".join(['(function(){"use strict";', data, *parts, "})();"])


# --- the numbers that a reader may change: where they begin, how far they go, their units


DEGREE = math.pi / 180


class Slider(Frozen):
    """An adjustable number in SI units (angles in radians); shown it is value / `unit_size` `unit`."""

    name: str
    symbol: t.Node
    meaning: str
    value: float
    least: float
    most: float
    unit: str = ""
    unit_size: float = 1.0


def unit_of(dimension: Dimension) -> str:
    """The SI unit of a dimension as it is shown; that of an energy is that of a torque too."""
    return unit_text(units.unit_of(dimension, "torque" if dimension == ENERGY else ""))


def sliders(study: Study, parts: tuple[Stage, ...]) -> tuple[Slider, ...]:
    """Parameters, constants of the start, and starts that the author left open; the example's numbers to begin with, without
    one such that the motion comes to all phases."""
    problem = study.problem
    numbers = sample(problem, problem.example) if problem.example else begun_numbers(study, followable(parts), far=True)
    starts = {c.start.name: c for c in problem.coordinates if isinstance(c.start, t.Sym) and c.start.name in problem.implicit}
    turned = angles(problem)
    given = ((q, starts.get(q.name)) for q in problem.parameters)
    found = (_start(q.name, start, numbers) if start else _parameter(q, numbers, turned) for q, start in given)
    return (*found, *_open_starts(study, numbers))


def _parameter(quantity: Quantity, numbers: Mapping[str, float], turned: frozenset[str]) -> Slider:
    value, symbol = numbers[quantity.name], t.Sym(quantity.name)
    if quantity.dimension == NUMBER and quantity.name in turned:
        least, most = (-1.4, 1.4) if quantity.sign == "real" else (0.02, max(1.4, 1.1 * value))
        return Slider(quantity.name, symbol, quantity.meaning, value, least, most, "°", DEGREE)
    least, most = _around(value, quantity.sign)
    return Slider(quantity.name, symbol, quantity.meaning, value, least, most, unit_of(quantity.dimension))


def _around(value: float, sign: str) -> tuple[float, float]:
    """From a fifth to three times a positive number; both signs where both are allowed."""
    if sign in ("positive", "nonnegative") and value > 0:
        return (0.0 if sign == "nonnegative" else value / 5), 3 * value
    size = 3 * abs(value) or 1.0
    return (0.0 if sign == "nonnegative" else -size), size


def _start(name: str, coordinate: Coordinate, numbers: Mapping[str, float]) -> Slider:
    """A start inside the range of its coordinate."""
    quantity, value = coordinate.quantity, numbers[name]
    least, most = _room(coordinate, value, numbers)
    unit, size = ("°", DEGREE) if quantity.dimension == NUMBER else (unit_of(quantity.dimension), 1.0)
    return Slider(name, t.Sym(name), quantity.meaning, value, least, most, unit, size)


def _room(coordinate: Coordinate, value: float, numbers: Mapping[str, float]) -> tuple[float, float]:
    """The range of a coordinate without its ends; a guess where it has none."""
    wide = math.pi if coordinate.quantity.dimension == NUMBER else 3 * abs(value) or 1.0
    low, high = (bound(node, numbers) for node in (coordinate.lower, coordinate.upper))
    low = min(value, -wide) if low is None else low
    high = max(value, wide, low + 2 * wide if coordinate.lower else wide) if high is None else high
    edge = 0.01 * (high - low)
    return min(value, low + edge), max(value, high - edge)


def _open_starts(study: Study, numbers: Mapping[str, float]) -> Iterator[Slider]:
    """Coordinates of which the author does not say where they start."""
    for coordinate in study.problem.coordinates:
        if coordinate.name in study.system.independent and coordinate.start is None:
            own = {**numbers, start_name(coordinate.name): numbers[coordinate.name]}
            found = _start(start_name(coordinate.name), coordinate, own)
            at = t.At(t.Sym(coordinate.name), t.equation(t.Sym("t"), t.ZERO))
            yield replace(found, symbol=at)
