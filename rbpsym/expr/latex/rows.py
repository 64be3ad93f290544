"""The rows of a display: what goes on is joined, what stands side by side is parted, what is neither is refused.

This is the one place where tokens are taken out before a formula is read: alignment, ends of rows, gaps, punctuation
between relations, delimiters that are cut at the end of a row. What parts two relations becomes one token "row".
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from rbpsym.errors import RbpsymError
from rbpsym.expr.latex.asides import without_asides
from rbpsym.expr.latex.spelled import by_command
from rbpsym.expr.latex.tokens import (
    COLUMN,
    CONDITION,
    CONDITIONS,
    END_COLUMN,
    EQUIVALENT,
    IMPLIED,
    NEXT,
    PUNCTUATION,
    Token,
)
from rbpsym.expr.source import SourceText

OPEN = "?"  # the text of a row token where a sum or product may go on
GAP = "gap"  # the text of a row token made by a wide gap, behind which a condition may stand
_SAYING = (CONDITION, IMPLIED, EQUIVALENT)  # those that say how what stands behind them hangs on what stands before
RELATIONS = frozenset(("=", "<", ">", r"\le", r"\ge", r"\ne", r"\approx", r"\to", r"\propto", r"\sim", r"\ll", r"\gg", r"\in"))
_JOINING = frozenset(("+", r"\cdot", r"\times", "*", "/"))  # signs with which nothing begins
_SIGNS = frozenset((*RELATIONS, *_JOINING, "-", r"\pm", r"\mp"))
ARROW = r"\to"
_LEAST = frozenset((r"\min", r"\max", r"\sup", r"\inf"))
_QUANTIFIERS = (r"\forall", r"\exists")
_REACHING = (r"\int", r"\iint", r"\oint", r"\sum")  # behind which an & aligns
_CUT = (r"\left.", r"\right.")
_HELD = frozenset(("^", "_", "'", ")", "]", "}", r"\}", r"\rvert"))  # what belongs to the thing before it
_DEEPER, _HIGHER = frozenset("([{⟨") | {r"\{", COLUMN}, frozenset(")]}⟩") | {r"\}", END_COLUMN}
_WIDE = (r"\quad", r"\qquad")
_CELLED = frozenset(("array", "cases"))  # whose rows may be no sum, but the values of a vector or by cases


def laid_out(source: SourceText, tokens: tuple[Token, ...]) -> tuple[Token, ...]:
    """The tokens of the relations, with a token "row" between two of them. Raises ReadError for what can't be joined."""
    return _Layout(source, without_asides(tokens, RELATIONS)).tokens()


