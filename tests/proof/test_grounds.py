"""Each ground of a sentence is true of what it tells and false where one part of that is not so."""

from types import SimpleNamespace as Told

import pytest

from rbpsym.decide.verdict import PROVED, UNDECIDED
from rbpsym.expr import tree as t
from rbpsym.field.scalar import NOTHING, lift, symbol
from rbpsym.field.vector import ORIGIN, cartesian
from rbpsym.proof import grounds as g
from rbpsym.proof import grounds_works as w

X, Y, F, C, RATE = symbol("x"), symbol("y"), symbol("F"), symbol("C"), symbol("theta_dot")
MOVING = {"t", "x", "x_dot", "x_ddot"}


def step(proved: bool = True, **parts) -> Told:
    kind = PROVED if proved else UNDECIDED
    return Told(certificate=Told(verdict=Told(kind=kind)), **{"slots": {}, "data": {}, **parts})


def rows(*rights: t.Node, left: t.Node | None = None) -> list[t.Chain]:
    return [t.equation(left or t.Sym("a"), right) for right in rights]


def force(name="N", on="rod", by="", point=ORIGIN, vector=ORIGIN, couple=NOTHING, unknowns=("N",)) -> Told:
    return Told(name=name, on=on, by=by, point=point, vector=vector, couple=couple, unknowns=unknowns)


@pytest.mark.parametrize(
    ("ground", "right", "told"),
    [
        (g.is_of_position_and_speed, "m", True), (g.is_of_position_and_speed, "x", True),
        (g.is_of_position_and_speed, "x_dot", True), (g.is_of_position_and_speed, "x_ddot", False),
        (g.is_of_position_and_speed, "t", False), (g.is_of_position, "x", True), (g.is_of_position, "x_dot", False),
        (g.is_of_position, "x_ddot", False), (g.is_of_position, "t", False), (g.is_steady, "m", True),
        (g.is_steady, "x", False), (g.is_steady, "t", False),
    ],
)  # fmt: skip
def test_what_stands_on_the_right(ground, right, told):
    said = Told(step=step(), rows=rows(t.Sym("m"), t.mul(t.Sym("m"), t.Sym(right))), moving=MOVING)
    assert ground(said) is told
    left = Told(step=step(), rows=rows(t.Sym("m"), left=t.Sym("x_ddot")), moving=MOVING)
    assert ground(left)


@pytest.mark.parametrize(
    ("omega", "back", "still"), [(RATE, False, False), (-RATE, True, False), (NOTHING, False, True), (RATE - 2, False, False)]
)
def test_how_a_body_turns(omega, back, still):
    states = {"rod": Told(omega=omega)}
    said = Told(
        step=step(slots={"coordinates": [t.Sym("phi"), t.Sym("theta")]}), slot=lambda name: "rod", system=Told(bodies=states)
    )
    assert (g.is_turned_back(said), g.does_not_turn(said), g.nothing_turns(said)) == (back, still, still)


TORQUES = {
    "through the point": ([force(point=cartesian(X, Y), vector=cartesian(X * F, Y * F))], True),
    "beside it": ([force(point=cartesian(X, Y), vector=cartesian(F, NOTHING))], False),
    "a couple": ([force(couple=C)], False),
    "a couple against it": ([force(point=cartesian(X, NOTHING), vector=cartesian(NOTHING, F), couple=-X * F)], True),
    "a couple with it": ([force(point=cartesian(X, NOTHING), vector=cartesian(NOTHING, F), couple=X * F)], False),
    "one of two": ([force(), force(point=cartesian(X, Y), vector=cartesian(F, NOTHING))], False),
    "known ones": ([force(point=cartesian(X, Y), vector=cartesian(F, NOTHING), unknowns=())], True),
}


