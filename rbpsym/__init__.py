"""rbpsym: symbolic derivations for the plane motion of rigid bodies.

A problem is data; the engine derives its equations step by step, proves every step and writes
lecture notes. The public names are loaded when they are first used.
"""

from __future__ import annotations

__version__ = "0.1.0"
