"""A misconception, and the places in a problem where a student may fall for it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from rbpsym.mechanics.study import Study


@dataclass(frozen=True, slots=True)
class Site:
    """Where a misconception applies in a problem: `slots` fill its feedback; `wrong()` is the study with it."""

    slots: Mapping[str, Any]
    wrong: Callable[[], Study]


@dataclass(frozen=True, slots=True)
class Misconception:
    """A misconception of the literature as an operator.

    name: its key, also of its phrases (`misconception.<name>`) and of `literature.DESCRIBED`; sites(study): where
    it applies, decided by the structure of the problem; about: kinds of targets (`targets.KINDS`, "axis-moment")
    that it can change. tells: chapters that a
    derivation with the slip must leave out to read as a student's (None: it does not read so at all).
    """

    name: str
    sites: Callable[[Study], Iterator[Site]]
    about: frozenset[str] = field(default_factory=frozenset)
    tells: frozenset[str] | None = None


MOTION = frozenset({"acceleration", "reaction", "speed", "frequency", "work", "friction", "loss"})
SPIN = MOTION | {"momentum", "kinetic", "axis-moment"}
INERTIA = SPIN | {"moment"}
WORKS = frozenset({"work"})
FORCES = frozenset({"reaction", "work", "friction", "loss"})
ENERGY = frozenset({"speed", "reaction", "loss"})

WELL: frozenset[str] = frozenset()  # the derivation with the slip reads well as it is
NO_INERTIA = frozenset({"inertia"})  # it does from the angular momentum on
NO_FORCES = frozenset({"inertia", "forces"})