@pytest.mark.parametrize("name", TORQUES)
def test_all_lines_meet_where_no_unknown_force_has_a_torque(name):
    forces, told = TORQUES[name]
    assert g.all_lines_meet(Told(step=step(data={"forces": forces, "origin": ORIGIN}))) is told
    away = cartesian(lift(1), lift(2))
    moved = [force(point=f.point + away, vector=f.vector, couple=f.couple, unknowns=f.unknowns) for f in forces]
    assert g.all_lines_meet(Told(step=step(data={"forces": moved, "origin": away}))) is told
    assert not g.all_lines_meet(Told(step=step(False, data={"forces": forces, "origin": ORIGIN})))


@pytest.mark.parametrize(("left", "told"), [(t.Sym("L"), True), (t.ZERO, False)])
def test_a_spin_starts_to_turn(left, told):
    assert g.starts_to_turn(Told(step=step(), rows=rows(t.Sym("tau"), left=left))) is told
    assert not g.starts_to_turn(Told(step=step(False), rows=rows(t.Sym("tau"), left=left)))


ASIDE = cartesian(X, NOTHING)


@pytest.mark.parametrize(("apart", "vector", "told"), [(ORIGIN, True, True), (ASIDE, True, False), (ASIDE, False, True)])
def test_inner_forces_act_at_one_point(apart, vector, told):
    pull = cartesian(F, NOTHING) if vector else ORIGIN
    pair = [force(on="one", by="two", vector=pull), force(on="two", by="one", point=apart, vector=-pull)]
    terms = [(None, Told(id=f"torque.{name}")) for name in ("one", "two")]
    said = Told(
        step=step(data={"terms": terms}, statement=t.relation(t.Sym("a"), "=", t.Sym("b"))),
        system=Told(forces=[*pair, force(on="one", by="", point=cartesian(Y, Y))], unknowns=("N",)),
    )
    assert g.acts_at_same_points(said) is told


@pytest.mark.parametrize(("freedom", "driven"), [(True, True), (True, False), (False, True), (False, False)])
def test_what_is_free_or_driven_moves_and_what_is_driven_keeps_no_energy(freedom, driven):
    said = Told(step=step(), system=Told(independent=("x",) * freedom, has_clock=driven))
    assert w.can_move(said) is (freedom or driven)
    assert w.energy_has_no_drive(said) is w.is_not_carried(said) is (not driven)
    assert not w.energy_has_no_drive(Told(step=step(False), system=said.system))


ACCELERATIONS = {
    "of position": (X * C, "alone", "position"), "with its speed": (symbol("x_dot") * C, "alone"), "with another": (Y * C,),
    "with the speed of another": (symbol("y_dot"),), "constant": (C, "alone", "position"),
}  # fmt: skip


@pytest.mark.parametrize("stays", [True, False])
@pytest.mark.parametrize("name", ACCELERATIONS)
def test_of_what_an_acceleration_is(name, stays, monkeypatch):
    monkeypatch.setattr(w, "stays_at_rest", lambda said: stays)
    value, *kinds = ACCELERATIONS[name]
    study = Told(dynamics=Told(accelerations={"x_ddot": value}))
    said = Told(step=step(), slot=lambda name: "x", study=study, system=Told(independent=("x", "y")))
    assert w.acceleration_is_alone(said) is ("alone" in kinds)
    assert w.acceleration_is_of_position(said) is ("position" in kinds)
    assert w.acceleration_is_alone_and_does_not_stay(said) is ("alone" in kinds and not stays)
    assert w.acceleration_is_of_position_and_does_not_stay(said) is ("position" in kinds and not stays)


TOGETHER = {
    "at rest": ([(ORIGIN, ORIGIN, NOTHING, ORIGIN)], True),
    "moving": ([(ORIGIN, cartesian(X, NOTHING), NOTHING, ORIGIN)], False),
    "a point of a turning body that is at rest": ([(cartesian(X, NOTHING), cartesian(NOTHING, X * RATE), RATE, ORIGIN)], True),
    "another one": ([(cartesian(X, NOTHING), cartesian(NOTHING, X * RATE), RATE, cartesian(X, NOTHING))], False),
    "two with one velocity": ([(ORIGIN, cartesian(X, Y), NOTHING, ORIGIN), (ORIGIN, cartesian(X, Y), RATE, ORIGIN)], True),
    "two with two": ([(ORIGIN, cartesian(X, Y), NOTHING, ORIGIN), (ORIGIN, cartesian(Y, X), NOTHING, ORIGIN)], False),
}


