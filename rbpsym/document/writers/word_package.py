"""The package of a .docx: its styles, pictures, numberings and the file itself. Imports python-docx."""

from __future__ import annotations

from collections.abc import Mapping
from io import BytesIO
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from rbpsym.document.files import extra
from rbpsym.document.model import Document, ItemList, parts
from rbpsym.document.pictures import Picture, pictures
from rbpsym.document.writers.word_xml import UNPRINTABLE, W
from rbpsym.frozen import Frozen
from rbpsym.languages import phrases
from rbpsym.typeset.omml import NAMESPACE

LETTERS = "Cambria"
EMU = 360_000  # a centimetre
WIDEST = 15.8  # cm


class ParagraphLook(Frozen):
    """A paragraph style: size and space in points, alignment, and whether it stays with what follows."""

    size: float = 11
    before: float = 0
    after: float = 0
    side: str = "LEFT"
    bold: bool = False
    italic: bool = False
    color: str = "1F2430"
    stays: bool = False


STYLES: Mapping[str, ParagraphLook] = {
    "Normal": ParagraphLook(after=0),
    "Body Text": ParagraphLook(after=6, stays=False),
    "Title": ParagraphLook(20, 0, 4, "CENTER", bold=True),
    "Subtitle": ParagraphLook(12.5, 0, 2, "CENTER"),
    "Source": ParagraphLook(10, 0, 10, "CENTER", color="6B7280"),
    "Heading 1": ParagraphLook(15, 18, 6, bold=True, stays=True),
    "Heading 2": ParagraphLook(12.5, 14, 5, bold=True, stays=True),
    "Heading 3": ParagraphLook(11, 10, 4, bold=True, stays=True),
    "Formula": ParagraphLook(after=2, before=2),
    "Number": ParagraphLook(side="RIGHT"),
    "Reason": ParagraphLook(10, 0, 6, "CENTER", italic=True, color="5F6673"),
    "Caption": ParagraphLook(10, 6, 6, "CENTER"),
    "Figure": ParagraphLook(10, 8, 2, "CENTER", stays=True),
    "Cell": ParagraphLook(10, 2, 2),
    "Gap": ParagraphLook(4),
    "CalloutTitle": ParagraphLook(11, 2, 2, bold=True, color="1D5FA8", stays=True),
    "List Bullet": ParagraphLook(after=3),
    "List Number": ParagraphLook(after=3),
}


def new(title: str, language: str) -> Any:
    """An empty A4 file with our styles."""
    file = extra("docx").Document()
    set_page(file)
    for name, look in STYLES.items():
        set_style(file, name, look)
    set_language(file, language)
    file.core_properties.title = UNPRINTABLE.sub("", title)[:255]
    file.core_properties.author = file.core_properties.comments = ""
    file.core_properties.language = language
    return file


def set_page(file: Any) -> None:
    """A4 with margins of 2.5 cm, numbers at the foot."""
    section, cm = file.sections[0], extra("docx.shared").Cm
    section.page_width, section.page_height = cm(21), cm(29.7)
    section.left_margin = section.right_margin = cm(2.5)
    section.top_margin = section.bottom_margin = cm(2.4)
    foot = section.footer.paragraphs[0]
    foot.alignment = 1
    foot._p.append(parsed('<w:fldSimple w:instr="PAGE"><w:r><w:t>1</w:t></w:r></w:fldSimple>')[0])


def set_style(file: Any, name: str, look: ParagraphLook) -> None:
    """A style of the file, made if it is not there."""
    shared, sides = extra("docx.shared"), extra("docx.enum.text").WD_ALIGN_PARAGRAPH
    known = {style.name for style in file.styles}
    style = file.styles[name] if name in known else file.styles.add_style(name, 1)
    font, form = style.font, style.paragraph_format
    font.name, font.size, font.bold, font.italic = LETTERS, shared.Pt(look.size), look.bold, look.italic
    font.color.rgb = shared.RGBColor.from_string(look.color)
    form.space_before, form.space_after = shared.Pt(look.before), shared.Pt(look.after)
    form.alignment, form.keep_with_next = getattr(sides, look.side), look.stays
    form.line_spacing = 0.4 if name == "Gap" else 1.08
    of_all_scripts(style.element)


