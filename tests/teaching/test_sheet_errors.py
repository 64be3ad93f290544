"""Worksheet files with errors: each gets a sentence that says what, where, and what instead."""

from __future__ import annotations

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.teaching.model import Student
from rbpsym.teaching.plan import plan_of
from rbpsym.teaching.sheet import sheet_of_text
from tests.teaching.test_worksheet import GOOD


def instead(old: str, new: str) -> str:
    """The good worksheet with a mistake."""
    assert old in GOOD
    return GOOD.replace(old, new)


KIND, POINTS = 'kind = "number"', "points = 2.5"
RANGE = 'M = { from = "5 kg", to = "6 kg", step = "0.5 kg" }'

# what stands in the file, a part of the sentence, the line
BROKEN: dict[str, tuple[str, str, int]] = {
    "nothing": ("", "has no “problem”", 1),
    "no TOML": ("title = \n", "not a value", 1),
    "a key twice": (instead('title = "Mine"', 'title = "Mine"\ntitle = "y"'), "there already", 3),
    "problem as a text": ('title = "x"\nproblem = "sliding-ladder"\n', "one or more tables", 2),
    "problem with one bracket": ('[problem]\nname = "sliding-ladder"\n', "one or more tables", 1),
    "an empty list of problems": ('title = "x"\nproblem = []\n', "one or more tables", 2),
    "no task": (GOOD.split("[[problem.task]]")[0], "has no “task”", 3),
    "task with one bracket": (instead("[[problem.task]]", "[problem.task]"), "one or more tables", 9),
    "a number for a title": (instead('title = "Mine"', "title = 3"), "must be a text", 2),
    "a title in no language of ours": (instead('title = "Mine"', 'title = { fr = "Moi" }'), "unknown key “fr”", 2),
    "a list for an introduction": (instead('title = "Mine"', 'title = "x"\nintroduction = ["a"]'), "must be a text", 3),
    "a language that is not there": (instead('title = "Mine"', 'title = "x"\nlanguage = "fr"'), "no worksheets in “fr”", 3),
    "a number for a language": (instead('title = "Mine"', 'title = "x"\nlanguage = 5'), "text in quotes", 3),
    "name and file": (instead('name = "sliding-ladder"', 'name = "sliding-ladder"\nfile = "x.toml"'), "one of both", 3),
    "a file that is not there": (instead('name = "sliding-ladder"', 'file = "x.toml"'), "no such file", 4),
    "a course": (instead('name = "sliding-ladder"', 'name = "paper"'), "no problem", 4),
    "numbers with two brackets": (instead("[problem.numbers]", "[[problem.numbers]]"), "one table", 5),
    "a number without quotes": (instead('theta_0 = "60 deg"', "theta_0 = 60"), "a number with its unit", 7),
    "a number without a unit": (instead('theta_0 = "60 deg"', 'ell = "60"'), "needs a unit", 7),
    "a negative mass": (instead('from = "5 kg"', 'from = "-5 kg"'), "“M” must be positive", 6),
    "no mass": (instead(RANGE, 'M = "0 kg"'), "“M” must be positive", 6),
    "an angle out of its range": (instead('theta_0 = "60 deg"', 'theta_0 = "120 deg"'), "not 120° in this problem", 7),
    "a place that is not reached": (instead('theta = "45 deg"', 'theta = "80 deg"'), "would not be reached", 5),
    "no digits": (instead('"0.5 kg" }', '"0.5 kg", digits = 0 }'), "from 1 to 6", 6),
    "digits in quotes": (instead('"0.5 kg" }', '"0.5 kg", digits = "3" }'), "from 1 to 6", 6),
    "too few digits for the step": (instead('"0.5 kg" }', '"0.05 kg", digits = 1 }'), "do not tell", 6),
    "no step": (instead(', step = "0.5 kg" }', " }"), "has no “step”", 6),
    "two units": (instead('to = "6 kg"', 'to = "6000 g"'), "same unit", 6),
    "a step that never ends": (instead('step = "0.5 kg"', 'step = "1e-20 kg"'), "more than 100000", 6),
    "a number beyond all bounds": (instead('to = "6 kg"', 'to = "1e400 kg"'), "is no number", 6),
    "not a number": (instead('"5 kg"', '"nan kg"'), "is no number", 6),
    "a list of kinds": (instead(KIND, 'kind = ["number"]'), "text in quotes", 10),
    "no kind": (instead(KIND + "\n", ""), "has no “kind”", 9),
    "a number to be asked about": (instead('about = "speed.theta"', "about = 4"), "a text or a list", 11),
    "nothing to be asked about": (instead('about = "speed.theta"', "about = []"), "a text or a list", 11),
    "what the problem has not": (instead('"speed.theta"', '"frequency.*"'), "no quantity", 10),
    "points in words": (instead(POINTS, 'points = "two"'), "a number above 0", 12),
    "points that are no number": (instead(POINTS, "points = nan"), "a number above 0", 12),
    "points without end": (instead(POINTS, "points = inf"), "a number above 0", 12),
    "points true": (instead(POINTS, "points = true"), "a number above 0", 12),
    "no tasks": (instead(POINTS, "number = 0"), "from 1 to 40", 12),
    "a level in words": (instead(POINTS, 'level = "easy"'), "“level” must be", 12),
    "a level beyond": (instead(POINTS, "level = [0, 4]"), "“level” must be", 12),
    "an unknown key": (instead(POINTS, "point = 2"), "unknown key “point”", 12),
    "options for a number": (instead(POINTS, "options = 4"), "has no meaning for number", 12),
    "misconceptions for a number": (instead(POINTS, 'misconceptions = ["torque-sign"]'), "has no meaning for number", 12),
    "too few wrong answers": (
        instead(KIND, 'kind = "choose"\noptions = 6').replace("speed.theta", "work.T.W.ladder"), "only 1 wrong", 10,
    ),
    "a step that is not there": (
        instead(KIND, 'kind = "explain"').replace("speed.theta", "workless.X"), "no step “workless.X”", 10,
    ),
    "a misconception that has no place": (
        instead(KIND, 'kind = "find-the-slip"\nmisconceptions = ["tension-is-weight"]'), "no misconception", 10,
    ),
    "what can't be compared": (instead(KIND, 'kind = "compare"').replace("speed.theta", "work.*"), "can be compared", 10),
    "signs of a motion that is not known": (
        '[[problem]]\nname = "bicycle-wheelie"\n[[problem.task]]\nkind = "signs"\n', "not known along the motion", 4,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_worksheet_gets_a_sentence(name: str) -> None:
    text, says, line = BROKEN[name]
    with pytest.raises(RbpsymError) as caught:
        plan_of(sheet_of_text(text)).worksheet(Student("a"))
    error = caught.value
    assert says in error.what and error.place is not None and error.place.line == line, (error.what, error.place)
    assert error.instead or "text in quotes" in error.what
    assert "\n" not in error.what and len(error.what) < 250


def test_a_list_of_levels_makes_a_task_of_each() -> None:
    fading = instead(KIND, 'kind = "fill-in"\nlevel = [0, 1, 2, 3]').replace('about = "speed.theta"', 'about = "*"')
    found = plan_of(sheet_of_text(fading)).worksheet().items
    assert [item.level for item in found] == [0, 1, 2, 3]
    assert len({item.asked.quantity for item in found}) == 4
    assert len(found[0].key.blanks) <= 2 < len(found[2].key.blanks)


def test_numbers_are_drawn_as_they_are_printed() -> None:
    long = instead('theta_0 = "60 deg"', 'theta_0 = "60.25 deg"')
    [given] = {str(plan_of(sheet_of_text(long)).worksheet(Student(str(k))).parts[0].given["theta_0"]) for k in range(3)}
    assert "241, 4" in given and "digits=4" in given
