"""LaTeX -> tokens. Thin spaces, `\\left`, `\\right` and `\\nonumber` mean nothing and make no token;

every other character makes one, or an error that names it. Gaps make one where rows are laid out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from unicodedata import combining

from rbpsym.errors import LimitError
from rbpsym.expr.hyperbolic import FUNCTION_WORDS
from rbpsym.expr.latex.spelled import as_latex, spelled, words
from rbpsym.expr.letters import LETTERS, NAME_OF_LETTER, SAME_LETTER
from rbpsym.expr.source import SourceText, refused
from rbpsym.frozen import Frozen, replace

MAX_LENGTH = 8000

_SYSTEMS = "array|aligned|alignedat|gathered|split|cases"  # what one brace may open for all rows
_MARK = r"(?:\\textcircled\s*\{[\w*]+\}|[①-⑳]|\\circledast(?![A-Za-z]))"  # the number of an equation in a circle
_SILENT = (
    r"\.{5,}\s*+\(\d+[a-z]?\)(?=\s*+(?:\\\\|$))|\\(?:,|:|!|>)|\^\s*\{\s*\}|\{\}(?=\s*\})"
    r"|\\(?:nonumber|notag|displaystyle|textstyle|(?:display|no)?limits|thinspace"
    r"|left|right|[bB]igg?[lrm]?|middle|mathstrut|strut|allowbreak|nobreak|hfill|math(?:op|open|close|inner|ord|rel|bin)(?:\s*\{\})?"
    r"|tiny|small|footnotesize|normalsize|large|Large|LARGE|huge|Huge|qedhere|scriptstyle|begingroup|endgroup|boxed|fbox|Aboxed|[pb]qty|ab|smash|lefteqn|break|checkmark|blacksquare|qedsymbol)(?![A-Za-z])"
    r"|\\operatorname\*?(?=\s*\{\s*\\(?:text|math))|\\rm(?=(?:\s|~|\\ )*(?:[^A-Za-z\s~{\\]|\\[A-Za-z]|$))"
    rf"|(?:(?<=[\s}}])|\A){_MARK}(?=\s*(?:\\[\\ ]|\\q?quad|$))|(?<=[A-Za-z\d}}'])\{{\}}(?=[_^])"
    r"|\\qty(?![A-Za-z]|\s*\{[^{}]*\}\s*\{)|(?:(?<=\\SI)|(?<=\\num)|(?<=\\ang)|(?<=\\si)|(?<=\\unit)(?!\s*\[[-\d.,\s]+\]))\s*\[[^\]]*\]"
    r"|\\(?:label|tag|vspace|color|textcolor|[hv]?phantom)\*?\s*\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\\m?kern\s*-?[\d.]+\s*[a-z]{2}"
)
_SO = r"\\(?:therefore|because|implies|impliedby|iff|Rightarrow|Longrightarrow|Leftrightarrow|Longleftrightarrow|lor)(?![A-Za-z])"
_INDEX = r"(?:[A-Za-z]|\\[a-z]+)'?"
_DOTS = r"(?:\\[cl]?dots[bc]?(?![A-Za-z])|\.\.\.)"
_APART = r"(?:(?<=[,;:(~])|(?<=[,;:(~] )|(?<=quad)|(?<=quad ))"  # in a = 2 b, i = 1, 2, ... the b is a factor
_RUN = (  # i = 1, 2, ..., n; without dots only of what is an index, for x = 0, 1 says something
    rf"(?:{_APART}{_INDEX}(?:\s*,\s*{_INDEX})+|{_INDEX})\s*=\s*(?:\d+|{_INDEX}\s*[-+]\s*\d+)(?:\s*,\s*(?:\d+|{_INDEX}\s*[-+]\s*\d+))*\s*,?\s*{_DOTS}(?:\s*,?\s*(?:\d*\s*{_INDEX}(?:_\w)?(?:\s*[-+]\s*\w)?|\d+))?"
    rf"|{_INDEX}(?:\s*,\s*{_INDEX})*\s*\\in\s*(?:\\left)?\s*\\\{{[\d\s,]*(?:{_DOTS})?[\w\s,]*(?:\\right)?\s*\\\}}"
    r"|[ijk]\s*=\s*x\s*,\s*y(?:\s*,\s*z)?|(?:[ijklnpqr]|\\(?:alpha|beta|mu|nu))(?:\s*,\s*(?:[ijklnpqr]|\\(?:alpha|beta|mu|nu)))*\s*=\s*\d+(?:\s*,\s*\d+)+"
)
_EACH = (  # (i = 1, 2, ..., n) behind a formula, perhaps with a word: for each value of an index
    r"(?<=[\s,~(:;])"
    rf"(?:\\(?:text(?:rm)?|mbox)\s*\{{\s*(?:for|with|where|para|con)(?:\s+\w+)?\s*\}}(?:\s|\\[,:; ]|\\q?quad)*)?"
    rf"\(?\s*(?:{_RUN})(?:\s*[;,](?:\s|\\[,;])*(?:{_RUN}))*+\s*\)?"
    rf"(?=\s*(?:\\(?:[,; ]|thinspace)\s*)?(?:[.,;]\s*)?(?:\Z|\\\\|\\end|\\q?quad|{_SO}))"
)
_ZERO = r"\\(?:vec|bar|tilde|overrightarrow|mathbf|boldsymbol|bm|vb|va|mathrm|bf)\s*(?:\{\s*0\s*\}|0)"
_DEGREE = r"\^\s*(?:\{\s*\\circ\s*\}|\\circ(?![A-Za-z]))|\\(?:degree|textdegree)(?![A-Za-z])|°"
_GAP = (
    r"(?<=[-+=&])\{\}|\{\}(?=\s*(?:[-+=<>&]|\\[pm]{2}(?![A-Za-z])))"
    r"|\\(?:;| |\n)|~|\\(?:quad|qquad|enspace|space|hfil)(?![A-Za-z])"
    r"|\\hspace\*?\s*\{[^{}]*\}"
)
_QUICK = "and|or|if|for|where|when|with|then|so|let|given|assume|since|unless|otherwise|thus|at"  # \qand: and, between gaps
_UPRIGHT = r"\\rm(?![A-Za-z])(?:\s*\\bf(?![A-Za-z]))?"  # all that follows in its group: {\rm kg}, 3\rm\ m
PUNCTUATION = (",", ".", ";")
CONDITION = "if"  # the text of a row token behind which a condition stands
IMPLIED, EQUIVALENT = "implies", "iff"  # and of those behind which stands what follows, from that side or from both
_ARROWS = {
    **dict.fromkeys((r"\implies", r"\Rightarrow", r"\Longrightarrow"), IMPLIED), r"\impliedby": CONDITION,
    **dict.fromkeys((r"\iff", r"\Leftrightarrow", r"\Longleftrightarrow"), EQUIVALENT),
}  # fmt: skip
_PATTERNS = (
    rf"(?P<blank>\\left\s*(?:\.|\\(?:\{{|lbrace))(?:\s|\\[,;! ])*(?=\\begin\s*\{{(?:{_SYSTEMS})\}})"
    rf"|(?:{'|'.join(rf'(?<={name}}})' for name in _SYSTEMS.split('|'))})\s*\\right\s*(?:\.|\\(?:\}}|rbrace))|\s+)"
    r"|(?P<empty>\\(?:left|right)\s*\.)"
    r"|(?P<bar>\\(?:left|right|[bB]igg?[lrm]?)\s*(?:\\\||\\[lr]?[vV]ert(?![A-Za-z])|\|))"
    rf"|(?P<silent>{_SILENT})"
    rf"|(?P<gap>{_GAP})"
    rf"|(?P<each>{_EACH})|(?P<zero>{_ZERO})"
    r"|(?P<gradient>\\(?:vec|mathbf|boldsymbol|bm|vb|va|overrightarrow)\s*(?:\{\s*\\nabla\s*\}|\\nabla(?![A-Za-z])))"
    r"|(?P<differential>\\(?:mathrm|text|textrm|textup|rm)\s*\{\s*d\s*\}|\\mathrm\s+d|\\(?:d|dd|o?dif|partial)(?![A-Za-z]))(?:\s*\{\s*\})?"
    r"|(?P<text>\\(?:text(?:rm|sl|it|bf|up|tt)?|[mh]box|qq\*?)\s*\{(?:[^{}]|\{[^{}]*\})*\}"
    rf"|\\q(?:c|comma|{_QUICK})\*?(?![A-Za-z])"
    r"|\\(?:mathrm|operatorname\*?|rm)\s*\{(?:[^{}]|\^\{-?\d+\})*\}|\\(?:text(?:rm|it|bf)?|mathrm|mbox)\s+[A-Za-z\d]"
    rf"|(?<![_^])(?<![_^] )\{{\s*{_UPRIGHT}(?:[^{{}}\\]|\\[ ,])*\}}"
    rf"|{_UPRIGHT}(?:\s|~|\\ )*+[A-Za-z]++(?:(?:\s|~|\\ |/)+[A-Za-z]++)*+(?!\())"
    r"|(?P<begin>\\begin\s*\{(?:array|alignedat|aligned|gathered|multlined|split)\}(?:\s*\[[tbc]\])?"
    r"(?:(?<!split\})(?<!ed\})\s*\{(?:[lcr|\s\d]|[@!p]\{[^{}]*\})*\})?|\\(?:begin|end)\s*\{[^{}]*\})"
    r"|(?P<over>\\(?:overset|stackrel)\s*\{(?:[^{}]|\{[^{}]*\})*\}\s*\{\s*(?:[=<>]|\\[a-z]+)\s*\})"
    rf"|(?P<row>\\\\\*?(?:\[[^\]]*\])?|\\newline(?![A-Za-z])|\\&|{_SO}|\\(?:short)?intertext\s*\{{(?:[^{{}}]|\{{[^{{}}]*\}})*\}})"
    rf"|(?P<degree>{_DEGREE})"
    rf"|(?P<plain>(?<![a\\])(?:{'|'.join(word for word in FUNCTION_WORDS if len(word) > 2)})(?=\s*[(\[{{^\\]|\s+[A-Za-z\d])"
    rf"|(?<![A-Za-z\\])(?:{'|'.join(word for word in FUNCTION_WORDS if len(word) == 2)})(?=\s*(?:\(|\\left|\\[a-z])))"
    r"|(?P<arrow>\\x(?:right|Right|mapsto)arrow\s*(?:\[[^\]]*\]\s*)?\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})"
    r"|(?P<command>\\(?:v[abu]\*|[A-Za-z]+|[|{}%]))"
    r"|(?P<word>[\u3040-\u30ff\u4e00-\u9fff\uac00-\ud7af]+)|(?P<dots>\.\.\.)"
    r"|(?P<digit>[0-9])|(?P<mark>\{[,.]\})|(?P<letter>[A-Za-z])"
    r"|(?P<sign>:=|=:|<<|>>|[-+*/=<>()\[\]{}|_^',.;:&!?])"
)
CONDITIONS = re.compile(
    r"\b(for|if|when|where|while|until|only|unless|except|provided|small|large|near|assum\w*|approx\w*|at|on|in|since|initial\w*"
    r"|para|si|cuando|donde|solo|pequeñ\w*|en|per|se|quando|dove|piccol\w*|pour|lorsque|quand|où|petit\w*|für|wenn|falls|bei|klein\w*|nur)\b",
    re.I,
)  # words of a remark by which a formula may hold only sometimes
GIVEN = r"\given"
COLUMN, END_COLUMN, NEXT = r"\column", r"\endcolumn", r"\next"  # signs round the rows of a vector, and between them


class Token(Frozen):
    """A token: `kind` is letter (with its character), digit, text, command, sign, row, ..."""

    kind: str
    text: str
    start: int
    end: int


def tokenize(source: SourceText, *, gaps: bool = False) -> tuple[Token, ...]:
    """The tokens of a LaTeX formula, with an end token; `gaps`: with wide spaces too. Raises ReadError, LimitError."""
    if len(source.text) > MAX_LENGTH:
        what = f"the formula has {len(source.text)} characters; at most {MAX_LENGTH} are read"
        raise LimitError(what, instead="Split it into smaller parts.")
    found = [token for token in _tokens(source) if gaps or token.kind != "gap"]
    for pass_over in (_arrayed, _underset, _divided, _unraised, _unbraced, _lowered, _given):
        found = pass_over(found)
    return (*found, Token("end", "", len(source.text), len(source.text)))


def _arrayed(tokens: list[Token]) -> list[Token]:
    r"""The tokens with the brackets behind \\mqty as the signs round a matrix."""
    for k, token in enumerate(tokens[:-1]):
        if token.text not in (r"\mqty", r"\pmqty", r"\bmqty", r"\vmqty"):
            continue
        if (end := closed(tokens, k + 1)) < len(tokens):
            opening, closing = (replace(tokens[at], kind="sign", text=text) for at, text in ((k, COLUMN), (end, END_COLUMN)))
            return _arrayed([*tokens[:k], opening, *tokens[k + 2 : end], closing, *tokens[end + 1 :]])
    return tokens


def _underset(tokens: list[Token]) -> list[Token]:
    r"""The tokens with \\underset{a}{b} as b_{a}, or as what a brace names where it stands below several."""
    for k, token in enumerate(tokens):
        end = closed(tokens, k + 1) if token.text == r"\underset" else len(tokens)
        if (last := closed(tokens, end + 1)) < len(tokens):
            named = [replace(token, text=r"\underbrace"), *tokens[end + 1 : last + 1]]
            of = named if last > end + 3 else tokens[end + 2 : last]
            behind = tokens[last + 1 :]
            return _underset([*tokens[:k], *of, replace(token, kind="sign", text="_"), *tokens[k + 1 : end + 1], *behind])
    return tokens


def _unraised(tokens: list[Token]) -> list[Token]:
    r"""The tokens with what is raised behind a mark as a power of its own, x^{\\prime 2}, c^{*2}."""
    for k in range(len(tokens) - 4):
        begin = end = k + 2
        while tokens[k].text == "^" and tokens[k + 1].text == "{" and tokens[end].text in ("'", "*", r"\star", r"\dagger"):
            end += 1
        if end > begin and tokens[end].text not in ("}", ",", "^", "_"):
            marks = tokens[begin:end] if tokens[begin].text == "'" else [tokens[k], *tokens[begin:end]]
            return [*tokens[:k], *marks, *_unraised([*tokens[k : k + 2], *tokens[end:]])]
    return tokens


def _lowered(tokens: list[Token]) -> list[Token]:
    """The tokens with what stands below a bracket in front of what stands above it, ]^b_a."""
    for k in range(len(tokens) - 3):
        if tokens[k].text in ("]", r"\rvert") and tokens[k + 1].text == "^":
            below = _behind_script(tokens, k + 2)
            if below < len(tokens) - 1 and tokens[below].text == "_":
                end = _behind_script(tokens, below + 1)
                tokens = [*tokens[: k + 1], *tokens[below:end], *tokens[k + 1 : below], *tokens[end:]]
    return tokens


def _behind_script(tokens: list[Token], k: int) -> int:
    """Where the argument of ^ or _ ends that begins there: a sign, braces, or a command with its braces."""
    end = closed(tokens, k) + 1
    while tokens[k].kind == "command" and end < len(tokens) and tokens[end].text == "{":
        end = closed(tokens, end) + 1
    return end


_OPENING, _CLOSING = ("(", "[", "{", r"\{", r"\lvert"), (")", "]", "}", r"\}", r"\rvert")
_TAKING = ("command", "text", "begin")
_DIVIDING = {r"\over": r"\frac", r"\choose": r"\binom"}


def _divided(tokens: list[Token]) -> list[Token]:
    r"""The tokens with {a \\over b} as \\frac{a}{b}, and (a \\over b) as (\\frac{a}{b}); so \\choose."""
    place = next((k for k, token in enumerate(tokens) if token.text in _DIVIDING), None)
    if place is None:
        return tokens
    begin, depth = place, 0
    while begin and depth >= 0:
        begin -= 1
        depth += (tokens[begin].text in _CLOSING) - (tokens[begin].text in _OPENING)
    end = closed(tokens, begin)
    if depth >= 0 or end == len(tokens):
        return tokens
    over, inner = tokens[place], tokens[begin].text == "{"
    one, last = (replace(over, kind="sign", text=text) for text in "{}")
    made = [replace(over, text=_DIVIDING[over.text]), one, *tokens[begin + 1 : place], last, one, *tokens[place + 1 : end], last]
    return _divided([*tokens[: begin + (not inner)], *made, *tokens[end + inner :]])


def closed(tokens: Sequence[Token], k: int) -> int:
    """Where the brackets are closed that open there; the last place, if nowhere."""
    depth = 0
    for end in range(k, len(tokens)):
        depth += (tokens[end].text in _OPENING) - (tokens[end].text in _CLOSING)
        if not depth:
            return end
    return len(tokens)


def _unbraced(tokens: list[Token]) -> list[Token]:
    """The tokens without braces round a letter that has a subscript or prime behind them, {v}_1."""
    dropped, argued = set[int](), _argued(tokens)
    for k, token in enumerate(tokens):
        texts = [found.text for found in tokens[k : k + 5]]
        if token.text == r"\boldsymbol" and texts[1:4] in _BRACED_SIGNS:
            dropped |= {k, k + 1, k + 3}
        if texts[:3] in _BRACED_SIGNS and tokens[k - 1].text not in ("^", "_"):
            dropped |= {k, k + 2}
        free = k == 0 or not (tokens[k - 1].kind in _TAKING or tokens[k - 1].text in ("^", "_", "]") or k - 1 in argued)
        twice = texts[:2] == ["{", "{"] != texts[1:3]
        if (twice or (free and texts[:2] == ["{", "("])) and closed(tokens, k + 1) == closed(tokens, k) - 1:
            dropped |= {k, closed(tokens, k)}  # {{x}}, f{\left(x \right)}
        for size in (2, 3) if token.text == "{" else ():
            inner = tokens[k + 1 : k + size]
            named = size == 2 or (bool(inner) and inner[0].kind == "command" and inner[0].text[1:] not in FUNCTION_WORDS)
            alone = bool(inner) and inner[-1].kind in ("letter", "text") and named
            alone = alone or (size == 2 and "".join(texts[1:2])[1:] in FUNCTION_WORDS)
            if alone and free and texts[size:][:2] in (["}", "_"], ["}", "'"], ["}", "^"]):
                dropped |= {k, k + size}
    return [token for k, token in enumerate(tokens) if k not in dropped]


def _given(tokens: list[Token]) -> list[Token]:
    """The tokens with a bar that stands alone in brackets, as in P(A|B) or {x | x > 0}, as a relation of its own."""
    alone, begun = set[int](), list[tuple[str, list[int]]]()
    for k, token in enumerate(tokens):
        if token.text in (*_OPENING, "⟨"):
            begun.append((token.text, []))
        elif token.text in (*_CLOSING, "⟩") and begun:
            opening, bars = begun.pop()
            single = len(bars) == 1 or (len(bars) % 2 and token.text == r"\}")
            alone |= {*bars[:1]} if single and opening in ("(", "[", r"\{") and token.text in (")", "]", r"\}") else set()
        elif token.text == "|" and begun and tokens[k + 1 : k + 2] and tokens[k + 1].text != "_":
            begun[-1][1].append(k)
    return [replace(token, text=GIVEN) if k in alone else token for k, token in enumerate(tokens)]


_BRACED_SIGNS = [["{", sign, "}"] for sign in (r"\cdot", r"\times", "+", "-", "=", "[", "]")]


def _argued(tokens: list[Token]) -> set[int]:
    """Where braces end that are a command's argument: what stands behind may be a further one."""
    found, begun = set[int](), list[int]()
    for k, token in enumerate(tokens):
        if token.text == "{":
            begun.append(k)
        elif token.text == "}" and begun:
            begin = begun.pop()
            if begin and (tokens[begin - 1].kind in _TAKING or tokens[begin - 1].text == "]" or begin - 1 in found):
                found.add(k)
    return found


