"""Writes templates/math.woff2 anew: Latin Modern Math cut down to what formulas of rigid bodies need.

    python docs/math_font.py [latinmodern-math.otf]

Needs fonttools and brotli (pip install 'fonttools[woff]') and the font (apt install lmodern, fonts-lmodern).
The licence asks for another name: “Notes Math”.
"""

from __future__ import annotations

import sys
from io import BytesIO
from pathlib import Path
from string import ascii_letters

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

from rbpsym.expr.letters import LETTERS, UPRIGHT_CAPITALS, bold, script

ROOT = Path(__file__).resolve().parents[1]
TARGET = ROOT / "templates" / "math.woff2"
SOURCE = "/usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf"
SIGNS = "0123456789+−-=<>≤≥≠≈∼→∫∑∂√∞∝()[]{}|/∕,.;:!'\"·⋅×′″‴˙¨^¯~ˇ°±*ıȷℓℏℎΔ\u2061\u2062 \u00a0\u2009\u20d7\u20db→"


def wanted() -> set[str]:
    """Letters in italic (as browsers map them), upright, bold and script; digits and signs."""
    letters = set(ascii_letters) | set(LETTERS.values()) | UPRIGHT_CAPITALS
    found = letters | set(SIGNS) | {bold(char) for char in letters} | {script(char) for char in ascii_letters}
    found |= {chr(0x1D434 + k) for k in range(52)}  # italic Latin
    return found | {chr(0x1D6E2 + k) for k in range(58)}  # italic Greek


def main(source: str) -> None:
    """Cut the font and write it."""
    font = TTFont(source)
    known = set(TTFont(TARGET).getBestCmap()) if TARGET.is_file() else set()
    options = Options()
    options.layout_features, options.notdef_outline, options.hinting = ["dtls"], True, False
    cutter = Subsetter(options)
    cutter.populate(unicodes=known | {ord(char) for char in wanted()})
    cutter.subset(font)
    for record in font["name"].names:
        if record.nameID in (1, 4, 6, 16):
            record.string = "NotesMath" if record.nameID == 6 else "Notes Math"
    font.flavor = "woff2"
    buffer = BytesIO()
    font.save(buffer)
    TARGET.write_bytes(buffer.getvalue())
    print(f"{TARGET}: {len(buffer.getvalue())} bytes, {len(font.getBestCmap())} characters")


if __name__ == "__main__":
    main(*(sys.argv[1:] or [SOURCE]))
