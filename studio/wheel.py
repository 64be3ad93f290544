"""Packs the built site as a wheel of its own: python studio/wheel.py SITE OUT; installed, “rbpsym studio” serves it."""

import sys
import tomllib
import zipfile
from base64 import urlsafe_b64encode
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

PROJECT = Path(__file__).parents[1] / "pyproject.toml"
FIRST = (1980, 1, 1, 0, 0, 0)  # the same site gives the same bytes


def contents(site: Path, version: str) -> Iterator[tuple[str, bytes]]:
    """(name, content) of all files but the list of them."""
    yield "rbpsym_studio/__init__.py", b'"""The built page of the studio: `rbpsym studio` serves what is in `site`."""\n'
    for path in sorted(path for path in site.rglob("*") if path.is_file()):
        yield f"rbpsym_studio/site/{path.relative_to(site).as_posix()}", path.read_bytes()
    about = ("Metadata-Version: 2.1", "Name: rbpsym-studio", f"Version: {version}", "License: MIT",
             f"Requires-Dist: rbpsym=={version}",
             "Summary: The studio of rbpsym: a page in which one states a problem and sees it derived.")  # fmt: skip
    kind = ("Wheel-Version: 1.0", "Generator: rbpsym", "Root-Is-Purelib: true", "Tag: py3-none-any")
    for name, lines in (("METADATA", about), ("WHEEL", kind)):
        yield f"rbpsym_studio-{version}.dist-info/{name}", "\n".join([*lines, ""]).encode()


def write(site: Path, out: Path) -> Path:
    """The wheel of a built site, in a folder."""
    version = tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]["version"]
    files = list(contents(site, version))
    record = f"rbpsym_studio-{version}.dist-info/RECORD"
    sums = [f"{name},sha256={urlsafe_b64encode(sha256(made).digest()).decode().rstrip('=')},{len(made)}" for name, made in files]
    out.mkdir(parents=True, exist_ok=True)
    path = out / f"rbpsym_studio-{version}-py3-none-any.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, made in (*files, (record, "\n".join([*sums, f"{record},,", ""]).encode())):
            wheel.writestr(zipfile.ZipInfo(name, FIRST), made, zipfile.ZIP_DEFLATED)
    return path


if __name__ == "__main__":
    print(write(*map(Path, sys.argv[1:3])))
