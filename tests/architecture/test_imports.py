"""Imports go down only, without cycles; heavy packages are imported where they are used."""

from __future__ import annotations

from tests.architecture.source import MODULES, NAMES, Module, of_every_module

# The floor of each room: a module may import what stands on its floor's room or on a lower floor.
FLOORS = {
    "errors": 0, "frozen": 0, "languages": 0.5, "quantities": 0, "showing": 0,
    "expr": 1, "typeset": 1.1, "field": 1.2, "present": 1.3, "numeric": 1.4, "decide": 1.5,
    "statement": 2, "mechanics": 3, "quantity": 3.5, "proof": 4, "chapters": 5, "ask": 5.5, "remarks": 5.8,
    "oracles": 6, "claims": 6.2, "kernel": 6.5, "pictures": 7, "document": 8, "explorer": 8.5,
    "derive": 9, "courses": 9.1, "solve": 9.2, "face": 9.22, "facade": 9.25, "teaching": 9.3, "studio": 9.4,
    "commands": 9.5, "cli": 9.8, "__main__": 9.9,
}  # fmt: skip
HEAVY = {"sympy", "matplotlib", "scipy", "typst", "jinja2", "rich", "docx", "nbformat", "flint"}
SYMPY_LIVES_IN = ("rbpsym.field.sympy_bridge", "rbpsym.face.late")


# of the folder of a kind, whose data are part of the statement
PARTS = {"law": "mechanics", "work": "oracles", "row": "oracles", "check": "proof"}


def room(dotted: str) -> str:
    """The room in which a module stands; the modules of a kind stand where their work is done."""
    own, last = [*dotted.split("."), ""][1], dotted.rpartition(".")[2]
    return PARTS.get(last, "statement") if own == "elements" else own


@of_every_module
def test_every_module_has_a_floor(module: Module) -> None:
    assert room(module.name) in {*FLOORS, ""}, f"{module.name}: say in FLOORS on which floor it stands"


@of_every_module
def test_imports_go_down_only(module: Module) -> None:
    own = room(module.name)
    if not own:
        return  # the public names, which are lazy
    for line, name in module.imports():
        if name.split(".")[0] != "rbpsym" or not room(name):
            continue
        other = room(name)
        assert other == own or FLOORS[other] < FLOORS[own] or FLOORS[other] == FLOORS[own] == 0, (
            f"{module.path}:{line}: {own} (floor {FLOORS[own]}) imports {other} (floor {FLOORS[other]})"
        )


@of_every_module
def test_heavy_packages_are_imported_late(module: Module) -> None:
    found = [(line, name) for line, name in module.imports(inner=False) if name.split(".")[0] in HEAVY]
    assert not found, f"{module.path}: import {found} in the function that needs it"


@of_every_module
def test_sympy_is_met_at_one_bridge_and_at_the_door_of_the_face(module: Module) -> None:
    found = [(line, name) for line, name in module.imports() if name.split(".")[0] == "sympy"]
    assert not found or module.name in SYMPY_LIVES_IN, f"{module.path}: {found}"


def test_there_are_no_cycles() -> None:
    graph = {
        module.name: {name for _, name in module.imports(inner=False) if name in NAMES and name != module.name}
        for module in MODULES
    }
    finished: set[str] = set()

    def visit(name: str, way: tuple[str, ...]) -> None:
        assert name not in way, " → ".join([*way[way.index(name) :], name])
        if name not in finished:
            for other in sorted(graph[name]):
                visit(other, (*way, name))
            finished.add(name)

    for name in graph:
        visit(name, ())


ROCQ = {f"rbpsym.kernel.{name}" for name in ("rocq", "reading", "coqc", "certify", "claimed", "theory")}


@of_every_module
def test_claims_and_their_certificates_know_no_prover(module: Module) -> None:
    """A second one could be written for the same claims: only what writes and runs knows Rocq."""
    if room(module.name) == "kernel" and module.name not in ROCQ:
        assert not ROCQ & {name for _, name in module.imports()}, f"{module.path} knows a prover"
