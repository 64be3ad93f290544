"""A new event is one folder and its phrases: CONTRIBUTING names the files, and this adds one by them alone."""

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
from rbpsym.elements import events
from rbpsym.elements.kinds import in_folders
from rbpsym.languages import phrases
from rbpsym.statement.loader import load_text

FILES = {
    "__init__.py": '''
"""A coordinate has gone a way."""

from rbpsym.elements.kinds import event

KIND = event(__name__, "the coordinate “of” has gone the way “at”", of="coordinate", at="value", moment="value", place="value")
''',
    "law.py": '''
"""When a coordinate has gone a way."""

from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import endings
from rbpsym.mechanics.arrivals import at_start, of_coordinate


def _ends(study, phase):
    start, gain = at_start(study), endings.gain_of(study, phase, phase.subject)
    way = scalar(phase.value)
    return endings.after(study, phase, start, *endings.time_until(study, phase, way, start.speeds[phase.subject], gain))


def _gap(study, phase):
    return of_coordinate(study, phase.subject)[0] - at_start(study).places[phase.subject] - scalar(phase.value)


LAW = endings.EventLaw(_ends, _gap)
''',
    "check.py": '''
"""What is left of the way."""

from rbpsym.field.evaluate import scalar
from rbpsym.proof.checks.courses import EventCheck, course_of
from rbpsym.proof.checks.places import own_place


def _then(context, phase):
    place = own_place(context, phase.subject)
    return course_of(context, place)[0] - context.start(place) - scalar(phase.value)


CHECK = EventCheck(_then)
''',
    "row.py": '''
"""What is left of the way."""


def watch(bench, phase, start):
    placement = bench.placement
    place, near = placement.names.index(phase.subject), [start.q]
    goal = float(start.q[place]) + placement.mechanism.number(phase.value)

    def ahead(time, where, speed):
        near[0] = placement.coordinates(where.tolist(), near[0])
        return float(near[0][place]) - goal

    return ahead
''',
}
PHRASES = {
    "en": "The phase {phase} begins when {coordinate} has gone the way {value}.",
    "es": "La fase {phase} empieza cuando {coordinate} ha recorrido el camino {value}.",
}
PROBLEM = """
[parameters]
m = "mass: mass of the block"
F = "force: force that pushes it"
v = "speed: speed at the start"
a = "length: place at the start"
d = "length: way"

[coordinates.x]
meaning = "place of the block"
dimension = "length"
start = "a"
speed = "v"

[bodies.block]
shape = "particle"
mass = "m"
center = ["x", "0"]

[interactions.P]
type = "force"
on = "block.cm"
force = ["F", "0"]

[constraints.N]
type = "guide"
point = "block.cm"
line = "y = 0"

[[phases]]
name = "free"
event = "gone"
of = "x"
at = "d"
without = ["P"]
"""


@pytest.fixture
def gone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The folder `gone` among those of the events, and its phrases."""
    folder = tmp_path / "gone"
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
    monkeypatch.setattr(events, "__path__", [*events.__path__, str(tmp_path)])
    importlib.invalidate_caches()
    for registry in (events.EVENTS, events.STATED):  # what a new process finds by itself
        monkeypatch.setitem(registry, "gone", in_folders(events.__name__, events.__path__)["gone"])
    for language, text in PHRASES.items():
        monkeypatch.setitem(phrases(language), "statement.event.gone", text)
    yield
    for name in [name for name in sys.modules if name.startswith("rbpsym.elements.events.gone")]:
        del sys.modules[name]


def test_a_new_event_is_one_folder_and_its_phrases(gone: None) -> None:
    """Each step is proved, the simulation sees it come, and it is told in both languages."""
    derivation = derive(load_text(PROBLEM))
    steps = [step for part in (derivation, *(phase.derivation for phase in derivation.phases)) for step in part.steps]
    steps += [step for phase in derivation.phases for step in phase.begins]
    assert not [(s.id, s.certificate) for s in steps if s.certificate.verdict.kind is not PROVED]
    assert any(step.rule == "event_time" for step in steps)
    assert derivation.summary()["simulation"]["max_relative_error"] <= 1e-8
    for language, words in (("en", "has gone the way"), ("es", "ha recorrido el camino")):
        assert words in writer("md")(notes(derivation, language=language))


def test_contributing_names_the_files() -> None:
    text = (Path(__file__).parents[2] / "CONTRIBUTING.md").read_text(encoding="utf-8")
    part = text[text.index("## An event") :]
    assert all(f"`{name}`" in part[: part.index("\n## ", 5)] for name in FILES)
