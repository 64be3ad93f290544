"""Where the misconceptions are described: papers and books, by key."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path

SOURCES: Mapping[str, str] = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
