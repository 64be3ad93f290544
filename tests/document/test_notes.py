"""Notes of all shipped problems and of the course: complete, clean, and equal to what was proved."""

import re

import pytest

from rbpsym.courses import derive_course
from rbpsym.derive import derive
from rbpsym.document.model import Display, Math
from rbpsym.document.notes import course_notes, notes, shown_steps
from rbpsym.document.numbering import parts
from rbpsym.document.writers import writer
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files, problem_files
from rbpsym.statement.loader import load_problem, load_text

_DERIVED = {}


def derived(name):
    if name not in _DERIVED:
        _DERIVED[name] = derive(load_problem(problem_files()[name]), simulation=False)
    return _DERIVED[name]


by_problem = pytest.mark.parametrize("name", sorted(problem_files()))


@by_problem
@pytest.mark.parametrize("detail", ["brief", "standard", "full"])
def test_every_shown_step_is_in_the_document(name, detail):
    derivation = derived(name)
    document = notes(derivation, "en", detail)
    nodes = [part.node for part in parts(document) if isinstance(part, (Display, Math))]
    for step in derivation.steps:
        if step.id in shown_steps(derivation, detail) and step.chapter not in ("forces", "work"):
            assert step.statement in nodes, step.id


@by_problem
@pytest.mark.parametrize("ending", ["tex", "html", "typ", "md"])
def test_every_format_is_written(name, ending):
    text = writer(ending)(notes(derived(name)))
    assert len(text) > 5000
    assert "{" not in re.sub(r"<style.*?</style>", "", text, flags=re.S) if ending == "html" else True


def test_the_course_is_one_document_with_all_parts():
    course = load_course(course_files()["paper"])
    found = derive_course(course, simulation=False)
    document = course_notes(found)
    assert len([s for s in document.sections if s.level == 1]) == len(course.parts)
    displays = [part for part in parts(document) if isinstance(part, Display)]
    assert len(displays) > 100
    assert all(len(writer(ending)(document)) > 20_000 for ending in ("tex", "html"))


UNSEEN = """
title = "Torsion pendulum"
[parameters]
M = "mass: mass"
R = "length: radius"
kappa = "torsion stiffness: wire"
[coordinates.phi]
meaning = "angle"
start = "phi_0"
[bodies.disk]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "phi"
[interactions.T]
type = "torsion-spring"
between = ["ground", "disk"]
stiffness = "kappa"
[constraints.P]
type = "pivot"
point = "disk.center"
"""


@pytest.mark.parametrize("ending", ["tex", "html", "pdf"])
def test_an_unseen_problem_has_notes(ending):
    assert writer(ending)(notes(derive(load_text(UNSEEN), simulation=False)))
