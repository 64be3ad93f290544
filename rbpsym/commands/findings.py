"""Findings of a check for other programs: those that are known already (a baseline), and all of them as SARIF 2.1.0."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rbpsym.claims.model import Outcome, Result
from rbpsym.claims.papers.check import plain
from rbpsym.claims.run import digest
from rbpsym.commands.reports import lines, name_of, place, shown, word
from rbpsym.errors import Place, ReadError
from rbpsym.statement.library import text_in

if TYPE_CHECKING:
    from rbpsym.commands.check import CheckRun

MOST_BYTES = 4 * 1024 * 1024
Finding = tuple[str, str, str]
SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
RULES = {  # what a finding is, and how grave
    Outcome.REFUTED: ("refuted", "error", "The formula is false."),
    Outcome.UNREAD: ("unread", "error", "The formula could not be read."),
    Outcome.UNDECIDED: ("undecided", "warning", "It was not decided whether the formula is true."),
    Outcome.NOT_COMPUTED: ("not-computed", "warning", "Nothing can be computed of the formula."),
    Outcome.PROVED: ("proved", "warning", "The formula is true, and was said not to be."),
    Outcome.DEFINITION: ("definition", "warning", "The formula defines a symbol, and was said not to."),
}
REMARK = ("text", "note", "Something about the text.")


def finding(result: Result) -> Finding:
    """What stays of a finding while lines and numbers around it move: its file, formula and verdict."""
    return shown(place(result)[0]), plain(result.latex) or result.id, str(result.outcome)


def as_baseline(found: CheckRun) -> str:
    """The findings of a run as a file to be kept: one a line, in an order that does not depend on the text's."""
    kept = sorted(finding(result) for result in found.results if result.is_finding)
    rows = [json.dumps(dict(zip(("file", "formula", "verdict"), one, strict=True)), ensure_ascii=False) for one in kept]
    return '{"version": 1, "findings": [\n' + ",\n".join(rows) + "\n]}\n"


def without_known(found: CheckRun, path: Path, anew: bool) -> CheckRun:
    """The run with each finding of a baseline (which is written first if `anew`) marked as known, which is as expected.

    Raises ReadError for what is no baseline."""
    from rbpsym.commands.check import CheckRun
    from rbpsym.document.files import write_whole

    if anew:
        write_whole(path, as_baseline(found))
    if not path.is_file():
        instead = "write it once, by the same command with --write-baseline, and commit it."
        raise ReadError("there is no baseline yet", instead=instead, place=Place(str(path)))
    try:
        rows = json.loads(text_in(path, MOST_BYTES, "the baseline"))["findings"]
        left = Counter((str(row["file"]), str(row["formula"]), str(row["verdict"])) for row in rows)
    except (ValueError, KeyError, TypeError, RecursionError):
        raise ReadError("this is no baseline", instead="write one with --write-baseline.", place=Place(str(path))) from None
    results = []
    for result in found.results:
        known = not result.expected and left[finding(result)] > 0
        left[finding(result)] -= known
        results.append(replace(result, expected=True, known=True) if known else result)
    gone = sum(left.values())
    said = f"{gone} findings of the baseline are gone; write it anew with --write-baseline"
    return CheckRun(results, [*found.remarks, *([(str(path), 1, said)] if gone else [])])


def compared(old: Path, new: Path) -> tuple[str, bool]:
    """What changed from one run to another, both as baselines or as --json wrote them; is anything worse?"""
    before, after = _verdicts(old), _verdicts(new)
    rows, worse = [], False
    for key in sorted({*before, *after}):
        ones, others = sorted((before[key] - after[key]).elements()), sorted((after[key] - before[key]).elements())
        worse |= any(verdict not in FINE for verdict in others)
        changes = zip_longest(ones, others, fillvalue="-")
        rows += [f"{key[0]}: {key[1]}\n  {one} -> {other}" for one, other in changes]
    same = sum(sum((before[key] & after[key]).values()) for key in before)
    return "\n".join((*rows, f"{len(rows)} changed, {same} as before.")) + "\n", worse


FINE = (str(Outcome.PROVED), str(Outcome.DEFINITION))


def _verdicts(path: Path) -> defaultdict[tuple[str, str], Counter[str]]:
    """The verdicts of a file by what is judged. Raises ReadError for what holds none."""
    found: defaultdict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    try:
        said = json.loads(text_in(path, MOST_BYTES, "the findings"))
        told = [(row["file"], row["formula"], row["verdict"]) for row in said.get("findings", ())]
        told += [(shown(row["file"]), plain(row["latex"]) or row["id"], row["outcome"]) for row in said.get("results", ())]
        if not {"findings", "results"} & said.keys():
            raise KeyError("findings")
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        instead = "compare two files that --write-baseline or --json wrote."
        raise ReadError("this holds no findings", instead=instead, place=Place(str(path))) from None
    for file, formula, verdict in told:
        found[str(file), str(formula)][str(verdict)] += 1
    return found


def as_sarif(found: CheckRun) -> str:
    """All findings as SARIF 2.1.0; known ones are suppressed."""
    from rbpsym import __version__

    told = [_told(result) for result in found.results if result.is_finding]
    told += [_record(REMARK, remark, file, line) for file, line, remark in found.remarks]
    rules = [{"id": name, "shortDescription": {"text": text}} for name, _, text in (*RULES.values(), REMARK)]
    driver = {"name": "rbpsym", "version": __version__, "rules": rules}
    run = {"tool": {"driver": driver}, "results": told, "columnKind": "unicodeCodePoints"}
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=1, ensure_ascii=False) + "\n"


def _told(result: Result) -> dict[str, Any]:
    said = "\n".join((f"{name_of(result)} {word(result)}", *lines(result)))
    record = _record(RULES[result.outcome], said, *place(result))
    known = {"suppressions": [{"kind": "external"}]} if result.known else {}
    return {**record, "partialFingerprints": {"formula/v1": digest(*finding(result))}, **known}


def _record(rule: tuple[str, str, str], said: str, file: str, line: int) -> dict[str, Any]:
    where = {"artifactLocation": {"uri": shown(file)}, "region": {"startLine": max(line, 1)}}
    return {"ruleId": rule[0], "level": rule[1], "message": {"text": said}, "locations": [{"physicalLocation": where}]}
