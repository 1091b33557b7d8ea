"""What was shown and answered that cannot both be."""

import pytest

from maestra.learning.contradictions import (
    Contradiction,
    Said,
    Shown,
    Understood,
    clashes,
    overruled,
)
from maestra.rules.answers import Answer, MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.setting import Play, play_of
from maestra.rules.token_tests import has
from tests.learning.caregivers import small

RISING = Ordered("value", Direction.RISING, strict=True)
FALLING = Ordered("value", Direction.FALLING, strict=True)
NOT_FALLING = Ordered("value", Direction.RISING, strict=False)
RED = EveryToken(has("is-red", "colour"))


def play(tokens: str, turn: int = 0) -> Play:
    return play_of(small(tokens, turn))


def row(tokens: str, turn: int = 0) -> RowQuestion:
    return RowQuestion(play(tokens, turn))


def move(tokens: str) -> MoveQuestion:
    """Is the last of these moves right after the others?"""
    return MoveQuestion(play(tokens[:-1]), "abcde".index(tokens[-1]), len(tokens) - 1)


def yes(question: Question) -> Answer:
    return Answer(question, Reply.YES)


def no(question: Question) -> Answer:
    return Answer(question, Reply.NO)


FROM_SHOWN = (Contradiction(Shown(4), Said(0)),)


@pytest.mark.parametrize(
    "answer",
    [no(row("abc")), no(move("a")), no(move("abc")), yes(RuleQuestion(FALLING))],
    ids=["row", "first move", "last move", "rule"],
)
def test_an_answer_that_denies_what_was_shown_is_found(answer: Answer) -> None:
    assert clashes({4: play("abc")}, [answer]) == FROM_SHOWN


@pytest.mark.parametrize(
    "answer",
    [
        no(row("abd")),
        no(row("abc", 1)),
        yes(row("abc")),
        yes(row("cba")),
        no(move("b")),
        yes(move("c")),
        yes(RuleQuestion(RISING)),
        no(RuleQuestion(RISING)),
        Answer(row("abc"), Reply.UNSURE),
    ],
)
def test_an_answer_that_goes_with_what_was_shown_is_none(answer: Answer) -> None:
    assert clashes({4: play("abc")}, [answer]) == ()


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (yes(row("abc")), no(row("abc"))),
        (yes(move("a")), no(move("a"))),
        (yes(RuleQuestion(RISING)), no(RuleQuestion(RISING))),
        (yes(row("abc")), no(move("ab"))),
        (yes(move("abc")), no(row("abc"))),
        (yes(move("ab")), no(move("a"))),
        (yes(move("ba")), yes(RuleQuestion(RISING))),
        (yes(row("cba")), yes(RuleQuestion(RISING))),
    ],
)
def test_two_answers_that_cannot_both_be_are_found_in_either_order(
    one: Answer, other: Answer
) -> None:
    expected = (Contradiction(Said(0), Said(1)),)
    assert clashes({}, [one, other]) == clashes({}, [other, one]) == expected


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (yes(move("ab")), no(row("abc"))),
        (yes(move("abc")), no(row("abd"))),
        (yes(row("abc")), no(move("abd"))),
        (yes(RuleQuestion(RISING)), no(RuleQuestion(FALLING))),
        (yes(RuleQuestion(RISING)), yes(RuleQuestion(FALLING))),
        (no(row("abc")), no(move("a"))),
    ],
)
def test_two_answers_that_may_both_be_are_none(one: Answer, other: Answer) -> None:
    assert clashes({}, [one, other]) == clashes({}, [other, one]) == ()


def test_contradictions_come_in_the_order_of_the_answers() -> None:
    answers = [no(row("abc")), yes(row("ade")), no(row("ade")), no(row("abd"))]
    found = clashes({0: play("abc"), 1: play("abd")}, answers)
    assert found == (
        Contradiction(Shown(0), Said(0)),
        Contradiction(Said(1), Said(2)),
        Contradiction(Shown(1), Said(3)),
    )


@pytest.mark.parametrize(
    "answer",
    [
        no(row("abc")),
        yes(row("cba")),
        no(move("ab")),
        yes(move("ba")),
        yes(move("e")),
        no(RuleQuestion(RISING)),
        yes(RuleQuestion(RED)),
    ],
)
def test_rules_overrule_an_answer_that_they_do_not_agree_with(answer: Answer) -> None:
    rules = (FullRow(), RISING)
    found = overruled(rules, [answer], [play("abc")], seed=0)
    assert found == (Contradiction(Understood(), Said(0)),)


@pytest.mark.parametrize(
    "answer",
    [
        yes(row("abc")),
        no(row("cba")),
        yes(move("ab")),
        no(move("ba")),
        yes(RuleQuestion(RISING)),
        yes(RuleQuestion(NOT_FALLING)),
        no(RuleQuestion(RED)),
        Answer(row("abc"), Reply.UNSURE),
    ],
)
def test_rules_agree_with_what_follows_from_them(answer: Answer) -> None:
    assert overruled((FullRow(), RISING), [answer], [play("abc")], seed=0) == ()
