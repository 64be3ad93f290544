"""Readers that others wrote, each in a process of its own: pyslet and citolab-qti-convert (QTI 2.1), qti2latex (Canvas),
moodle-xml-parser, gift-pegjs, Maxima.

Called as `python -m tests.teaching.readers NAME FILE`, it prints what the reader found as JSON.
"""

from __future__ import annotations

import glob
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from tests.npm import MODULES

ROOT = Path(__file__).resolve().parents[2]
REQUIRED = bool(os.environ.get("RBPSYM_REQUIRE_TOOLS"))


def need(found: object, what: str) -> None:
    """Skip a test whose reader is not there; fail where all of them must be."""
    if not found:
        assert not REQUIRED, f"{what} is not installed"
        pytest.skip(f"{what} is not installed")


def by_python(name: str, path: Path, *more: str) -> object:
    """What a reader of this file finds."""
    need(importlib.util.find_spec(name), name)
    call = [sys.executable, "-W", "ignore", "-m", "tests.teaching.readers", name, str(path), *more]
    done = subprocess.run(call, cwd=ROOT, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


GIFT = """
const {parse} = require(process.argv[1] + '/gift-pegjs');
const text = require('fs').readFileSync(process.argv[2], 'utf8');
console.log(JSON.stringify(parse(text)));
"""


def by_gift_pegjs(path: Path) -> list[dict]:
    """The questions that gift-pegjs reads."""
    need(shutil.which("node") and (MODULES / "gift-pegjs").is_dir(), "gift-pegjs")
    done = subprocess.run(
        ["node", "-e", GIFT, str(MODULES), str(path)], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def by_maxima(lines: list[str]) -> list[str]:
    """What Maxima prints for each line."""
    need(shutil.which("maxima"), "maxima")
    text = "display2d:false$\n" + "".join(f'{line}$\nprint("=>", %)$\n' for line in lines)
    done = subprocess.run(
        ["maxima", "--very-quiet"], input=text, capture_output=True, text=True, timeout=120, check=False
    )
    return [line.split("=>", 1)[1].strip() for line in done.stdout.splitlines() if "=>" in line]


# --- run in their own process


def _pyslet(folder: str, asked: str) -> object:
    """The SCORE and FEEDBACK that pyslet's engine gives for responses [(file, {name: value})]; it reads every file first."""
    import pyslet.qtiv2.variables as variables
    import pyslet.qtiv2.xml as qti
    from pyslet.rfc2396 import URI

    def load(path: str) -> object:
        document = qti.QTIDocument(base_uri=URI.from_path(path))
        document.read()
        return document.root

    read = {
        os.path.basename(path): type(load(path)).__name__
        for path in sorted(glob.glob(f"{folder}/*.xml"))
        if "manifest" not in path
    }
    scores = []
    for file, responses in json.loads(asked):
        item = load(f"{folder}/{file}")
        state = variables.ItemSessionState(item)
        state.begin_session()
        with suppress(AttributeError):  # it would draw the item
            state.begin_attempt()
        for name, value in responses.items():
            state[name].set_value(value)
        item.ResponseProcessing.run(state)
        scores.append([state["SCORE"].value, state["FEEDBACK"].value])
    return {"read": read, "scores": scores}


def _qti2latex(path: str) -> object:
    """Type, points, number of options and right ones of each item, as qti2latex reads them."""
    import xml.etree.ElementTree as Tree

    import qti2latex as reader

    folder = reader.extract_zip_to_tmp(Path(path))
    file = next(p for p in Path(folder).rglob("*.xml") if p.name not in ("imsmanifest.xml", "assessment_meta.xml"))
    found = []
    for item in reader.findall_anyns(Tree.parse(file).getroot(), "item"):
        fields = reader.get_qti_metadata(item)
        right = sorted(reader.get_correct_idents(item))
        found.append([reader.guess_type(fields, item), fields["points_possible"], len(reader.get_choices(item)), right])
    shutil.rmtree(folder)
    return found


def _citolab(path: str) -> object:
    """The parts of each item as citolab's converter makes QTI 3.0 of them: interactions, right responses, pictures."""
    import tempfile
    import xml.etree.ElementTree as Tree
    import zipfile

    folder = Path(tempfile.mkdtemp())
    command = [str(Path(sys.executable).parent / "qti-convert"), "upgrade", path, str(folder / "new.zip")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(folder / "new.zip") as package:
        roots = {n: Tree.fromstring(package.read(n)) for n in package.namelist() if n.startswith("q-item")}
    shutil.rmtree(folder)
    found = {}
    for name, root in roots.items():
        tags = [part.tag.partition("}")[2] for part in root.iter()]
        right = [value.text for part in root.iter() if part.tag.endswith("}qti-correct-response") for value in part]
        pictures = [part.get("alt") for part in root.iter() if part.tag.endswith("}img")]
        found[name] = {
            "interactions": sorted({t for t in tags if t.endswith("-interaction")}),
            "right": right,
            "alt": pictures,
        }
    return found


def _moodle_xml_parser(path: str) -> object:
    """Of multiple choices: the fractions; of clozes: the options of each field with their fractions."""
    from moodle_xml_parser.parser import parse_file

    found = parse_file(path)
    return {
        "multichoice": [[option.score_fraction for option in q.options] for q in found["multichoice"]],
        "cloze": [
            [[[o.answer, o.score] for o in gap.options] for gap in q.gaps if gap.sub_type == "MULTICHOICE"]
            for q in found["cloze"]
        ],
    }


if __name__ == "__main__":
    known = {
        "pyslet": _pyslet, "qti2latex": _qti2latex, "qti_convert": _citolab, "moodle_xml_parser": _moodle_xml_parser,
    }  # fmt: skip
    print(json.dumps(known[sys.argv[1]](*sys.argv[2:])))
