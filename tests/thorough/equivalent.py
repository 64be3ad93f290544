"""Mutants of the source that change nothing that can be seen, by the name that `mutants.key` gives them, with the reason."""

SAMPLE = "which of many sets of sample numbers is drawn; all of them are as good"
SIGN = "a sign is its own inverse"
ONLY_SIGN = "only its sign is asked for"
EFFORT = "a bound of effort or a margin, whose exact size is no matter of right and wrong"
NEVER_EQUAL = "a number of floating point beside a tolerance is not just equal to it"

EQUIVALENT: dict[str, str] = {
    "mechanics/numbers.py _factor: 104729 -> 104730": SAMPLE,
    "mechanics/numbers.py _parameter: 1.0 + 0.31 * ((place * 7) % 5) / 2 -> (1.0) - (0.31 * ((place * 7) % 5) / 2)": SAMPLE,
    "mechanics/unsolvable.py _is_seen: abs(number(value, known)) > SEEN * max(1.0, *sizes) -> "
    "abs(number(value, known)) >= SEEN * max(1.0, *sizes)": NEVER_EQUAL,
    "mechanics/phase_checks.py check_collision: _at(study, along.dot(second - first), known) > -CLOSE -> "
    "_at(study, along.dot(second - first), known) >= -CLOSE": NEVER_EQUAL,
    "decide/factoring.py _factor_list: factor.terms[min(factor.terms)] < 0 -> "
    "factor.terms[min(factor.terms)] <= 0": "no coefficient of a polynomial is 0",
    "present/forms.py _with_denominator: i[1] > 0 -> i[1] >= 0": "no exponent of a monomial is 0",
    "present/forms.py _powers: item[1] > 0 -> item[1] >= 0": "no exponent of a monomial is 0",
    "algebra/squares.py _squared: total + Scalar(part) * odd * square ** (power // 2) -> "
    "(total) - (Scalar(part) * odd * square ** (power // 2))": "numerator and denominator both change their sign",
    "field/normal.py _multiple: denominator > 1 -> denominator >= 1": "a number over 1 is that number",
    "typeset/text.py _Text.rows: 0 -> 1": "where there is no row, none is moved to the right",
    "decide/points.py _pick: k > 0 -> k >= 0": SAMPLE,
    "decide/points.py _pick: k > 0 -> k <= 0": SAMPLE,
    "decide/points.py points: 0 -> 1": SAMPLE,
    "present/grouping.py _forms: len(form) > 1 -> len(form) >= 1": "a sum that becomes one term has factors as it is",
    "mechanics/interactions.py stretch: UNITY * sign -> (UNITY) / (sign)": SIGN,
    "mechanics/endings.py time_until: speed * sense -> (speed) / (sense)": SIGN,
    "mechanics/phase_checks.py check_still_slipping: _at(study, slip_speed(geometry, meeting(element, geometry)), known) * "
    "sense < -CLOSE -> _at(study, slip_speed(geometry, meeting(element, geometry)), known) * sense <= -CLOSE": NEVER_EQUAL,
    "field/normal.py without_inverses: 1 -> 2": "it is asked only whether it vanishes",
    "decide/sign_rules.py _on_range: max(parts) > 8 -> max(parts) >= 8": EFFORT,
    "decide/constants.py is_zero_number: 1 -> 2": EFFORT,
    "decide/signs.py Study.poly: 2 -> 3": EFFORT,
    "decide/reading.py Reading.raised: 0 -> 1": "no exponent of a monomial is 0",
    "proof/checks/solutions.py _terminal: other * value -> (other) / (value)": ONLY_SIGN,
    "proof/checks/places.py _beyond: 1 -> 2": ONLY_SIGN,
    "expr/latex/names.py _unknown: 1 -> 2": "of the names that are near only the nearest is told",
    "mechanics/numbers.py _parameter: 0.4 * generic -> (0.4) / (generic)": SAMPLE,
    "mechanics/numbers.py _parameter: 3 -> 4": SAMPLE,
    "mechanics/numbers.py _side: given < 0 -> given <= 0": "0 is on neither side",
    "present/grouping.py _nearer: a > 0 -> a >= 0": "no exponent of a monomial is 0",
    "chapters/methods/known_works.py steady: start[f\"{q}_dot\"] ** 2 -> (start[f\"{q}_dot\"]) * (2)":
    "what is constant drops out",
    "decide/constants.py _order: Fraction(1, 2) - turns -> (Fraction(1, 2)) + (turns)":
    "the two differ by a half turn: the orders by a factor 2 where one is odd, which the totient does not see",
    "mechanics/roots.py _principal: -Fraction(number) + 1 -> (-Fraction(number)) - (1)": "the two are the same modulo 2",
    "ask/numbers.py _digits: 1 -> 2": "the least number of figures that are told is 3",
    "decide/factoring.py _factor_list: 1 / rational -> (1) * (rational)": "factors have no content but their sign",
    "mechanics/events.py _changes_sign: way.sense > 0 -> way.sense >= 0": "a sense is 1 or -1",
    "proof/checks/places.py _beyond: wave(high) * sense -> (wave(high)) / (sense)": SIGN,
    "mechanics/numbers.py _parameter: place % 3 -> (place) * (3)": SAMPLE,
    "field/modular.py _random: int.from_bytes(blake2b(label.encode(), digest_size=8).digest(), \"big\") % (PRIME - 2) -> "
    "(int.from_bytes(blake2b(label.encode(), digest_size=8).digest(), \"big\")) * (PRIME - 2)": SAMPLE,
}
