"""Certificates of earlier runs, keyed by the content of all they depend on.

A key is the digest of the engine's own source, of the problem's file, and of the claim: formula,
meanings, what is given. Nothing is taken over from a run that saw anything else.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from hashlib import blake2b
from pathlib import Path

from rbpsym.verify.claims_model import Claim, Link, Outcome, Printed, Result, Setting, told_of

MOST = 20_000
NAME = "certificates.json"
_PACKAGE = Path(__file__).resolve().parent.parent


def default_folder() -> Path:
    """The folder of the user's caches."""
    root = os.environ.get("XDG_CACHE_HOME")
    return (Path(root) if root else Path.home() / ".cache") / "rbpsym"


def digest(*parts: str | bytes) -> str:
    """The digest of some texts."""
    whole = blake2b(digest_size=16)
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        whole.update(len(data).to_bytes(8) + data)
    return whole.hexdigest()


def engine() -> str:
    """The digest of the engine: any change of its source makes all certificates void."""
    return digest(*(part for path in sorted(_PACKAGE.rglob("*.py")) for part in (path.name, path.read_bytes())))


@dataclass(frozen=True)
class Certificates:
    """The certificates of a folder; `store` writes them back whole."""

    folder: Path | None
    engine: str = ""
    draws: bool = False
    entries: dict[str, dict] = field(default_factory=dict)
    new: list[str] = field(default_factory=list)

    @classmethod
    def opened(cls, folder: Path | None, draws: bool = False) -> Certificates:
        """The certificates of a folder; None remembers nothing. `draws`: formulas in MathML are wanted."""
        if folder is None:
            return cls(None, draws=draws)
        return cls(folder, engine(), draws, _loaded(folder / NAME))

    def get(self, key: str) -> Result | None:
        """The result under a key."""
        entry = self.entries.get(key)
        try:
            found = None if entry is None else _result(entry)
        except (KeyError, TypeError, ValueError):
            return None
        drawn = found is None or not self.draws or all(link.mathml for link in found.links)
        return found if drawn else None

    def put(self, key: str, result: Result) -> None:
        """Remember a result."""
        if self.folder is not None and key:
            self.entries[key] = _entry(result)
            self.new.append(key)

    def store(self) -> None:
        """Write the certificates back, the newest if they are too many; a folder that can't be written is no error."""
        if self.folder is None or not self.new:
            return
        kept = dict(list(self.entries.items())[-MOST:])
        target = self.folder / NAME
        waiting = target.with_suffix(f".{os.getpid()}.part")
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            waiting.write_text(json.dumps(kept, ensure_ascii=False), encoding="utf-8")
            waiting.replace(target)
        except OSError:
            with suppress(OSError):
                waiting.unlink(missing_ok=True)


def _loaded(path: Path) -> dict[str, dict]:
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _entry(result: Result) -> dict:
    kept = asdict(result)
    for key in ("cached", "seconds", "declared"):
        kept.pop(key)
    return kept


def _result(entry: dict) -> Result:
    links = tuple(Link(**{**link, "outcome": Outcome(link["outcome"])}) for link in entry["links"])
    return Result(**{**entry, "outcome": Outcome(entry["outcome"]), "links": links, "cached": True})


def key_of(claim: Claim, printed: Printed | None, problem: bytes, made_by: str) -> str:
    """The key of a claim; "" for one that depends on what another claim defines."""
    setting, formula = claim.setting, printed or claim.printed
    if formula is None or not made_by or _uses_definition(setting, formula.latex):
        return ""
    return digest(
        made_by,
        problem,
        setting.theory,
        setting.phase,
        str(setting.fixed_axis),
        *_symbols(setting),
        formula.latex,
        claim.holds,
        claim.expect,
        claim.right.latex if claim.right else "",
        claim.not_computed,
    )


def _symbols(setting: Setting) -> Iterable[str]:
    for latex, meaning in sorted(setting.symbols.items()):
        yield from (latex, meaning.phrase)
    yield from (given.latex for given in setting.given)


def _uses_definition(setting: Setting, latex: str) -> bool:
    plain = "".join(latex.split())
    defined = (name for name, meaning in setting.symbols.items() if meaning.phrase.strip() == "defined here")
    return any("".join(name.split()) in plain for name in defined)


def as_told(found: Result, claim: Claim) -> Result:
    """A remembered result with what the claim says today of its place and its words."""
    return replace(found, **told_of(claim))
