"""sympy, imported when something of it is asked for: who states problems in text never waits for it."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import sympy as sympy
    from sympy.physics import mechanics as mechanics
else:

    class Late:
        """A module that is imported when an attribute is asked for."""

        def __init__(self, name: str) -> None:
            self.name = name

        def __getattr__(self, attribute: str) -> Any:
            return getattr(import_module(self.name), attribute)

    sympy, mechanics = Late("sympy"), Late("sympy.physics.mechanics")
