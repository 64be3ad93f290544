"""Questions of all kinds and their answers: about parameters (see `parameters`), or about a quantity."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress

from rbpsym.ask.answer import answer, found_of
from rbpsym.ask.asked import Asked, struck_phases
from rbpsym.ask.certified import LETTER
from rbpsym.ask.finding import Finding
from rbpsym.ask.found import Answer, Found
from rbpsym.ask.parameters import WITH, finding, of_parameters, resorted
from rbpsym.ask.placed import met
from rbpsym.ask.plainly import plain_words
from rbpsym.ask.question import MANNERS, SUPERLATIVES, read_question
from rbpsym.ask.seen import scene
from rbpsym.ask.senses import converse, taken_for_kept, under, whichever
from rbpsym.ask.special import COEFFICIENT, special_problem, with_coefficient
from rbpsym.ask.units import in_letters
from rbpsym.errors import Ambiguous, RbpsymError, ReadError, StatementError, Undecided, WorkSpent
from rbpsym.field import depends_on, granted
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.arrivals import mover
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.quantities import NUMBER
from rbpsym.quantity.bound import Bound, number
from rbpsym.statement.checks import unknowns_of
from rbpsym.statement.model import Problem
from rbpsym.typeset.machine import to_machine

MOST_PRODUCTS = 10_000_000  # for one question, some ten seconds: three times what the longest that is tested takes
LESS = "ask of one phase or place, or “with” special values."
# what a motion as a function of the time tells, and is no question about parameters
OF_TIME = re.compile(r"as (?:a )?functions? of (?:t|time)$")
OF_COURSE = re.compile("|".join((*MANNERS, r"(?:greatest|largest|maximum) speed of \w+$")))


class Refused(Frozen):
    """A question of a problem file without an answer, and the sentence that says why."""

    text: str
    reason: str


def own_answers(study: Study) -> Iterator[Answer | Refused]:
    """What the problem of a study asks itself, each with its answer or with the sentence why there is none."""
    return answered_all(study, letters(study))


def answered_all(study: Study, questions: Mapping[str, str]) -> Iterator[Answer | Refused]:
    """The same of questions, each with the letter by which its answer is called."""
    asked = Asked(study.problem, study)
    for text, letter in questions.items():
        try:
            if (text, letter) not in study.answered:
                study.answered[text, letter] = answered(asked, text, letter)
            yield study.answered[text, letter]
        except RbpsymError as error:
            yield Refused(text, error.what)


def letters(study: Study) -> dict[str, str]:
    """By what the answers to a problem's own questions are called, each with a letter of its own."""
    texts = study.problem.questions
    of = {text: led[1] if (led := LED.fullmatch(text)) else text for text in texts}
    stems = {quantity: _stem(quantity, study) for quantity in of.values()}
    alike = {stem: [quantity for quantity in stems if stems[quantity] == stem] for stem in stems.values()}
    marks = {q: f"_{alike[stem].index(q) + 1}" if len(alike[stem]) > 1 else "" for q, stem in stems.items()}
    return {text: f"{stems[of[text]]}{marks[of[text]]}" for text in texts}


LED = re.compile(r"\w+ for which (?:the )?(.+) is \w+")  # what is called by the letter there is the quantity, no parameter


# what a book calls a quantity of this name: along a line, of an angle
STEMS: Mapping[str, tuple[str, str]] = {
    "period": ("T", "T"), "frequency": ("vartheta", "vartheta"), "moment of inertia": ("I", "I"),
    "angular velocity": ("omega", "omega"), "angular acceleration": ("alpha", "alpha"), "angular momentum": ("L", "L"),
    "speed": ("v", "omega"), "velocity": ("v", "omega"), "acceleration": ("a", "alpha"), "time": ("t", "t"),
    "decay rate": ("gamma", "gamma"), "impulse": ("J", "J"), "energy lost": ("E_lost", "E_lost"),
    "kinetic energy": ("K", "K"), "potential energy": ("U", "U"), "energy": ("E", "E"), "work": ("W", "W"),
    "linear momentum": ("P", "P"), "momentum": ("P", "P"), "power": ("P", "P"), "torque": ("tau", "tau"),
    "couple": ("tau", "tau"), "tension": ("T", "T"), "normal force": ("N", "N"), "friction": ("f", "f"),
    "(?:spring |net )?force": ("F", "F"), "reaction": ("F", "F"), "distance": ("d", "d"), "position": ("r", "r"),
}  # fmt: skip
AT_REST = re.compile(r"(?:(?:stable|unstable) )?equilibri(?:um|a) of (\w+)")
BEST = re.compile(r"(?:(largest|greatest|maximum|highest)|(smallest|least|minimum|lowest)) (\w+)(?: for which .*)?")
SIZE = r"(?:the )?(?:(?:lowest|highest|damped|magnitude of|size of|total|mechanical|largest|greatest|smallest|least) )*(?:the )?"
ASKED = re.compile(rf"{SIZE}(?:({'|'.join(STEMS)})\b(?: (?:of|on) (?:the )?(\w+)\b)?|(\w+))")


