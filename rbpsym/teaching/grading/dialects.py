"""Answers as other systems have them typed: Mathematica, Maple, Maxima, spreadsheets, calculators.

Each function rewrites text into what the readers know. What none of them knows stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from types import MappingProxyType

from rbpsym.languages import in_any
from rbpsym.teaching.grading.ground import Book
from rbpsym.teaching.grading.words import CALLED, OTHER_FUNCTIONS, WORD, lookup

NUMBER = r"(?:\d+(?:\.\d*)?|\.\d+)"
INVERSES = MappingProxyType({"sen": "asin", "tg": "atan", "senh": "asinh", "tgh": "atanh"})
_MINUS_ONE = r"\s*(?:(?:\^|\*\*)\s*(?:[({]\s*)?[-−–]\s*1(?!\d)\s*[)}]?|⁻¹)\s*"
_INVERSE = re.compile(rf"(?<![A-Za-z\\])(a?(?:sinh|cosh|tanh|senh|tgh|sin|cos|tan|sen|tg)){_MINUS_ONE}(?=[\w(\\√|{{\[])")
_LATEX_INVERSE = re.compile(rf"\\(sinh|cosh|tanh|sin|cos|tan){_MINUS_ONE}")


def letters_of_mathematica(text: str, book: Book) -> str:
    r"""\[Theta] is theta."""
    return re.sub(r"\\\[([A-Z])([a-z]+)\]", lambda found: f" {found[1].lower()}{found[2]} ", text)


def small_letters(text: str, book: Book) -> str:
    """Sin, SIN, Sqrt, Pi and THETA in small letters, unless they are names of the problem; E^x is e^x."""

    def lowered(found: re.Match[str]) -> str:
        word, small = found[0], found[0].lower()
        is_one = len(word) > 1 and not lookup(word, book) and word not in CALLED
        is_one = is_one and not (lookup(word[0], book) and word[1:] in CALLED)  # A cos(x), where A is a name
        known = small in CALLED or small in TWO_ARGUMENTS or small == "pi" or (len(word) > 2 and lookup(small, book))
        return small if is_one and known and word[0].isupper() else word

    text = WORD.sub(lowered, text)
    return text if lookup("E", book) else re.sub(r"(?<![A-Za-z0-9_.])E(?=\s*(?:\^|\*\*))", "e", text)


def _root(first: str, second: str) -> str:
    return f"(({first})^(1/({second})))"


def _logarithm(first: str, second: str) -> str:
    return f"(ln({first})/ln({second}))"


def _power(first: str, second: str) -> str:
    return f"(({first})^({second}))"


TWO_ARGUMENTS: MappingProxyType[str, Callable[[str, str], str]] = MappingProxyType({
    "root": _root, "nthroot": _root, "surd": _root, "log": _logarithm, "lg": _logarithm, "pow": _power, "power": _power,
    "hypot": lambda first, second: f"sqrt(({first})^2+({second})^2)",
})  # fmt: skip
_TWO = re.compile(rf"(?<![A-Za-z_])({'|'.join(TWO_ARGUMENTS)})\s*[(\[]")


def two_arguments(text: str, book: Book) -> str:
    """root(x, n) is x^(1/n), log(x, b) is ln x / ln b, pow(x, n) is x^n."""
    if book.language != "en":
        return text
    for found in reversed(list(_TWO.finditer(text))[:20]):
        parts = arguments_from(text, found.end())
        if parts and len(parts[0]) == 2:
            arguments, end = parts
            text = text[: found.start()] + TWO_ARGUMENTS[found[1]](*arguments) + text[end:]
    return text


_BASED = re.compile(r"(?<![A-Za-z_])(?:log|lg)_\(?(\w+)\)?\s*[(\[]")


def based_logarithms(text: str, book: Book) -> str:
    """log_2(x) is ln x / ln 2."""
    for found in reversed(list(_BASED.finditer(text))[:20]):
        parts = arguments_from(text, found.end())
        if parts and len(parts[0]) == 1:
            text = text[: found.start()] + _logarithm(parts[0][0], found[1]) + text[parts[1] :]
    return text


def arguments_from(text: str, start: int) -> tuple[list[str], int] | None:
    """(arguments between commas, where the parenthesis ends); None if it never does."""
    parts: list[str] = []
    depth, begin = 0, start
    for place in range(start, len(text)):
        char = text[place]
        if char in ")]" and depth == 0:
            return [*parts, text[begin:place]], place + 1
        if char == "," and depth == 0:
            parts.append(text[begin:place])
            begin = place + 1
        depth += (char in "([") - (char in ")]")
    return None


_DIFF = re.compile(
    r"(?<![A-Za-z_])(?:diff|[Dd]erivative|D|dt)\s*[(\[]\s*([^\s,()\[\]]+)\s*(?:\(t\)|\[t\])?\s*,\s*\{?\s*t\s*"
    r"(?:,\s*(2|t)\s*\}?)?\s*[)\]]"
)
_OPERATED = re.compile(
    r"(?<![A-Za-z_])d\s*/\s*dt\s*\(?\s*([^\s()]+?)\s*(?:\)|(?=\s|$))|(?<![A-Za-z_])d\s*\(\s*(\w+)\s*\)\s*/\s*dt"
)


def derivatives(text: str, book: Book) -> str:
    """diff(theta, t), D[theta, t], d(theta)/dt and d/dt theta are dθ/dt."""
    if "t" in book.names:
        return text
    text = _DIFF.sub(lambda f: f" d^2 {f[1]}/dt^2 " if f[2] else f" d{f[1]}/dt ", text)
    return _OPERATED.sub(lambda f: f" d{f[1] or f[2]}/dt ", text)


def indices(text: str, book: Book) -> str:
    """m[1], m_{1} and m(1) … the first two are m_1, if this is a name."""
    text = re.sub(r"_\{\s*(\w+)\s*\}", r"_\1", text)

    def named(found: re.Match[str]) -> str:
        name = f"{found[1]}_{found[2]}"
        return f" {name} " if lookup(name, book) and not lookup(found[1], book) else found[0]

    return re.sub(r"(?<!\w)([A-Za-z]\w*)\s*\[\s*(\w{1,3})\s*\]", named, text)


def mixed_numbers(text: str, book: Book) -> str:
    """1½ and 1 3/4 are sums; 1 200 is 1200; ³⁄₂ is 3/2; 50 % is 50/100."""
    text = re.sub(r"([⁰¹²³⁴⁵⁶⁷⁸⁹]+)[⁄/]([₀₁₂₃₄₅₆₇₈₉]+)", _small_fraction, text)
    text = re.sub(r"(?<![\w.,^])(\d+)\s?([¼½¾⅐-⅞])", r"(\1+\2)", text)
    text = re.sub(r"(?<![\w.,^)\]/*])(\d{1,3})\s+(\d{1,3})\s*/\s*(\d{1,3})(?![\w.,])", _mixed, text)
    text = re.sub(rf"(?<![\w.])({NUMBER})\s*%(?!\s*[\w(])", r"(\1/100)", text)
    return re.sub(r"(?<![\w.,^])(\d{1,3})((?:[ \u2009\u202f]\d{3})+)(?![\w.,])", lambda f: re.sub(r"\s", "", f[0]), text)


def _small_fraction(found: re.Match[str]) -> str:
    plain = found[0].translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉⁄", "01234567890123456789/"))
    return f"({plain})"


def _mixed(found: re.Match[str]) -> str:
    whole, above, below = found.groups()
    return f"({whole}+{above}/{below})" if int(above) < int(below) else found[0]


def powers_of_ten(text: str, book: Book) -> str:
    """2.5 x 10^3 is 2.5*10^3, where an x with blanks around it, or one that is no name, stands for the sign."""
    tail = r"(?=10\s*(?:\^|\*\*|[⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹]))"
    text = re.sub(rf"(?<![\w.])({NUMBER})\s+[xX]\s+{tail}", r"\1*", text)
    return text if "x" in book.names else re.sub(rf"(?<![\w.])({NUMBER})\s*[xX]\s*{tail}", r"\1*", text)


def degrees(text: str, book: Book) -> str:
    """60° and 60 degrees are angles."""
    word = rf"|\s*(?:{in_any('degrees')})\b" if not lookup("deg", book) else ""
    return re.sub(rf"(?<![\d.])({NUMBER})(?:\s*°{word})", r"(\1*pi/180)", text, flags=re.IGNORECASE)


def inverses(text: str, book: Book) -> str:
    """sin^-1(x) is the inverse function, as on calculators; sin(x)^-1 is the reciprocal."""
    return _INVERSE.sub(lambda found: f"{INVERSES.get(found[1], 'a' + found[1])} ", text)


def ratios(text: str, book: Book) -> str:
    """a : b is a/b."""
    return re.sub(r"(?<=[\w)\]])\s*:\s*(?=[\w(])", "/", text)


# --- LaTeX


def latex(text: str, book: Book) -> str:
    """LaTeX with what the reader knows for other commands: \\sin^{-1}, 60^\\circ, \\over, \\sfrac, 1\\frac{3}{4}."""
    text = _LATEX_INVERSE.sub(r"\\arc\1 ", text)
    text = re.sub(
        rf"(?<![\d.])({NUMBER})\s*(?:\^\s*\{{?\s*\\circ\s*\}}?|\\degree(?![A-Za-z])|°)", r"\\left(\1\\cdot\\pi/180\\right)", text
    )
    text = re.sub(r"\\(?:s|nice|x|c|l)frac(?![A-Za-z])", r"\\frac", text)
    text = re.sub(r"\\div(?![A-Za-z])", "/", text)
    text = re.sub(rf"(\\(?:sin|cos|tan)\s*{NUMBER})\s*\\(?:cdot|times)(?![A-Za-z])", r"\1 ", text)
    text = re.sub(r"\{([^{}]*)\\over(?![A-Za-z])([^{}]*)\}", r"\\frac{\1}{\2}", text)
    text = re.sub(r"\\log\s*_\s*(?:\{(\w+)\}|(\w))", lambda f: rf"\frac{{1}}{{\ln({f[1] or f[2]})}}\ln ", text)
    text = re.sub(rf"(?<![\d.])({NUMBER})\s*\\%", r"\\frac{\1}{100}", text)
    return _LATEX_MIXED.sub(_latex_mixed, text)


_LATEX_MIXED = re.compile(r"(?<![\w.,^_}/\\])(\d+)\s*(\\[dt]?frac\s*(?:\{\s*(\d+)\s*\}\s*\{\s*(\d+)\s*\}|(\d)\s*(\d)))")


def _latex_mixed(found: re.Match[str]) -> str:
    above, below = found[3] or found[5], found[4] or found[6]
    return rf"\left({found[1]}+{found[2]}\right)" if int(above) < int(below) else found[0]


_UNIT = r"(?:1|rad|deg|kg|Hz|N|J|W|m|s|°)(?:\s*\^\s*[({]?-?\d[)}]?|[⁻¹²³⁴]+)?"
_UNIT_BEHIND = re.compile(
    rf"\s*\[\s*{_UNIT}(?:\s*[*·⋅/ ]?\s*\(?{_UNIT}\)?){{0,6}}\s*\]$|(?<=[\s)])(?:rad\s*/\s*s|rad\s+s)\S{{0,6}}$"
)


def without_unit(text: str, book: Book) -> str:
    """A formula without the unit that stands behind it in brackets, or as rad/s."""
    return text if lookup("rad", book) else _UNIT_BEHIND.sub("", text).rstrip()


def is_label(word: str, book: Book) -> bool:
    """Is it a name that the problem does not have, so that before a sign = it only says what follows?"""
    return not lookup(word, book) and word not in CALLED and word.lower() not in OTHER_FUNCTIONS
