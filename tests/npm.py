"""The packages of npm that tests call: in .ci of this checkout, else of the one of which it is a worktree."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def _main_checkout() -> Path:
    link = ROOT / ".git"  # in a worktree a file: "gitdir: …/.git/worktrees/NAME"
    return Path(link.read_text(encoding="utf-8").split(maxsplit=1)[1].strip()).parents[2] if link.is_file() else ROOT


_PLACES = [root / ".ci" / "node_modules" for root in (ROOT, _main_checkout())]
MODULES = next((place for place in _PLACES if place.is_dir()), _PLACES[0])