@cache
def _patterns() -> re.Pattern[str]:
    """Of the tokens; compiled where LaTeX is read, not where the house is entered."""
    return re.compile(_PATTERNS)


def _tokens(source: SourceText) -> Iterator[Token]:
    position = 0
    while position < len(source.text):
        found = _patterns().match(source.text, position)
        if found is None or (found.lastgroup == "letter" and combining(source.text[found.end() : found.end() + 1] or "x")):
            yield from (made := _single(source, position))
            position = made[-1].end
            continue
        if found.lastgroup not in ("blank", "silent", "each"):
            apart = found.lastgroup == "text" and found[0].startswith(r"\q")
            yield from [Token("gap", r"\quad", found.start(), found.start())] * apart
            yield _token(source, found)
            yield from [Token("gap", r"\quad", found.end(), found.end())] * apart
        position = found.end()


def _single(source: SourceText, position: int) -> list[Token]:
    """A character beyond ASCII: a letter, or the tokens of what it stands for. Raises ReadError for others."""
    char = source.text[position]
    latex, end = as_latex(source.text, position)
    letter = SAME_LETTER.get(char, char) if end == position + 1 and char not in "∑∏" else ""
    if letter in NAME_OF_LETTER:
        return [Token("letter", letter, position, position + 1)]
    if not latex and char.isalpha() and SCRIPTED.search(source.text, 0, position):
        return [Token("text", char, position, position + 1)]
    if not latex:
        raise refused(source, char, position)
    return [replace(token, start=position, end=end) for token in _tokens(SourceText(latex))]


