"""What a step is given as data is read by something: by its check, by what grounds its sentence, or by another step."""

import ast
from collections.abc import Iterator

from tests.architecture.source import MODULES


def written(tree: ast.AST) -> Iterator[str]:
    """The keys of the mappings that are handed over as `data`."""
    given = (node.value for node in ast.walk(tree) if isinstance(node, ast.keyword) and node.arg == "data")
    tables = (table for value in given for table in ast.walk(value) if isinstance(table, ast.Dict))
    yield from (key.value for table in tables for key in table.keys if isinstance(key, ast.Constant))


def read(tree: ast.AST) -> Iterator[str]:
    """The keys that stand behind `data`, or are walked through where `data[key]` stands."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and is_data(node.value) and isinstance(node.slice, ast.Constant):
            yield node.slice.value
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get":
            if is_data(node.func.value) and isinstance(node.args[0], ast.Constant):
                yield node.args[0].value
        elif isinstance(node, ast.GeneratorExp) and isinstance(node.elt, ast.Subscript) and is_data(node.elt.value):
            keys = node.generators[0].iter
            yield from ast.literal_eval(keys) if isinstance(keys, ast.Tuple) else ()


def is_data(node: ast.AST) -> bool:
    return "data" in (getattr(node, "attr", ""), getattr(node, "id", ""))


def test_no_step_is_given_data_that_nobody_reads():
    trees = [module.tree for module in MODULES]
    known = {key for tree in trees for key in read(tree)}
    idle = sorted({key for tree in trees for key in written(tree)} - known)
    assert not idle, f"data of steps that no check, ground or step reads: {idle}"
