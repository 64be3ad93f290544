"""Answer text -> tree, typed plainly, in Unicode or in LaTeX; the first of the two questions: is it valid?"""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Iterable, Iterator
from dataclasses import replace
from functools import partial
from types import MappingProxyType

from rbpsym.errors import LimitError, Place, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import Ways, read_infix, read_relation, read_ways
from rbpsym.expr.infix_names import MAX_LENGTH
from rbpsym.expr.latex.reader import latex_ways, read_latex
from rbpsym.languages import in_any
from rbpsym.teaching.grading import dialects as d
from rbpsym.teaching.grading.dialects import NUMBER, arguments_from, is_label, latex, without_unit
from rbpsym.teaching.grading.ground import Book
from rbpsym.teaching.grading.words import EULER, GREEK, MADE, WORD, dotted, lookup, spelled, standard

# --- what students type, made ready for the readers: one small rewriting after the other
# Nothing is dropped: a character that no rule knows stays, and the reader refuses it with a caret.


_FRAMES = (("$$", "$$"), ("$", "$"), (r"\(", r"\)"), (r"\[", r"\]"), ("`", "`"))
_COMMAND = re.compile(r"\\[A-Za-z,;!:> ]")
# typed signs for which the readers know another
_SIGNS = MappingProxyType({
    "’": "'", "′": "'", "‘": "'", "´": "'", "″": "''", "\u00a0": " ", "＝": "=", "∙": "*", "•": "*",
    "º": "°", "˚": "°", "∛": " cbrt ", "{": "(", "}": ")", "⟦": "(", "⟧": ")",
})  # fmt: skip


def checked_length(text: str) -> str:
    """The text, if it is short enough to be read. Raises LimitError."""
    if len(text) > MAX_LENGTH:
        what = f"the answer has {len(text)} characters; at most {MAX_LENGTH} are read"
        raise LimitError(what, instead="Enter the result alone.", place=Place(text=text[:60], column=1))
    return text


def unframed(text: str) -> str:
    """The text without the marks of a formula ($ … $), a sign = before it, and a full stop after it."""
    text = text.strip().replace("{,}", ",")
    for opening, closing in _FRAMES:
        if text.startswith(opening) and text.endswith(closing) and len(text) > len(opening) + len(closing):
            text = text[len(opening) : -len(closing)].strip()
    return re.sub(r"\s*[.;,]$", "", re.sub(r"^=(?![=>])\s*", "", text))


_LABEL = re.compile(rf"(\\?[A-Za-z{GREEK}][A-Za-z0-9_{GREEK}]*(?:_\{{\w+\}})?'*)\s*[=≈]\s*(?![=>])(?=\S)")


def unlabelled(text: str, book: Book) -> str:
    """The text without a name before a sign = that the problem does not have: T = 2π√(ℓ/g)."""
    found = _LABEL.match(text)
    if found is None:
        return text
    word = re.sub(r"[\\{}]", "", found[1])
    alone = is_label(word, book) and spelled(word, book) == word and text.count("=") <= 1
    return text[found.end() :] if alone else text


def is_latex(text: str) -> bool:
    """Is the text typed in LaTeX?"""
    return bool(_COMMAND.search(text))


def plain(text: str, book: Book) -> str:
    """Typed text in the grammar of `expr.infix`, with the names of the problem."""
    for step in STEPS:
        text = step(text, book)
    return text


def with_decimal_points(text: str, language: str) -> str:
    """Numbers with a decimal point: 3,5 is 3.5; 1,250 is 1250 in English, 1.250 in Spanish."""
    if language == "en":
        text = re.sub(r"(?<![\d.,])([1-9]\d{0,2}(?:,\d{3})+)(?![\d,])", lambda f: f[0].replace(",", ""), text)
    return re.sub(r"(?<=\d),(?=\d)", ".", text)


def _signs(text: str, book: Book) -> str:
    return dotted("".join(_SIGNS.get(char, char) for char in text))


_ENGLISH_CALL = re.compile(r"(?<!\w)[A-Za-z]\w*\s*\([^()]*\d,\d")


