"""A remark as a proposition: its sentence, what stands in it, whether it is proved."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rbpsym.derivation.assertions import told
from rbpsym.derivation.step import Certificate, Step
from rbpsym.equality.verdict import Verdict
from rbpsym.notation.tree import ZERO


@dataclass(frozen=True)
class Made:
    """key and slots of its phrase; `about`: what it says, so that it is said once in a text."""

    key: str
    slots: Mapping[str, Any]
    verdict: Verdict
    about: tuple[str, ...]

    def said(self) -> Step:
        """As a step with a sentence that is true: none if it is not proved."""
        certificate = Certificate(("remark",), self.verdict)
        return told(Step("remark", "remark", ZERO, "remarks", self.key, self.slots, certificate=certificate))
