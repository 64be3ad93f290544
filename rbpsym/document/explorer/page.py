"""The page of the explorer: shell, style, script, words and one or two models in one HTML file."""

from __future__ import annotations

from pathlib import Path

from markupsafe import Markup

from rbpsym.document.explorer.model import Model, as_json, model
from rbpsym.document.figures.scene import COLORS
from rbpsym.document.phrases import phrases
from rbpsym.document.resources import data_folder
from rbpsym.document.writers.html import font
from rbpsym.document.writers.page import shell
from rbpsym.statement.model import Problem

SCRIPTS = ("numbers", "motion", "shapes", "drawing", "readings", "controls")
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
    data = f"const WORDS={as_json(words)};\nconst MODELS=[{','.join(found.script for found in models)}];"
    parts = [(FOLDER / f"{name}.js").read_text(encoding="utf-8") for name in SCRIPTS]
    return "\n".join(['(function(){"use strict";', data, *parts, "})();"])