SCRIPTED = re.compile(r"[_^]\s*(?:\{[^{}]*)?$")  # where a word is a mark, and joins nothing


def _token(source: SourceText, found: re.Match[str]) -> Token:
    kind, text = found.lastgroup or "", found[0]
    if kind == "begin":
        return _environment(source, text, *found.span())
    if kind == "text" and _text(text)[0] == "row" and SCRIPTED.search(source.text, 0, found.start()):
        return Token("text", re.sub(r".*\{|\}.*", "", text).strip(), *found.span())
    return Token(*(_DRAWN[kind](text) if kind in _DRAWN else (kind, spelled().get(text, text))), *found.span())


def _text(text: str) -> tuple[str, str]:
    """Upright text; a word such as `and` between relations begins a new one."""
    bare = re.sub(r"^\\q(?!q)|^(?:\\[a-z]+\*?)?\s*\{?|\}$|\\(?:rm|bf)(?![A-Za-z])|~|\\[ ,]", " ", text)
    word = re.sub(r"\s+", " ", bare).strip()
    if word in FUNCTION_WORDS and text.startswith((r"\mathrm", r"\operatorname", r"\rm", "{")):
        return "command", rf"\{word}"
    if re.fullmatch(r"\\[A-Za-z]+", word):
        return _command(word)
    if word == "d" and text[0] == "{":
        return "differential", word
    plain = "" if text.startswith((r"\mathrm", r"\operatorname")) or re.fullmatch(r"\\[a-z]+\s+\w", text) else word.strip(" ,;:.")
    if plain in words("conditional"):
        return "row", CONDITION
    if text.startswith(r"\qc"):
        return "row", ""
    if word in (*PUNCTUATION, *"+-=()[]"):
        return "sign", word
    joining = words("joining")
    return "row" if plain in joining or (plain and joining.issuperset(plain.split())) else "text", word


