"""The methods, in the order in which the notes tell them. A new method is a new file and a new entry."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.chapters.methods import conservation, newton_euler, torque, work_energy
from rbpsym.field import Scalar
from rbpsym.proof.draft import Draft

Method = Callable[[Draft], Mapping[str, Scalar] | None]

METHODS: Mapping[str, Method] = {module.NAME: module.write for module in (torque, newton_euler, work_energy, conservation)}