def _stem(text: str, study: Study) -> str:
    """The letter of a question's answer: the usual one of its quantity, with what it is of, if the problem has another use for
    the letter alone; a force has the usual one of forces."""
    names = (*study.system.coordinates, *study.system.unknowns, *(q.name for q in study.problem.parameters), COEFFICIENT)
    if (best := BEST.fullmatch(text)) and best[3] in names:
        return study.letters.free(f"{best[3]}_{'max' if best[1] else 'min'}")
    if rests := AT_REST.fullmatch(text):
        return study.letters.free(f"{rests[1]}_eq")
    said = ASKED.match(text)
    if said and said[3] in study.letters.forces:
        return next((name for name in ("F", f"F_{said[3]}") if study.letters.free(name) == name), LETTER)
    if not said or said[3]:
        return LETTER
    turns = any(said[2] == c.name and c.quantity.dimension == NUMBER for c in study.problem.coordinates)
    wanted = next(letters for noun, letters in STEMS.items() if re.fullmatch(noun, said[1]))[turns]
    wishes = (wanted, *([f"{wanted}_{said[2]}"] if said[2] else []), f"{wanted}_1", LETTER)
    return next(name for name in wishes if name == LETTER or study.letters.free(name) == name)


def found_in(study: Study, text: str) -> Found | Finding:
    """What is found in a study for a question of its problem, without steps. Raises RbpsymError."""
    asked = with_coefficient(Asked(study.problem, study), text)
    plain = plain_words(asked, text)
    about = finding(asked, plain)
    return about[1] if about else found_of(asked, read_question(plain))


def meant_by(study: Study, text: str) -> Bound | None:
    """What a claim calls by a question: the one value that is proved to answer it; None where there is none."""
    with suppress(RbpsymError):
        found = answered(Asked(study.problem, study), text)
        return number(found.value) if found.verdict.is_proved and found.values else None
    return None


def ask(problem: Problem, *questions: str) -> list[Answer]:
    """The answers to questions about a problem, to its own ones if none are given. Raises StatementError for one that has none.

    >>> import rbpsym
    >>> [found] = rbpsym.ask("rod-pendulum", "F_y in equilibrium")
    >>> found.text, str(found.verdict.kind)
    ('M*g', 'PROVED')
    """
    from rbpsym.ask.words.reader import spread

    asked = Asked(problem)
    return [answered(asked, one) for text in questions or problem.questions for one in spread(problem, text)]


def answered(asked: Asked, text: str, letter: str = LETTER) -> Answer:
    """The answer to one question, called by the letter. Raises as `ask`, and WorkSpent where it takes too much work."""
    try:
        with granted(MOST_PRODUCTS):
            other, plain, given = in_letters(with_coefficient(asked, text), text)
            found = _in_its_words(other, plain, letter)
            given = {**found.given, **given}
            return found if plain == text else replace(found, question=replace(found.question, text=text), given=given)
    except WorkSpent as error:
        raise WorkSpent(f"“{text}”: {error.what}", instead=LESS) from None


def _in_its_words(asked: Asked, plain: str, letter: str) -> Answer:
    """The answer to a question, or to what the grammar of a book's English makes of it, if that is proved. Raises StatementError
    where it may mean several things with other answers."""
    try:
        return _ended(asked, _stated(asked, plain, letter), plain)
    except Ambiguous:
        raise
    except (StatementError, ReadError) as error:
        refused = error
    from rbpsym.ask.words.reader import PLURAL, read

    found: dict[str, Answer] = {}
    errors: dict[str, RbpsymError] = {}
    readings = read(asked.problem, plain)
    if len(readings) > 1 and PLURAL.match(plain):
        raise Ambiguous(f"“{plain}” asks several things", instead=f"ask {' and '.join(f'“{text}”' for text in readings)}.")
    for text in readings:
        try:
            one = _ended(asked, _stated(asked, text, letter), plain)
            if one.verdict.is_proved and not any(_is_one(one, other) for other in found.values()):
                found[text] = one
        except RbpsymError as error:
            errors[text] = error
    if len(found) > 1:
        told = " or ".join(f"“{text}”" for text in found)
        raise Ambiguous(f"“{plain}” may mean several things", instead=f"write {told}.")
    for text, one in found.items():
        return replace(one, question=replace(one.question, text=plain), read_as=text)
    raise _refusal(asked.problem, plain, refused, errors)


