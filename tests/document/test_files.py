"""Files are written whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from rbpsym.document.files import write_whole
from rbpsym.errors import RbpsymError


def test_text_and_bytes_are_written_and_replaced(tmp_path: Path) -> None:
    target = tmp_path / "new" / "notes.html"
    write_whole(target, "ä")
    assert target.read_text(encoding="utf-8") == "ä"
    write_whole(target, b"\x00")
    assert target.read_bytes() == b"\x00"
    assert list(target.parent.iterdir()) == [target]


def test_what_cannot_be_written_is_a_sentence_and_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(RbpsymError, match="can't write"):
        write_whole(tmp_path / "file" / "notes.html", "x")
    (tmp_path / "folder" / "inner").mkdir(parents=True)
    with pytest.raises(RbpsymError, match="can't write"):
        write_whole(tmp_path / "folder", "x")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]