def _command(text: str) -> tuple[str, str]:
    text = spelled().get(text, text)
    letter = LETTERS.get(text[1:].removesuffix("up")) or (LETTERS.get(text[4:]) if text.startswith(r"\var") else None)
    return ("letter", letter) if letter else ("command" if text.startswith("\\") else "sign", text)


_DRAWN: dict[str, Callable[[str], tuple[str, str]]] = {  # what is drawn in several ways: its kind and text
    "text": _text, "command": _command, "mark": lambda text: ("sign", text.strip("{}") if "." in text else text),
    "plain": lambda text: ("command", rf"\{text}"),  # sin(x) is no product of three letters
    "differential": lambda text: ("differential", "∂" if "partial" in text else "d"),
    "bar": lambda text: ("sign", r"\rvert" if text.startswith((r"\right", r"\bigr")) else r"\lvert"),
    "row": lambda text: ("row", "\\\\" if text == r"\newline" else text if text[1] == "\\" else _ARROWS.get(text, "so")),
    "over": lambda text: _command(text[text.rindex("{") + 1 : -1].strip()),  # a word on a sign, which says why
    "zero": lambda _: ("digit", "0"),  # the vector zero is printed as a bold number
    "gradient": lambda _: ("command", r"\nabla"), "degree": lambda _: ("sign", "°"),
    "arrow": lambda text: ("row", IMPLIED) if text.startswith(r"\xR") else ("command", r"\to"),  # and a word how one gets there
    "word": lambda text: ("text", text),  # of a text in Chinese, Japanese or Korean
    "dots": lambda _: ("command", r"\dots"), "empty": lambda text: ("sign", re.sub(r"\s", "", text)),
}  # fmt: skip


