"""What is said while a caregiver teaches, read and approved in each language."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from maestra.language import Language
from maestra.language.ca.teaching import TEACHING as CATALAN
from maestra.language.en.teaching import TEACHING as ENGLISH
from maestra.language.es.teaching import TEACHING as SPANISH
from maestra.language.teaching import Teacher, breaking_pair, typed_words
from maestra.language.teaching_keys import TeachKey
from maestra.language.templates import slots
from maestra.rules.answers import Answer, MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.pairs import Apart
from maestra.rules.setting import Line, Play, play_of
from maestra.rules.token_tests import has
from tests.language.scenes import GOLDEN
from tests.learning.caregivers import SMALL_BOARD, SMALL_DECK, small

TABLES = {Language.EN: ENGLISH, Language.ES: SPANISH, Language.CA: CATALAN}
RISING = Ordered("value", Direction.RISING, strict=True)
IN_TIME = Ordered("value", Direction.RISING, strict=True, line=Line.TIME)
RED = EveryToken(has("is-red", "colour"))
every_language = pytest.mark.parametrize("language", Language)


def play(tokens: str, cells: list[int] | None = None) -> Play:
    return play_of(small(tokens, cells=cells))


ROW = RowQuestion(play("ade"))
BACKWARDS = RowQuestion(play("eda", [2, 1, 0]))
NOTHING = RowQuestion(play(""))
FIRST = MoveQuestion(play(""), 2, 0)
THIRD = MoveQuestion(play("ab"), 4, 2)
RULE = RuleQuestion(RISING)
QUESTIONS = (ROW, BACKWARDS, NOTHING, FIRST, THIRD, RULE)


def scenes(language: Language) -> Iterator[str]:
    """Every sentence about plays and rules, and then those that stand alone."""
    teacher = Teacher(language, SMALL_BOARD, SMALL_DECK)
    yield from (teacher.question(question) for question in QUESTIONS)
    for question in QUESTIONS:
        yield from (teacher.said(Answer(question, reply)) for reply in (Reply.YES, Reply.NO))
    yield teacher.shown(2, play("adc"), Answer(RULE, Reply.YES))
    yield teacher.shown(2, play("adc"), Answer(ROW, Reply.NO))
    yield teacher.shown(3, play("ade"), Answer(RuleQuestion(RED), Reply.YES))
    yield teacher.understood([FullRow(), RISING])
    yield teacher.slip(2, play("adc"), 2, [FullRow(), RISING])
    yield teacher.slip(21, play("abe"), 1, [FullRow(), RED])
    yield teacher.slip(1, play("abe"), 1, [FullRow(), EachPair(Pairs.MIRRORED, Apart("value", 1))])
    for sentence in teacher.rules([FullRow(), RISING, RED]):
        yield f"{sentence.id}: {sentence.text}"
    parts = {name: f"<{name}>" for text in ENGLISH.values() for name in slots(text)}
    for key in TeachKey:
        if "nth" not in slots(ENGLISH[key.value]):
            yield f"{key.value}: {teacher.say(key, **parts)}"


@every_language
def test_what_is_said_is_what_was_read_and_approved(language: Language) -> None:
    golden = GOLDEN / f"teaching.{language.value}.txt"
    assert "".join(f"{line}\n" for line in scenes(language)) == golden.read_text(encoding="utf-8")


@every_language
def test_each_key_has_a_sentence_about_the_same(language: Language) -> None:
    table = TABLES[language]
    assert set(table) == {key.value for key in TeachKey}
    for key in TeachKey:
        assert slots(table[key.value]) == slots(ENGLISH[key.value])


@every_language
def test_what_is_typed_can_be_told_apart(language: Language) -> None:
    typed = [typed_words(key, language) for key in TeachKey if key.name.startswith("TYPE_")]
    # "no" and "neither" begin alike, but are never both asked for.
    assert len(set(typed)) == len(typed)
    assert all(word == word.lower() for word in typed)


def test_two_tokens_that_break_an_order_are_named() -> None:
    assert breaking_pair(RISING, play("adc")) == (3, 2)
    assert breaking_pair(RISING, play("dac")) == (3, 0)
    assert breaking_pair(RISING, play("cba"), 0) == (1, 0)
    assert breaking_pair(IN_TIME, play("ca", [0, 2])) == (2, 0)
    assert breaking_pair(RISING, play("ade")) is None
    assert breaking_pair(RISING, play("acb"), 0) is None
    assert breaking_pair(RED, play("abe")) is None
    assert breaking_pair(FullRow(), play("ab")) is None