def _ended(asked: Asked, found: Answer, plain: str) -> Answer:
    """The answer, if it is one value where one at the end is asked for. Raises StatementError for what still changes."""
    is_moving = found.holds or any(depends_on(value, "t") for value in found.values)
    if is_moving and ENDING.match(plain):
        how = f"say until when: {moments_of(asked.problem, True)}." if plain[:3].lower() == "how" else "say where, or when."
        raise StatementError("it changes along the motion", instead=how)
    return found


def _refusal(problem: Problem, plain: str, refused: RbpsymError, errors: Mapping[str, RbpsymError]) -> RbpsymError:
    """Why a question has no answer: what one says that it was read as, or else which of its words are not understood."""
    from rbpsym.ask.words.reader import unread

    if NOTHING_MEANT not in refused.what:
        return refused
    told = {text: error for text, error in errors.items() if NOTHING_MEANT not in error.what}
    if len(told) == 1:
        [(text, error)] = told.items()
        return StatementError(f"“{plain}”, read as “{text}”: {error.what}", instead=error.instead)
    if parts := unread(problem, plain):
        said = moments_of(problem, counted=COUNTED.match(parts[0]) is not None)
        return StatementError(f"“{parts[1]}” is not understood behind “{parts[0]}”", instead=f"write {said}.")
    return refused


ENDING = re.compile(r"how (?:far|many|much|long)\b|(?:.* )?final \w", re.I)
NOTHING_MEANT = "means nothing in the problem"


def moments_of(problem: Problem, counted: bool = False) -> str:
    """How the moments and the parts of a problem's motion are said; of what is counted over it, how its ends are."""
    names = [coordinate.name for coordinate in problem.coordinates]
    phases = [f"in phase {phase.name}" for phase in problem.phases]
    if counted:
        told = [*(f"until {name} = VALUE" for name in names[:2]), "until it stops", *phases]
    else:
        struck = ["right after impact", "just before impact"] if len(struck_phases(problem)) == 1 else []
        held = [f"where {e.name} vanishes" for e in problem.constraints if e.kind == "contact"]
        told = ["at the start", *struck, *phases, *(f"where {name} = VALUE" for name in names[:2]), *held[:1]]
    return ", ".join(f"“{one}”" for one in told) + ("" if counted else " or no moment at all")


COUNTED = re.compile(r".*\b(?:time|distance|work|energy lost|heat|turns|revolutions|turned)\b")


def _is_one(found: Answer, other: Answer) -> bool:
    """Whether two answers say the same."""
    return (found.relation, found.says, found.values, found.symbol) == (other.relation, other.says, other.values, other.symbol)


def _stated(asked: Asked, plain: str, letter: str) -> Answer:
    """The answer, which hangs on no mass that the statement leaves out, as forces do. Raises StatementError for one that does."""
    problem = asked.problem
    try:
        found = _whole(asked, plain, letter)
    except (StatementError, ReadError):
        forces = {name for element in problem.constraints for name in (element.name, *unknowns_of(element))}
        if problem.unstated and forces & set(re.findall(r"(?<![.\w])\w+(?![.\w])", plain)):
            raise StatementError(f"“{plain}” is a force: it hangs on masses, which are not stated", instead=ADD_MASSES) from None
        raise
    missed = [name for name in problem.unstated if any(depends_on(value, name) for value in found.values)]
    if missed:
        raise StatementError(f"“{plain}” hangs on masses, which are not stated", instead=ADD_MASSES)
    return taken_for_kept(found, lambda other: _whole(Asked(other), plain, letter)) if found.study.problem.kept else found


ADD_MASSES = 'give each body its mass = "M".'


def _whole(asked: Asked, text: str, letter: str) -> Answer:
    plain = plain_words(asked, text)
    if plain != (own := " ".join(text.split()).rstrip(" ?.")):
        found = _whole(asked, plain, letter)
        return replace(found, question=replace(found.question, text=own))
    if (said := WITH.fullmatch(plain)) and OF_TIME.search(said[1]):
        found = _whole(Asked(special_problem(scene(asked), said[2])), said[1], letter)
        return replace(found, question=replace(found.question, text=plain))
    if inverse := converse(asked, plain):
        return _by_letter(inverse, plain, letter)
    in_time = read_question(plain) if OF_COURSE.search(plain) else None
    if in_time is not None and in_time.manner:
        return answer(asked, in_time, letter)
    if in_time is not None and (in_time.phase or asked.lasting + 1 == len(asked.names)):  # of several phases: of all
        with suppress(StatementError):
            return answer(asked, in_time, letter)
    if (spelt := met(asked, plain)) != plain:
        return replace(found := _whole(asked, spelt, letter), question=replace(found.question, text=plain))
    try:
        found = _answered(asked, plain, letter)
    except (StatementError, ReadError):
        with suppress(RbpsymError):  # by the time at which the coordinate has that value
            if inverse := converse(asked, plain, last=True):
                return _by_letter(inverse, plain, letter)
        with suppress(RbpsymError):
            if other := _by_quantity(asked, plain, letter):
                return other
        raise
    return whichever(asked, found, lambda other: _answered(other, plain, letter))


