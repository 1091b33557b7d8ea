from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import IllegalMoveError, Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import GroundedLearner
from maestra.rules.exercise import GroundedExercise
from maestra.rules.features import CellFeature, PairFeature
from maestra.rules.grounded_judging import GroundedJudge
from maestra.rules.judging import Judge
from maestra.rules.strips import completion
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.strips.literals import Placed, Related
from maestra.rules.verdicts import (
    AfterTheEnd,
    Allowed,
    BrokenPrecondition,
    DeadEnd,
    NotShown,
    PutBack,
)
from tests.rules import by_definition
from tests.rules.ascending import (
    BOARD,
    TOKENS,
    ascending,
    exercise_of,
    moves,
    paper_lesson,
    start,
)
from tests.rules.lessons import Lesson, lessons

START = start()


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


@pytest.fixture(scope="module")
def judge() -> GroundedJudge:
    exercise = exercise_of(paper_lesson())
    return GroundedJudge(exercise, exercise.deck)


def to_goal(rank: int, column: int) -> Move:
    """The token of this rank, from where it begins, into the goal row."""
    token = TOKENS[rank]
    return Move(token.id, START.cells[token.id], cell(1, column))


def action(rank: int, step: int) -> Action:
    return Action(TOKENS[rank].attributes, step)


# ------------------------------------------------------------------ the paper's exercise


def test_the_seventh_lowest_cannot_go_first(judge: GroundedJudge) -> None:
    assert judge.verdict(START, 0, to_goal(5, 1)) == Allowed(action(5, 1))
    assert judge.verdict(START, 0, to_goal(6, 1)) == NotShown(action(6, 1))


def test_a_broken_precondition_is_told_with_its_false_literals(judge: GroundedJudge) -> None:
    state = START.after(to_goal(3, 1))
    smaller = Related(cell(1, 1), PairFeature("less-than", "value"), converse=False)
    told = BrokenPrecondition(action(2, 2), (smaller,))
    assert judge.verdict(state, 1, to_goal(2, 2)) == told
    elsewhere = Placed(CellFeature("destination"), cell(1, 1))
    told = BrokenPrecondition(action(0, 1), (elsewhere,))
    assert judge.verdict(START, 0, to_goal(0, 2)) == told


def test_a_larger_token_is_allowed_as_long_as_the_row_can_be_filled(judge: GroundedJudge) -> None:
    state = START.after(to_goal(4, 1))
    assert judge.verdict(state, 1, to_goal(5, 2)) == Allowed(action(5, 2))
    assert judge.verdict(state, 1, to_goal(6, 2)) == Allowed(action(6, 2))
    assert judge.verdict(state, 1, to_goal(7, 2)) == NotShown(action(7, 2))


def test_after_the_last_step_nothing_more_may_be_moved(judge: GroundedJudge) -> None:
    play = ascending((0, 1, 2, 3, 4))
    extra = Move(TOKENS[5].id, play.end.cells[TOKENS[5].id], cell(4, 5))
    assert judge.verdict(play.end, 5, extra) == AfterTheEnd(action(5, 6))
    assert not list(judge.allowed_moves(play.end, 5))


def test_a_play_may_end_after_as_many_moves_as_some_demonstration_had(
    judge: GroundedJudge,
) -> None:
    assert [made for made in range(8) if judge.may_end(made)] == [5]
    exercise = exercise_of([ascending((0, 1, 2)), ascending((0, 1))])
    other = GroundedJudge(exercise, exercise.deck)
    assert [made for made in range(8) if other.may_end(made)] == [2, 3]


def test_at_the_start_the_six_lowest_may_be_moved(judge: GroundedJudge) -> None:
    assert set(judge.allowed_moves(START, 0)) == {to_goal(rank, 1) for rank in range(6)}


def test_nothing_learned_allows_nothing() -> None:
    lesson = paper_lesson()
    nothing = GroundedLearner(exercise_of(lesson).model.vocabulary).exercise()
    judge = GroundedJudge(nothing, nothing.deck)
    assert judge.verdict(START, 0, to_goal(0, 1)) == NotShown(action(0, 1))
    assert not list(judge.allowed_moves(START, 0))
    assert not judge.may_end(0)


def test_when_the_search_is_given_up_the_move_is_allowed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(completion, "QUICK_NODES", 0)
    monkeypatch.setattr(completion, "CAREFUL_NODES", 0)
    exercise = exercise_of(paper_lesson())
    judge = GroundedJudge(exercise, exercise.deck)
    assert isinstance(judge.verdict(START, 0, to_goal(0, 1)), Allowed)
    assert len(list(judge.allowed_moves(START, 0))) == 6


# ------------------------------------------------------------------ what cannot be judged


