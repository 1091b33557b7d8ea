"""Random exercises made of rules, with all that is kept beside the rules."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from hypothesis import strategies as st

from maestra.core.demonstration import Demonstration
from maestra.rules.answers import Answer, MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import (
    Alternative,
    Evidence,
    Exam,
    LearnStatus,
    RuledExercise,
    meant_rules,
)
from maestra.rules.fitting import misfits
from maestra.rules.forms.length import FullRow
from maestra.rules.rule import Rule
from maestra.rules.setting import Play, Setting, bits
from tests.rules.rule_strategies import FORMS, RULES, decks, plays_from, settings_with

_T = TypeVar("_T")

SHARES = st.floats(0, 1)


def demonstration_of(play: Play) -> Demonstration:
    """The play as it was shown."""
    return Demonstration(play.setting.deck, play.setting.start, play.moves())


def some(draw: st.DrawFn, most: int, one: Callable[[st.DrawFn], _T]) -> tuple[_T, ...]:
    """Up to `most` of what `one` draws."""
    return tuple(one(draw) for _ in range(draw(st.integers(0, most))))


def fitting_rule(draw: st.DrawFn, setting: Setting) -> Rule:
    """A rule of any form that the deck of `setting` can be asked for."""
    deck = setting.deck
    form = draw(st.sampled_from(FORMS))
    rule: Rule = draw(RULES[form](deck, setting.start.board))
    return FullRow() if misfits([rule], deck) else rule


def answer(draw: st.DrawFn, setting: Setting) -> Answer:
    """A question of any kind and any reply to it."""
    play = draw(plays_from(setting))
    question: Question = RowQuestion(play)
    kind = draw(st.sampled_from(("row", "move", "rule")))
    if kind == "rule":
        question = RuleQuestion(fitting_rule(draw, setting))
    elif kind == "move" and play.room:
        token = draw(st.sampled_from(list(bits(play.left))))
        question = MoveQuestion(play, token, draw(st.sampled_from(play.free)))
    reply = draw(st.sampled_from(Reply))
    wrong = None
    if isinstance(question, RowQuestion) and reply is Reply.NO:
        wrong = draw(st.none() | st.integers(0, setting.length - 1))
    return Answer(question, reply, wrong)


def exam(draw: st.DrawFn) -> Exam:
    """An exam with any result."""
    plays, misses = draw(st.integers(0, 20)), draw(st.integers(0, 20))
    agreed, found = draw(st.integers(0, plays)), draw(st.integers(0, misses))
    return Exam(draw(st.sampled_from(("2026-11-22", "yesterday"))), plays, agreed, misses, found)


def evidence(draw: st.DrawFn, setting: Setting) -> Evidence:
    """A little of everything that is kept."""
    return Evidence(
        some(draw, 2, lambda draw: demonstration_of(draw(plays_from(setting)))),
        some(draw, 2, lambda draw: answer(draw, setting)),
        some(draw, 2, exam),
    )


@st.composite
def ruled_exercises(draw: st.DrawFn, setting: Setting | None = None) -> RuledExercise:
    """An exercise of up to three rules of any form, over a random deck and board."""
    if setting is None:
        setting = draw(settings_with(draw(decks())))
    start = setting

    def rules(draw: st.DrawFn) -> tuple[Rule, ...]:
        return some(draw, 3, lambda draw: fitting_rule(draw, start))

    meant = rules(draw)
    return RuledExercise(
        setting.start.board,
        setting.deck,
        meant_rules(meant, [draw(SHARES) for _ in meant]),
        draw(SHARES),
        draw(st.sampled_from(LearnStatus)),
        (*meant, *rules(draw)),
        some(draw, 2, lambda draw: Alternative(rules(draw), draw(SHARES))),
        evidence(draw, setting),
    )
