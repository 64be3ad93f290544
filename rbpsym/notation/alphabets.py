"""Mathematical alphabets of Unicode: script and bold letters, superscripts and subscripts."""

from __future__ import annotations

_SCRIPT_EXCEPTIONS = dict(zip("BEFHILMRego", "ℬℰℱℋℐℒℳℛℯℊℴ", strict=True))
_SUPERSCRIPTS = dict(zip("0123456789+−=()nix/-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱˣᐟ⁻", strict=True))
_SUBSCRIPTS = dict(zip("0123456789+−=()aehijklmnoprstuvxβγρϕχ-",
                       "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ₋", strict=True))  # fmt: skip


def script(letter: str) -> str:
    """The calligraphic form of a Latin letter, other characters as they are."""
    return _SCRIPT_EXCEPTIONS.get(letter) or _shifted(letter, 0x1D49C, 0x1D4B6, None)


def bold(letter: str) -> str:
    """The bold upright form of a Latin or Greek letter, other characters as they are."""
    return _shifted(letter, 0x1D400, 0x1D41A, 0x1D6C2)


def _shifted(letter: str, capital: int, small: int, greek: int | None) -> str:
    if letter.isascii() and letter.isalpha():
        return chr(ord(letter) - ord("A") + capital if letter.isupper() else
                   ord(letter) - ord("a") + small)  # fmt: skip
    if greek and "α" <= letter <= "ω":
        return chr(ord(letter) - ord("α") + greek)
    return letter


def superscript(text: str) -> str | None:
    """The text in superscript characters, None if one is missing."""
    return _mapped(text, _SUPERSCRIPTS)


def subscript(text: str) -> str | None:
    """The text in subscript characters, None if one is missing."""
    return _mapped(text, _SUBSCRIPTS)


def _mapped(text: str, table: dict[str, str]) -> str | None:
    return "".join(table[c] for c in text) if text and all(c in table for c in text) else None
