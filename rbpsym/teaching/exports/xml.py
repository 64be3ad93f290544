"""XML files from the shells of `templates/lms`: every text is escaped there, what is markup already says so."""

from __future__ import annotations

import re

from rbpsym.document.writers.page import shell

_BAD = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")


def filled(shell_name: str, /, **values: object) -> str:
    """A shell with its places filled, without characters that no XML file can hold."""
    return _BAD.sub("\ufffd", shell(f"lms/{shell_name}", autoescape=True, **values))


def written(shell_name: str, /, **values: object) -> bytes:
    """The XML file."""
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + filled(shell_name, **values).encode("utf-8")
