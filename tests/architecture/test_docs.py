"""The pages of docs/ say what the code says, every kind has an example that works, the README is true."""

from __future__ import annotations

import importlib.util
import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.derive import derive
from rbpsym.elements.events import STATED
from rbpsym.elements.impulses import IMPULSES
from rbpsym.solve import solve
from rbpsym.statement import CONSTRAINTS, INTERACTIONS, SHAPES, load_problem, load_text
from tests.architecture.source import ROOT
from tests.library.derived import derived_from, stated

DOCS = ROOT / "docs"
README = (ROOT / "README.md").read_text(encoding="utf-8")
KINDS = {"shapes": SHAPES, "interactions": INTERACTIONS, "constraints": CONSTRAINTS}
EXAMPLES = [DOCS / "examples" / section / f"{name}.toml" for section, kinds in KINDS.items() for name in kinds]
PHASES = [DOCS / "examples" / "events" / f"{name.replace(' ', '-')}.toml" for name in STATED]
PHASES += [DOCS / "examples" / "impulses" / f"{name}.toml" for name in IMPULSES]


def build():
    spec = importlib.util.spec_from_file_location("docs_build", DOCS / "build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", build().PAGES)
def test_pages_are_up_to_date(name: str) -> None:
    assert (DOCS / name).read_text(encoding="utf-8") == build().PAGES[name](), "run make docs"


def test_no_example_is_left_over() -> None:
    assert sorted([*EXAMPLES, *PHASES]) == sorted((DOCS / "examples").rglob("*.toml"))


@pytest.mark.parametrize("path", PHASES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_examples_of_phases_are_derived(path: Path) -> None:
    """The example of an event or an impulse has it, every step is proved, and the simulation sees it come."""
    problem = stated(path)
    [phase] = problem.phases
    assert path.stem in {phase.event.replace(" ", "-"), *(impulse.kind for impulse in phase.impulses)}
    summary = derived_from(path).summary()
    assert (summary["refuted"], summary["undecided"], summary["lagrange"]) == (0, 0, "PROVED")
    assert summary["simulation"]["max_relative_error"] <= 1e-8


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_examples_are_derived(path: Path) -> None:
    """The example of a kind is of that kind, its motion is determined, and every step is proved."""
    problem = stated(path)
    kinds = {body.shape.kind for body in problem.bodies} | {e.kind for e in problem.interactions + problem.constraints}
    kinds |= {"link" for e in problem.constraints if e.values.get("rigid")}  # read as a string that may push
    assert path.stem in kinds
    assert derived_from(path).study.dynamics.accelerations is not None
    summary = derived_from(path).summary()
    assert (summary["refuted"], summary["undecided"], summary["lagrange"]) == (0, 0, "PROVED")
    assert summary["methods_agree"], summary


def test_the_tutorial_is_a_problem_that_is_derived() -> None:
    pieces = re.findall(r"```toml\n(.*?)```", (DOCS / "statement.intro.md").read_text(encoding="utf-8"), re.S)
    summary = derive(load_text("\n".join(pieces)), simulation=False).summary()
    assert summary["proved"] == summary["steps"] > 20 and summary["methods_agree"]


PLACE = ("at", "stable", "stable_where_positive", "valid_where", "frequencies_squared")


def test_the_page_of_the_answer_tells_every_key() -> None:
    answer = solve(load_problem(EXAMPLES[-1].parent / "contact.toml"), simulation=False)
    page = (DOCS / "solve.intro.md").read_text(encoding="utf-8")
    for key in [*answer, *answer["verdicts"], *answer["conditions"][0], *PLACE]:
        assert f"`{key}`" in page, key


# --- README


def blocks(language: str, text: str = README) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.S | re.M)


def test_readme_opens_with_two_commands() -> None:
    first = blocks("sh")[0].splitlines()
    assert [line.split("#")[0].strip() for line in first] == ["make notes", "make test"]
    assert README.index("make notes") < 300


