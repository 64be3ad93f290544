"""The package around the items of a Canvas quiz: assessment, its settings, manifest, pictures."""

from __future__ import annotations

from xml.etree.ElementTree import Element

from rbpsym.teaching.exports.bench import Desk
from rbpsym.teaching.exports.packing import identifier
from rbpsym.teaching.exports.xml import element, written

QTI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
CANVAS = "http://canvas.instructure.com/xsd/cccv1p0"
PACKAGE = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"


def package(desk: Desk, items: list[Element]) -> dict[str, bytes]:
    """The files of the package by path."""
    name = identifier(desk.worksheet.code)
    files = {
        f"{name}/{name}.xml": written(_assessment(desk, name, items)),
        f"{name}/assessment_meta.xml": written(_settings(desk, name)),
    }
    files |= {f"images/{path}": data for path, data in desk.paper.pictures.items()}
    return {**files, "imsmanifest.xml": written(_manifest(name, list(files)))}


def _title(desk: Desk) -> str:
    return f"{desk.plain(desk.worksheet.title)} {desk.worksheet.code}"


def _assessment(desk: Desk, name: str, items: list[Element]) -> Element:
    attempts = element("qtimetadatafield", None, element("fieldlabel", "cc_maxattempts"), element("fieldentry", "1"))
    section = element("section", None, *items, ident="root_section")
    inner = element("assessment", None, element("qtimetadata", None, attempts), section, ident=name, title=_title(desk))
    return element("questestinterop", None, inner, xmlns=QTI)


def _settings(desk: Desk, name: str) -> Element:
    parts = (
        ("title", _title(desk)), ("shuffle_answers", "false"), ("scoring_policy", "keep_highest"), ("quiz_type", "assignment"),
        ("points_possible", f"{float(desk.worksheet.points):g}"), ("allowed_attempts", "1"), ("available", "false"),
    )  # fmt: skip
    return element("quiz", None, *(element(key, value) for key, value in parts), xmlns=CANVAS, identifier=name)


def _manifest(name: str, paths: list[str]) -> Element:
    quiz = element(
        "resource", None, element("file", None, href=f"{name}/{name}.xml"),
        element("dependency", None, identifierref=f"{name}-meta"),
        identifier=name, type="imsqti_xmlv1p2",
    )  # fmt: skip
    meta = f"{name}/assessment_meta.xml"
    settings = element(
        "resource", None, element("file", None, href=meta), identifier=f"{name}-meta", href=meta,
        type="associatedcontent/imscc_xmlv1p1/learning-application-resource",
    )  # fmt: skip
    pictures = [
        element(
            "resource",
            None,
            element("file", None, href=path),
            identifier=identifier(path),
            type="webcontent",
            href=path,
        )
        for path in paths
        if path.startswith("images/")
    ]
    about = element("metadata", None, element("schema", "IMS Content"), element("schemaversion", "1.1.3"))
    resources = element("resources", None, quiz, settings, *pictures)
    return element(
        "manifest", None, about, element("organizations"), resources, xmlns=PACKAGE, identifier=f"{name}-package"
    )
