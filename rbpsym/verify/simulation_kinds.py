"""Which kind of constraint is simulated how (the joints of points stand in `simulation_joints`)."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.statement.model import Element
from rbpsym.verify.simulation_bodies import Mechanism, State
from rbpsym.verify.simulation_contacts import holding, meshing, slider, sliding
from rbpsym.verify.simulation_drives import driven_angle, driven_point
from rbpsym.verify.simulation_joints import Kept
from rbpsym.verify.simulation_strings import string

KINDS: Mapping[str, Callable[[Element, Mechanism, State], list[Kept]]] = {
    "contact": sliding,
    "guide": sliding,
    "slider": slider,
    "touch": sliding,
    "rolling": holding,
    "gear": meshing,
    "sticking": holding,
    "string": string,
    "link": string,
    "prescribed": driven_point,
    "prescribed-angle": driven_angle,
}
