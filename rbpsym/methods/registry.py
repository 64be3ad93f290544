"""The methods, in the order in which the notes tell them. A new method is a new file and a new entry."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.algebra import Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.methods import conservation, newton_euler, torque, work_energy

Method = Callable[[Draft], Mapping[str, Scalar] | None]

METHODS: Mapping[str, Method] = {module.NAME: module.write for module in (torque, newton_euler, work_energy, conservation)}
