"""All misconceptions by name. A new one is an entry of the table of its module, and phrases."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path

from rbpsym.teaching.misconceptions import energy, forces, inertia, joints
from rbpsym.teaching.misconceptions.model import Misconception

MISCONCEPTIONS: Mapping[str, Misconception] = {
    item.name: item for module in (joints, inertia, forces, energy) for item in module.MISCONCEPTIONS
}


# --- where the misconceptions are described: papers and books by key, and the keys of each misconception


_TABLES = tomllib.loads(Path(__file__).with_name("literature.toml").read_text(encoding="utf-8"))
SOURCES: Mapping[str, str] = _TABLES["sources"]
DESCRIBED: Mapping[str, list[str]] = _TABLES["described"]
