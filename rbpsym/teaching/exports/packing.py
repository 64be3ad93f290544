"""Zip packages that are the same bytes on every machine."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Mapping

_LONG_AGO = (1980, 1, 1, 0, 0, 0)


def zipped(files: Mapping[str, bytes | str]) -> bytes:
    """A package of files by path, in the order of their paths. Raises ValueError for a path that leads out of it."""
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as package:
        for path, content in sorted(files.items()):
            if path.startswith("/") or ".." in path.split("/") or "\\" in path:
                raise ValueError(f"the path {path} leads out of the package")
            entry = zipfile.ZipInfo(path, _LONG_AGO)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            package.writestr(entry, content)
    return held.getvalue()


def slug(text: str) -> str:
    """A text as a part of a file name: letters, digits, dots and dashes."""
    return re.sub(r"[^A-Za-z0-9.]+", "-", text).strip("-.")[:80] or "worksheet"


def identifier(text: str) -> str:
    """A text as an identifier of XML."""
    return "q-" + re.sub(r"[^A-Za-z0-9]+", "-", text).strip("-")
