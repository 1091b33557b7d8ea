from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import (
    GroundedLearner,
    Observation,
    learn_grounded,
    vocabulary_for,
)
from maestra.rules.exercise import GroundedExercise
from maestra.rules.features import DEFAULT_CELLS, FRAME, UnknownFeatureError
from maestra.rules.judging import Judge
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Literal
from maestra.rules.strips.vocabulary import Level
from tests.rules import by_definition
from tests.rules.ascending import ascending, exercise_of, paper_lesson
from tests.rules.lessons import Lesson, lessons

Known = dict[Action, frozenset[Literal]]


def learn(lesson: Lesson) -> GroundedExercise:
    learner = GroundedLearner(lesson.vocabulary)
    for demonstration in lesson.demonstrations:
        learner.show(demonstration)
    return learner.exercise()


def known(exercise: GroundedExercise) -> Known:
    model = exercise.model
    return {action: frozenset(model.precondition(action)) for action in model.preconditions}


@given(lessons())
def test_what_is_learned_is_what_held_each_time_by_definition(lesson: Lesson) -> None:
    exercise = learn(lesson)
    assert known(exercise) == by_definition.learn(lesson.vocabulary, lesson.demonstrations)
    assert exercise.lengths == {len(play.moves) for play in lesson.demonstrations}
    assert exercise.demonstrations == len(lesson.demonstrations)


@given(st.data())
def test_the_order_of_demonstrations_does_not_matter(data: st.DataObject) -> None:
    lesson = data.draw(lessons())
    shuffled = tuple(data.draw(st.permutations(lesson.demonstrations)))
    one, other = learn(lesson), learn(Lesson(shuffled, lesson.vocabulary))
    assert one.model.preconditions == other.model.preconditions
    assert list(one.model.preconditions) == list(other.model.preconditions)
    assert (one.lengths, one.demonstrations) == (other.lengths, other.demonstrations)
    seen = {action: whence.seen for action, whence in one.provenance.items()}
    assert seen == {action: whence.seen for action, whence in other.provenance.items()}


@given(lessons())
def test_a_further_demonstration_makes_nothing_stricter(lesson: Lesson) -> None:
    learner = GroundedLearner(lesson.vocabulary)
    before: dict[Action, int] = {}
    for demonstration in lesson.demonstrations:
        learner.show(demonstration)
        after = dict(learner.exercise().model.preconditions)
        assert all(after[action] & ~bits == 0 for action, bits in before.items())
        before = after


@given(lessons())
def test_a_move_once_applicable_stays_applicable(lesson: Lesson) -> None:
    learner = GroundedLearner(lesson.vocabulary)
    index = lesson.vocabulary.index_of_token
    before: set[tuple[int, int, Cell, Cell]] = set()
    for demonstration in lesson.demonstrations:
        learner.show(demonstration)
        model = learner.exercise().model
        after = {
            (number, step, *cells)
            for number, play in enumerate(lesson.demonstrations)
            for state in play.states()
            for step in (1, 2, 3)
            for cells in model.applicable(
                step, {at: index[token] for token, at in state.cells.items()}
            )
        }
        assert before <= after
        before = after


@given(lessons())
def test_every_demonstration_is_accepted(lesson: Lesson) -> None:
    judge = Judge(learn(lesson), lesson.deck)
    for play in lesson.demonstrations:
        judged, end = judge.read(play.start, play.moves)
        assert not any(one.is_refused for one in judged)
        assert judge.may_end(end)


@given(lessons())
def test_learning_is_the_same_one_by_one_and_all_at_once(lesson: Lesson) -> None:
    features = [feature.label for feature in lesson.vocabulary.features]
    at_once = learn_grounded(lesson.demonstrations, lesson.vocabulary.level, features)
    learner = GroundedLearner(at_once.model.vocabulary)
    for count, demonstration in enumerate(lesson.demonstrations, start=1):
        learner.show(demonstration)
        shorter = Lesson(lesson.demonstrations[:count], at_once.model.vocabulary)
        assert learner.exercise() == learn(shorter)
    assert learner.exercise() == at_once


@given(lessons())
def test_each_literal_is_left_or_was_deleted_by_the_first_demonstration_that_broke_it(
    lesson: Lesson,
) -> None:
    exercise = learn(lesson)
    for action, whence in exercise.provenance.items():
        left = lesson.vocabulary.everything
        seen = 0
        for number, play in enumerate(lesson.demonstrations, start=1):
            shown = by_definition.learn(lesson.vocabulary, [play])
            if action not in shown:
                continue
            seen += 1
            deleted = left & ~lesson.vocabulary.bits(shown[action])
            told = [one.literals for one in whence.deletions if one.demonstration == number]
            assert told == ([deleted] if deleted else [])
            left &= ~deleted
        assert whence.seen == seen
        assert exercise.model.preconditions[action] == left