def _numbers(text: str, book: Book) -> str:
    if book.language != "en" or not _ENGLISH_CALL.search(text):  # f(2,3) in English: two arguments, not 2.3
        text = with_decimal_points(text, book.language)
    text = re.sub(r"(?<=\d)\.(?![\d\w])", "", text)
    if "e" not in book.names:
        text = re.sub(rf"(?<![\w.])({NUMBER})[eE]([+\-−]?\d{{1,3}})(?![\w.])", r"(\1*10^(\2))", text)
    return text


def _constants(text: str, book: Book) -> str:
    return re.sub(r"%(pi|e)\b", r"\1", text)


_WORD = rf"[A-Za-z{GREEK}][A-Za-z0-9_{GREEK}]*"
_RATE = re.compile(
    rf"(?<![A-Za-z_])d\s*(\^\s*2|²)?\s*({_WORD})\s*/\s*(?:\(\s*d\s*t\s*(\^\s*2|²)?\s*\)|d\s*t\s*(\^\s*2|²)?)(?!\w)"
)


def _rates(text: str, book: Book) -> str:
    """dθ/dt and d²θ/dt² are the names of the rates."""

    def named(found: re.Match[str]) -> str:
        tail = {0: "_dot", 2: "_ddot"}.get(bool(found[1]) + bool(found[3] or found[4]))
        name = tail and lookup(found[2] + tail, book)
        return f" {name} " if name else found[0]

    return _RATE.sub(named, text) if "dt" not in book.names else text


def _times(text: str, book: Book) -> str:
    """θ(t) is θ where t is no name of its own."""
    if "t" in book.names:
        return text
    return re.sub(rf"(?<!\w)({_WORD}'*)\s*\(t\)", lambda f: f[1] if lookup(f[1], book) else f[0], text)


STEPS: tuple[Callable[[str, Book], str], ...] = (
    d.letters_of_mathematica, d.mixed_numbers, d.indices, _signs, _constants, d.small_letters, d.two_arguments,
    d.based_logarithms, _numbers,
    d.powers_of_ten, d.degrees, d.derivatives, _rates, _times, d.ratios, spelled, d.inverses,
)  # fmt: skip


# ---


# --- integrals as one types them: ∫_{a}^{b} f dθ, Integral(f, (θ, a, b)), integrate(f, θ, a, b), int(f, θ=a..b)


HELD = "integral_0"  # the name that holds the place of an integral in the formula around
_CALL = re.compile(r"(?<![A-Za-z\\])(?:Integral|[Ii]ntegrate|int)\s*[(\[]")
_LIMIT = r"\s*(?:\{([^{}]*)\}|\(([^()]*)\)|(-?[^\s^_{}()+*/-]+))\s*"
_SIGN = re.compile(rf"∫\s*_{_LIMIT}\^{_LIMIT}(.*?)d\s*({WORD.pattern})(?=\s*(?:$|[-+)\],=*/]))", re.DOTALL)


def with_integral(text: str, book: Book, read: Callable[[str, Book], t.Node]) -> t.Node | None:
    """The tree of a text that holds a typed integral, each part of it read by `read`; None if it holds none.

    Raises ReadError for one without limits, or over what is no quantity of the problem.
    """
    call = _CALL.search(text)
    if call is None and "∫" not in text:
        return None
    found = call or _SIGN.search(text)
    parts, end = _of_call(text, call) if call else _of_sign(found)
    if found is None or len(parts) != 4 or (variable := lookup(parts[1].strip(), book)) is None:
        raise ReadError("this integral can't be read", instead="Write Integral(f, theta, a, b): of f, from a to b.")
    integrand, lower, upper = (read(parts[k], book) for k in (0, 2, 3))
    whole = t.Integral(integrand, variable, lower, upper)
    rest = read(f"{text[: found.start()]} {HELD} {text[end:]}", replace(book, names=book.names | {HELD}))
    return _filled(rest, whole)


def _of_call(text: str, call: re.Match[str]) -> tuple[list[str], int]:
    """(integrand, variable, lower and upper limit, where the call ends) of Integral(f, ...)."""
    parts, end = arguments_from(text.translate(str.maketrans("{}", "()")), call.end()) or ([], len(text))
    bare = ", ".join(part.strip().strip("()") for part in parts[1:])
    return [*parts[:1], *re.split(r",|=|\.\.", bare)], end


