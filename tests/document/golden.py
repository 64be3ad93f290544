"""The LaTeX of the notes of the paper's problems, kept in tests/golden so that every change of a page is seen.

`python -m tests.document.golden` writes it anew; read the difference before you commit it.
"""

from pathlib import Path

from rbpsym.document.notes import notes
from rbpsym.document.writers import writer
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from tests.library.derived import unsimulated

FOLDER = Path(__file__).parents[1] / "golden"
NAMES = tuple(part.name for part in load_course(course_files()["paper"]).parts if part.kind == "problem")


def body(name: str) -> str:
    """What stands between \\begin{document} and \\end{document}."""
    text = writer("tex")(notes(unsimulated(name)))
    return text.partition("\\begin{document}")[2].partition("\\end{document}")[0].strip() + "\n"


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for problem in NAMES:
        (FOLDER / f"{problem}.tex").write_text(body(problem), encoding="utf-8")
