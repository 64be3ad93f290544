"""Claims files: TOML -> `ClaimsFile`, every fault told with its place.

A file says what its symbols mean, by `problem` and `[symbols]` for all claims or by `[settings.NAME]` tables for
some of them, and has `[[claim]]` tables in the order of the source. `docs/claims.md` shows the grammar by examples.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from rbpsym.claims.model import EXPECTATIONS, Claim, ClaimsFile, Meaning, Printed, Setting
from rbpsym.errors import ReadError
from rbpsym.statement.loader import load_table
from rbpsym.statement.source import SourceTable, did_you_mean, kind_of

MAX_BYTES = 512 * 1024
SHARED_KEYS = ("problem", "phase", "theory", "fixed_axis", "symbols", "given")
SETTING_KEYS = (*SHARED_KEYS, "like")
FILE_KEYS = ("title", "source", "text", "settings", "claim", "unclaimed", *SHARED_KEYS)
WORDS = ("id", "label", "says", "holds", "erratum", "note", "not_computed")  # of a claim, taken as they stand
CLAIM_KEYS = (*WORDS, "number", "line", "setting", "latex", "symbols", "expect", "right", "given")
_OWN_TABLE = re.compile(r"\s*\[(?:\[\s*claim\s*\]|\s*symbols\s*|\s*settings\b.*)\]\s*(?:#.*)?$")  # of claims files only
WHOLE = "the file"  # the name of the setting that a file's own keys make
HOLDS = ("identity", "motion", "start")


def load_claims(path: Path, *, binds: bool = False) -> ClaimsFile:
    """The claims in a file; one that only `binds` the symbols of a text needs none.

    Raises ReadError, StatementError or LimitError with the place of what is wrong.
    """
    root, file, name = load_table(path, MAX_BYTES), str(path), path.stem
    root.check_keys(FILE_KEYS, "a claims file")
    settings = _settings(root)
    rows = root.rows("claim", "claim")
    if not rows and not (binds and settings):
        raise root.error("a claims file without claims", "add [[claim]] with id, setting and latex.")
    unclaimed = root.choice("unclaimed", ("not computed",))
    claims = tuple(_claim(row, settings) for row in rows)
    _check_ids(claims)
    own = settings.get(WHOLE) or (next(iter(settings.values())) if len(settings) == 1 else None)
    words = (_title(root), root.string("source"), root.string("text"))
    return ClaimsFile(name, *words, claims, file, root.source.text, own, unclaimed=unclaimed)


def claims_within(root: SourceTable, file: str, name: str) -> ClaimsFile | None:
    """The claims in the tables [settings] and [[claim]] of another kind of file, a course; None if it has none."""
    settings, rows = _settings(root), root.rows("claim", "claim")
    claims = tuple(_claim(row, settings) for row in rows)
    _check_ids(claims)
    return ClaimsFile(name, "", "", "", claims, file, root.source.text) if claims else None


def is_claims(path: Path) -> bool:
    """Does the file hold claims, or settings for them? (A file that can't be read is left to its loader.)"""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return False
    return any(_OWN_TABLE.match(line) for line in lines)


def _title(root: SourceTable) -> str:
    title = root.data.get("title", "")
    return str(title.get("en", next(iter(title.values()), ""))) if isinstance(title, Mapping) else root.string("title")


def _settings(root: SourceTable) -> dict[str, Setting]:
    found: dict[str, Setting] = {}
    if any(key in root for key in SHARED_KEYS):
        found[WHOLE] = _setting(WHOLE, root, found)
    for name, table in root.tables("settings", "settings"):
        table.check_keys(SETTING_KEYS, f"settings.{name}")
        found[name] = _setting(name, table, found)
    return found


def _setting(name: str, table: SourceTable, known: Mapping[str, Setting]) -> Setting:
    goes_on = WHOLE in known and "problem" not in table and "theory" not in table  # from what the file says
    like = table.string("like") if "like" in table else WHOLE * goes_on
    if like and like not in known:
        raise table.value_error("like", f"there is no setting “{like}” above", did_you_mean(like, known, "settings"))
    base = known.get(like) or Setting(name)
    problem, theory = table.string("problem", base.problem), table.string("theory", base.theory)
    phase = table.string("phase", base.phase)
    if phase and not problem:
        raise table.error("a phase belongs to a problem", 'write problem = "NAME" too.', "phase")
    if bool(problem) == bool(theory):
        what = "both a problem and a theory" if problem else "neither a problem nor a theory"
        subject = "the file" if name == WHOLE else f"the setting “{name}”"
        raise table.error(f"{subject} has {what}", 'write problem = "NAME" or theory = "plane-motion".')
    symbols = {**base.symbols, **_symbols(table)}
    given = (*base.given, *_many(table, "given"))
    fixed = table.flag("fixed_axis", base.fixed_axis)
    place = table.source.key(table.path) if table.path else table.source.key(("problem",))
    return Setting(name, problem, theory, fixed, symbols, given, place, phase)


def _symbols(table: SourceTable) -> dict[str, Meaning]:
    section = table.table("symbols", "symbols")
    return {latex: Meaning(section.string(latex), section.source.value((*section.path, latex))) for latex in section.names()}


def _many(table: SourceTable, key: str) -> tuple[Printed, ...]:
    """A text or a list of texts."""
    value = table.data.get(key, ())
    if isinstance(value, str):
        return tuple(filter(None, [_printed(table, key)]))
    if not isinstance(value, (list, tuple)) or not all(isinstance(part, str) for part in value):
        raise table.value_error(key, f"“{key}” is a list of formulas in quotes")
    return tuple(Printed(part, table.source.value((*table.path, key, i))) for i, part in enumerate(value))


def _printed(table: SourceTable, key: str) -> Printed | None:
    if key not in table:
        return None
    text, path = table.string(key), (*table.path, key)
    if not text.strip():
        raise table.value_error(key, f"“{key}” is empty", f"{key} = '''...''' holds the formula as printed.")
    return Printed(text, table.source.inside(path, text, 1, 1) if "\n" not in text else table.source.value(path))


def _claim(table: SourceTable, settings: Mapping[str, Setting]) -> Claim:
    table.check_keys(CLAIM_KEYS, "a claim")
    table.require("id", "a claim", 'give it a name that stays: id = "eq-12"')
    setting = _setting_of(table, settings)
    expect = table.choice("expect", EXPECTATIONS, "proved")
    table.choice("holds", HOLDS)
    _check_content(table, expect)
    return Claim(
        **{key: table.string(key) for key in WORDS},
        setting=setting,
        printed=_printed(table, "latex"),
        number=_number(table),
        line=_line(table),
        expect=expect,
        right=_printed(table, "right"),
        place=table.source.key((*table.path, "id")),
    )


def _check_content(table: SourceTable, expect: str) -> None:
    if "latex" not in table and "not_computed" not in table:
        raise table.error("the claim has no formula", "add latex = '''...''', or not_computed = \"why\".", "id")
    if "right" in table and expect != "refuted":
        raise table.error("“right” belongs to a claim that is refuted", 'add expect = "refuted", or drop it.', "right")
    if "erratum" in table and expect not in ("refuted", "not computed"):
        raise table.error("an erratum is a claim that is refuted", 'add expect = "refuted" and right = "...".', "erratum")


def _setting_of(table: SourceTable, settings: Mapping[str, Setting]) -> Setting:
    name = table.string("setting")
    if not name and (WHOLE in settings or len(settings) == 1):
        name = WHOLE if WHOLE in settings else next(iter(settings))
    if name not in settings:
        what = f"there is no setting “{name}”" if name else "the claim has no setting"
        raise table.error(what, did_you_mean(name, settings, "settings"), "setting" if "setting" in table else "id")
    base = settings[name]
    own = _symbols(table)
    given = (*base.given, *_many(table, "given"))
    return replace(base, symbols={**base.symbols, **own}, given=given)


def _number(table: SourceTable) -> str:
    value = table.data.get("number", "")
    if isinstance(value, bool) or not isinstance(value, (int, str)):
        raise table.value_error("number", f"“number” is the number of the equation, not {kind_of(value)}")
    return str(value)


def _line(table: SourceTable) -> int:
    value = table.data.get("line", 0)
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise table.value_error("line", "“line” is the number of a line in the source")
    return value


def _check_ids(claims: tuple[Claim, ...]) -> None:
    seen: dict[str, Claim] = {}
    for claim in claims:
        if claim.id in seen:
            other = seen[claim.id].place
            where = f"the other one is in line {other.line}." if other else ""
            raise ReadError(f"two claims are called “{claim.id}”", instead=where, place=claim.place)
        seen[claim.id] = claim
