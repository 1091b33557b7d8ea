import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from maestra.core.board import Board
from maestra.core.faults import InvalidError
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import GroundedLearner
from maestra.rules.features import select_features
from maestra.rules.ground_truth import ground_truth
from maestra.rules.right_plays import RightPlays
from maestra.rules.strips.literals import Contains
from maestra.rules.strips.vocabulary import Level, Vocabulary
from tests.rules.small_exercises import every_play, small_exercises, vocabularies


@given(st.data())
def test_the_truth_is_what_showing_every_play_leaves(data: st.DataObject) -> None:
    plays = data.draw(small_exercises())
    vocabulary = data.draw(vocabularies(plays))
    assume(plays.count <= 3_000)
    learner = GroundedLearner(vocabulary)
    for play in every_play(plays):
        learner.show(play)
    learned = learner.exercise().model.preconditions
    assert ground_truth(plays, vocabulary).preconditions == learned


def test_actions_are_in_the_order_of_steps() -> None:
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in range(3)))
    plays = RightPlays(Board(2, 3), deck)
    vocabulary = Vocabulary(plays.board, deck, Level.A, select_features(deck, None))
    steps = [action.step for action in ground_truth(plays, vocabulary).preconditions]
    assert steps == [1, 1, 1, 2, 2, 2, 3, 3, 3]


def test_another_board_than_the_vocabularys_is_refused() -> None:
    deck = Deck((Token(TokenId("t"), (("value", 1),)),))
    vocabulary = Vocabulary(Board(2, 3), deck, Level.A, select_features(deck, None))
    with pytest.raises(InvalidError, match="another board"):
        ground_truth(RightPlays(Board(2, 2), deck), vocabulary)


def test_a_vocabulary_over_more_tokens_than_the_exercise_has_is_enough() -> None:
    small = Deck((Token(TokenId("a"), (("value", 1),)),))
    large = Deck((Token(TokenId("a"), (("value", 1),)), Token(TokenId("b"), (("value", 2),))))
    vocabulary = Vocabulary(Board(2, 1), large, Level.C, select_features(large, None))
    truth = ground_truth(RightPlays(Board(2, 1), small), vocabulary)
    (action,) = truth.preconditions
    held = [one for one in truth.precondition(action) if isinstance(one, Contains)]
    assert [(one.cell.name, dict(one.shown)) for one in held] == [("l21", {"value": 1})]
