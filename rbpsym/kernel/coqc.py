"""What coqc says of a derivation that is written for it; what it once said of a text is kept."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any

from rbpsym.claims.run import digest
from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, replace
from rbpsym.kernel.certify import Written
from rbpsym.kernel.rocq import REFUSED
from rbpsym.kernel.theory import Theory

PRELUDE, BODY, MODEL = (Path(__file__).with_name(f"{name}.v") for name in ("Prelude", "Body", "Particles"))
NOT_ACCEPTED = "coqc does not accept its proof"
LONGEST = 900  # seconds that coqc may take for one file
WRITTEN = ("-norec", "Prelude", "-norec", "Steps")  # what coqchk looks at of a problem; with the theory, all libraries below it
AXIOMS = frozenset((  # of the real numbers (the last for their arctangent), and that functions are equal that have equal values
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
))  # fmt: skip


class Report(Frozen):
    """refused: why a step is not certified, by its id; axioms: what the accepted lemmas rest on; None: no coqc. checked:
    whether coqchk, which checks compiled proofs alone, agrees; None: it was not asked."""

    steps: int
    lemmas: int
    refused: dict[str, str]
    axioms: tuple[str, ...] | None = None
    seconds: float = 0.0
    checked: bool | None = None

    def is_certified(self, id: str) -> bool:
        """Whether coqc accepted a step, by its id with the phase before it."""
        return self.axioms is not None and id not in self.refused

    def record(self) -> dict[str, Any]:
        """What is certified, for programs."""
        certified = 0 if self.axioms is None else self.steps - len(self.refused)
        return {"steps": self.steps, "certified": certified, "not_certified": self.refused, "axioms": self.axioms}

    @property
    def is_whole(self) -> bool:
        """Whether coqc accepted every step."""
        return self.axioms is not None and not self.refused

    @property
    def is_sound(self) -> bool:
        """Whether coqc accepts all that is written, from no axioms but those of the reals."""
        is_accepted = NOT_ACCEPTED not in self.refused.values() and self.checked is not False
        return is_accepted and {*(self.axioms or ())} <= AXIOMS


def together(reports: Iterable[tuple[str, Report]]) -> Report:
    """The report of all parts, each with what stands before the ids of its steps."""
    told = list(reports)
    every = {f"{part}{id}": why for part, report in told for id, why in report.refused.items()}
    each = [report.axioms for _, report in told]
    axioms = None if None in each else tuple(dict.fromkeys(axiom for one in each for axiom in one or ()))
    steps, lemmas = (sum(getattr(report, name) for _, report in told) for name in ("steps", "lemmas"))
    checked = None if any(report.checked is None for _, report in told) else all(report.checked for _, report in told)
    return Report(steps, lemmas, every, axioms, sum(report.seconds for _, report in told), checked)


def has_coqc() -> bool:
    """Whether coqc is at hand."""
    return shutil.which("coqc") is not None


def compiled(found: Written | Theory, folder: Path | None = None, *, check: bool = False) -> Report:
    """The report of coqc, and of coqchk if there is to be a `check`; lemmas that are not accepted are found in one more pass,
    and left out in a third. What was said before of the same text is taken from the folder, if one is given."""
    refused, lemmas = dict(found.refused), sum(map(len, found.lemmas.values()))
    report = Report(len(found.lemmas) + len(found.refused), lemmas, refused)
    if not has_coqc():
        return report
    whole = found.text()
    key = digest(version(), *(path.read_bytes() for path in (PRELUDE, BODY, MODEL)), whole, *(["coqchk"] if check else []))
    said = kept(folder, key, lambda: _said(found, whole, check))
    bad = {*said["bad"]}
    refused |= {id: NOT_ACCEPTED for id, own in found.lemmas.items() if {lemma.name for lemma in own} & bad}
    return replace(report, axioms=tuple(said["axioms"]), seconds=said["seconds"], checked=said.get("checked"))


def _said(found: Written | Theory, whole: str, check: bool) -> dict[str, Any]:
    """The lemmas that coqc does not accept, the axioms of the others, how long it took, and whether coqchk agrees."""
    begin, bad = time.perf_counter(), []
    [done] = with_prelude([whole])
    if done.returncode:
        bad = re.findall(rf"^{REFUSED}(\S+)", with_prelude([found.text(trial=True)])[0].stdout, re.MULTILINE)
        [done] = with_prelude([found.text(without=bad)])
        if done.returncode:
            raise RbpsymError(f"coqc does not read the written file: {done.stderr[-400:]}")
    axioms = re.findall(r"^([\w.']+)\s*:", done.stdout.partition("Axioms:")[2], re.MULTILINE)
    parts = ("Steps",) if isinstance(found, Theory) else WRITTEN
    checked = _run(Path(_desk().name), "-silent", *parts, program="coqchk").returncode == 0 if check else None
    return {"bad": bad, "axioms": axioms, "seconds": time.perf_counter() - begin, "checked": checked}


def kept(folder: Path | None, key: str, make: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """What the folder has under a key, else what is made and put there."""
    path = None if folder is None else folder / "rocq" / f"{key}.json"
    if path is not None and path.is_file():
        with suppress(ValueError):  # a file that was cut off
            return dict(json.loads(path.read_text(encoding="utf-8")))
    made = make()
    if path is not None:
        with suppress(OSError):  # a folder that can't be written is no error
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(json.dumps(made), encoding="utf-8")
    return made


@cache
def version() -> str:
    """What coqc says of itself."""
    return subprocess.run(["coqc", "--version"], capture_output=True, text=True, check=False).stdout


def reported(folder: Path | None, key: str, make: Callable[[], Report]) -> Report:
    """A whole report, kept in the same way."""
    found = kept(folder, digest(key, version() if has_coqc() else ""), lambda: asdict(make()))
    return Report(**{**found, "axioms": None if found["axioms"] is None else tuple(found["axioms"])})


@cache
def _desk() -> tempfile.TemporaryDirectory[str]:
    """A folder for all files of a run."""
    made = tempfile.TemporaryDirectory()
    for path in (PRELUDE, BODY, MODEL):
        shutil.copy(path, made.name)
    return made


@cache
def _below(name: str) -> None:
    """Compiles what a file stands on, once."""
    folder = Path(_desk().name)
    for other in re.findall(r"^Require (?:Im|Ex)port (Prelude|Body)\b", (folder / f"{name}.v").read_text(encoding="utf-8"), re.M):
        _below(other)
    _run(folder, "-q", f"{name}.v")


def with_prelude(contents: Iterable[str]) -> list[subprocess.CompletedProcess[str]]:
    """coqc on texts that begin with the prelude."""
    folder, found = Path(_desk().name), []
    for content in contents:
        for name in re.findall(r"\w+", content.partition("Require Import ")[2].partition(".")[0]):
            _below(name)
        (folder / "Steps.v").write_text(content, encoding="utf-8")
        found.append(_run(folder, "-q", "Steps.v"))
    return found


def _run(folder: Path, *words: str, program: str = "coqc") -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, timeout=LONGEST, check=False)
    except subprocess.TimeoutExpired as error:
        raise RbpsymError(f"{program} takes more than {LONGEST} seconds") from error
