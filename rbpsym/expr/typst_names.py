"""What stands for Typst's signs, names and functions in LaTeX; those of the package physica too."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from functools import partial
from pathlib import Path

UNBALANCED = r"\unbalanced "
_NUMBERED = re.compile(r"[1-9]")
_SUM = re.compile(r"[-+=<>&]")


def _braced(side: str, mark: str, *given: str) -> str:
    """A brace, perhaps with its name."""
    named = "".join(f"{mark}{{{name}}}" for name in given[1:])
    return rf"\{side}brace{{{given[0]}}}{named}" if len(given) < 3 else UNBALANCED


def _derivative(head: str, of: str, *by: str) -> str:
    """Of nothing, in front of what it stands for; by several variables, or by one so many times."""
    variables, order = (by[:-1], f"[{by[-1]}]") if len(by) > 1 and _NUMBERED.fullmatch(by[-1]) else (by, "")
    if not variables or (order and len(variables) > 1):
        return UNBALANCED
    return head + order + "".join(f"{{{part}}}" for part in (of, *variables))


def _differentials(*of: str) -> str:
    """d x d y; d^3 r."""
    if len(of) == 2 and _NUMBERED.fullmatch(of[1]):
        return rf"\mathrm{{d}}^{{{of[1]}}} {of[0]}"
    return UNBALANCED if any("[" in one for one in of) else " ".join(rf"\mathrm{{d}} {one}" for one in of)


def _before(sign: str, *of: str) -> str:
    return UNBALANCED if len(of) > 1 or _SUM.search(of[0]) else f"{sign} {of[0]}"


def _state(*of: str) -> str:
    return r"\braket{" + "|".join(of) + "}"


_TABLES: dict[str, dict[str, str]] = tomllib.loads(Path(__file__).with_name("typst.toml").read_text(encoding="utf-8"))
SIGNS, NAMES, ROWS = (_TABLES[part] for part in ("signs", "names", "rows"))
CALLS: dict[str, str | Callable[..., str]] = {
    **_TABLES["calls"],
    "bold": lambda body: body if _SUM.search(body) else rf"\boldsymbol{{{body}}}",  # a relation is but shown so
    **dict.fromkeys(("underbrace", "underbracket", "underparen"), partial(_braced, "under", "_")),
    **dict.fromkeys(("overbrace", "overbracket", "overparen"), partial(_braced, "over", "^")),
    # what the package physica adds
    "dv": partial(_derivative, r"\dv"), "pdv": partial(_derivative, r"\pdv"), "dd": _differentials,
    **dict.fromkeys(("ketbra", "braket", "mel"), _state),
    "var": partial(_before, r"\delta"), "difference": partial(_before, r"\Delta"),
}  # fmt: skip
