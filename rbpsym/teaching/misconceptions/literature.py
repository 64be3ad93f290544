"""Where the misconceptions are described: papers and books, by key."""

from __future__ import annotations

from collections.abc import Mapping

SOURCES: Mapping[str, str] = {
    "rimoldini-singh-2005": "L. G. Rimoldini and C. Singh, Student understanding of rotational and rolling motion "
    "concepts, Phys. Rev. ST Phys. Educ. Res. 1, 010102 (2005)",
    "ortiz-heron-shaffer-2005": "L. G. Ortiz, P. R. L. Heron and P. S. Shaffer, Student understanding of static "
    "equilibrium: Predicting and accounting for balancing, Am. J. Phys. 73, 545 (2005)",
    "lopez-2003": "M. L. López, Angular and linear acceleration in a rigid rolling body: students' misconceptions, "
    "Eur. J. Phys. 24, 553 (2003)",
    "close-gomez-heron-2013": "H. G. Close, L. S. Gomez and P. R. L. Heron, Student understanding of the application "
    "of Newton's second law to rotating rigid bodies, Am. J. Phys. 81, 458 (2013)",
    "close-heron-2011": "H. G. Close and P. R. L. Heron, Student understanding of the angular momentum of classical "
    "particles, Am. J. Phys. 79, 1068 (2011)",
    "sherwood-1983": "B. A. Sherwood, Pseudowork and real work, Am. J. Phys. 51, 597 (1983)",
    "sherwood-bernard-1984": "B. A. Sherwood and W. H. Bernard, Work and heat transfer in the presence of sliding "
    "friction, Am. J. Phys. 52, 1001 (1984)",
    "penchina-1978": "C. M. Penchina, Pseudowork-energy principle, Am. J. Phys. 46, 295 (1978)",
    "mallinckrodt-leff-1992": "A. J. Mallinckrodt and H. S. Leff, All about work, Am. J. Phys. 60, 356 (1992)",
    "mungan-2005": "C. E. Mungan, A primer on work-energy relationships for introductory physics, "
    "Phys. Teach. 43, 10 (2005)",
    "carnero-1993": "C. Carnero, J. Aguiar and J. Hierrezuelo, The work of the frictional force in rolling motion, "
    "Phys. Educ. 28, 225 (1993)",
    "lindsey-2009": "B. A. Lindsey, P. R. L. Heron and P. S. Shaffer, Student ability to apply the concepts of work "
    "and energy to extended systems, Am. J. Phys. 77, 999 (2009)",
    "singh-rosengrant-2003": "C. Singh and D. Rosengrant, Multiple-choice test of energy and momentum concepts, "
    "Am. J. Phys. 71, 607 (2003)",
    "lawson-mcdermott-1987": "R. A. Lawson and L. C. McDermott, Student understanding of the work-energy and "
    "impulse-momentum theorems, Am. J. Phys. 55, 811 (1987)",
    "hestenes-1992": "D. Hestenes, M. Wells and G. Swackhamer, Force Concept Inventory, Phys. Teach. 30, 141 (1992)",
    "mcdermott-1994": "L. C. McDermott, P. S. Shaffer and M. D. Somers, Research as a guide for teaching introductory "
    "mechanics: An illustration in the context of the Atwood's machine, Am. J. Phys. 62, 46 (1994)",
    "flores-2004": "S. Flores, S. E. Kanim and C. H. Kautz, Student use of vectors in introductory mechanics, "
    "Am. J. Phys. 72, 460 (2004)",
    "shaffer-mcdermott-2005": "P. S. Shaffer and L. C. McDermott, A research-based approach to improving student "
    "understanding of the vector nature of kinematical concepts, Am. J. Phys. 73, 921 (2005)",
    "mashood-singh-2012": "K. K. Mashood and V. A. Singh, An inventory on rotational kinematics of a particle: "
    "unravelling misconceptions and pitfalls in reasoning, Eur. J. Phys. 33, 1301 (2012)",
    "besson-2007": "U. Besson, L. Borghi, A. De Ambrosis and P. Mascheretti, How to teach friction: Experiments and "
    "models, Am. J. Phys. 75, 1106 (2007)",
    "nelson-olsson-1986": "R. A. Nelson and M. G. Olsson, The pendulum: Rich physics from a simple system, "
    "Am. J. Phys. 54, 112 (1986)",
    "arons-1997": "A. B. Arons, Teaching Introductory Physics (Wiley, New York, 1997)",
    "kleppner-kolenkow": "D. Kleppner and R. Kolenkow, An Introduction to Mechanics, 2nd ed. (Cambridge University "
    "Press, 2014), chapter 7",
    "paper": "the lessons of arXiv:2011.03355",
}
