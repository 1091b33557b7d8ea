"""Random exercises made of rules, with all that is kept beside the rules."""

from __future__ import annotations

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
from maestra.rules.rule import Rule
from maestra.rules.setting import Play, Setting, bits
from tests.rules.rule_strategies import decks, plays_from, rules_for, settings_with

SHARES = st.floats(0, 1)


def demonstration_of(play: Play) -> Demonstration:
    """The play as it was shown."""
    return Demonstration(play.setting.deck, play.setting.start, play.moves())


def fitting_rules(setting: Setting) -> st.SearchStrategy[Rule]:
    """Rules of any form that the deck of `setting` can be asked for."""
    deck = setting.deck
    return rules_for(deck, setting.start.board).filter(lambda rule: not misfits([rule], deck))


@st.composite
def answers(draw: st.DrawFn, setting: Setting) -> Answer:
    """A question of any kind and any reply to it."""
    play = draw(plays_from(setting))
    question: Question = draw(
        st.builds(RuleQuestion, fitting_rules(setting)) | st.just(RowQuestion(play))
    )
    if play.room and draw(st.booleans()):
        token = draw(st.sampled_from(list(bits(play.left))))
        question = MoveQuestion(play, token, draw(st.sampled_from(play.free)))
    reply = draw(st.sampled_from(Reply))
    wrong = None
    if isinstance(question, RowQuestion) and reply is Reply.NO:
        wrong = draw(st.none() | st.integers(0, setting.length - 1))
    return Answer(question, reply, wrong)


@st.composite
def exams(draw: st.DrawFn) -> Exam:
    """An exam with any result."""
    plays, misses = draw(st.integers(0, 20)), draw(st.integers(0, 20))
    agreed, found = draw(st.integers(0, plays)), draw(st.integers(0, misses))
    return Exam(draw(st.sampled_from(("2026-11-22", "yesterday"))), plays, agreed, misses, found)


@st.composite
def evidences(draw: st.DrawFn, setting: Setting) -> Evidence:
    """A little of everything that is kept."""
    return Evidence(
        tuple(draw(st.lists(plays_from(setting).map(demonstration_of), max_size=2))),
        tuple(draw(st.lists(answers(setting), max_size=2))),
        tuple(draw(st.lists(exams(), max_size=2))),
    )


@st.composite
def ruled_exercises(draw: st.DrawFn, setting: Setting | None = None) -> RuledExercise:
    """An exercise of up to three rules of any form, over a random deck and board."""
    if setting is None:
        setting = draw(settings_with(draw(decks())))
    some = st.lists(fitting_rules(setting), max_size=3)
    rules = draw(some)
    shares = draw(st.tuples(*[SHARES] * len(rules)))
    others = st.builds(
        Alternative, st.lists(fitting_rules(setting), max_size=2).map(tuple), SHARES
    )
    return RuledExercise(
        setting.start.board,
        setting.deck,
        meant_rules(rules, shares),
        draw(SHARES),
        draw(st.sampled_from(LearnStatus)),
        (*rules, *draw(some)),
        tuple(draw(st.lists(others, max_size=2))),
        draw(evidences(setting)),
    )
