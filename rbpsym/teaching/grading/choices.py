"""Judging what is chosen and not calculated: options, orders, the line with the slip, signs."""

from __future__ import annotations

import re
from fractions import Fraction

from rbpsym.frozen import replace
from rbpsym.teaching.grading import judgement as j
from rbpsym.teaching.grading.judgement import Judgement, Remark, Status
from rbpsym.teaching.model import ChoiceKey, ComparisonKey, OrderKey, SignsKey

LETTERS = "abcdefghijklmnopqrstuvwxyz"
LONGEST = 400


def labels(count: int) -> str:
    """The labels of options as a sentence shows them: a, b, c."""
    return ", ".join(LETTERS[:count])


def place_of(label: str, count: int) -> int | None:
    """The place (from 0) of a label: a letter, or a number from 1; None if it is no label."""
    label = label.strip().strip("()[].:").lower()
    if len(label) == 1 and label in LETTERS[:count]:
        return LETTERS.index(label)
    if label.isascii() and label.isdigit() and len(label) < 4 and 1 <= int(label) <= count:
        return int(label) - 1
    return None


_SAYING = r"(?:i\s+think|maybe|it['’]?s|it\s+is|creo\s+que|es)"
_NAMING = r"(?:the\s+|la\s+)?(?:answer|option|opción|respuesta|letter|letra)\s*(?:is|es)?"
_LEAD = rf"(?:(?:{_SAYING}\s+)?{_NAMING}|{_SAYING})[\s:]\s*"
_FIRST = re.compile(rf"\s*(?:{_LEAD})?[(\[]?([A-Za-z]|\d{{1,3}})(?:[)\].:,;\s]|$)", re.IGNORECASE)


# further labels: “d or c”, “b/a”, “a, b”; the words of an explanation are none
_BETWEEN = r"[/,;&+|?]|\b(?:or|and|o|y|u|maybe|perhaps|quizás?)\b"
_OTHER = re.compile(rf"(?:^|{_BETWEEN})\s*[(\[]?([A-Za-z]|\d{{1,3}})(?=[)\].:?\s]*(?:$|{_BETWEEN}))", re.IGNORECASE)


def judge_choice(text: str, key: ChoiceKey) -> Judgement:
    """The judgement on a chosen option; words after its label go to the teacher."""
    if not text.strip():
        return j.EMPTY
    found = _FIRST.match(text)
    place = place_of(found[1], len(key.options)) if found else None
    if found is None or place is None:
        return _unread("not an option", text=text[:40], options=labels(len(key.options)))
    rest = text[found.end() :].strip()
    others = {place_of(word[1], len(key.options)) for word in _OTHER.finditer(rest)}
    if others - {place, None}:
        return _unread("several options", text=text[:40])
    judged = j.RIGHT if place == key.right else _wrong_option(key, place)
    return replace(judged.with_remark("open"), teacher=True) if rest and isinstance(key, ComparisonKey) else judged


def _unread(key: str, **slots: str) -> Judgement:
    return Judgement(Status.INVALID, remarks=(Remark(key, slots),))


def _wrong_option(key: ChoiceKey, place: int) -> Judgement:
    slip = key.options[place].slip
    return Judgement(Status.WRONG, remarks=j.slip_remarks(slip) if slip else (Remark("wrong option"),), slip=slip)


def judge_order(text: str, key: OrderKey) -> Judgement:
    """The judgement on an order: the part of the conditions beyond the half that chance fulfils."""
    if not text.strip():
        return j.EMPTY
    count = len(key.pieces)
    parts = [part for part in re.split(r"[\s,;>→\-–]+", text[:LONGEST]) if part]
    if len(parts) == 1 and len(parts[0]) == count > 1:
        parts = list(parts[0])
    order = tuple(place for part in parts if (place := place_of(part, count)) is not None)
    if sorted(order) != list(range(count)) or len(parts) != count:
        return _unread("not an order", options=labels(count))
    if key.accepts(order):
        return j.RIGHT
    kept = sum(order.index(before) < order.index(after) for before, after in key.before)
    credit = max(Fraction(2 * kept, len(key.before)) - 1, Fraction(0))
    remark = Remark("wrong order", {"right": str(kept), "all": str(len(key.before))})
    return Judgement(Status.PARTLY if credit else Status.WRONG, credit, (remark,))


SIGNS = {"+": "+", "＋": "+", "-": "-", "−": "-", "–": "-", "0": "0"}
_ROW = re.compile(r"([+＋\-−–0])[\s,]*([+＋\-−–0])[\s,]*([A-Za-z*]?)")


def judge_signs(text: str, key: SignsKey) -> Judgement:
    """The judgement on a table of signs, row by row, and on the letters that mark rows whose works cancel.

    The same sign everywhere earns nothing.
    """
    if not text.strip():
        return j.EMPTY
    wanted = [row.translational + row.rotational for row in key.rows]
    found = _ROW.findall(text[:LONGEST])
    if len(found) != len(wanted):
        count = sum(char in SIGNS for char in text[:LONGEST])
        return _unread("not signs", wanted=str(2 * len(wanted)), found=str(count))
    rows = [SIGNS[first] + SIGNS[second] for first, second, _ in found]
    parts = [(str(place + 1), Fraction(a == b)) for place, (a, b) in enumerate(zip(rows, wanted, strict=True))]
    remarks = [Remark("rows", {"right": str(sum(c == 1 for _, c in parts)), "all": str(len(wanted))})]
    if any(row.cancels for row in key.rows):
        is_right = _cancel(_groups([mark.lower() for *_, mark in found]), _groups([row.cancels for row in key.rows]))
        parts.append(("cancel", Fraction(is_right)))
        remarks += [] if is_right else [Remark("cancelling")]
    return _by_parts(tuple(parts), tuple(remarks), guessed=len(set("".join(rows))) == 1)


def _groups(marks: list[str]) -> frozenset[frozenset[int]]:
    """The rows that bear the same mark."""
    held: dict[str, set[int]] = {}
    for place, mark in enumerate(marks):
        if mark:
            held.setdefault(mark, set()).add(place)
    return frozenset(map(frozenset, held.values()))


def _cancel(own: frozenset[frozenset[int]], wanted: frozenset[frozenset[int]]) -> bool:
    """Are the same rows marked, and is each own group made of whole groups, whose works then cancel too?"""
    whole = all(any(group <= mine for mine in own) for group in wanted)
    return whole and frozenset().union(*own) == frozenset().union(*wanted)


def _by_parts(parts: tuple[tuple[str, Fraction], ...], remarks: tuple[Remark, ...], guessed: bool) -> Judgement:
    earned = sum(credit for _, credit in parts)
    if earned == len(parts):
        return j.RIGHT
    credit = Fraction(0) if guessed else Fraction(earned, len(parts))
    return Judgement(Status.PARTLY if credit else Status.WRONG, credit, remarks, parts=parts)
