"""The language in which values show themselves in a notebook: English, until `speak` names another."""

from __future__ import annotations

from rbpsym.document.phrases import phrases

_CHOSEN = {"language": "en"}  # what a notebook chose: values know nothing of the language of their reader


def speak(language: str) -> None:
    """Let values show themselves in a language from now on. Raises DocumentError if there are no phrases in it.

    >>> speak("en")
    """
    phrases(language)
    _CHOSEN["language"] = language


def spoken() -> str:
    """The language that was chosen."""
    return _CHOSEN["language"]
