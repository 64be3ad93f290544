"""Resistance as any power of the speed or an exponential of it, and what was asked in a trial of other textbooks: worked out by
hand before the engine was asked.

Symon 2; Marion 2, 3; Irodov 1.2, 1.3; Kleppner & Kolenkow 2, 6; Beer & Johnston 16, 17; Meriam & Kraige 3, 6; Goodman & Warner.
"""

from __future__ import annotations

import pytest

from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

ANSWERS = (
    ("exp-brake", "time until x comes to rest", "m*u/b*(1-exp(-v_0/u))"),
    ("exp-brake", "x where x comes to rest", "m*u**2/b*(1-(1+v_0/u)*exp(-v_0/u))"),
    ("exp-brake", "speed of x as a function of t", "-u*ln(exp(-v_0/u)+b*t/(m*u))"),
    ("exp-brake", "v_0 for which time until x comes to rest = m*u/(2*b)", "u*ln(2)"),
    ("exp-brake", "time until x comes to rest in the limit v_0 -> oo", "m*u/b"),
    ("drag-three-halves", "total way of x", "2*m*v_0**2/F_0"),
    ("drag-three-halves", "speed of x as a function of x", "v_0*(1-F_0*x/(2*m*v_0**2))**2"),
    ("drag-three-halves", "speed of x as a function of t", "v_0/(1+F_0*t/(2*m*v_0))**2"),
    ("drag-three-halves", "time until speed of x = v_0/4", "2*m*v_0/F_0"),
    ("root-drag", "time until x comes to rest", "2*m*v_0/F_0"),
    ("root-drag", "x where x comes to rest", "2*m*v_0**2/(3*F_0)"),
    ("spun-cubic", "total angle of phi", "2*I*omega_0**2/tau"),
    ("spun-cubic", "number of turns of phi until speed of phi = omega_0/4", "I*omega_0**2/(2*pi*tau)"),
    ("drum-and-load", "number of turns of drum until y = h", "h/(2*pi*r)"),
    ("drum-and-load", "displacement of phi where y = h", "-h/r"),  # phi has no start of its own
    ("drum-and-load", "M_f for which y where y comes to rest = h", "(g*m*h + m*v_0**2/2 + I*v_0**2/(2*r**2))*r/h"),
    ("spin-on-slope", "time until rolling", "omega_0*R/(g*(3*mu*cos(beta)-sin(beta)))"),
    ("spin-on-slope", "displacement of s where s comes to rest",
     "omega_0**2*R**2*(mu*cos(beta)-sin(beta))/(4*g*sin(beta)*(3*mu*cos(beta)-sin(beta)))"),  # through both phases
    ("spin-on-slope", "energy lost until rolling", "mu*cos(beta)*m*omega_0**2*R**2/(2*(3*mu*cos(beta)-sin(beta)))"),
    ("half-disk-on-slope", "friction coefficient needed at N in equilibrium", "tan(beta)"),  # at rest, not as it swings by
    ("half-disk-on-slope", "equilibrium of phi", "asin(3*pi*sin(beta)/4)"),
    ("half-disk-on-slope", "frequency of phi in the limit beta -> 0", "sqrt(8*g/(R*(9*pi-16)))"),
    ("half-disk-on-slope", "beta for which the equilibrium of phi is stable", "asin(4/(3*pi))"),
    ("half-disk-on-slope", "is the equilibrium of phi stable", "yes"),
    # limits of what answers a question about parameters
    ("morse", "smallest v_0 for which x reaches L", "sqrt(2*E/m)*(1-exp(-L/a))"),
    ("morse", "smallest v_0 for which x reaches L in the limit L -> oo", "sqrt(2*E/m)"),
    ("spin-on-slope", "largest s in the limit mu -> oo", "omega_0**2*R**2/(12*g*sin(beta))"),
    ("spin-on-slope", "ratio of energy lost until rolling to kinetic energy at the start in the limit mu -> oo", "2/3"),
    ("spun-cubic", "tau for which total angle of phi = 20*pi", "I*omega_0**2/(10*pi)"),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: value[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)
