"""How far what meets is apart."""

from rbpsym.errors import there
from rbpsym.field import NOTHING, Scalar, names_in, substitute, symbol, time_derivative
from rbpsym.proof.checks.courses import EventCheck, closing, course_of
from rbpsym.proof.checks.of_steps import same
from rbpsym.proof.checks.places import own_place
from rbpsym.proof.context import Context
from rbpsym.statement.model import Phase


def _then(context: Context, phase: Phase) -> Scalar:
    gap, coordinates = _gap(context, phase), {*context.study.system.coordinates}
    return substitute(gap, {n: course_of(context, own_place(context, n))[0] for n in names_in(gap) & coordinates})


def _there(context: Context, phase: Phase) -> Scalar:
    gap, free = _gap(context, phase), {*context.study.system.independent}
    return substitute(gap, {n: context.start(symbol(n)) for n in names_in(gap) & free if _rests(context, n)})


def _gap(context: Context, phase: Phase) -> Scalar:
    return substitute(closing(context.study.system, there(phase.gap)), context.study.system.dependent)


def _rests(context: Context, name: str) -> bool:
    """Whether a coordinate keeps its start: nothing moves it, and it does not move at first."""
    rate = symbol(f"{name}_dot")
    gain = context.on_motion(time_derivative(rate, context.study.system.scope))
    return not context.start(rate) and same(context, gain, NOTHING).is_proved


CHECK = EventCheck(_then, _there)
