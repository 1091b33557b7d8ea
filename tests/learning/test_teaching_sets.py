from itertools import combinations

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning import teaching_sets
from maestra.learning.grounded import GroundedLearner
from maestra.learning.teaching_sets import TeachingSet, teaching_set
from maestra.rules.features import select_features
from maestra.rules.ground_truth import ground_truth
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.right_plays import Placements, RightPlays
from maestra.rules.strips.vocabulary import Level, Vocabulary
from tests.rules.small_exercises import every_play, small_exercises, vocabularies


def teaches(shown: tuple[Demonstration, ...], plays: RightPlays, vocabulary: Vocabulary) -> bool:
    learner = GroundedLearner(vocabulary)
    for demonstration in shown:
        learner.show(demonstration)
    learned = learner.exercise().model.preconditions
    return learned == ground_truth(plays, vocabulary).preconditions


@pytest.mark.parametrize(
    ("key", "fewest"),
    [
        ("odd-ascending", 2),
        ("ascending", 12),
        ("descending", 12),
        ("first-row", 10),
        ("curie", 2),
        ("letters", 12),
    ],
)
def test_the_papers_exercises_take_as_many_demonstrations_as_the_paper_says(
    key: str, fewest: int
) -> None:
    exercise = PAPER_EXERCISES[key]
    plays, vocabulary = exercise.plays(), exercise.vocabulary()
    found = teaching_set(plays, vocabulary)
    assert len(found.demonstrations) == found.lower_bound == exercise.fewest == fewest
    assert found.is_smallest
    assert teaches(found.demonstrations, plays, vocabulary)
    for without in range(fewest):
        rest = (*found.demonstrations[:without], *found.demonstrations[without + 1 :])
        assert not teaches(rest, plays, vocabulary)


def test_the_ascending_exercise_is_taught_by_six_windows_each_shown_twice() -> None:
    exercise = PAPER_EXERCISES["ascending"]
    found = teaching_set(exercise.plays(), exercise.vocabulary())
    values = [int(token.id) for token in exercise.plays().deck.tokens]
    shown = sorted(tuple(int(move.token) for move in one.moves) for one in found.demonstrations)
    windows = [tuple(values[first : first + 5]) for first in range(6)]
    assert shown == sorted([*windows, *windows])


@pytest.mark.parametrize("level", [Level.B, Level.C])
@pytest.mark.parametrize("key", ["odd-ascending", "ascending", "curie"])
def test_a_richer_vocabulary_is_taught_too_and_the_bound_stays_below(
    key: str, level: Level
) -> None:
    exercise = PAPER_EXERCISES[key]
    plays, vocabulary = exercise.plays(), exercise.vocabulary(level)
    found = teaching_set(plays, vocabulary)
    assert teaches(found.demonstrations, plays, vocabulary)
    assert exercise.fewest <= found.lower_bound <= len(found.demonstrations)


@given(st.data())
def test_what_is_found_teaches_exactly_and_the_bound_holds(data: st.DataObject) -> None:
    plays = data.draw(small_exercises())
    vocabulary = data.draw(vocabularies(plays))
    found = teaching_set(plays, vocabulary)
    assert teaches(found.demonstrations, plays, vocabulary)
    assert found.lower_bound <= len(found.demonstrations)


@given(st.data())
def test_of_few_plays_no_smaller_set_teaches(data: st.DataObject) -> None:
    plays = data.draw(small_exercises(tokens=2, cells=3))
    assume(plays.count <= 12)
    vocabulary = data.draw(vocabularies(plays))
    found = teaching_set(plays, vocabulary)
    assert found.is_smallest
    listed = list(every_play(plays))
    fewest = next(
        size
        for size in range(len(listed) + 1)
        if any(teaches(some, plays, vocabulary) for some in combinations(listed, size))
    )
    assert len(found.demonstrations) == fewest


@settings(max_examples=20)
@given(st.data())
def test_the_searches_for_few_and_for_many_plays_agree(data: st.DataObject) -> None:
    plays = data.draw(small_exercises(tokens=3))
    assume(plays.count <= 300)
    vocabulary = data.draw(vocabularies(plays))
    listed = teaching_set(plays, vocabulary)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(teaching_sets, "MAX_LISTED", -1)
        unlisted = teaching_set(plays, vocabulary)
    assert teaches(unlisted.demonstrations, plays, vocabulary)
    assert unlisted.lower_bound <= len(listed.demonstrations) <= len(unlisted.demonstrations)


@pytest.mark.parametrize(
    "limits",
    [{"MAX_NODES": 0}, {"MAX_LISTED": -1, "MAX_ROWS": 1}, {"MAX_LISTED": -1, "MAX_TRIES": 0}],
)
@given(data=st.data())
@settings(max_examples=15)
def test_a_search_cut_short_still_teaches_exactly(
    limits: dict[str, int], data: st.DataObject
) -> None:
    plays = data.draw(small_exercises(tokens=3))
    vocabulary = data.draw(vocabularies(plays))
    with pytest.MonkeyPatch.context() as patch:
        for limit, least in limits.items():
            patch.setattr(teaching_sets, limit, least)
        found = teaching_set(plays, vocabulary)
    assert teaches(found.demonstrations, plays, vocabulary)
    assert found.lower_bound <= len(found.demonstrations)


def numbers(count: int) -> Deck:
    return Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in range(count)))


def from_left(placements: Placements) -> bool:
    return all(one.destination.column == step for step, one in enumerate(placements, start=1))


def test_sequences_of_the_bounds_size_that_no_start_completes_are_given_up() -> None:
    deck = numbers(4)
    plays = RightPlays(Board(5, 2), deck, may_begin=from_left)
    vocabulary = Vocabulary(plays.board, deck, Level.C, select_features(deck, None))
    assert plays.count > teaching_sets.MAX_LISTED
    found = teaching_set(plays, vocabulary)
    assert teaches(found.demonstrations, plays, vocabulary)


def test_plays_of_different_lengths_are_taught_together() -> None:
    deck = numbers(6)
    plays = RightPlays(Board(4, 3), deck, from_left, from_left, lengths=frozenset({1, 3}))
    vocabulary = Vocabulary(plays.board, deck, Level.A, select_features(deck, None))
    found = teaching_set(plays, vocabulary)
    assert teaches(found.demonstrations, plays, vocabulary)


def test_an_exercise_without_a_right_play_needs_no_demonstration() -> None:
    deck = numbers(2)
    plays = RightPlays(Board(2, 2), deck, lambda _placements: False)
    vocabulary = Vocabulary(plays.board, deck, Level.A, select_features(deck, None))
    assert teaching_set(plays, vocabulary) == TeachingSet((), 0)


def test_where_greedy_takes_too_many_plays_the_fewest_are_found() -> None:
    deck = numbers(3)
    plays = RightPlays(Board(2, 3), deck, from_left, from_left, lengths=frozenset({2}))
    vocabulary = Vocabulary(plays.board, deck, Level.A, select_features(deck, None))

    def take_all(plays: RightPlays, *_rest: object) -> tuple[Demonstration, ...]:
        return tuple(plays.play(number) for number in range(plays.count))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(teaching_sets, "_greedy", take_all)
        found = teaching_set(plays, vocabulary)
    assert found.is_smallest
    assert len(found.demonstrations) == 6
    assert teaches(found.demonstrations, plays, vocabulary)
