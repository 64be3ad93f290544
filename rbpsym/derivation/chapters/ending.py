"""The end of a phase, and how places and speeds at that moment are called: x_1, v_1."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.derivation.draft import Draft
from rbpsym.mechanics.state import State
from rbpsym.statement.model import Phase


@dataclass(frozen=True)
class Ending:
    """The end of the phase number `number` (counted from 1) that begins `phase`."""

    phase: Phase
    number: int
    state: State


def place_name(draft: Draft, coordinate: str, number: int) -> str:
    """x_1: the coordinate at the end of phase 1."""
    return draft.free(f"{coordinate}_{number}")


def speed_name(draft: Draft, coordinate: str, number: int) -> str:
    """x_1_dot, or v_1 where the speed is called v."""
    alias = draft.study.problem.notation.get(f"{coordinate}_dot")
    return draft.free(f"{alias}_{number}" if alias else f"{coordinate}_{number}_dot")
