"""QTI 2.1: one package a student, with an item for each question, a test and a manifest."""

from __future__ import annotations

from xml.etree.ElementTree import Element

from rbpsym.teaching.exports.bench import Desk
from rbpsym.teaching.exports.packing import identifier, slug, zipped
from rbpsym.teaching.exports.page import Paper, mathml
from rbpsym.teaching.exports.qti_items import KINDS
from rbpsym.teaching.exports.telling import left_out
from rbpsym.teaching.exports.xml import element, written
from rbpsym.teaching.formats import Exported, Options
from rbpsym.teaching.model import Item, Worksheet

QTI = "http://www.imsglobal.org/xsd/imsqti_v2p1"
SCHEMA = f"{QTI} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"
PACKAGE = "http://www.imsglobal.org/xsd/imscp_v1p1"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"


def export_qti(worksheets: tuple[Worksheet, ...], options: Options) -> Exported:
    """A zip package for each student. Formulas are MathML, pictures SVG files."""
    files, missing, drawn = {}, [], {}
    for sheet in worksheets:
        desk = Desk(sheet, Paper(mathml, drawn=drawn), missing)
        files[f"{slug(sheet.code)}.qti.zip"] = zipped(package(desk))
    return Exported(files, left_out("QTI 2.1", missing))


def package(desk: Desk) -> dict[str, bytes]:
    """The files of one package."""
    sheet = desk.worksheet
    files = {f"{item_name(item)}.xml": written(assessment_item(item, desk)) for item in sheet.items}
    files["test.xml"] = written(assessment_test(desk))
    files |= desk.paper.pictures
    files["imsmanifest.xml"] = written(manifest(desk, list(files)))
    return files


def item_name(item: Item) -> str:
    """The identifier of an item in its package."""
    return identifier(f"item {item.id}")


def assessment_item(item: Item, desk: Desk) -> Element:
    """One item: declarations, body, processing, feedback."""
    parts = KINDS[type(item.key)](item, desk)
    root = element(
        "assessmentItem", None, *parts,
        xmlns=QTI, identifier=item_name(item), title=f"{desk.plain(desk.worksheet.title)} {item.id}",
        adaptive="false", timeDependent="false",
    )  # fmt: skip
    root.set("xmlns:xsi", INSTANCE)
    root.set("xsi:schemaLocation", SCHEMA)
    return root


def assessment_test(desk: Desk) -> Element:
    """The test: all items in the printed order."""
    sheet = desk.worksheet
    refs = [
        element("assessmentItemRef", None, identifier=item_name(item), href=f"{item_name(item)}.xml")
        for item in sheet.items
    ]
    section = element("assessmentSection", None, *refs, identifier="all", title=desk.plain(sheet.title), visible="true")
    part = element(
        "testPart", None, section, identifier="part", navigationMode="nonlinear", submissionMode="simultaneous"
    )
    outcome = element("outcomeDeclaration", None, identifier="SCORE", cardinality="single", baseType="float")
    total = element("sum", None, element("testVariables", None, variableIdentifier="SCORE"))
    process = element("outcomeProcessing", None, element("setOutcomeValue", None, total, identifier="SCORE"))
    root = element(
        "assessmentTest", None, outcome, part, process,
        xmlns=QTI, identifier=identifier(sheet.code), title=f"{desk.plain(sheet.title)} {sheet.code}",
    )  # fmt: skip
    root.set("xmlns:xsi", INSTANCE)
    root.set("xsi:schemaLocation", SCHEMA)
    return root


def manifest(desk: Desk, paths: list[str]) -> Element:
    """The manifest: the test depends on the items, these on their pictures."""
    items = [item_name(item) for item in desk.worksheet.items]
    pictures = [path for path in paths if path.endswith(".svg")]
    resources = [
        element(
            "resource", None, element("file", None, href="test.xml"),
            *(element("dependency", None, identifierref=name) for name in items),
            identifier="test", type="imsqti_test_xmlv2p1", href="test.xml",
        )
    ]  # fmt: skip
    for name in items:
        files = [element("file", None, href=f"{name}.xml"), *(element("file", None, href=path) for path in pictures)]
        resources.append(
            element("resource", None, *files, identifier=name, type="imsqti_item_xmlv2p1", href=f"{name}.xml")
        )
    metadata = element("metadata", None, element("schema", "QTIv2.1 Package"), element("schemaversion", "1.0.0"))
    return element(
        "manifest", None, metadata, element("organizations"), element("resources", None, *resources),
        xmlns=PACKAGE, identifier=identifier(f"package {desk.worksheet.code}"),
    )  # fmt: skip
