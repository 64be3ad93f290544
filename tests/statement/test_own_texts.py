"""What authors of courses write: no sentence asserts anything without a claim, and each claim is proved before it is printed."""

from __future__ import annotations

import pytest

from rbpsym.courses import derive_course
from rbpsym.document.model import Display, Math, Paragraph
from rbpsym.document.notes import course_notes
from rbpsym.document.own_texts import asserting
from rbpsym.errors import RbpsymError
from rbpsym.languages import languages, phrases
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from rbpsym.statement.own_text import OwnFormula, own_paragraphs
from rbpsym.typeset.latex import to_latex

CLAIM = r"""
[settings.ladder]
problem = "sliding-ladder"
[settings.ladder.symbols]
'w_T' = "work of N_w on ladder, translational"
'w_\theta' = "work of N_w on ladder, rotational"
[[claim]]
id = "cancel"
latex = '''%s'''
"""


@pytest.fixture
def written(tmp_path):
    def write(text, claim=r"w_T+w_\theta=0"):
        file = tmp_path / "week.toml"
        file.write_text(f"title = 'x'\n[[part]]\ntext = '''{text}'''\n" + CLAIM % claim, encoding="utf-8")
        return load_course(file)

    return write


def test_a_text_is_cut_into_sentences_with_their_marks():
    text = "It *is* so, $x$. {claim:a} {claim:b} And (e.g. here) that{claim:c}. Why?\n\n{display:a}\n"
    first, second = own_paragraphs(text)
    assert [one.claims for one in first] == [("a", "b"), ("c",), ()]
    assert first[0].pieces == ("It *is* so, ", OwnFormula("x"), ".")
    assert [one.display for one in second] == [True]


def test_the_formulas_that_were_decided_are_printed(written):
    course = derive_course(written("The halves are $w_T$ and $w_\\theta=-w_T$. {claim:cancel}\n\n{display:cancel}"))
    said, shown = course_notes(course).sections[0].blocks
    assert isinstance(said, Paragraph)
    formulas = [to_latex(inline.node) for inline in said.inlines if isinstance(inline, Math)]
    assert formulas == ["w_T", r"w_{\theta} = -w_T"]
    assert isinstance(shown, Display)
    assert to_latex(shown.node) == r"w_T + w_{\theta} = 0"


BOUND = "So it is. {claim:cancel}"
WRONG = {
    ("They cancel: $w_T+w_\\theta=0$.", ""): "is bound to no claim, but holds a formula",
    ("It takes 3 hours.", ""): "holds “3”",
    ("The fixed one is slower.", ""): "holds “slower”",
    ("It is so. {claim:cancels}", ""): "there is no claim “cancels”",
    ("It is so.", ""): "no text of the course is bound to the claim “cancel”",
    ("It is so. {cancel}", ""): "“{cancel}” is no mark of a sentence",
    ("It is so. {display:cancel}", ""): "“{display:cancel}” is no mark of a sentence",
    ("It is so, $x. {claim:cancel}", ""): "“$” opens nothing",
    ("It is \\emph{so}. {claim:cancel}", ""): "a backslash stands outside a formula",
    ("It is \\so. {claim:cancel}", ""): "a backslash stands outside a formula",
    ("Then $w_T=w_\\theta$. {claim:cancel}", ""): r"w_T=w_\theta is REFUTED",
    ("Then $q$. {claim:cancel}", ""): "q",
    (BOUND, r"w_T=w_\theta"): "“So it is.” stands by the claim “cancel”, and w_T=w_\\theta is REFUTED",
    (BOUND, r"w_T"): "asserts nothing",
    (BOUND, "w_T=0'''\nexpect = 'refuted'\nnote = '''"): "is not one that is to be proved",
}


@pytest.mark.parametrize(("given", "said"), WRONG.items(), ids=range(len(WRONG)))
def test_what_is_not_proved_stops_the_build_with_a_sentence(written, given, said):
    text, claim = given
    with pytest.raises(RbpsymError) as caught:
        derive_course(written(text, claim or r"w_T+w_\theta=0"))
    assert said in str(caught.value)
    assert caught.value.exit_code == 2
    assert caught.value.instead


@pytest.mark.parametrize("name", sorted(course_files()))
def test_a_course_that_ships_says_the_same_in_each_language(name):
    for part in load_course(course_files()[name]).parts:
        bound = {language: set() for language, _ in part.sentences}
        for language, sentence in part.sentences:
            bound[language] |= set(sentence.claims)
            assert sentence.claims or not asserting(sentence, language)
        assert not bound or set(bound) == set(languages())
        assert len(set(map(frozenset, bound.values()))) <= 1, bound


@pytest.mark.parametrize("language", languages())
def test_the_words_of_the_table_are_found(language):
    for word in phrases(language)["own_text.words"].split(", "):
        [[sentence]] = own_paragraphs(f"Well, {word} so.")
        assert asserting(sentence, language) == f"“{word}”"
