"""A new constraint is one folder and its phrases: CONTRIBUTING names the files, and this adds one by them alone."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from rbpsym.decide.verdict import PROVED
from rbpsym.derive import derive
from rbpsym.document.notes import notes
from rbpsym.document.writers import writer
from rbpsym.elements import constraints
from rbpsym.elements.kinds import in_folders
from rbpsym.languages import phrases
from rbpsym.statement.loader import load_text

FILES = {
    "__init__.py": '''
"""A point between two level rails."""

from rbpsym.elements.kinds import element
from rbpsym.statement.curves import NORMAL
from rbpsym.statement.rules import on_a_body

KIND = element(
    __name__,
    "a point runs between two level rails, which keep it at a height; their force is vertical",
    unknowns=NORMAL,
    rules=(on_a_body("point"),),
    point="point: the point that is kept",
    height="length = 0: how high it is kept",
)
''',
    "law.py": '''
"""The vertical force of the rails."""

from rbpsym.field import EY, ORIGIN, Scalar, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.constraints import Joint
from rbpsym.mechanics.geometry import Geometry
from rbpsym.mechanics.system import Force, opposed
from rbpsym.statement.model import Element


def _force(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    ref = element["point"]
    ends = ((ref.body, geometry.where(ref), ref.label), (None, ORIGIN, ""))
    return opposed(element.name, ends, EY * symbol(element.name), unknowns=(element.name,))


def _gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    return ((geometry.where(element["point"]).y - scalar(element["height"]), "height"),)


JOINT = Joint(_force, gaps=_gaps)
''',
    "row.py": '''
"""The height of the point."""

from rbpsym.oracles.simulation_bodies import Mechanism, State
from rbpsym.oracles.simulation_joints import Kept, component, difference
from rbpsym.statement.model import Element, PointRef


def rows(element: Element, mechanism: Mechanism, start: State) -> list[Kept]:
    """The force on the point is the multiplier."""
    rail = PointRef("", at=(element["height"], element["height"]))
    ends = (component(mechanism.spot(ref), 0.0, 1.0) for ref in (rail, element["point"]))
    return [Kept(element.name, element.name, difference(*ends))]
''',
}
PHRASES = {
    "en": "{point} is kept at the height {height} by level rails, which exert the unknown force {force}.",
    "es": "{point} se mantiene a la altura {height} entre carriles horizontales, que ejercen la fuerza desconocida {force}.",
}
PROBLEM = """
[parameters]
m = "mass: mass of the rod"
ell = "length: length of the rod"
h = "length: height of the rails"
g = "acceleration: gravity"

[coordinates.x]
meaning = "how far its end has gone"
dimension = "length"
start = "0"
speed = "0"

[coordinates.theta]
meaning = "angle of the rod from the downward vertical"
start = "theta_0"
speed = "0"

[bodies.rod]
shape = "rod"
mass = "m"
length = "ell"
start = ["x", "h"]
angle = "theta - pi/2"

[interactions.W]
type = "gravity"

[constraints.N]
type = "level"
point = "rod.start"
height = "h"
"""


@pytest.fixture
def level(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The folder `level` among those of the constraints, and its phrases."""
    folder = tmp_path / "level"
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
    monkeypatch.setattr(constraints, "__path__", [*constraints.__path__, str(tmp_path)])
    importlib.invalidate_caches()
    kinds = in_folders(constraints.__name__, constraints.__path__)
    for registry in (constraints.CONSTRAINTS, importlib.import_module("rbpsym.statement.slots").ALL):
        monkeypatch.setitem(registry, "level", kinds["level"])  # what a new process finds by itself
    for language, text in PHRASES.items():
        monkeypatch.setitem(phrases(language), "statement.level", text)
    yield
    for name in [name for name in sys.modules if name.startswith("rbpsym.elements.constraints.level")]:
        del sys.modules[name]


def test_a_new_constraint_is_one_folder_and_its_phrases(level: None) -> None:
    """Each step is proved, the methods agree, both oracles agree with them, and it is told in both languages."""
    derivation = derive(load_text(PROBLEM))
    summary = derivation.summary()
    assert not [(s.id, s.certificate) for s in derivation.steps if s.certificate.verdict.kind is not PROVED]
    assert summary["lagrange"] == "PROVED" and summary["methods_agree"]
    assert summary["simulation"]["max_relative_error"] <= 1e-8
    for language, words in (("en", "by level rails"), ("es", "carriles horizontales")):
        assert words in writer("md")(notes(derivation, language=language))


def test_contributing_names_the_files() -> None:
    text = (Path(__file__).parents[2] / "CONTRIBUTING.md").read_text(encoding="utf-8")
    part = text[text.index("## A kind") :]
    assert all(f"`{name}`" in part[: part.index("\n## ", 5)] for name in FILES)
