r"""LaTeX that survives Markdown: on GitHub, formulas pass through the reader of Markdown before MathJax.

Taken for emphasis: an underscore after a bracket (github.com/github/markup, issue 1575). Taken for
escapes: a backslash before punctuation. Taken for HTML: < and >. Unknown to MathJax: \mathpzc.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from rbpsym.notation.letters import script

COMMANDS: Mapping[str, str] = {r"\,": r"\thinspace ", r"\{": r"\lbrace ", r"\}": r"\rbrace ", r"\;": r"\thickspace "}


def in_markdown(latex: str) -> str:
    """The same formula, written so that no part of it is taken for Markdown."""
    for command, word in COMMANDS.items():
        latex = latex.replace(command, word)
    latex = re.sub(r"\\mathpzc\{(\w)\}", lambda found: script(found[1]), latex)
    latex = re.sub(r"(?<=[^\w\s\\])_", "_ ", latex)
    latex = re.sub(r" *([<>]) *", lambda found: {"<": r" \lt ", ">": r" \gt "}[found[1]], latex)
    return latex.replace("](", "] (").replace("*", r"\ast ")


def in_cell(text: str) -> str:
    """Text of a cell on one line; the bars of formulas would part cells (those of words are escaped)."""
    return re.sub(r"(?<!\\)\||(?<=\\left)\||(?<=\\right)\|", r"\\vert ", text.replace("\n", " "))


def wrapped(mark: str, text: str) -> str:
    """Emphasised text: the marks must stand at letters, not at spaces."""
    inner = text.strip()
    if not inner:
        return text
    before, after = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
    return f"{before}{mark}{inner}{mark}{after}"