def _of_sign(sign: re.Match[str] | None) -> tuple[list[str], int]:
    if sign is None:
        return [], 0
    lower, upper = (next(filter(None, sign.groups()[k : k + 3]), "") for k in (0, 3))
    return [sign[7], sign[8], lower, upper], sign.end()


def _filled(node: t.Node, whole: t.Node) -> t.Node:
    return whole if node == t.Sym(HELD) else t.mapped(node, lambda part: _filled(part, whole))


# ---


_HINT = "Enter one formula, for example with * for products and sqrt( ) for roots."


def read_formula(text: str, book: Book, *, labels: bool = True) -> t.Node:
    """The tree of an answer: an expression, or a Chain for one with = signs.

    labels: whether a name that the problem does not have may stand before a sign = (`T = 2π√(ℓ/g)`).
    Raises ReadError, LimitError (with a caret) for what is no valid answer.
    """
    told = _told(text, book, labels)
    if is_latex(told):
        return _made(_single(read_latex(_latex_text(told, book), book.table)), told, book)
    return with_integral(told, book, partial(read_formula, labels=False)) or _made(_typed(told, book), told, book)


def read_all(text: str, book: Book, *, labels: bool = True) -> Ways:
    """Every way to read an answer that can be read in several. Raises as `read_formula`."""
    told = _told(text, book, labels)
    if not is_latex(told) and (whole := with_integral(told, book, partial(read_formula, labels=False))):
        return Ways((whole,), None, ((),))
    if is_latex(told):
        ways = latex_ways(_latex_text(told, book), book.table)
    else:
        ways = read_ways(plain(told, book), _symbols(book), functions=MADE)
    return replace(ways, trees=tuple(_made(tree, told, book) for tree in ways.trees))


_RADIANS = re.compile(rf"(?<=[)\]}}\s])\s*\b(?:{in_any('radians')})\s*$", re.IGNORECASE)  # a unit behind a formula of an angle


def _told(text: str, book: Book, labels: bool) -> str:
    told = _RADIANS.sub("", unframed(checked_length(text)))
    if not told:
        raise ReadError("there is no answer", instead=_HINT)
    told = told if is_latex(told) else without_unit(told, book)
    return unlabelled(told, book) if labels else told


def _made(node: t.Node, text: str, book: Book) -> t.Node:
    return _equations_only(_with_rates(standard(node, book.typed, _has_euler(book)), book), text)


def _has_euler(book: Book) -> bool:
    return EULER not in book.names and EULER not in book.typed


def _symbols(book: Book) -> frozenset[str]:
    return book.names | ({EULER} if _has_euler(book) else frozenset())


def _typed(text: str, book: Book) -> t.Node:
    made = plain(text, book)
    read = read_relation if any(sign in made for sign in "=<>≤≥≠≈~") else read_infix
    return read(made, _symbols(book), functions=MADE)


def _latex_text(text: str, book: Book) -> str:
    return latex(with_decimal_points(text, book.language), book)


def _single(node: t.Node) -> t.Node:
    if isinstance(node, t.Relations):
        raise ReadError("several formulas stand here", instead=_HINT)
    return node


_TAILS = {1: "_dot", 2: "_ddot"}


def _with_rates(node: t.Node, book: Book) -> t.Node:
    """dθ/dt is the symbol of the rate, where there is one."""
    if isinstance(node, t.Deriv) and isinstance(node.of, t.Sym) and node.wrt == "t":
        name = book.named(node.of.name + _TAILS.get(node.order, "_"))
        return t.Sym(name, span=node.span) if name else node
    return t.mapped(node, lambda part: _with_rates(part, book))


def _equations_only(node: t.Node, text: str) -> t.Node:
    if isinstance(node, t.Chain) and set(node.ops) - {"=", "~"}:
        raise ReadError("an inequality is no answer here", instead="Enter the result.", place=Place(text=text[:200]))
    return node


def meanings(read: t.Node, own: Container[str], known: Iterable[str]) -> Iterator[t.Node]:
    """What a formula may mean: I, if it is none of the `own` letters, is that about the centre of mass or about a point."""
    yield read
    if "I" in t.names(read) and "I" not in own:
        yield from (t.renamed(read, {"I": t.Sym(name)}) for name in known if name.startswith("I_"))
