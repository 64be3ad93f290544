"""What coqc says of the written files."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

from rbpsym.errors import RbpsymError
from rbpsym.kernel.certify import Written, text
from rbpsym.kernel.rocq import REFUSED

PRELUDE = Path(__file__).with_name("Prelude.v")
LONGEST = 900  # seconds that coqc may take for one file


@dataclass(frozen=True, slots=True)
class Report:
    """refused: why a step is not certified, by its id; axioms: what the accepted lemmas rest on; None: no coqc."""

    steps: int
    lemmas: int
    refused: dict[str, str]
    axioms: tuple[str, ...] | None = None
    seconds: float = 0.0


def has_coqc() -> bool:
    """Whether coqc is at hand."""
    return shutil.which("coqc") is not None


def compiled(found: Written) -> Report:
    """The report of coqc; lemmas that it does not accept are found in one more pass, and left out in a third."""
    refused, lemmas = dict(found.refused), sum(map(len, found.lemmas.values()))
    report = Report(len(found.lemmas) + len(found.refused), lemmas, refused)
    if not has_coqc():
        return report
    begin = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(PRELUDE, folder)
        run(Path(folder), PRELUDE.name)
        done = tried(Path(folder), text(found))
        if done.returncode:
            told = tried(Path(folder), text(found, trial=True)).stdout
            bad = re.findall(rf"^{REFUSED}(\S+)", told, re.MULTILINE)
            refused |= {id: "coqc does not accept its proof" for id, own in found.lemmas.items() for x in own if x.name in bad}
            done = tried(Path(folder), text(found, without=bad))
            if done.returncode:
                raise RbpsymError(f"coqc does not read the written file: {done.stderr[-400:]}")
    axioms = tuple(re.findall(r"^([\w.']+)\s*:", done.stdout.partition("Axioms:")[2], re.MULTILINE))
    return replace(report, axioms=axioms, seconds=time.perf_counter() - begin)


def tried(folder: Path, content: str) -> subprocess.CompletedProcess[str]:
    """coqc on a text of ours."""
    (folder / "Steps.v").write_text(content, encoding="utf-8")
    return run(folder, "Steps.v")


def run(folder: Path, name: str) -> subprocess.CompletedProcess[str]:
    """coqc on a file."""
    try:
        return subprocess.run(["coqc", "-q", name], cwd=folder, capture_output=True, text=True, timeout=LONGEST, check=False)
    except subprocess.TimeoutExpired as error:
        raise RbpsymError(f"coqc takes more than {LONGEST} seconds") from error
