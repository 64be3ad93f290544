"""Letters of formulas: Greek and special letters by name, Unicode, LaTeX command and word; alphabets of Unicode."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from unicodedata import combining, normalize

# name in a problem file -> the character; LaTeX writes all but LATIN_LOOKING as \name
LETTERS: Mapping[str, str] = MappingProxyType({
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ϵ", "varepsilon": "ε", "zeta": "ζ", "eta": "η",
    "theta": "θ", "vartheta": "ϑ", "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "omicron": "ο",
    "pi": "π", "rho": "ρ", "varrho": "ϱ", "sigma": "σ", "varsigma": "ς", "tau": "τ", "upsilon": "υ", "phi": "ϕ",
    "varphi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω", "varpi": "ϖ", "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ",
    "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Upsilon": "Υ", "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω", "ell": "ℓ",
    "hbar": "ℏ",
})  # fmt: skip

# names that Python or TeX reserve, as people write them instead
SPELLINGS: Mapping[str, str] = MappingProxyType({
    "lamda": "lambda", "lam": "lambda", "lambda_": "lambda", "infinity": "infty",
})  # fmt: skip

NAME_OF_LETTER: Mapping[str, str] = MappingProxyType({c: n for n, c in LETTERS.items()})

UPRIGHT_CAPITALS = frozenset("ΓΔΘΛΞΠΣΥΦΨΩ")

# other characters for the same letters, as keyboards and other programs give them
SAME_LETTER: Mapping[str, str] = MappingProxyType({
    "\u00b5": "μ", "\u2206": "Δ", "\u2126": "Ω", "\u220f": "Π", "\u2211": "Σ",
})  # fmt: skip


def letter_named(name: str) -> str | None:
    """The character of a letter's name ("theta" -> "θ"), None if it is no letter's name."""
    return LETTERS.get(SPELLINGS.get(name, name))


def latex_letter(char: str) -> str:
    """The LaTeX of one letter: "θ" -> "\\theta", "m" -> "m"."""
    name = NAME_OF_LETTER.get(char)
    return "o" if name == "omicron" else f"\\{name}" if name else char


_VARIANTS = (("phi", "varphi"), ("theta", "vartheta"), ("epsilon", "varepsilon"),
             ("rho", "varrho"), ("sigma", "varsigma"), ("pi", "varpi"))  # fmt: skip
_OTHER = {name: other for pair in _VARIANTS for name, other in (pair, pair[::-1])}


def names_of_letter(char: str) -> tuple[str, ...]:
    """The names that a typed letter may stand for, the likeliest first: φ is varphi or phi."""
    name = NAME_OF_LETTER.get(SAME_LETTER.get(char, char))
    return tuple(n for n in (name, _OTHER.get(name or ""), "lamda" if name == "lambda" else None)
                 if n)  # fmt: skip


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


def without_accents(text: str) -> str:
    """The text in plain letters: péndulo is pendulo."""
    return "".join(char for char in normalize("NFD", text) if not combining(char))
