"""Characters beyond ASCII -> the LaTeX that they stand for: ½ m v², ∂u/∂t, ẋ, 𝑥, as keyboards and other programs give them."""

from __future__ import annotations

import re
from unicodedata import category, decomposition, name, normalize

_MARKS = {"\u0307": r"\dot", "\u0308": r"\ddot", "\u20db": r"\dddot", "\u20d7": r"\vec", "\u0302": r"\hat", "\u0304": r"\bar"}
_ALPHABETS = {"BOLD": r"\boldsymbol", "SCRIPT": r"\mathcal", "FRAKTUR": r"\mathfrak", "DOUBLE-STRUCK": r"\mathbb"}
_WRITTEN = (  # each character with its LaTeX
    r"−- ×\times ·\cdot ⋅\cdot ⋆\star ∗* ∘\circ ⊗\otimes ⊕\oplus ∧\wedge ∨\vee ∩\cap ∪\cup ∖\setminus ÷/ ±\pm ∓\mp ≤\le "
    r"≥\ge ⩽\le ⩾\ge ≠\ne ≈\approx ≃\approx ≅\approx ≡= ≔= ∝\propto ∼\sim ≪\ll ≫\gg ≲\lesssim ≳\gtrsim ⊥\perp "
    r"∥\parallel ‖\| ∈\in ∉\notin ⊂\subset ⊆\subseteq →\to ←\gets ↔\leftrightarrow ↦\mapsto ⇒\Rightarrow ⟹\Rightarrow "
    r"⇔\iff ⟺\iff ∴\therefore ∵\because ∀\forall ∃\exists ∇\nabla ∞\infty ∅\emptyset □\Box ∂\partial ∑\sum ∏\prod ∫\int "
    r"∮\oint ⟨\langle ⟩\rangle ′' º° ⋯\dots ∠\angle †\dagger ħ\hbar"
)
_SIGNS = {written[0]: written[1:] for written in _WRITTEN.split()}
TYPED = re.compile(r"[^\W\d_][\u0300-\u036f\u20d0-\u20ff]+|[^\x00-\x7f]")


def as_latex(text: str, start: int) -> tuple[str, int]:
    """(the LaTeX of what is typed there, where that ends); "" where nobody writes it so."""
    found = TYPED.match(text, start)
    char, end = (found[0], found.end()) if found else (text[start], start + 1)
    tag, plain = decomposition(char[0]).partition(">")[0], normalize("NFKC", char)
    if char in _SIGNS or category(char[0]) == "Lo":
        return _SIGNS.get(char, ""), end
    if tag in ("<super", "<sub"):
        while end < len(text) and decomposition(text[end]).startswith(tag):
            end += 1
        return f"{'^' if tag == '<super' else '_'}{{{normalize('NFKC', text[start:end])}}}", end
    if tag == "<fraction":
        above, _, below = plain.partition("⁄")
        return rf"\frac{{{above}}}{{{below}}}", end
    if tag == "<font":
        heads = [head for word, head in _ALPHABETS.items() if word in name(char)]
        return f"{''.join(f'{head}{{' for head in heads)}{plain}{'}' * len(heads)}", end
    base, *marks = list(normalize("NFD", char))
    dotted = marks == ["\u0307"] or len(char) > 1  # ü is a letter
    if marks and dotted and _MARKS.keys() >= set(marks):
        return f"{''.join(_MARKS[mark] for mark in reversed(marks))}{{{base}}}", end
    return plain if tag in ("<compat", "<wide") else "", end
