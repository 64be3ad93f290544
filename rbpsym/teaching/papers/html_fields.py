"""The fields of a page in which answers are typed or picked, and what its script checks them against (None: nothing)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from markupsafe import escape

from rbpsym.document.writers.html import content, inline_math
from rbpsym.document.writers.page import Page
from rbpsym.errors import RbpsymError
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.tree import Node, Sym
from rbpsym.field.evaluate import scalar
from rbpsym.statement.units import OFFERED, offered
from rbpsym.teaching import model as m
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.compiled import compiled
from rbpsym.teaching.papers.blocks import LETTERS
from rbpsym.teaching.papers.layout import SIGN_WORDS, feedback
from rbpsym.teaching.ranges import si
from rbpsym.teaching.wording import plain_text
from rbpsym.typeset.text import to_text

# --- values of formulas at some points, for pages that compare typed formulas without holding the key


def sample_points(names: Sequence[str], count: int) -> list[dict[str, float]]:
    """Points at which all names have generic values between 0.3 and 1.4 (so that angles are acute)."""
    draws = Draws(b"points", ",".join(names))
    return [{name: round(0.3 + 1.1 * draws.below(100_000) / 100_000, 5) for name in names} for _ in range(count)]


def sampled(node: Node, points: Sequence[Mapping[str, float]]) -> list[float] | None:
    """The values of a formula at the points; None if it has none there."""
    try:
        evaluate = compiled([scalar(node)])
    except (RbpsymError, ZeroDivisionError):
        return None
    values = [evaluate(point)[0] for point in points]
    return values if all(map(math.isfinite, values)) else None


# ---


Fields = Iterator[tuple[str, dict[str, object] | None]]


def _choice(key: m.ChoiceKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    rows = "".join(
        f'<label><input type="radio" name="t{item.id}" value="{k}"> {LETTERS[k]}) {content(option.content, page)}</label>'
        for k, option in enumerate(key.options)
    )
    comments = [_comment(o.slip, item, worksheet, page) if o.slip else "" for o in key.options]
    yield rows, {"check": "choose", "right": key.right, "comments": comments}


def _comment(slip: m.Slip, item: m.Item, worksheet: m.Worksheet, page: Page) -> str:
    return page.inlines(feedback(slip, item, worksheet))


def _field(label: str, about: str) -> str:
    return f'<label>{label} <input type="text" autocomplete="off" spellcheck="false" aria-label="{escape(about)}"></label>'


def _number(key: m.NumberKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    dimension = offered()[key.units[0]][0] if key.units and key.units[0] in OFFERED else None
    units = {unit: scale for unit, (known, scale) in offered().items() if known == dimension} or {key.measure.unit: 1.0}
    slips = [{"exact": si(a.number), "comment": _comment(a.slip, item, worksheet, page)} for a in key.anticipated if a.number]
    left = f"{inline_math(key.left, page)} ="
    yield (
        _field(left, to_text(key.left, page.notation)),
        {
            "check": "number",
            "exact": key.exact,
            "tolerance": float(key.tolerance.relative),
            "digits": key.tolerance.digits,
            "units": units,
            "slips": slips,
        },
    )


def _formulas(key: m.FormulaKey | m.BlanksKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    wanted = [(key.left, to_text(key.left, page.notation), key)] if isinstance(key, m.FormulaKey) else [
        (m.blank(blank.number), str(blank.number), blank) for blank in key.blanks
    ]  # fmt: skip
    points = sample_points(sorted({*key.names}), 5)
    for left, about, one in wanted:
        values = sampled(one.value, points)
        slips = [(slip, sampled(formula, points)) for formula, slip in m.wrong_formulas(one.anticipated) if values]
        check: dict[str, object] = {
            "check": "formula",
            "points": points,
            "values": values,
            "spellings": spellings(key.names, page.notation),
            "slips": [{"values": v, "comment": _comment(slip, item, worksheet, page)} for slip, v in slips if v is not None],
        }
        yield _field(f"{inline_math(left, page)} =", about), None if values is None else check


def spellings(names: tuple[str, ...], notation: Notation) -> dict[str, str]:
    """How the names may be typed: as in the file, as printed, and in plain letters where that is not ambiguous."""
    found: dict[str, str] = {}
    for name in names:
        printed = to_text(Sym(name), notation)
        alias = notation.aliases.get(name, "")
        for spelling in (name, printed, alias, printed.translate(LOWERED), name.replace("_", "")):
            if spelling and not any(c.isspace() for c in spelling):
                found.setdefault(spelling, name)
    for plain, name in (("l", "ell"), ("L", "ell")):
        if name in names and plain not in found:
            found[plain] = name
    return found


LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉ₓ", "0123456789x")


def _order(key: m.OrderKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    label = escape(plain_text("paper.order", page.language)) + ":"
    yield _field(label, "order"), {"check": "order", "count": len(key.pieces), "before": sorted(key.before)}


def _slip(key: m.SlipKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    radios = "".join(
        f'<label class="beside"><input type="radio" name="t{item.id}" value="{k}"> {k + 1}</label>' for k in range(len(key.lines))
    )
    comments = ["" if k != key.wrong else _comment(key.slip, item, worksheet, page) for k in range(len(key.lines))]
    label = escape(plain_text("paper.line", page.language))
    yield f"<div>{label}: {radios}</div>", {"check": "choose", "right": key.wrong, "comments": comments}
    for asked in ("corrected", "reason"):
        about = plain_text(f"paper.{asked}", page.language)
        yield _field(f"{escape(about)}:", about), None


def _signs(key: m.SignsKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    choices = "".join(
        f'<option value="{sign}">{escape(plain_text(f"signs.{word}", page.language))}</option>'
        for sign, word in SIGN_WORDS.items()
    )
    first = f'<option value="">{escape(plain_text("paper.choose", page.language))}</option>'
    select = f'<select aria-label="+ − 0">{first}{choices}</select>'
    letter = '<input type="text" class="letter" maxlength="1" aria-label="a b c">'
    heads = ("force", "translational", "rotational", "cancels")
    head = "".join(f"<th>{escape(plain_text(f'signs.{key}', page.language))}</th>" for key in heads)
    cells = f"<td>{select}</td><td>{select}</td><td>{letter}</td>"
    rows = "".join(f"<tr><td>{page.inlines(row.label)}</td>{cells}</tr>" for row in key.rows)
    table = f'<div class="table"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>'
    yield table, {"check": "signs", "rows": [(r.translational, r.rotational, r.cancels) for r in key.rows]}


def _words(key: m.ExplanationKey | m.ComparisonKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    yield f'<textarea rows="6" aria-label="{escape(plain_text("paper.reason", page.language))}"></textarea>', None


def _compared(key: m.ComparisonKey, item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    yield from (*_choice(key, item, worksheet, page), *_words(key, item, worksheet, page))


def fields_of(item: m.Item, worksheet: m.Worksheet, page: Page) -> Fields:
    """The fields of a task, each with what it is checked against."""
    return FIELDS[type(item.key)](item.key, item, worksheet, page)


FIELDS: Mapping[type, Callable[[Any, m.Item, m.Worksheet, Page], Fields]] = {
    m.ChoiceKey: _choice,
    m.ComparisonKey: _compared,
    m.NumberKey: _number,
    m.FormulaKey: _formulas,
    m.BlanksKey: _formulas,
    m.OrderKey: _order,
    m.SlipKey: _slip,
    m.SignsKey: _signs,
    m.ExplanationKey: _words,
}
