"""`rbpsym notes`: lecture notes of a problem or a course, in one or several formats."""

from __future__ import annotations

from pathlib import Path

import click

from rbpsym.commands.arguments import Listed, detail_option, name_argument, output_option

FORMATS = ("pdf", "html", "tex", "beamer", "ipynb", "md", "docx", "typ")
ENGINES = ("typst", "pdflatex")


@click.command("notes")
@name_argument
@click.option(
    "--format",
    "formats",
    type=Listed(FORMATS),
    default="pdf,html,tex",
    show_default=True,
    help="Formats, separated by commas: " + ", ".join(FORMATS) + ".",
)
@click.option("--engine", type=click.Choice(ENGINES), default="typst", show_default=True, help="What makes the PDF.")
@click.option("--lang", metavar="LANGUAGE", default="en", show_default=True, help="Language of the notes.")
@detail_option
@click.option("--simulation/--no-simulation", default=True, show_default=True, help="Run the numerical oracle too.")
@output_option(".", "Folder of the files.")
def command(
    name: str, formats: tuple[str, ...], engine: str, lang: str, detail: str, simulation: bool, output: Path
) -> int:
    """Write lecture notes of a problem or a course: every step derived, with its reason.

    \b
    Examples:
      rbpsym notes paper
      rbpsym notes sliding-ladder --format pdf -o build
      rbpsym notes my-problem.toml --format tex,html --detail full
      rbpsym notes paper --engine pdflatex
      rbpsym notes sliding-ladder --format beamer,ipynb,docx

    The files are called as the problem or course, slides NAME-slides; the drawings of Markdown lie
    beside it. All of them are written whole or not at all. Word needs pip install 'rbpsym[docx]'.
    """
    from rbpsym.commands.shelf import found

    kind, path = found(name)
    document, fine = {"course": _course, "problem": _problem}[kind](path, lang, detail, simulation)
    for file in _written(document, path.stem, formats, engine, output):
        click.echo(str(file))
    return 0 if fine else 1


def _problem(path: Path, lang: str, detail: str, simulation: bool):
    """The document of a problem, and whether all of it is proved."""
    from rbpsym.commands.progress import Progress
    from rbpsym.commands.solve import exit_code
    from rbpsym.derive import derive
    from rbpsym.document.notes import notes
    from rbpsym.statement.loader import load_problem

    with Progress(f"deriving {path.stem}"):
        derivation = derive(load_problem(path), simulation=simulation)
        return notes(derivation, lang, detail), exit_code(derivation.summary()) == 0


def _course(path: Path, lang: str, detail: str, simulation: bool):
    """The document of a course, and whether all of it is proved."""
    from rbpsym.commands.progress import Progress
    from rbpsym.commands.solve import exit_code
    from rbpsym.courses import derive_course
    from rbpsym.document.notes import course_notes
    from rbpsym.statement.course import load_course

    course = load_course(path)
    with Progress(f"deriving {path.stem}", len(course.parts)) as progress:
        derived = derive_course(course, simulation=simulation, progress=progress.step)
        document = course_notes(derived, lang, detail)
    steps = [step for lesson in derived.lessons.values() for step in lesson.steps]
    fine = all(step.certificate.verdict.is_proved for step in steps)
    return document, fine and all(exit_code(d.summary()) == 0 for d in derived.derivations.values())


def _written(document, stem: str, formats: tuple[str, ...], engine: str, output: Path) -> list[Path]:
    """All formats are made before the first file is written."""
    from rbpsym.document.files import write_all
    from rbpsym.document.writers import files

    made = {name: content for f in formats for name, content in files(document, f, stem, engine).items()}
    return write_all(output, made)
