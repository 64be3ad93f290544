"""All misconceptions by name. A new one is an entry of the table of its module, and phrases."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.teaching.misconceptions import energy, forces, inertia, joints
from rbpsym.teaching.misconceptions.model import Misconception

MISCONCEPTIONS: Mapping[str, Misconception] = {
    item.name: item for module in (joints, inertia, forces, energy) for item in module.MISCONCEPTIONS
}
