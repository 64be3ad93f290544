"""What a model answers in parts: energies, works and momenta of centre of mass and turning; linear equations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from rbpsym.ask.found import Answer
from rbpsym.ask.telling import latex_of
from rbpsym.decide.verdict import Verdict
from rbpsym.document.notes import notation_of
from rbpsym.face.late import mechanics, sympy
from rbpsym.face.writing import alphabet
from rbpsym.field import Scalar, Vector
from rbpsym.frozen import Frozen, field
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState
from rbpsym.proof.step import Derivation
from rbpsym.solve import shown
from rbpsym.typeset.latex import to_latex

# --- the steps of a derivation as sympy's relations, with their LaTeX, premises, verdicts and obligations


class StepRelation(Frozen):
    """A step: the `relations` that it asserts, in order; `latex` as the notes print it; the ids of the steps and facts
    from which it follows; what became of its check; what must hold for it to have a meaning, as relations."""

    id: str
    relations: tuple[sympy.Basic, ...]
    latex: str
    premises: tuple[str, ...]
    verdict: Verdict
    obligations: tuple[sympy.Basic, ...]

    @property
    def relation(self) -> sympy.Basic:
        """All that is asserted: one relation, or the conjunction of several."""
        return self.relations[0] if len(self.relations) == 1 else sympy.And(*self.relations, evaluate=False)

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex}$"


def relations_of(derivation: Derivation) -> Iterator[StepRelation]:
    """The steps of all phases, those of later ones with phase2. before their ids."""
    later = ((phase.derivation, (*phase.begins, *phase.derivation.steps)) for phase in derivation.phases)
    for number, (own, steps) in enumerate(((derivation, derivation.steps), *later), 1):
        names, notation = alphabet(own.study, own.letters), notation_of(own)
        for step in steps:
            verdict = step.certificate.verdict
            duties = dict.fromkeys((*step.obligations, *(duty.relation for duty in verdict.open_obligations)))
            yield StepRelation(
                f"phase{number}.{step.id}" if number > 1 else step.id,
                names.relations(step.statement),
                to_latex(step.statement, notation),
                step.premises,
                verdict,
                tuple(relation for duty in duties for relation in names.relations(duty)),
            )


# --- the answer of a model to a question, in sympy


class SymbolicAnswer(Frozen):
    """`value`: an expression, or the components along x and y of a vector as a column; `valid_where`: relations that must
    hold; `steps`: ids of the steps from which it follows; `latex` as the notes print it."""

    question: str
    value: sympy.Basic
    verdict: Verdict
    valid_where: tuple[sympy.Basic, ...]
    steps: tuple[str, ...]
    latex: str

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex}$"


def in_sympy(found: Answer) -> SymbolicAnswer:
    """The answer with its formulas in sympy."""
    names = alphabet(found.study)
    values = [names.write(shown(value, found.study)) for value in found.values]
    valid = tuple(relation for node in found.valid for relation in names.relations(node))
    value = values[0] if len(values) == 1 else sympy.Matrix(values)
    return SymbolicAnswer(found.question.text, value, found.verdict, valid, tuple(s.id for s in found.steps), latex_of(found))


# --- the bodies of a problem as those of sympy.physics.mechanics


class InertialFrame(NamedTuple):
    """An inertial frame, its fixed origin, and the bodies that move in it."""

    frame: Any
    origin: Any
    bodies: tuple[Any, ...]


def space(study: Study, written: Callable[[Scalar], Any]) -> InertialFrame:
    """The bodies with frames, points and velocities; `written` makes sympy of a value."""
    frame, origin = mechanics.ReferenceFrame("N"), mechanics.Point("O")
    origin.set_vel(frame, 0)

    def plane(vector: Vector) -> Any:
        return written(vector.x) * frame.x + written(vector.y) * frame.y

    def body(name: str, state: BodyState) -> Any:
        center = origin.locatenew(f"{name}_cm", plane(state.center))
        center.set_vel(frame, plane(state.velocity))
        if study.problem.body(name).shape.kind == "particle":
            return mechanics.Particle(name, center, written(state.mass))
        own = frame.orientnew(f"{name}_frame", "Axis", (written(state.pose.angle), frame.z))
        own.set_ang_vel(frame, written(state.omega) * frame.z)
        about_center = mechanics.inertia(own, 0, 0, written(state.moment))
        return mechanics.RigidBody(name, center, own, written(state.mass), (about_center, center))

    return InertialFrame(frame, origin, tuple(body(name, state) for name, state in study.system.bodies.items()))


# ---


class Halves(Frozen):
    """What belongs to the motion of the centre of mass, and what to the turning about it; `on` each body apart."""

    translational: sympy.Expr
    rotational: sympy.Expr
    on: Mapping[str, Halves] = field(default_factory=dict)

    @property
    def total(self) -> sympy.Expr:
        """Both together."""
        return self.translational + self.rotational


class AngularMomentum(Frozen):
    """The component along z of an angular momentum: R × P of the centre of mass, and I_cm ω."""

    orbital: sympy.Expr
    spin: sympy.Expr

    @property
    def total(self) -> sympy.Expr:
        """Both together."""
        return self.orbital + self.spin


class Linearization(Frozen):
    """M δq̈ + C δq̇ + K δq = 0 about a place of rest, up to second order. `at` holds the coordinates that are not arbitrary;
    stable is None if it is not decided; what must hold for that place to exist, and for what is said of it."""

    at: Mapping[sympy.Expr, sympy.Expr]
    mass_matrix: sympy.Matrix
    damping: sympy.Matrix
    stiffness: sympy.Matrix
    stable: bool | None
    valid_where: tuple[sympy.Basic, ...] = ()

    @property
    def A(self) -> sympy.Matrix:
        """The matrix of d/dt (δq, δq̇) = A (δq, δq̇)."""
        size = self.mass_matrix.rows
        accelerations = self.mass_matrix.LUsolve(-sympy.Matrix.hstack(self.stiffness, self.damping))
        return sympy.Matrix.vstack(sympy.Matrix.hstack(sympy.zeros(size), sympy.eye(size)), accelerations)


def together(on: Mapping[str, Halves]) -> Halves:
    """The halves of all bodies."""
    parts = on.values()
    return Halves(sympy.Add(*(each.translational for each in parts)), sympy.Add(*(each.rotational for each in parts)), on)