class _Layout:
    """One pass over the tokens of a display."""

    def __init__(self, source: SourceText, tokens: tuple[Token, ...]) -> None:
        self.source, self.all = source, tokens
        self.cut = 0
        self.open: list[str] = []  # what is open where a token stands
        self.related = False  # was there a relation sign since the last parting?
        self.stated = False  # and one that is no arrow?
        self.parted = 0  # relations side by side in this row
        self.beside = 0  # up to where a remark stands beside a row that the next one goes on with
        texts = [token.text for token in tokens]
        self.braced = texts.count(r"\{") == texts.count(r"\}")  # else one opens several rows
        self.steps = [self._step(token) for token in tokens]

    def tokens(self) -> tuple[Token, ...]:
        """What is read: things and signs, and what parts relations."""
        found: list[Token] = []
        for k, token in enumerate(self.all):
            self.open += [token.text] * (self.steps[k] > 0)
            del self.open[len(self.open) + min(self.steps[k], 0) :]
            self.related |= self.depth == 0 and _is_relation(token)
            self.stated |= self.depth == 0 and _is_relation(token) and token.text != ARROW
            kept = self._kept(k, token)
            if kept is None or (kept.kind == "row" and kept.text != CONDITION and not found):
                continue
            if kept.kind == "row":
                self.related = self.stated = False
                while found and found[-1].kind == "row":
                    kept = _both(found.pop(), kept)
            found.append(kept)
        last = found.pop()
        while found and found[-1].kind == "row" and found[-1].text != CONDITION:
            found.pop()
        return (*found, last)

    def _kept(self, k: int, token: Token) -> Token | None:
        """The token, a token that parts two relations, or None where it only forms the page."""
        if k < self.beside:
            return None
        if token.text in PUNCTUATION and token.kind == "sign":
            return self._punctuation(k, token)
        rule = _RULES.get(token.text if token.kind == "sign" or token.text == ARROW else token.kind)
        return rule(self, k, token) if rule else token

    def _step(self, token: Token) -> int:
        """How much deeper what follows stands."""
        counts = token.kind == "sign" or (self.braced and token.kind == "command")
        return (token.text in _DEEPER) - (token.text in _HIGHER) if counts else 0

    @property
    def depth(self) -> int:
        """In how many brackets a token stands."""
        return len(self.open)

    # --- what stands around

    def _near(self, k: int, step: int, *, over_rows: bool = True) -> Token | None:
        """The next thing or sign before or behind (or the end of the row); None at the edge of the formula."""
        k += step
        while 0 <= k < len(self.all) - 1 and _is_blank(self.all[k]) and (over_rows or self.all[k].kind != "row"):
            k += step
        return self.all[k] if 0 <= k < len(self.all) - 1 else None

    def _at_edge(self, k: int, step: int) -> bool:
        """Does a row (or the formula) begin or end here, but for what only forms the page?"""
        found = self._near(k, step, over_rows=False)
        return found is None or found.kind == "row"

    def _row_behind(self, k: int) -> list[int]:
        """Where the tokens up to the next end of a row or parting stand, on this level."""
        places, depth = list[int](), 0
        for place in range(k + 1, len(self.all) - 1):
            token = self.all[place]
            depth += self.steps[place]
            if depth == 0 and places and (token.kind == "row" or token.text in PUNCTUATION):
                break
            places += [place] if depth == 0 and token.kind != "row" else []
        return places

    def _relates(self, k: int) -> bool:
        """Does a relation sign follow in this row?"""
        return any(_is_relation(self.all[place]) for place in self._row_behind(k))

    def _is_sign(self, token: Token) -> bool:
        """Does it go on behind it? The star of z^* is none."""
        return token.text in _SIGNS and not self.source.text[: token.start].rstrip().endswith("^")

    # --- rules

    def _words(self, k: int, token: Token) -> Token:
        """Words with a blank behind them, and in a row one before them, are no factor of the relation around or behind them."""
        told, begins = self.source.text[token.start : token.end].partition("{")[2], self._at_edge(k, -1)
        before, behind = self._near(k, -1), None if self._at_edge(k, 1) else self._near(k, 1)
        begins |= before is None or before.text in PUNCTUATION
        apart = told[-2:-1] == " " and (begins or (told[:1] == " " and self.related and not (before and self._is_sign(before))))
        apart = apart and behind is not None and not self._is_sign(behind) and not CONDITIONS.search(token.text)
        if apart and not self.depth and self._relates(k):
            raise self._error(token, "do these words part two formulas?", r"Write a comma, or \text{and}, between two relations.")
        return token

    def _row(self, k: int, token: Token) -> Token | None:
        """The end of a row, or a word that joins relations."""
        before, behind = self._near(k, -1), self._near(k, 1)
        if self.open and self.open[-1] == COLUMN:
            inside = not self._at_edge(k, -1) and not self._at_edge(k, 1) and self.all[k - 1].text != "&"
            if inside and not token.text.startswith("\\") and token.text not in _SAYING:
                raise self._error(token, "does this word part two formulas of one cell?", "Write a row for each.")
            if not token.text.startswith("\\") or (behind and behind.text == END_COLUMN):
                return None
            return replace(token, kind="sign", text=NEXT)
        if not token.text.startswith("\\"):
            self.parted -= self._at_edge(k, -1)  # a row may begin with a word
            return self._part(token, token.text if token.text in _SAYING else "")
        several, self.parted = self.parted, 0
        if before is None or behind is None:
            return None
        if {before.text, behind.text} <= {"+", "-"} and before.text == "-":
            raise self._error(token, "a sign ends this row, and a sign begins the next", "Write it once.")
        if self._is_sign(before) or behind.text in _JOINING:
            return None
        if self.depth:
            if behind.text in (*_SIGNS, *_HELD) or before.text in PUNCTUATION:
                return None
            raise self._error(token, "does this go on with a product?", "Begin the row with the sign.")
        if _is_relation(behind):
            return replace(token, text="") if several else None  # which relation of the row above goes on here?
        return self._minus(k, token, several > 0) if behind.text == "-" else replace(token, text="")

    def _minus(self, k: int, token: Token, beside: bool) -> Token | None:
        """A row that begins with a minus goes on where its first cell is empty or it is no relation; {-} is the sign of what
        stands behind it."""
        row = self._row_behind(k)
        minus = self._near(k, 1)
        if minus is not None and self.source.text[: minus.start].endswith("{") and self._relates(k):
            return replace(token, text="")
        first = next((place for place in row if not _is_blank(self.all[place])), k)
        if any(self.all[place].text == "&" for place in row if place < first):
            return None
        sign = next((place for place in row if _is_relation(self.all[place])), None)
        if sign is None or not (self.related or beside):
            return None
        aligned = "&" in (self.all[sign - 1].text, self.all[sign + 1].text)
        return replace(token, text="" if aligned else OPEN)

    def _gap(self, k: int, token: Token) -> Token | None:
        """A gap in a row parts two relations, and never stands in a product within one; in brackets it parts components."""
        if (k and self.all[k - 1].kind == "gap") or self._at_edge(k, -1) or self._at_edge(k, 1):
            return None
        before, behind, last = self._near(k, -1), self._near(k, 1), k
        if before is None or behind is None:
            return None
        while self.all[last + 1].kind == "gap":
            last += 1
        if self.all[last + 1].text == "&" or self._is_least(k) or self._is_integrated(last + 1):
            return None
        if self.depth:
            inner = token.text in _WIDE and self.open[-1] in ("[", "(", COLUMN)
            things = not any(one.kind == "text" or one.text in (*_SIGNS, *PUNCTUATION) for one in (before, behind))
            parts = inner and things and self.all[k - 1].text != "&" and before.text != self.open[-1] and behind.text not in _HELD
            return replace(token, kind="sign", text="&" if self.open[-1] == COLUMN else ",") if parts else None
        if before.text in PUNCTUATION:
            return replace(token, kind="row", text=GAP)
        related = self.related + self._relates(k)
        if before.text in ("+", "-") and related == 2 and token.text in _WIDE:
            raise self._error(token, "what stands behind this sign?", "Leave the sign out, or write the term.")
        if self._is_sign(before) or behind.text in (*_JOINING, *RELATIONS, *_HELD, *PUNCTUATION):
            return None
        wide = last > k or token.text.startswith((r"\q", r"\enspace"))
        if behind.text == "-" or not wide:
            return self._part(token, OPEN) if related == 2 else None
        return self._part(token, GAP) if related else None

    def _part(self, token: Token, text: str) -> Token:
        self.parted += 1
        return replace(token, kind="row", text=text)

    def _cell(self, k: int, token: Token) -> Token | None:
        """A & that aligns rows, or that parts two relations of a row; any other is left to be refused."""
        if self.open and self.open[-1] == COLUMN:
            return token
        if self._at_edge(k, -1) or self._at_edge(k, 1):
            return None
        before, behind = self._near(k, -1), self._near(k, 1)
        near = [found.text for found in (before, behind) if found]
        if self.depth or {*RELATIONS, ":"}.intersection(near):
            return token if self.depth else None
        if near[0] in (*PUNCTUATION, *_REACHING) or self._cell_before(k) or self._is_least(k):
            return None
        remark = behind is not None and behind.kind == "text" and self.related and not self._relates(k)
        if remark and (end := self._remark_behind(k)):
            self.beside = end
            return None
        if remark or (before is not None and before.kind == "text" and not self.related and self._relates(k)):
            return self._part(token, "")
        used = any(self.all[place].text == "&" for place in self._row_before(k))
        if self.related and self._relates(k) and (used or not _SIGNS.intersection(near)):
            return self._part(token, "")
        return None if {"+", "-"}.intersection(near) and any(map(_is_relation, self.all)) else token

    def _remark_behind(self, k: int) -> int:
        """Where the row ends, if nothing but words that are no condition follows in it, and the next row goes on; else 0."""
        end = next(place for place in range(k, len(self.all)) if self.all[place].kind in ("row", "end"))
        words = [token for token in self.all[k + 1 : end] if not _is_blank(token)]
        goes_on = self._near(end, 1) if all(token.kind == "text" for token in words) else None
        said = any(CONDITIONS.search(token.text) for token in words)
        return end if goes_on is not None and _is_relation(goes_on) and not said else 0

    def _is_least(self, k: int) -> bool:
        """Does what follows stand behind “min” or “max”, which is of it?"""
        return not self.related and bool(_LEAST.intersection(self.all[place].text for place in self._row_before(k)))

    def _is_integrated(self, k: int) -> bool:
        """Does the differential of an integral stand there: ∫ v  dt?"""
        differential = self.all[k].kind == "differential" or (self.all[k].text == "d" and self.all[k + 1].kind == "letter")
        return differential and any(self.all[place].text == r"\int" for place in self._row_before(k))

    def _is_quantified(self, k: int) -> bool:
        """Does it part what “for all” is of: ∀ x, y ∈ M?"""
        parts = (self.all[place] for place in self._row_before(k))
        return next((one.text in _QUANTIFIERS for one in parts if one.text in (*_QUANTIFIERS, *by_command("loose"))), False)

    def _cell_before(self, k: int) -> bool:
        """Is the cell empty that ends here?"""
        while k and self.all[k - 1].kind == "gap":
            k -= 1
        return k > 0 and self.all[k - 1].text == "&"

    def _row_before(self, k: int) -> Iterator[int]:
        """Where the tokens of this row before stand."""
        while k > 0 and self.all[k - 1].kind != "row":
            k -= 1
            yield k

    def _environment(self, k: int, token: Token) -> Token | None:
        """An environment that stands alone, or at the right side of a relation."""
        begins, name = token.text.startswith(r"\begin"), token.text.partition("{")[2].partition("}")[0]
        step = -1 if begins else 1
        near, beside = self._near(k, step), self.all[k + step]
        alone = self._at_edge(k, step) or beside.kind == "gap" or near is None or near.text in PUNCTUATION
        if self.depth or not (alone or (near and _is_relation(near) and name not in _CELLED)):
            raise self._error(token, f"an environment “{name}” within a formula can't be read", "Write it alone.")
        return None

    def _arrow(self, k: int, token: Token) -> Token | None:
        """An arrow between two relations says that the second follows; a value tends to another in none of them."""
        behind = (self.all[place] for place in self._row_behind(k))
        before, last = self._near(k, -1), self._at_edge(k, 1)
        first = self._at_edge(k, -1) or (before is not None and before.text in PUNCTUATION)
        related = any(_is_relation(one) and one.text != ARROW for one in behind)
        follows = self.depth == 0 and (self.stated or first) and (related or last)
        return self._part(token, IMPLIED) if follows else token

    def _equal(self, k: int, token: Token) -> Token | None:
        """A sign at the end of a row that the next row begins with again."""
        behind = self._near(k, 1) if self.depth == 0 and self._at_edge(k, 1) else None
        return None if behind is not None and behind.text == token.text else token

    def _cut_delimiter(self, k: int, token: Token) -> Token | None:
        """\\right. at the end of a row, and the \\left. that opens the same parenthesis again."""
        if token.text == r"\left.":
            again, self.cut = self.cut > 0, max(self.cut - 1, 0)
            return None if again else token
        cut = self._at_edge(k, 1) and self._near(k, 1) is not None
        self.cut += cut
        return None if cut else token

    def _punctuation(self, k: int, token: Token) -> Token | None:
        """A comma between relations, or at the end of a row that goes on."""
        before, behind = self.all[k - 1] if k else None, self.all[k + 1]
        if self.depth or before is None or (not self.related and self._is_quantified(k)):
            return token
        if before.kind == behind.kind == "digit" and before.end == token.start and token.end == behind.start:
            if token.text == ".":
                return token
            raise self._error(token, "is this a decimal comma, or the end of a formula?", "Write 1.5, or a blank.")
        goes_on = self._near(k, 1)
        rows = any(found.kind == "row" for found in self.all[k + 1 : k + 4])
        if goes_on is not None and rows and goes_on.text in _SIGNS:
            return None
        return self._part(token, "")

    def _error(self, token: Token, what: str, instead: str) -> RbpsymError:
        return self.source.error(what, token.start, token.end, instead)


_RULES = {
    "text": _Layout._words, "row": _Layout._row, "gap": _Layout._gap, "&": _Layout._cell, "begin": _Layout._environment,
    ARROW: _Layout._arrow, "=": _Layout._equal, r"\left.": _Layout._cut_delimiter, r"\right.": _Layout._cut_delimiter,
}  # fmt: skip


def _is_relation(token: Token) -> bool:
    return token.text in RELATIONS and token.kind in ("sign", "command")


def _is_blank(token: Token) -> bool:
    return token.kind in ("gap", "begin", "row") or token.text == "&" or token.text in _CUT


def _both(one: Token, other: Token) -> Token:
    """Two partings in a row are one: the clearest of them."""
    texts = (one.text, other.text)
    text = next((text for text in (*_SAYING, GAP, "") if text in texts), OPEN)
    return replace(one, text=text)