def of_all_scripts(style: Any) -> None:
    """The template's headings name theme fonts, which would win over ours; its title has a rule below it."""
    fonts = style.rPr.rFonts
    for name in [key for key in fonts.attrib if key.endswith("Theme")]:
        del fonts.attrib[name]
    for edge in style.findall(f".//{{{W}}}pBdr"):
        edge.getparent().remove(edge)


def set_language(file: Any, language: str) -> None:
    """The language of all words, for spelling and for readers aloud."""
    for found in file.styles.element.iter(f"{{{W}}}lang"):
        found.set(f"{{{W}}}val", phrases(language)["word.tag"])


def put_pictures(file: Any, document: Document) -> dict[str, str]:
    """The drawings of all figures in the package, and the XML that shows each, by number."""
    return {
        number: shown(file, picture, place) for place, (number, picture) in enumerate(pictures(document).items(), 1)
    }


def shown(file: Any, picture: Picture, place: int) -> str:
    """The XML that shows a picture; ALTERNATIVE and NAME are filled in where it is used."""
    share = min(1.0, WIDEST / picture.width)
    identity, _ = file.part.get_or_add_image(BytesIO(picture.content))
    wide, high = (round(length * share * EMU) for length in (picture.width, picture.height))
    size = f'cx="{wide}" cy="{high}"'
    return (
        f'<w:r><w:drawing><wp:inline distT="0" distB="0" distL="0" distR="0"><wp:extent {size}/>'
        f'<wp:docPr id="{place}" name="NAME" descr="ALTERNATIVE"/>'
        '<a:graphic><a:graphicData uri="http://schemas.openxmlformats.org/drawingml/2006/picture"><pic:pic>'
        f'<pic:nvPicPr><pic:cNvPr id="{place}" name="NAME"/><pic:cNvPicPr/></pic:nvPicPr>'
        f'<pic:blipFill><a:blip r:embed="{identity}"/><a:stretch><a:fillRect/></a:stretch></pic:blipFill>'
        f'<pic:spPr><a:xfrm><a:off x="0" y="0"/><a:ext {size}/></a:xfrm><a:prstGeom prst="rect"><a:avLst/>'
        "</a:prstGeom></pic:spPr></pic:pic></a:graphicData></a:graphic></wp:inline></w:drawing></w:r>"
    )


def put_lists(file: Any, document: Document) -> dict[int, int]:
    """A numbering for each ordered list, by the list's identity, so that each begins with 1."""
    ordered = [part for part in parts(document.sections) if isinstance(part, ItemList) and part.ordered]
    if not ordered:
        return {}
    numbering = file.part.numbering_part.element
    own = file.styles["List Number"].element.pPr.numPr.numId.val
    kind = next(num.abstractNumId.val for num in numbering.num_lst if num.numId == own)
    found = {}
    for block in ordered:
        number = numbering.add_num(kind)
        number.add_lvlOverride(0).add_startOverride(1)
        found[id(block)] = number.numId
    return found


SPACES = {
    "w": W,
    "m": NAMESPACE,
    "r": "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
    "wp": "http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing",
    "a": "http://schemas.openxmlformats.org/drawingml/2006/main",
    "pic": "http://schemas.openxmlformats.org/drawingml/2006/picture",
}


def parsed(content: str) -> Any:
    """An element whose children are the content."""
    spaces = " ".join(f'xmlns:{name}="{address}"' for name, address in SPACES.items())
    return extra("docx.oxml").parse_xml(f"<w:body {spaces}>{content}</w:body>")


def fill(file: Any, content: str) -> None:
    """Put the content before the settings of the page."""
    last = file.element.body[-1]
    for element in parsed(content):
        last.addprevious(element)


def saved(file: Any) -> bytes:
    """The bytes of the file, the same for the same document: no time of writing is kept."""
    written, kept = BytesIO(), BytesIO()
    file.save(written)
    with ZipFile(written) as source, ZipFile(kept, "w", ZIP_DEFLATED) as target:
        for name in source.namelist():
            target.writestr(ZipInfo(name, (1980, 1, 1, 0, 0, 0)), source.read(name), ZIP_DEFLATED)
    return kept.getvalue()