def _is_column(whole: str, name: str, text: str, start: int, end: int) -> bool:
    """Is it (or its end) an array in brackets, or what a relation gives by cases, and no rows of relations?"""
    if text.startswith(r"\end"):
        start = whole.rfind(rf"\begin{{{name}}}", 0, start)
    before = whole[: max(start, 0)].rstrip().removesuffix(r"\displaystyle").rstrip(" &")
    before = re.sub(r"(?<=[\[(|])\s*\{$", "", before)  # \left[ {\begin{array}
    cut = re.sub(r"(?:\\left\s*)?\\(?:\{|lbrace)$", "", before).rstrip(" &")
    if name == "aligned" and cut == before:
        return False
    related = re.search(r"(?:[=<>]|\\(?:approx|propto|sim|simeq|equiv|[lg]eq?))$", cut)
    return bool(related) if name in ("cases", "dcases") or cut != before else before[-1:] in ("[", "(", "|")


def _environment(source: SourceText, text: str, start: int, end: int) -> Token:
    name = text.partition("{")[2].partition("}")[0]
    by_cases = name in ("array", "cases", "dcases", "aligned") and _is_column(source.text, name, text, start, end)
    if name.removesuffix("*") in words("columns") or by_cases:
        return Token("sign", COLUMN if text.startswith(r"\begin") else END_COLUMN, start, end)
    if name not in words("rows"):
        what = f"the environment “{name[:40]}” can't be read"
        raise source.error(what, start, end, "Use aligned, or write one formula.")
    return Token("begin", rf"\{text[1:].partition('{')[0].strip()}{{{name}}}", start, end)