@pytest.mark.parametrize("code", blocks("python"))
def test_readme_python_runs_and_says_so(code: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each line with a comment like `# 'text'` has that text as its value."""
    monkeypatch.chdir(ROOT)
    space: dict[str, object] = {}
    exec(compile("\n".join(line for line in code.splitlines() if "  # " not in line), "README.md", "exec"), space)
    for line in code.splitlines():
        expression, found, told = line.partition("  # ")
        if found:
            assert told.strip("' ") in str(eval(expression, space)), line


@pytest.mark.parametrize("text", blocks("toml"))
def test_readme_problem_is_derived(text: str) -> None:
    assert derive(load_text(text), simulation=False).summary()["methods_agree"]


def told() -> list[tuple[str, str]]:
    """(command, output) of the console blocks, where an output is shown."""
    shown = [*blocks("console"), *blocks("console", (DOCS / "tutorial.md").read_text(encoding="utf-8"))]
    pieces = [piece for block in shown for piece in re.split(r"^\$ ", block, flags=re.M) if piece]
    pairs = [piece.partition("\n") for piece in pieces]
    return [(command.split("  #")[0], output) for command, _, output in pairs if output.strip()]


@pytest.mark.parametrize(("command", "output"), told(), ids=lambda text: text.split("\n")[0][:40])
def test_readme_outputs_are_real(command: str, output: str) -> None:
    """What follows a command is its output; `...` stands for lines that are left out."""
    program, *arguments = shlex.split(command)
    assert program == "rbpsym"
    real = CliRunner().invoke(main, arguments, env={"COLUMNS": "100"}).output
    place = 0
    for part in output.split("...\n"):
        place = real.find(part.strip("\n"), place)
        assert place >= 0, f"{command} does not print:\n{part}\nbut:\n{real}"


def test_links_lead_somewhere() -> None:
    for page in [ROOT / "README.md", ROOT / "ARCHITECTURE.md", ROOT / "CONTRIBUTING.md", *DOCS.glob("*.md")]:
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"


def test_what_proved_means_says_so() -> None:
    """The example of the page on verdicts gives what it says."""
    from rbpsym import derive, load_problem

    page = (DOCS / "proved.md").read_text(encoding="utf-8")
    step = derive(load_problem("sliding-ladder"), simulation=False).step("theorem.T.ladder")
    assert f"step.premises  # {step.premises}" in page


# --- the site


def test_every_page_is_in_the_site() -> None:
    pages = {page.stem for page in DOCS.glob("*.md") if not page.name.endswith(".intro.md")} - {"index"}
    listed = re.findall(r"^([\w/-]+)$", (DOCS / "index.md").read_text(encoding="utf-8"), re.M)
    assert sorted(listed) == sorted(pages | {"gallery/index"})


def commands_in(page: Path) -> list[str]:
    """The command lines of a page, those that go on in the next line joined."""
    text = page.read_text(encoding="utf-8")
    shown = re.findall(r"^```(?:sh|console)\n(.*?)^```", text, re.S | re.M)
    lines = [line for block in shown for line in block.replace("\\\n", " ").splitlines()]
    return [line.removeprefix("$ ") for line in lines if re.match(r"(\$ )?rbpsym ", line)]


@pytest.mark.parametrize("page", [ROOT / "README.md", *sorted(DOCS.glob("*.md"))], ids=lambda page: page.name)
def test_options_in_pages_exist(page: Path) -> None:
    for line in commands_in(page):
        _, name, *words = shlex.split(line, comments=True)
        command = main.get_command(None, name)
        assert command is not None, line
        known = {option for param in command.params for option in (*param.opts, *param.secondary_opts)} | {"--help"}
        assert {word.split("=")[0] for word in words if word.startswith("-")} <= known, line


def test_the_ten_minutes_are_true(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each file of the tutorial is written under the name that the text before it says, each command after it runs."""
    monkeypatch.chdir(tmp_path)
    text = (DOCS / "tutorial.md").read_text(encoding="utf-8")
    for said, content in re.findall(r"`([\w-]+\.toml)`[^`]*?:\n\n```toml\n(.*?)```", text, re.S):
        (tmp_path / said).write_text(content, encoding="utf-8")
    lines = commands_in(DOCS / "tutorial.md")
    assert len(lines) >= 6
    for line in lines:
        found = CliRunner().invoke(main, shlex.split(line)[1:], env={"COLUMNS": "100"})
        assert found.exit_code == 0, (line, found.output)
