"""Where the misconceptions are described: papers and books by key, and the keys of each misconception."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path

_TABLES = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
SOURCES: Mapping[str, str] = _TABLES["sources"]
DESCRIBED: Mapping[str, list[str]] = _TABLES["described"]