def test_another_board_is_refused(judge: GroundedJudge) -> None:
    state = State(Board(4, 6), START.cells)
    with pytest.raises(InvalidError, match="4 x 6, goal row 1, expected the exercise's, 4 x 5"):
        judge.verdict(state, 0, to_goal(0, 1))
    with pytest.raises(InvalidError):
        next(judge.allowed_moves(state, 0))
    with pytest.raises(InvalidError):
        Judge(judge.exercise, judge.deck).judge(state, [to_goal(0, 1)])


def test_a_deck_that_shows_something_unknown_is_refused(judge: GroundedJudge) -> None:
    with pytest.raises(InvalidError, match=r"tokens\.x"):
        GroundedJudge(judge.exercise, Deck((Token(TokenId("x"), (("value", 99),)),)))


def test_a_move_that_no_board_could_make_is_no_verdict(judge: GroundedJudge) -> None:
    with pytest.raises(IllegalMoveError):
        judge.verdict(START, 0, Move(TOKENS[0].id, cell(4, 5), cell(1, 1)))
    with pytest.raises(IllegalMoveError, match=r"moves\[1\]\.destination"):
        Judge(judge.exercise, judge.deck).judge(START, [to_goal(0, 1), to_goal(1, 1)])


def test_other_tokens_that_look_the_same_are_judged_alike(judge: GroundedJudge) -> None:
    deck = Deck(tuple(Token(TokenId(f"x{token.id}"), token.attributes) for token in TOKENS))
    state = State(BOARD, {TokenId(f"x{token}"): at for token, at in START.cells.items()})
    other = GroundedJudge(judge.exercise, deck)
    for rank in range(10):
        move = to_goal(rank, 1)
        renamed = Move(TokenId(f"x{move.token}"), move.origin, move.destination)
        assert other.verdict(state, 0, renamed) == judge.verdict(START, 0, move)


# ------------------------------------------------------------------ whole plays


@pytest.fixture(name="whole", scope="module")
def a_judge_of_plays() -> Judge:
    exercise = exercise_of(paper_lesson())
    return Judge(exercise, exercise.deck)


def kinds(judge: Judge, written: Sequence[Move]) -> list[str]:
    return [type(one.verdict).__name__ for one in judge.judge(START, written)]


def test_a_right_play_is_allowed_throughout(whole: Judge) -> None:
    judged = whole.judge(START, moves(START, (0, 2, 4, 6, 8)))
    assert [type(one.verdict) for one in judged] == [Allowed] * 5
    assert [one.before for one in judged] == list(ascending((0, 2, 4, 6, 8)).states())[:5]


@pytest.mark.parametrize(
    "rest",
    [
        pytest.param([to_goal(6, 1), to_goal(0, 1)], id="another token next"),
        pytest.param([to_goal(6, 1), to_goal(6, 2), to_goal(0, 1)], id="the same token again"),
    ],
)
def test_a_refused_move_is_put_back_and_the_next_judged_without_it(
    whole: Judge, rest: list[Move]
) -> None:
    judged = whole.judge(START, rest)
    assert [one.before for one in judged] == [START] * len(rest)
    assert [type(one.verdict) for one in judged] == [NotShown] * (len(rest) - 1) + [Allowed]


def test_a_refused_token_may_be_written_where_it_was_refused(whole: Judge) -> None:
    away = Move(TOKENS[6].id, cell(1, 1), cell(1, 2))
    again = Move(TOKENS[6].id, cell(1, 2), cell(1, 3))
    judged = whole.judge(START, [to_goal(6, 1), away, again])
    assert [one.move.origin for one in judged] == [START.cells[TOKENS[6].id]] * 3
    assert [one.verdict for one in judged] == [NotShown(action(6, 1))] * 3


def test_a_putting_back_may_be_written_as_a_move(whole: Judge) -> None:
    wrong = to_goal(6, 1)
    back = Move(wrong.token, wrong.destination, wrong.origin)
    judged = whole.judge(START, [wrong, back, wrong, back, to_goal(0, 1)])
    refused, put_back, *_, last = (one.verdict for one in judged)
    assert refused == NotShown(action(6, 1))
    assert put_back == PutBack(NotShown(action(6, 1)))
    assert judged[1].move == back
    assert isinstance(last, Allowed)
    assert kinds(whole, [wrong, back, wrong, back])[2:] == ["NotShown", "PutBack"]


def test_an_allowed_token_that_was_refused_before_lies_where_it_was_allowed(whole: Judge) -> None:
    refused = to_goal(1, 2)
    right = Move(TOKENS[1].id, cell(1, 2), cell(1, 1))
    back = Move(TOKENS[1].id, cell(1, 1), cell(1, 2))
    verdicts = kinds(whole, [refused, right, back])
    assert verdicts == ["BrokenPrecondition", "Allowed", "BrokenPrecondition"]


