"""XML text from a tree of elements: every text is escaped, nothing is pasted."""

from __future__ import annotations

import re
from xml.etree import ElementTree as Tree

Element = Tree.Element
MATH = "http://www.w3.org/1998/Math/MathML"
_BAD = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")


def element(tag: str, text: str | None = None, /, *children: Element, **attributes: str) -> Element:
    """An element with text, children and attributes; an underscore after an attribute's name is dropped."""
    found = Element(tag, {name.rstrip("_"): _clean(value) for name, value in attributes.items()})
    found.text = None if text is None else _clean(text)
    found.extend(children)
    return found


def _clean(text: str) -> str:
    """The text without characters that no XML file can hold."""
    return _BAD.sub("\ufffd", str(text))


def fragment(markup: str) -> list[Element]:
    """The elements of well-formed markup that we made; MathML says its namespace itself."""
    found = list(Tree.fromstring(f"<all>{markup}</all>"))
    for part in found:
        for inner in part.iter():
            space, _, name = inner.tag.rpartition("}")
            inner.tag = name
            if space == "{" + MATH and name == "math":
                inner.set("xmlns", MATH)
    return found


def written(root: Element) -> bytes:
    """The XML file of a tree."""
    Tree.indent(root)
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + Tree.tostring(root, encoding="utf-8") + b"\n"