_MOST = f"(?:{'|'.join(SUPERLATIVES)})"
PLACED = re.compile(rf"(.+?),? (where|when|once|until|as soon as) (\w+ .+? (?:=|reaches|is) .+|\w+ is {_MOST})")
BEYOND = re.compile(rf"(.+) is ({_MOST})")


def _by_quantity(asked: Asked, plain: str, letter: str) -> Answer | None:
    """What is asked for where another quantity has a value: where the coordinate that moves, or else the time, is what makes it
    so, which is proved first; None where that is not one place. Of a ratio each part is spelt as a question of its own."""
    texts, places = list[str](), list[Answer]()
    parts = re.split(PARTING, plain.removeprefix(RATIO)) if plain.startswith(RATIO) else [plain]
    for part in parts:
        text = met(asked, plain_words(asked, part)) if len(parts) == 2 else part
        if (placed := _place_of(asked, text, letter)) is not None:
            asked, text = under(asked, placed[1]), placed[0]
            places.append(placed[1])
        texts.append(text)
    if (spelt := f"{RATIO}{' to '.join(texts)}" if len(parts) > 1 else texts[0]) == plain:
        return None
    found = _whole(asked, spelt, letter)
    first = [replace(step, id=f"place{k or ''}.{step.id}") for k, place in enumerate(places)
             for step in place.steps if step not in found.steps]  # fmt: skip
    valid = [node for place in places for node in place.valid]
    return replace(found, question=replace(found.question, text=plain), steps=(*first, *found.steps),
                   valid=tuple(dict.fromkeys((*valid, *found.valid))))  # fmt: skip


RATIO, PARTING = "ratio of ", r"(?<!relative)(?<!up)(?<!due) to "


def _place_of(asked: Asked, plain: str, letter: str) -> tuple[str, Answer] | None:
    """The question of a coordinate or the time that has a value, and what finds that; None where it is not one place."""
    if (said := PLACED.fullmatch(plain)) is None:
        return None
    name, value = mover(asked.study(asked.lasting)) or "t", said[3]
    if name == "t":  # as a function of that, which its equation asks for
        value = re.sub(r" (?:=|reaches|is) ", " as a function of t = ", value, count=1)
    elif re.match(rf"{name} (?:=|reaches|is) (?!{_MOST})", value):
        return None
    best = BEYOND.fullmatch(said[3])
    place = _whole(asked, f"where is {best[1]} {best[2]}" if best else f"{name} for which {value}", letter)
    if not (place.verdict.is_proved and len(place.values) == 1 and place.symbol and place.relation == "="):
        return None
    phase = ""
    if asked.problem.phases and " in phase " not in plain:  # what the coordinate is there, it is in that phase
        numbers = [number for number in range(len(asked.names)) if asked.study(number) is place.study]
        if not numbers:
            return None
        phase = f" in phase {asked.names[numbers[0]]}"
    return f"{said[1]}{phase} {said[2]} {place.symbol} = {to_machine(present(place.values[0]))}", place


def _by_letter(inverse: tuple[Asked, str, str, str], plain: str, letter: str) -> Answer:
    other, asking, stands, what = inverse
    found = _whole(other, asking, letter)
    is_plain = " " not in what
    told = {"given": {stands: what}} if is_plain else {"says": found.says or f"{stands} is {what}"}
    return replace(found, question=replace(found.question, text=plain), **told)


def _answered(asked: Asked, plain: str, letter: str) -> Answer:
    """The same for one sense of the motion."""
    said = WITH.fullmatch(plain)
    try:
        made = of_parameters(asked, plain, letter)
        if made and made.verdict.is_refuted:
            raise Undecided(f"what was found for “{plain}” is refuted by its own check, and is not told")
        found = made or answer(asked, read_question(plain), letter)
        return (said and not found.verdict.is_proved and _with_these(asked, said, letter)) or found
    except (StatementError, ReadError, Undecided):
        if other := (said and _with_these(asked, said, letter)) or resorted(asked, plain, letter):
            return other
        raise


def _with_these(asked: Asked, said: re.Match[str], letter: str) -> Answer | None:
    """What is proved where parameters have these values from the beginning; None if nothing is."""
    with suppress(RbpsymError):
        found = _whole(Asked(special_problem(scene(asked), said[2])), said[1], letter)
        return replace(found, question=replace(found.question, text=said[0])) if found.verdict.is_proved else None
    return None
