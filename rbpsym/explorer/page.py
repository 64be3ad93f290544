"""The page of the explorer: one or two problems as data and JavaScript, with shell, style and words in one HTML file."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import asdict
from itertools import chain
from pathlib import Path
from typing import Any

from markupsafe import Markup

from rbpsym.document.files import data_folder
from rbpsym.document.phrases import phrases, plain
from rbpsym.document.words import Words
from rbpsym.document.writers.html import font
from rbpsym.document.writers.page import shell
from rbpsym.errors import NoNumber, NotApplicable, StatementError
from rbpsym.explorer.events import force_labels, label, strikes
from rbpsym.explorer.loose import loose
from rbpsym.explorer.sliders import DEGREE, Slider, sliders, unit_of
from rbpsym.explorer.stage import LAST, Began, PhaseEnding, StagePhase, phase
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.field import Scalar
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.arrivals import of_coordinate
from rbpsym.mechanics.endings import gap
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.phases import Stage, stages
from rbpsym.mechanics.study import Study
from rbpsym.pictures.figures.outlines import OUTLINES
from rbpsym.pictures.figures.scene import COLORS
from rbpsym.quantities import NUMBER, TIME
from rbpsym.statement.curves import is_slot
from rbpsym.statement.model import Element, Problem

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
    parts, partial = problem_stages(problem)
    study = parts[0].study
    if any(part.study.at_start for part in parts):
        raise StatementError(
            f"the motion of “{problem.name}” can't be followed: it is known at its start alone",
            instead="its speeds, accelerations and forces there are in `rbpsym solve` and in notes.",
        )
    numbers = sliders(study)
    names = tuple(slider.name for slider in numbers)
    _require_start(study, {slider.name: slider.value for slider in numbers})
    phases = tuple(_phase(problem, parts, k, names, notation) for k in range(len(parts)))
    data = {
        "name": problem.name,
        "title": said.title(problem.title) or problem.name,
        "numbers": [_number(slider, notation, said) for slider in numbers],
        "coordinates": {c.name: _coordinate(c, notation, said) for c in problem.coordinates},
        "unknowns": {name: label(t.Sym(name), notation) for part in parts for name in part.study.system.unknowns},
        "forces": {
            k: v for part in reversed(parts) for k, v in force_labels(part.study.system, notation, said).items()
        },
        "bodies": {name: said.body(name) for name in problem.body_names},
        "origins": {name: label(t.Sym(name), notation) for name in study.origins},
        "phases": [
            {**found.data, "name": said.named(part.name) if k else ""}
            for k, (part, found) in enumerate(zip(parts, phases, strict=True))
        ],
    }
    ends = (parts[0], *parts[1:][-1:])
    free = tuple(loose(part.study, names, _ground(parts)) for part in ends)
    alt = plain("explorer.picture", language, parts=_bodies(study, said))
    return Model(data, phases, alt, partial, free if None not in free else ())


def _bodies(study: Study, said: Words) -> list[str]:
    return [said.body(name) for name in study.problem.body_names]


def _require_start(study: Study, numbers: dict[str, float]) -> None:
    """Raises StatementError if the numbers of the example give no start."""
    for name, value in study.system.scope.start.items():
        try:
            found = number(value, numbers)
        except NoNumber:
            found = math.nan
        if not math.isfinite(found):
            raise StatementError(
                f"with the numbers of the example there is no start: “{name}” has no value",
                instead="give other numbers under [example].",
            )


def problem_stages(problem: Problem) -> tuple[tuple[Stage, ...], bool]:
    """All phases of a problem; the first alone, and True, where the next has no closed form."""
    try:
        return stages(problem), False
    except NotApplicable:
        return (Stage(problem.name, Study(problem)),), True


def _phase(problem: Problem, parts: tuple[Stage, ...], k: int, names: tuple[str, ...], notation: Notation) -> StagePhase:
    """A phase with what strikes at its start, and what ends it."""

    def struck(put: Callable[[Scalar], int]) -> dict[str, Any] | None:
        return strikes(parts[k], problem.phases[k - 1], put, notation) if k else None

    return phase(parts[k].study, names, _ending(problem, parts, k), Began(struck, _ground(parts)))


def _ground(parts: tuple[Stage, ...]) -> tuple[Element, ...]:
    """The fixed lines that are touched in some phase: the floor is there also when nothing stands on it."""
    struck = (e for part in parts[1:] for e in part.began.phase.impulses)
    found = chain((e for part in parts for e in part.study.problem.constraints), struck)
    return tuple(
        e for e in found if e.values.get("line") is not None and e.values.get("of") is None and not is_slot(e)
    )


def _ending(problem: Problem, parts: tuple[Stage, ...], k: int) -> PhaseEnding:
    """The moment at which a phase ends, if it is known, and the event that is no surprise then."""
    if k + 1 == len(parts):
        return LAST
    ending = problem.phases[k]
    goal = None
    if ending.event in ("reaches", "rests"):
        place, speed = of_coordinate(parts[k].study, ending.subject)
        goal = ending.subject, speed if ending.event == "rests" else place - scalar(ending.value)
    if ending.event == "begins":
        goal = ending.subject, gap(ending.gap, geometry_of(parts[k].study.system))
    names_of = tuple((kind, ending.subject) for kind in KINDS.get(ending.event, ()))
    return PhaseEnding(parts[k + 1].began.before.time, names_of, goal)


# event that begins a phase -> events of the explorer that end the phase before
KINDS = {"lost": ("lost", "slack"), "slips": ("slips",), "no slip": ("holds",), "reaches": ("reaches",), "rests": ("reaches",),
         "begins": ("reaches",)}  # fmt: skip


def _number(slider: Slider, notation: Notation, said: Words) -> dict[str, Any]:
    found = asdict(slider) | {"symbol": None, "meaning": said.meaning(slider.name, slider.meaning)}
    return {k: v for k, v in found.items() if v is not None} | label(slider.symbol, notation)


def _coordinate(coordinate, notation: Notation, said: Words) -> dict[str, Any]:
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
    words = _words(language)
    return shell(
        "explorer.html",
        autoescape=True,
        language=language,
        words=words,
        title=" · ".join(found.data["title"] for found in models),
        style=Markup((data_folder("templates") / "explorer.css").read_text(encoding="utf-8")),
        colors=Markup(_colors()),
        font=Markup(font()),
        models=[_shown(k, found) for k, found in enumerate(models)],
        script=Markup(_script(models, words)),
    )


def _shown(place: int, found: Model) -> dict[str, object]:
    """What the shell says of a model."""
    return {"place": place, "title": found.data["title"], "partial": found.is_first_phase_only, "alt": found.alt}


def _words(language: str) -> dict[str, str]:
    """The phrases of the explorer, with places {…} that the script fills."""
    return {
        key.removeprefix("explorer."): text for key, text in phrases(language).items() if key.startswith("explorer.")
    }


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