@st.composite
def wandering_plays(draw: st.DrawFn) -> tuple[Lesson, GroundedExercise, list[Move]]:
    """A lesson and a play with right and wrong moves, as if nothing were ever put back."""
    lesson = draw(lessons())
    learner = GroundedLearner(lesson.vocabulary)
    for shown in lesson.demonstrations:
        learner.show(shown)
    exercise = learner.exercise()
    judge = GroundedJudge(exercise, lesson.deck)
    state, made = lesson.demonstrations[0].start, 0
    written: list[Move] = []
    for _ in range(draw(st.integers(0, 5))):
        able = [
            Move(token, origin, destination)
            for token, origin in state.cells.items()
            for destination in state.board.cells
            if destination not in state.tokens
        ]
        right = [move for move in able if isinstance(judge.verdict(state, made, move), Allowed)]
        rightly = draw(st.booleans()) and bool(right)
        move = draw(st.sampled_from(right if rightly else able))
        written.append(move)
        if move in right:
            state, made = state.after(move), made + 1
    return lesson, exercise, written


@given(wandering_plays(), st.data())
def test_however_putting_back_is_written_the_verdicts_are_the_same(
    pair: tuple[Lesson, GroundedExercise, list[Move]], data: st.DataObject
) -> None:
    lesson, exercise, written = pair
    judge = Judge(exercise, lesson.deck)
    begin = lesson.demonstrations[0].start
    expected = judge.judge(begin, written)
    assert [one.move for one in expected] == written
    others: list[Move] = []
    left_at: dict[TokenId, Cell] = {}
    for one in expected:
        move = one.move
        if move.token in left_at:
            away = left_at.pop(move.token)
            how = data.draw(st.sampled_from(["on its old cell", "where it was", "by a move"]))
            if how == "by a move":
                others.append(Move(move.token, away, move.origin))
            elif how == "where it was" and away != move.destination:
                move = Move(move.token, away, move.destination)
        others.append(move)
        if not isinstance(one.verdict, Allowed):
            left_at[move.token] = move.destination
    judged = [one for one in judge.judge(begin, others) if not isinstance(one.verdict, PutBack)]
    assert judged == list(expected)


@given(lessons())
def test_the_allowed_moves_are_those_with_the_verdict_allowed(lesson: Lesson) -> None:
    learner = GroundedLearner(lesson.vocabulary)
    for shown in lesson.demonstrations:
        learner.show(shown)
    exercise = learner.exercise()
    judge = GroundedJudge(exercise, lesson.deck)
    sets = by_definition.learn(lesson.vocabulary, lesson.demonstrations)
    for play in lesson.demonstrations:
        for made, state in enumerate(play.states()):
            able = [
                Move(token, origin, destination)
                for token, origin in state.cells.items()
                for destination in state.board.cells
                if destination not in state.tokens
            ]
            right = {m for m in able if isinstance(judge.verdict(state, made, m), Allowed)}
            assert set(judge.allowed_moves(state, made)) == right
            assert right == {
                move
                for move in by_definition.applicable(sets, lesson.deck, state, made)
                if made < max(exercise.lengths)
                and by_definition.can_end(
                    sets, exercise.lengths, lesson.deck, state.after(move), made + 1
                )
            }


def test_a_move_that_only_leads_nowhere_is_told_as_a_dead_end() -> None:
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in (1, 2, 3)))
    board = Board(2, 3)
    begin = State(
        board, {t.id: at for t, at in zip(deck.tokens, board.storage_cells, strict=True)}
    )

    def play(*ranks: int) -> Demonstration:
        ids = [deck.tokens[rank].id for rank in ranks]
        steps = zip(ids, board.goal_cells, strict=False)
        return Demonstration(deck, begin, tuple(Move(t, begin.cells[t], to) for t, to in steps))

    exercise = exercise_of([play(0, 1, 2), play(1, 0, 2)])
    judge = GroundedJudge(exercise, deck)
    assert isinstance(judge.verdict(begin, 0, play(0).moves[0]), Allowed)
    without_last = GroundedExercise(
        ActionModel(
            exercise.model.vocabulary,
            {a: bits for a, bits in exercise.model.preconditions.items() if a.step < 3},
        ),
        exercise.provenance,
        exercise.lengths,
        exercise.demonstrations,
    )
    first = play(0).moves[0]
    lost = GroundedJudge(without_last, deck)
    assert lost.verdict(begin, 0, first) == DeadEnd(Action(deck.tokens[0].attributes, 1))
    assert not list(lost.allowed_moves(begin, 0))
