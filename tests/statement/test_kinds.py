"""Every kind of the registries can be stated, is refused without its keys, and says its unknowns."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from rbpsym.elements.kinds import ElementKind, Field, known_names
from rbpsym.errors import RbpsymError
from rbpsym.statement import CONSTRAINTS, INTERACTIONS, SHAPES, build, load_text, unknowns_of
from rbpsym.statement.model import Element, Problem

REGISTRIES: Mapping[str, Mapping[str, ElementKind]] = {"interactions": INTERACTIONS, "constraints": CONSTRAINTS}
KINDS = [(section, kind) for section, kinds in REGISTRIES.items() for kind in kinds.values()]
OWN_KINDS = [(section, kind) for section, kind in KINDS if kind.name != "link"]  # which is read as a string
FIELDS = [(section, kind, field) for section, kind in KINDS for field in kind.fields]

# A sound value of each field kind that has no dimension of its own.
VALUES = {
    "point": "rod.end",
    "points": ["rod.end", "disk.center"],
    "body": "rod",
    "bodies": ["rod", "disk"],
    "two bodies": ["rod", "disk"],
    "line": "x = ell",
    "curve": "y = x^2/ell",
    "name": "kappa",
    "path": ["O", "rod.end"],
}
# What a kind needs instead: only a disk rolls, and a line (the default here) leaves no room for a circle or a curve.
OWN = {
    "touch": {"body": "disk", "of": "rod"},
    "rolling": {"body": "disk", "of": "rod"},
    "gear": {"body": "disk", "of": "rod"},
    "prescribed": {"of": "disk"},
    "prescribed-angle": {"of": "disk"},
    **{name: {"of": "disk"} for name in ("contact", "guide", "slider", "sticking")},
}
LEFT_OUT = ("circle", "radius", "curve", "beside")
# Of each field kind, what can't be.
WRONG = {
    "expression": ["", "((", "nobody", None, True, [], "1 +"],
    "pair": ["nowhere", ["0"], ["0", "0", "0"], 3, ["0", "nobody"], ["0", None]],
    "point": ["rod", "rod.", ".end", "rod.tip", "", 3, ["0"], ["0", "0", "0"]],
    "points": ["rod.end", ["rod.end"], ["rod.end", "rod.end"], ["rod.end", 3], []],
    "body": ["nobody", "", 3, None, ["rod"]],
    "bodies": ["rod", [], ["nobody"], 3],
    "two bodies": [["rod"], ["rod", "rod"], ["rod", "nobody"], "rod", ["rod", 1]],
    "line": ["x", "x = ", "= 0", "x = y = 0", "x*y = 0", "0 = 0", "x = 1/y", "sin(x) = 0", 3, "", "x < 0"],
    "curve": ["x", "y = ", "y = nobody", "x = y = 0", "y = y^2/ell", "y < x", 3, "", ["0"], ["0", "nobody"], ["0", None]],
    "choice": ["neither", 3, "", ["space"]],
    "name": ["", "a b", "pi", 3],
    "constraint": ["", "a b", "nothing", "E", 3],
    "path": [
        "rod.end",
        [],
        ["O"],
        ["rod.end", "rod.start"],
        ["rod.end", "disk"],
        ["rod.end", "up disk"],
        ["O", "O"],
        ["rod.end", "cw rod"],
        ["rod.end", {"around": "disk"}],
        ["rod.end", {"around": "disk", "sense": "up"}],
        3,
        ["rod.end", {"around": "disk", "sense": "cw", "smooth": True}],
    ],
}


def sound(field: Field) -> object:
    if field.kind == "choice":
        return field.choices[0]
    if field.dimension is None:
        return VALUES[field.kind]
    name = f"q_{field.name}"
    return [name, name] if field.kind == "pair" else name


def problem(section: str, table: dict[str, object], kind: ElementKind) -> Problem:
    own = {f"q_{field.name}": {"dimension": str(field.dimension)} for field in kind.fields if field.dimension}
    return build.problem(
        "test",
        parameters={"m": "mass", "ell": "length", "g": "acceleration", **own},
        coordinates={"theta": {}, "phi": {}},
        bodies={
            "rod": build.rod("ell", mass="m", start="O", angle="theta"),
            "disk": build.disk("ell", mass="m", angle="phi"),
        },
        **{section: {"E": table}},
    )


def stated(kind: ElementKind, **keys: object) -> dict[str, object]:
    own = OWN.get(kind.name, {})
    fields = {field.name: sound(field) for field in kind.fields if not own or field.name not in LEFT_OUT}
    return {"type": kind.name, **fields, **own, **keys}


def only(problem: Problem, section: str) -> Element:
    (element,) = getattr(problem, section)
    return element


@pytest.mark.parametrize(("section", "kind"), OWN_KINDS, ids=lambda x: getattr(x, "name", ""))
def test_every_kind_can_be_stated(section: str, kind: ElementKind) -> None:
    keys = {"reaction_on": "disk"} if kind.name == "couple" else {}
    element = only(problem(section, stated(kind, **keys), kind), section)
    assert element.kind == kind.name
    assert set(element.values) == {field.name for field in kind.fields}
    assert None not in [value for name, value in element.values.items() if name not in LEFT_OUT]


@pytest.mark.parametrize(("section", "kind"), OWN_KINDS, ids=lambda x: getattr(x, "name", ""))
def test_defaults(section: str, kind: ElementKind) -> None:
    needed = {field.name: sound(field) for field in kind.fields if field.default is None}
    element = only(problem(section, {"type": kind.name, **needed, **AT.get(kind.name, {})}, kind), section)
    assert set(element.values) == {field.name for field in kind.fields}


AT = {"pivot": {"at": ["0", "0"]}} | {
    name: {"line": "x = ell", **OWN[name]} for name in OWN if not name.startswith("prescribed")
}


@pytest.mark.parametrize(("section", "kind", "field"), FIELDS, ids=lambda x: getattr(x, "name", ""))
def test_every_field_refuses_what_cannot_be(section: str, kind: ElementKind, field: Field) -> None:
    for wrong in WRONG[field.kind]:
        with pytest.raises(RbpsymError) as found:
            problem(section, stated(kind, **{field.name: wrong}), kind)
        assert found.value.place is not None
        assert "Traceback" not in str(found.value)


@pytest.mark.parametrize(("section", "kind", "field"), FIELDS, ids=lambda x: getattr(x, "name", ""))
def test_every_required_field_is_required(section: str, kind: ElementKind, field: Field) -> None:
    if field.default is None:
        table = stated(kind)
        del table[field.name]
        with pytest.raises(RbpsymError, match=f"has no “{field.name}”"):
            problem(section, table, kind)


@pytest.mark.parametrize(("section", "kind", "field"), FIELDS, ids=lambda x: getattr(x, "name", ""))
def test_every_dimension_is_checked(section: str, kind: ElementKind, field: Field) -> None:
    if field.kind == "expression":
        with pytest.raises(RbpsymError, match="must be"):
            problem(section, stated(kind, **{field.name: "m*ell**5"}), kind)


@pytest.mark.parametrize("kinds", [SHAPES, *REGISTRIES.values()])
def test_names_of_kinds_are_unique(kinds: Mapping[str, ElementKind]) -> None:
    aliases = [alias for kind in kinds.values() for alias in kind.aliases]
    assert len({*kinds, *aliases}) == len(kinds) + len(aliases) == len(known_names(kinds))


def test_python_functions_do_not_hide_each_other() -> None:
    total = sum(len(known_names(kinds)) for kinds in (SHAPES, *REGISTRIES.values()))
    assert len(build.MAKERS) == total


@pytest.mark.parametrize("kind", CONSTRAINTS.values(), ids=lambda kind: kind.name)
def test_unknowns(kind: ElementKind) -> None:
    element = only(problem("constraints", stated(kind), kind), "constraints")
    names = unknowns_of(element)
    assert names and all(name == "kappa" or name.startswith("E") for name in names)


def test_bearing_is_a_pin() -> None:
    text = """
    [parameters]
    m = "mass"
    ell = "length"
    [coordinates.theta]
    [bodies]
    a = { shape = "rod", length = "ell", mass = "m", start = "O", angle = "theta" }
    b = { shape = "hoop", radius = "ell", mass = "m" }
    [constraints]
    N = { type = "bearing", points = ["a.end", "b.center"] }
    """
    loaded = load_text(text)
    assert only(loaded, "constraints").kind == "pin"
    assert list(unknowns_of(only(loaded, "constraints"))) == ["N_x", "N_y"]
    assert loaded.body("b").shape.kind == "ring"


def test_a_link_is_read_as_a_string_that_may_push() -> None:
    kind = REGISTRIES["constraints"]["link"]
    element = only(problem("constraints", stated(kind), kind), "constraints")
    assert (element.kind, element["rigid"], element["length"] is not None) == ("string", True, True)
    assert [turn.center.label for turn in element["path"]] == ["O", "rod.end"]
