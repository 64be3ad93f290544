"""The sentences of marks, in each language. {name} is a place; a tree in a place is printed as a formula."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from rbpsym.document.model import Inlines, Math, Text
from rbpsym.notation.tree import Node
from rbpsym.teaching.grading.judgement import Judgement, Remark
from rbpsym.teaching.model import Slip

SENTENCES: Mapping[str, Mapping[str, str]] = {
    "en": {
        "empty": "No answer.",
        "invalid": "This can't be read: {why}",
        "zero division": "This divides by zero.",
        "undecided": "It could not be decided whether this is right ({reason}).",
        "open": "An answer in words.",
        "wrong": "This is not equal to the result.",
        "at": "They differ {witness}.",
        "circular": "The answer holds {name}, which is asked for.",
        "chain": "The last side is right, but another side of the chain is not equal to it.",
        "other side": "Solve for {left} and enter the right side.",
        "equation": "Enter the right side alone.",
        "equation wanted": "An equation is asked for.",
        "other equation": "This equation says something else.",
        "identity": "This equation is always true; it says nothing about what is asked.",
        "unsolved": "The equation is right, but not yet solved for {left}.",
        "unfinished": "True on the motion, but {names} should not stand in the result.",
        "read as": "Read as {formula}.",
        "carried": "Right with your own earlier result.",
        "slip": "{slip}",
        "first wrong": "The first step that goes wrong should read: {step}",
        "sign": "The sign is wrong.",
        "factor": "The result is wrong by a factor of {factor}.",
        "dimension": "Your answer is {found}; {wanted} is asked for.",
        "dimensions": "The dimensions don't fit: {why}.",
        "zero": "Zero is not the result.",
        "wrong value": "The value is wrong.",
        "power of ten": "The value is wrong by a power of ten.",
        "degrees": "Degrees and radians are mixed up.",
        "unit missing": "The unit is missing.",
        "unit wrong": "The unit does not fit.",
        "unit cycles": "Hertz count turns, radians per second count angle: they differ by 2π.",
        "too few figures": "Too few significant figures: {digits} are asked for.",
        "too many figures": "Too many significant figures: {digits} are asked for.",
        "blank": "Blank {number}:",
        "not an option": "“{text}” is none of the options; enter one of {options}.",
        "wrong option": "This is not the right option.",
        "wrong order": "{right} of {all} conditions on the order hold.",
        "not an order": "Enter each of {options} once, in order.",
        "wrong line": "The slip is in another line.",
        "right line": "The line is right.",
        "wrong correction": "The line is right; the corrected formula is not.",
        "rows": "{right} of {all} rows are right.",
        "cancelling": "Mark the rows whose works cancel with the same letter; these marks are not right.",
        "not signs": "{wanted} signs (+, - or 0) are asked for; {found} were found.",
    },
    "es": {
        "empty": "Sin respuesta.",
        "invalid": "No se puede leer: {why}",
        "zero division": "Aquí se divide por cero.",
        "undecided": "No se pudo decidir si es correcto ({reason}).",
        "open": "Una respuesta con palabras.",
        "wrong": "No es igual al resultado.",
        "at": "Difieren {witness}.",
        "circular": "La respuesta contiene {name}, que es lo que se pide.",
        "chain": "El último miembro es correcto, pero otro miembro de la cadena no es igual a él.",
        "other side": "Despeja {left} y escribe el miembro derecho.",
        "equation": "Escribe solo el miembro derecho.",
        "equation wanted": "Se pide una ecuación.",
        "other equation": "Esta ecuación dice otra cosa.",
        "identity": "Esta ecuación se cumple siempre; no dice nada de lo que se pide.",
        "unsolved": "La ecuación es correcta, pero falta despejar {left}.",
        "unfinished": "Es cierto durante el movimiento, pero {names} no debe figurar en el resultado.",
        "read as": "Leído como {formula}.",
        "carried": "Correcto con tu propio resultado anterior.",
        "slip": "{slip}",
        "first wrong": "El primer paso que falla debería decir: {step}",
        "sign": "El signo es incorrecto.",
        "factor": "El resultado difiere en un factor {factor}.",
        "dimension": "Las dimensiones no corresponden a lo que se pide.",
        "dimensions": "Las dimensiones de los términos no concuerdan.",
        "zero": "El resultado no es cero.",
        "wrong value": "El valor es incorrecto.",
        "power of ten": "El valor difiere en una potencia de diez.",
        "degrees": "Se confunden grados y radianes.",
        "unit missing": "Falta la unidad.",
        "unit wrong": "La unidad no corresponde.",
        "unit cycles": "El hercio cuenta vueltas y el radián por segundo, ángulo: difieren en 2π.",
        "too few figures": "Faltan cifras significativas: se piden {digits}.",
        "too many figures": "Sobran cifras significativas: se piden {digits}.",
        "blank": "Hueco {number}:",
        "not an option": "«{text}» no es ninguna de las opciones; escribe una de {options}.",
        "wrong option": "No es la opción correcta.",
        "wrong order": "Se cumplen {right} de {all} condiciones sobre el orden.",
        "not an order": "Escribe cada una de {options} una vez, en orden.",
        "wrong line": "El error está en otra línea.",
        "right line": "La línea es correcta.",
        "wrong correction": "La línea es correcta; la fórmula corregida no.",
        "rows": "{right} de {all} filas son correctas.",
        "cancelling": "Marca con la misma letra las filas cuyos trabajos se cancelan; estas marcas no son correctas.",
        "not signs": "Se piden {wanted} signos (+, - o 0) y hay {found}.",
    },
}  # fmt: skip
_PLACE = re.compile(r"\{([a-z]+)\}")
SaySlip = Callable[[Slip, str], Inlines]


def said(remark: Remark, language: str, say_slip: SaySlip) -> Inlines:
    """A remark as a sentence."""
    text = SENTENCES.get(language, SENTENCES["en"])[remark.key]
    return tuple(_pieces(text, remark.slots, language, say_slip))


def _pieces(text: str, slots: Mapping[str, Any], language: str, say_slip: SaySlip) -> Iterator[Text | Math]:
    for place, piece in enumerate(_PLACE.split(text)):
        if place % 2:
            yield from _inlines(slots[piece], language, say_slip)
        elif piece:
            yield Text(piece)


def _inlines(value: Any, language: str, say_slip: SaySlip) -> Iterator[Any]:
    if isinstance(value, Node):
        yield Math(value)
    elif isinstance(value, Slip):
        yield from say_slip(value, language)
    elif isinstance(value, tuple):
        for place, item in enumerate(value):
            yield from ((Text(", "),) if place else ())
            yield from _inlines(item, language, say_slip)
    else:
        yield Text(str(value))


def comment(judgement: Judgement, language: str, say_slip: SaySlip) -> Inlines:
    """All remarks of a judgement, one after the other."""
    found: list[Any] = []
    for remark in judgement.remarks:
        found += [Text(" ")] if found else []
        found += said(remark, language, say_slip)
    return tuple(found)