def test_nothing_shown_is_nothing_applicable() -> None:
    lesson = paper_lesson()
    exercise = GroundedLearner(vocabulary_for(lesson)).exercise()
    assert not exercise.model.preconditions
    assert not exercise.lengths
    assert not exercise.demonstrations


def test_a_demonstration_without_moves_shows_that_a_play_may_end_at_once() -> None:
    play = ascending((0, 1, 2, 3, 4)).until(0)
    assert learn_grounded([play]).lengths == {0}


def test_an_observation_says_what_was_moved_when_and_what_held() -> None:
    play = ascending((0, 1, 2, 3, 4))
    vocabulary = vocabulary_for([play])
    seen = GroundedLearner(vocabulary).observe(play)
    assert [one.step for one in seen] == [1, 2, 3, 4, 5]
    index = vocabulary.index_of_token
    assert [one.moved for one in seen] == [index[move.token] for move in play.moves]
    assert isinstance(seen[0], Observation)
    shown = known(learn_grounded([play]))
    assert [set(vocabulary.select(one.holding)) for one in seen] == [
        set(shown[Action(vocabulary.shown[one.moved], one.step)]) for one in seen
    ]


def another_board(play: Demonstration) -> Demonstration:
    return Demonstration(play.deck, State(Board(4, 6), play.start.cells), play.moves)


def unknown_token(play: Demonstration) -> Demonstration:
    tokens = (*play.deck.tokens[1:], Token(play.deck.tokens[0].id, (("value", 99),)))
    return Demonstration(Deck(tokens), play.start, play.moves)


@pytest.mark.parametrize("spoil", [another_board, unknown_token])
def test_a_play_that_does_not_fit_is_refused_and_nothing_learned_from_it(
    spoil: Callable[[Demonstration], Demonstration],
) -> None:
    lesson = paper_lesson()
    learner = GroundedLearner(vocabulary_for(lesson))
    learner.show(lesson[0])
    before = learner.exercise()
    with pytest.raises(InvalidError):
        learner.show(spoil(lesson[1]))
    assert learner.exercise() == before
    learner.show(lesson[1])
    assert learner.exercise().demonstrations == 2


def test_plays_with_other_tokens_that_look_the_same_teach_the_same() -> None:
    play = ascending((0, 1, 2, 3, 4))
    renamed = {token.id: TokenId(f"other-{token.id}") for token in play.deck.tokens}
    other = Demonstration(
        Deck(tuple(Token(renamed[token.id], token.attributes) for token in play.deck.tokens)),
        State(play.board, {renamed[token]: at for token, at in play.start.cells.items()}),
        tuple(Move(renamed[m.token], m.origin, m.destination) for m in play.moves),
    )
    learner = GroundedLearner(vocabulary_for([play]))
    for one in (play, other, play):
        learner.show(one)
    expected = learn_grounded([play, play, play])
    assert learner.exercise() == expected
    merged = learn_grounded([play, other, play])
    assert merged.model.preconditions == expected.model.preconditions


def test_a_board_equal_to_the_lessons_is_the_lessons() -> None:
    play = ascending((0, 1, 2, 3, 4))
    again = Demonstration(play.deck, State(Board(), play.start.cells), play.moves)
    assert again.board is not play.board
    learner = GroundedLearner(vocabulary_for([play]))
    learner.show(again)
    assert learner.exercise() == learn_grounded([play])


def test_the_vocabulary_has_all_that_any_demonstration_shows() -> None:
    one = Deck((Token(TokenId("a"), (("value", 1),)),))
    two = Deck((Token(TokenId("b"), (("value", 2),)),))
    plays = [
        Demonstration(deck, State(Board(2, 1), {token: Cell(Row(2), Column(1))}), ())
        for deck, token in ((one, TokenId("a")), (two, TokenId("b")))
    ]
    assert vocabulary_for(plays).shown == ((("value", 1),), (("value", 2),))


def test_the_caregiver_can_say_which_features_count() -> None:
    lesson = paper_lesson()
    vocabulary = vocabulary_for(lesson, Level.B, ["cells"])
    assert vocabulary.features == (*FRAME, *DEFAULT_CELLS)
    assert learn_grounded(lesson, Level.B, ["cells"]).model.vocabulary == vocabulary
    with pytest.raises(UnknownFeatureError, match="the nearest is odd"):
        learn_grounded(lesson, features=["od"])


def test_twelve_chosen_demonstrations_teach_the_papers_thirty_actions() -> None:
    exercise = exercise_of(paper_lesson())
    assert len(exercise.model.preconditions) == 30
    assert all(whence.seen >= 2 for whence in exercise.provenance.values())
