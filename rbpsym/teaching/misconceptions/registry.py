"""All misconceptions by name. A new one is an entry of the table of its module, and phrases."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path

from rbpsym.teaching.misconceptions import blows, energy, forces, inertia, joints
from rbpsym.teaching.misconceptions.model import Misconception

MODULES = (joints, inertia, forces, energy, blows)
MISCONCEPTIONS: Mapping[str, Misconception] = {item.name: item for module in MODULES for item in module.MISCONCEPTIONS}


# --- where the misconceptions are described: papers and books by key, and the keys of each misconception


_TABLES = tomllib.loads(Path(__file__).with_name("literature.toml").read_text(encoding="utf-8"))
SOURCES: Mapping[str, str] = _TABLES["sources"]
DESCRIBED: Mapping[str, list[str]] = _TABLES["described"]
