"""The commands as a user calls them: output, exit codes, sentences."""

import json
import subprocess
import sys

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.commands.solve import verdict_line
from rbpsym.statement.library import course_files, problem_files


def run(*args):
    return CliRunner().invoke(main, list(args), catch_exceptions=False)


def process(*args):
    return subprocess.run([sys.executable, "-m", "rbpsym", *args], capture_output=True, text=True, check=False)


def test_list_names_everything_that_ships():
    text = run("list").stdout
    assert all(name in text for name in [*problem_files(), *course_files()])
    found = json.loads(run("list", "--json").stdout)
    assert {p["name"] for p in found["problems"]} == set(problem_files())


def test_list_can_be_searched():
    found = json.loads(run("list", "--json", "--lang", "es", "PENDULOS", "introductorio").stdout)
    assert {"rod-pendulum", "kater-pendulum"} <= {p["name"] for p in found["problems"]}
    assert {(p["topic"], p["level"]) for p in found["problems"]} == {("péndulos físicos", "introductorio")}
    none = run("list", "perpetual", "motion")
    assert none.exit_code == 2 and "“perpetual” and “motion”" in none.stderr


SOLVES = ("solve", "sliding-ladder", "--json", "--no-simulation")


@pytest.mark.parametrize("args", [("--help",), ("list",), ("solve", "--help"), ("notes", "--help"), SOLVES])
def test_help_list_and_solving_are_light(args):
    code = (
        "import sys; sys.argv = ['rbpsym', *sys.argv[1:]]\n"
        "from rbpsym.cli import main\n"
        "try:\n    main()\nexcept SystemExit as end:\n    assert not end.code, end.code\n"
        "heavy = {'sympy', 'numpy', 'scipy', 'jinja2', 'rich', 'typst'} & set(sys.modules)\n"
        "assert not heavy, heavy\n"
    )
    done = subprocess.run([sys.executable, "-c", code, *args], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_solve_json_is_the_contract():
    done = process(*SOLVES)
    assert done.returncode == 0, done.stderr
    answer = json.loads(done.stdout)
    assert answer["accelerations"]["theta"] == "-3*g/(4*ell)*cos(theta)"
    assert answer["verdicts"]["simulation"] is None


def test_solve_in_short_and_with_simulation():
    done = process("solve", "sliding-ladder")
    assert done.returncode == 0
    assert "steps proved" in done.stdout and "simulation agrees" in done.stdout


@pytest.mark.parametrize("method", ["all", "torque", "newton-euler", "work-energy", "energy"])
@pytest.mark.parametrize("detail", ["brief", "standard", "full"])
def test_derive_shows_proved_steps(method, detail):
    done = run("derive", "rod-and-disk-free", "--method", method, "--detail", detail)
    assert done.exit_code == 0
    assert "✓" in done.output and "✗" not in done.output


def test_notes_are_written_whole(tmp_path):
    done = process("notes", "sliding-ladder", "--format", "html,tex,md", "--no-simulation", "-o", str(tmp_path / "new"))
    assert done.returncode == 0, done.stderr
    endings = (".html", ".tex", ".md", *(f"-figure-{k}.svg" for k in range(1, 3)))
    assert {p.name for p in (tmp_path / "new").iterdir()} == {f"sliding-ladder{e}" for e in endings}


BROKEN = 'title = "x"\n[parameters]\nM = "mass: m"\n[bodies.rod]\nshape = "rood"\n'


@pytest.mark.parametrize("command", [("solve",), ("derive",), ("notes", "-o", "out")])
def test_a_broken_file_gets_a_sentence_and_exit_2(command, tmp_path):
    file = tmp_path / "broken.toml"
    file.write_text(BROKEN)
    done = subprocess.run(
        [sys.executable, "-m", "rbpsym", command[0], str(file), *command[1:]],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert "broken.toml:5" in done.stderr and "rod" in done.stderr and "Traceback" not in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["broken.toml"]


def test_an_unknown_name_is_met_with_the_nearest():
    done = run("solve", "sliding-lader")
    assert done.exit_code == 2 and "sliding-ladder" in done.stderr


def test_an_unknown_command_and_option():
    assert run("solv", "x").exit_code == 2
    assert run("solve", "sliding-ladder", "--nonsense").exit_code == 2


def test_new_writes_a_problem_that_works(tmp_path):
    done = run("new", "my-problem", "-o", str(tmp_path))
    assert done.exit_code == 0, done.stderr
    assert run("solve", str(tmp_path / "my-problem.toml"), "--json", "--no-simulation").exit_code == 0
    assert run("new", "my-problem", "-o", str(tmp_path)).exit_code == 2


def test_an_error_of_the_statement_exits_2(tmp_path):
    extra = '\n[constraints.extra]\ntype = "contact"\npoint = "ladder.start"\nline = "y = 0"\n'
    text = problem_files()["sliding-ladder"].read_text() + extra
    file = tmp_path / "twice.toml"
    file.write_text(text)
    done = process("solve", str(file), "--json")
    assert done.returncode == 2 and "N_f" in done.stderr and "extra" in done.stderr


@pytest.mark.parametrize("methods", [{}, {"torque": "PROVED"}])
def test_methods_agree_where_there_are_two(methods: dict[str, str]) -> None:
    """One method agrees with nothing; that two do not is said however many there are."""
    told = {"steps": 9, "proved": 9, "methods": methods, "methods_agree": True, "lagrange": "PROVED", "simulation": None}
    assert "methods" not in verdict_line({**told, "left_out": []})
    assert "methods agree" in verdict_line({**told, "left_out": [], "methods": {"torque": "PROVED", "energy": "PROVED"}})
    assert "METHODS DISAGREE" in verdict_line({**told, "left_out": [], "methods_agree": False})
