"""What coqc says of the written files."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from rbpsym.errors import RbpsymError
from rbpsym.kernel.certify import Written, text
from rbpsym.kernel.rocq import REFUSED

PRELUDE = Path(__file__).with_name("Prelude.v")
NOT_ACCEPTED = "coqc does not accept its proof"
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
    [done] = with_prelude([text(found)])
    if done.returncode:
        bad = re.findall(rf"^{REFUSED}(\S+)", with_prelude([text(found, trial=True)])[0].stdout, re.MULTILINE)
        refused |= {id: NOT_ACCEPTED for id, own in found.lemmas.items() if {lemma.name for lemma in own} & {*bad}}
        [done] = with_prelude([text(found, without=bad)])
        if done.returncode:
            raise RbpsymError(f"coqc does not read the written file: {done.stderr[-400:]}")
    axioms = tuple(re.findall(r"^([\w.']+)\s*:", done.stdout.partition("Axioms:")[2], re.MULTILINE))
    return replace(report, axioms=axioms, seconds=time.perf_counter() - begin)


def with_prelude(contents: Iterable[str]) -> list[subprocess.CompletedProcess[str]]:
    """coqc on texts that begin with the prelude."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copy(PRELUDE, folder)
        _run(folder, PRELUDE.name)
        found = []
        for content in contents:
            (folder / "Steps.v").write_text(content, encoding="utf-8")
            found.append(_run(folder, "Steps.v"))
    return found


def _run(folder: Path, name: str) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(["coqc", "-q", name], cwd=folder, capture_output=True, text=True, timeout=LONGEST, check=False)
    except subprocess.TimeoutExpired as error:
        raise RbpsymError(f"coqc takes more than {LONGEST} seconds") from error
