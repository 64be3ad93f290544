"""The paper's 41 displayed equations beside ours: which are printed the same, and why the others are not.

Both are read into display trees and printed by our LaTeX printer; spaces and the size of brackets are
dropped, and symbols are renamed as `DECLARED` says. Nothing else is made equal: neither the order of
terms and factors nor the grouping. "whole": one chain of ours has every side of the paper's equation;
"link": it has the last side and another one, but we take another way between; "no": none of both.

A report and no test, since a course is not to be like one text: `python -m tests.document.likeness`; `WHY` says why some differ.
"""

import re
from functools import cache

from rbpsym.courses import derive_course
from rbpsym.document.model import Display
from rbpsym.document.notes import course_notes
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.latex.reader import read_latex
from rbpsym.expr.symbol_table import symbol_table
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from rbpsym.typeset.latex import to_latex
from tests.expr.paper import NAMES, SPELLINGS, equations

TABLE = symbol_table(NAMES, spellings=SPELLINGS)

THEORY, FIXED, FREE, COMPARISON, LADDER, SPRING = (f"p{number}" for number in (2, 3, 4, 5, 6, 7))
PARTS = {
    THEORY: (*range(1, 10), *range(38, 42)),
    FIXED: range(10, 16),
    FREE: range(16, 26),
    COMPARISON: (26, 27),
    LADDER: range(28, 36),
    SPRING: (36, 37),
}  # fmt: skip
PART = {number: part for part, numbers in PARTS.items() for number in numbers}

DECLARED = {
    # the paper writes both E_k and E_K; O' is our O, p' our q
    THEORY: ((r"E_k", "E_K"), (r"I_{O'}", "I_O"), (r"\vec{r}_p'", r"\vec{r}_q"), ("C_p", "C_{p,q}")),
    FIXED: ((r"\vec{\omega}", r"\omega\hat{k}"),),  # along the axis: the vector is its component times k
    FREE: ((r"\vec{\omega}", r"\omega\hat{k}"), (r"\vec{\beta}", r"\beta\hat{k}")),
    SPRING: ((r"\mathpzc{w}_T", r"\mathcal{W}_{T,F_s}"), (r"\mathpzc{w}_{\theta}", r"\mathcal{W}_{\theta,F_s}")),
}
# E_K is the translational energy in (3) and in (4) that of the rotation about the fixed axis, as the paper says
# below them. W_theta is the work about that axis in (4) and about the centre of mass elsewhere: our names differ.
OF_ONE = {
    3: ((r"\DeltaE_K", r"\Delta(\frac{1}{2}MV_{\mathrm{cm}}^2)"),),
    4: (
        (r"\DeltaE_K", r"\Delta(\frac{1}{2}I_O\omega^2)"),
        (r"\mathcal{W}_{\theta}", r"\mathcal{W}_{\theta,O}"),
        (r"\theta_", r"\varphi_"),
        (r"d\theta", r"d\varphi"),
    ),
    # the paper's I_rod and I_disk are about O here, as its second line shows; ours without O are about the centres
    10: (
        (r"I_{\mathrm{rod}}", r"I_{\mathrm{rod},O}"),
        (r"I_{\mathrm{disk}}", r"I_{\mathrm{disk},O}"),
    ),
    13: ((r"\mathcal{W}_{\theta}", r"\mathcal{W}_{\theta,O}"), (r"I_0", r"I_O")),  # I_0 is a misprint for I_O
    # tau_net is the net torque on another part of the system each time: our name says on which, and about O
    11: ((r"\vec{\tau}_{\mathrm{net}}", r"\vec{\tau}_{O,\mathrm{rod},\mathrm{disk}}"),),
    17: ((r"\vec{\tau}_{\mathrm{net}}", r"\vec{\tau}_{O,\mathrm{rod}}"),),
    20: ((r"\vec{\tau}_{\mathrm{net}}", r"\vec{\tau}_{O,\mathrm{disk}}"),),
}


def bare(node: t.Node, notation: Notation = DEFAULT) -> str:
    """The LaTeX without spaces and sizes of brackets."""
    return re.sub(r"\\left|\\right|\\,|\s", "", to_latex(node, notation))


def rows(node: t.Node) -> tuple[t.Node, ...]:
    return node.rows if isinstance(node, t.Relations) else (node,)


def chains(node: t.Node, notation: Notation = DEFAULT) -> list[list[str]]:
    return [[bare(side, notation) for side in row.items] for row in rows(node) if isinstance(row, t.Chain)]


@cache
def ours() -> dict[str, list[list[str]]]:
    """The chains of each part of the paper's course, at full detail."""
    document = course_notes(derive_course(load_course(course_files()["paper"]), simulation=False), detail="full")
    found: dict[str, list[list[str]]] = {part: [] for part in PARTS}
    for section in document.sections:
        for block in section.blocks:
            if isinstance(block, Display):
                found.setdefault(section.label.split(".")[0], []).extend(chains(block.node, document.notation))
    return found


def declared(text: str, number: int) -> str:
    for theirs, own in (*OF_ONE.get(number, ()), *DECLARED.get(PART[number], ())):
        text = text.replace(theirs, own)
    return text


def paper(number: int) -> list[list[str]]:
    """The chains of an equation of the paper, in our names."""
    read = chains(read_latex(equations()[number], TABLE))
    return [[declared(side, number) for side in chain] for chain in read]


def grade_of(chain: list[str], part: str) -> str:
    shared = [set(chain) & set(own) for own in ours()[part]]
    if set(chain) in shared:
        return "whole"
    return "link" if any(chain[-1] in sides and len(sides) >= 2 for sides in shared) else "no"


def grade(number: int) -> str:
    """The worst grade among the relations of an equation of the paper."""
    return max((grade_of(chain, PART[number]) for chain in paper(number)), key=("whole", "link", "no").index)


WHY = {
    # the same result in another form or order; ours is kept where the paper has more than one
    11: "g l (m/2 + M), as the paper has it in (12)-(14); here it writes g (m l/2 + M l)",
    12: "no fraction stands below another",
    14: "kinetic before potential energy, as the paper has it in (32), (33)",
    15: "the term with alpha first, as in the equation of motion; square brackets",
    19: "orbital before spin part, as the paper has it in (5)",
    22: "no fraction stands below another",
    25: "kinetic before potential energy, the spin energy of the disk is kept",
    26: "no fraction stands below another",
    27: "no fraction stands below another",
}


if __name__ == "__main__":
    for number in equations():
        print(number, grade(number), WHY.get(number, ""))