@pytest.mark.parametrize("cancel", [True, False])
@pytest.mark.parametrize("name", TOGETHER)
def test_works_cancel_as_points_move_together(name, cancel, monkeypatch):
    monkeypatch.setattr(w, "works_cancel", lambda said: cancel)
    places, told = TOGETHER[name]
    bodies = {str(k): Told(center=c, velocity=v, omega=o) for k, (c, v, o, _) in enumerate(places)}
    forces = [force(on=str(k), point=point) for k, (*_, point) in enumerate(places)]
    said = Told(step=step(), forces=forces, system=Told(bodies=bodies))
    assert w.works_cancel_as_points_move_together(said) is (told and cancel)


@pytest.mark.parametrize("moves", [True, False])
def test_the_point_of_torques_moves(moves, monkeypatch):
    monkeypatch.setattr(g, "vector_rate", lambda origin, scope: cartesian(X, NOTHING) if moves else ORIGIN)
    for proved in (True, False):
        said = Told(step=step(proved, data={"origin": ORIGIN}), system=Told(scope=None))
        assert g.point_moves(said) is (moves and proved)


def test_a_chain_is_an_identity_where_its_ends_are_the_same_by_form():
    a, b, both = t.Sym("a"), t.Sym("b"), t.add(t.Sym("b"), t.Sym("a"))
    for items, told in (((a, a), True), ((a, b), False), ((t.add(a, b), a, both), True), ((a, a, b), False)):
        assert g.is_identity(Told(rows=[t.Chain(items, ("=",) * (len(items) - 1))])) is told


METHODS = {"torque": "PROVED", "newton": "PROVED"}


@pytest.mark.parametrize(
    ("summary", "agree", "confirmed"),
    [
        ({"methods": METHODS, "methods_agree": True, "lagrange": "UNDECIDED", "simulation": None}, True, True),
        ({"methods": METHODS, "methods_agree": False, "lagrange": "UNDECIDED", "simulation": None}, False, False),
        ({"methods": {"torque": "PROVED"}, "methods_agree": True, "lagrange": "PROVED", "simulation": None}, False, True),
        ({"methods": {**METHODS, "energy": ""}, "methods_agree": True, "lagrange": "", "simulation": None}, False, False),
        ({"methods": {}, "methods_agree": True, "lagrange": "", "simulation": {"max_relative_error": 1e-9}}, False, True),
        ({"methods": {}, "methods_agree": True, "lagrange": "", "simulation": {"max_relative_error": 1e-3}}, False, False),
    ],
)
def test_what_confirms_a_derivation(summary, agree, confirmed):
    said = Told(summary=summary)
    assert w.methods_agree(said) is agree
    assert w.is_confirmed(said) is confirmed


@pytest.mark.parametrize(("checks", "told"), [((2, 2, 1), True), ((2, 1), False), ((1, 1, 3), False)])
def test_most_steps_are_checked_twice(checks, told):
    said = Told(steps=[Told(certificate=Told(checks=("",) * count)) for count in checks])
    assert w.most_are_checked_twice(said) is told


@pytest.mark.parametrize(("fixed", "told"), [(("x", "y"), True), (("x",), False), (("y",), False)])
def test_a_family_of_places_is_not_one_place(fixed, told):
    system = Told(independent=("x", "y"))
    assert g.is_one_place(Told(step=step(data={"at": dict.fromkeys(fixed)}), system=system)) is told
    assert not g.is_one_place(Told(step=step(False, data={"at": dict.fromkeys(fixed)}), system=system))
