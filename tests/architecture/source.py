"""The source of rbpsym as the tests of this folder see it: its modules, parsed."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "rbpsym"


@dataclass(frozen=True)
class Module:
    """A module of rbpsym."""

    path: Path

    @cached_property
    def text(self) -> str:
        return self.path.read_text(encoding="utf-8")

    @cached_property
    def tree(self) -> ast.Module:
        return ast.parse(self.text)

    @property
    def parts(self) -> tuple[str, ...]:
        """Its dotted name in parts, without a final __init__."""
        parts = self.path.relative_to(ROOT).with_suffix("").parts
        return parts[:-1] if parts[-1] == "__init__" else parts

    @property
    def name(self) -> str:
        return ".".join(self.parts)

    @property
    def package(self) -> tuple[str, ...]:
        """The package in which its relative imports are looked up."""
        return self.parts if self.path.name == "__init__.py" else self.parts[:-1]

    def imports(self, *, inner: bool = True) -> Iterator[tuple[int, str]]:
        """(line, dotted name) of what it imports; without `inner` only what is imported on loading."""
        for node in ast.walk(self.tree) if inner else loaded(self.tree):
            if isinstance(node, ast.Import):
                yield from ((node.lineno, alias.name) for alias in node.names)
            elif isinstance(node, ast.ImportFrom):
                yield from self._from(node)

    def _from(self, node: ast.ImportFrom) -> Iterator[tuple[int, str]]:
        base = self.package[: len(self.package) - node.level + 1] if node.level else ()
        module = ".".join([*base, *([node.module] if node.module else [])])
        for alias in node.names:
            dotted = f"{module}.{alias.name}"
            yield node.lineno, dotted if dotted in NAMES else module

    def strings(self) -> Iterator[tuple[int, str]]:
        """(line, text) of its string constants that are not docstrings."""
        docs = {id(doc) for node in ast.walk(self.tree) if (doc := docstring(node)) is not None}
        for node in ast.walk(self.tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
                yield node.lineno, node.value


def loaded(tree: ast.AST) -> Iterator[ast.AST]:
    """The nodes that run when a module is loaded: no bodies of functions, no TYPE_CHECKING."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            continue
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        yield node
        yield from loaded(node)


def docstring(node: ast.AST) -> ast.Constant | None:
    """The docstring of a module, class or function."""
    body = getattr(node, "body", None)
    if not isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) or not body:
        return None
    first = body[0]
    is_text = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    return first.value if is_text and isinstance(first.value.value, str) else None


MODULES = [Module(path) for path in sorted(PACKAGE.rglob("*.py")) if "_data" not in path.parts]
NAMES = {module.name for module in MODULES}


def of_every_module(law: Callable[[Module], None]) -> Callable[[], None]:
    """One test that puts a law to every module and names all that break it: thousands of single tests are slow to report."""

    def test() -> None:
        broken = []
        for module in MODULES:
            try:
                law(module)
            except AssertionError as error:
                broken.append(f"{module.name}: {error}")
        assert not broken, "\n".join(broken)

    test.__name__, test.__doc__ = law.__name__, law.__doc__
    return test
