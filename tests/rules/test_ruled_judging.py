"""Judging by rules: against the plain meaning of the rules, and as the two kinds agree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.faults import InvalidError
from maestra.core.state import IllegalMoveError, Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import GroundedLearner
from maestra.rules import ruled_judging
from maestra.rules.account import account_of, broken_ids
from maestra.rules.exercise import (
    Alternative,
    Exercise,
    LearnStatus,
    RuledExercise,
    meant_rules,
)
from maestra.rules.forms.base import Position as Place
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import Equation
from maestra.rules.forms.order import ExtremeAt
from maestra.rules.forms.patterns import Template, given_row
from maestra.rules.forms.relations import TwoPlaces
from maestra.rules.forms.selection import EveryToken
from maestra.rules.judging import Judge
from maestra.rules.pairs import same
from maestra.rules.paper import BOARD, NUMBER_DECK
from maestra.rules.position import Position
from maestra.rules.rule import Rule
from maestra.rules.ruled_judging import RuledJudge
from maestra.rules.setting import Line, Play, Setting, bits
from maestra.rules.token_tests import Compared, Comparison, Extreme, has
from maestra.rules.verdicts import (
    JudgedMove,
    NoPlacement,
    NotKnown,
    NoWayOn,
    PutBack,
    RowDone,
    RulesBroken,
    RulesKept,
)
from tests.rules.exercise_strategies import fitting_rule, some
from tests.rules.lessons import Lesson, lessons
from tests.rules.positions import positions_of
from tests.rules.rule_strategies import decks, every_way_on, plays_from, settings_with
from tests.rules.told_exercises import FULL, ODD, RISING, VOWELS, deck_of, in_storage, told

SMALL = EveryToken(Compared("value", Comparison.LESS, 60))


def position_of(play: Play) -> Position:
    position = Position.begin(play.setting.start)
    for move in play.moves():
        position = position.after(move)
    return position


def can_keep(rules: Sequence[Rule], play: Play) -> bool:
    """The plain meaning: some way to go on, ending here included, keeps all of them."""
    return any(all(rule.holds(end) for rule in rules) for end in every_way_on(play))


@st.composite
def judged_plays(draw: st.DrawFn) -> tuple[RuledExercise, Play]:
    """An exercise with little evidence, and a play that can go on in few ways."""
    setting = draw(settings_with(draw(decks())))
    rules = some(draw, 3, lambda draw: fitting_rule(draw, setting))
    more = some(draw, 2, lambda draw: fitting_rule(draw, setting))
    others = some(draw, 2, lambda draw: some(draw, 2, lambda draw: fitting_rule(draw, setting)))
    exercise = RuledExercise(
        setting.start.board,
        setting.deck,
        meant_rules(rules, [1.0] * len(rules)),
        0.9,
        draw(st.sampled_from(LearnStatus)),
        (*rules, *more),
        tuple(Alternative(one, 0.1) for one in others),
    )
    return exercise, draw(plays_from(setting, ways=100))


# ------------------------------------------------------------------ the plain meaning


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(judged_plays())
def test_a_verdict_is_what_listing_every_way_on_says(pair: tuple[RuledExercise, Play]) -> None:
    exercise, play = pair
    judge = Judge(exercise, exercise.deck)
    outside = exercise.status is LearnStatus.OUTSIDE
    rules = exercise.safe if outside else exercise.conjunction
    position = position_of(play)
    right: list[Move] = []
    for cell in play.free:
        for token in bits(play.left):
            after = play.after(token, cell)
            move = after.moves()[-1]
            verdict = judge.verdict(position, move)
            safe = can_keep(exercise.safe, after)
            refused = exercise.status is not LearnStatus.CONTRADICTORY and not any(
                can_keep(other.rules, after) for other in exercise.alternatives
            )
            if can_keep(rules, after):
                right.append(move)
                assert verdict == RulesKept(certain=safe)
            elif outside:
                assert verdict == NotKnown()
            elif broken := tuple(one for one in exercise.rules if not can_keep([one.rule], after)):
                assert verdict == RulesBroken(broken, certain=refused)
            else:
                assert verdict == NoWayOn(certain=refused)
    assert list(judge.allowed_moves(position)) == right
    assert judge.may_end(position) == all(rule.holds(play) for rule in rules)


# ------------------------------------------------------------------ both kinds: the contract


def able_moves(state: State) -> list[Move]:
    return [
        Move(token, origin, destination)
        for token, origin in state.cells.items()
        for destination in state.board.cells
        if destination not in state.tokens
    ]


def check_agreement(judge: Judge, position: Position) -> None:
    """What is listed as allowed is what is judged to be; others say what is wrong."""
    account = account_of(judge.exercise)
    judged = [
        JudgedMove(position.now, move, judge.verdict(position, move))
        for move in able_moves(position.now)
    ]
    allowed = {one.move for one in judged if not one.is_refused}
    assert set(judge.allowed_moves(position)) == allowed
    for one in judged:
        assert not (one.move in allowed and broken_ids(one, account, judge.deck))
    if not position.moves:
        for one in judged:
            again, end = judge.read(position.start, [one.move])
            assert again == (one,)
            assert (end != position) == (one.move in allowed)


@given(lessons())
def test_a_judge_by_actions_agrees_with_itself(lesson: Lesson) -> None:
    learner = GroundedLearner(lesson.vocabulary)
    for shown in lesson.demonstrations:
        learner.show(shown)
    judge = Judge(learner.exercise(), lesson.deck)
    for play in lesson.demonstrations:
        for position in positions_of(play):
            check_agreement(judge, position)


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(judged_plays())
def test_a_judge_by_rules_agrees_with_itself(pair: tuple[RuledExercise, Play]) -> None:
    exercise, play = pair
    check_agreement(Judge(exercise, exercise.deck), position_of(play))


WRITTEN = ("on its old cell", "where it was", "by a move")


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(judged_plays(), st.data())
def test_however_putting_back_is_written_the_verdicts_are_the_same(
    pair: tuple[RuledExercise, Play], data: st.DataObject
) -> None:
    exercise, play = pair
    judge = Judge(exercise, exercise.deck)
    position = Position.begin(play.setting.start)
    written: list[Move] = []
    expected: list[JudgedMove] = []
    left_at: dict[TokenId, Cell] = {}
    for _ in range(data.draw(st.integers(0, 4))):
        able = able_moves(position.now)
        if not able:
            break
        move = data.draw(st.sampled_from(able))
        expected.append(JudgedMove(position.now, move, judge.verdict(position, move)))
        way, shown = data.draw(st.sampled_from(WRITTEN)), move
        if move.token in left_at:
            away = left_at.pop(move.token)
            if way == "by a move":
                written.append(Move(move.token, away, move.origin))
            elif way == "where it was" and away != move.destination:
                shown = replace(move, origin=away)
        written.append(shown)
        if expected[-1].is_refused:
            left_at[move.token] = move.destination
        else:
            position = position.after(move)
    judged, end = judge.read(play.setting.start, written)
    assert [one for one in judged if not isinstance(one.verdict, PutBack)] == expected
    assert end == position


# ------------------------------------------------------------------ how sure


def ascending_judge(exercise: Exercise) -> tuple[Judge, Position]:
    return Judge(exercise, NUMBER_DECK), Position.begin(in_storage(NUMBER_DECK, BOARD))


def placing(position: Position, value: int, column: int) -> Move:
    deck = NUMBER_DECK
    token = next(one.id for one in deck.tokens if one.value("value") == value)
    goal = Cell(position.now.board.goal_row, Column(column))
    return Move(token, position.now.cells[token], goal)


def test_what_the_safe_rules_allow_is_certain_and_the_rest_probable() -> None:
    exercise = told(RISING, FULL, status=LearnStatus.LEARNED, safe=(RISING, FULL, SMALL))
    judge, begin = ascending_judge(exercise)
    assert judge.verdict(begin, placing(begin, 34, 1)) == RulesKept(certain=True)
    assert judge.verdict(begin, placing(begin, 68, 5)) == RulesKept(certain=False)
    after = begin.after(placing(begin, 68, 5))
    assert judge.verdict(after, placing(begin, 34, 1)) == RulesKept(certain=False)


def test_what_no_alternative_allows_is_refused_for_certain() -> None:
    exercise = told(RISING, FULL, status=LearnStatus.AMBIGUOUS, others=[(SMALL, FULL)])
    judge, begin = ascending_judge(exercise)
    (rising, _) = exercise.rules
    after = begin.after(placing(begin, 51, 1))
    assert judge.verdict(after, placing(begin, 34, 2)) == RulesBroken((rising,), certain=False)
    last = after.after(placing(after, 68, 5))
    assert judge.verdict(last, placing(begin, 34, 2)) == RulesBroken((rising,), certain=True)
    assert judge.verdict(begin, placing(begin, 57, 1)) == NoWayOn(certain=False)
    assert judge.verdict(begin, placing(begin, 68, 1)) == NoWayOn(certain=True)


def test_where_nothing_fits_together_no_refusal_is_certain() -> None:
    judge, begin = ascending_judge(told(RISING, FULL, status=LearnStatus.CONTRADICTORY))
    assert judge.verdict(begin, placing(begin, 68, 1)) == NoWayOn(certain=False)


def test_outside_the_language_only_the_safe_rules_count_and_the_rest_is_asked() -> None:
    exercise = told(FULL, status=LearnStatus.OUTSIDE, safe=(RISING, FULL))
    judge, begin = ascending_judge(exercise)
    assert judge.verdict(begin, placing(begin, 19, 1)) == RulesKept(certain=True)
    assert judge.verdict(begin, placing(begin, 68, 1)) == NotKnown()
    assert len(list(judge.allowed_moves(begin))) == 30
    token = NUMBER_DECK.tokens[0].id
    within = Move(token, begin.now.cells[token], Cell(Row(4), Column(5)))
    assert judge.verdict(begin, within) == NotKnown()
    asked = JudgedMove(begin.now, within, NotKnown())
    assert (asked.is_refused, asked.is_certain) == (True, False)


def test_a_search_that_is_given_up_allows_but_is_not_sure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("maestra.rules.completability.QUICK_CHOICES", 0)
    monkeypatch.setattr(ruled_judging, "CAREFUL_CHOICES", 0)
    monkeypatch.setattr(ruled_judging, "CHOICES_TO_BE_SURE", 0)
    judge, begin = ascending_judge(told(RISING, FULL, others=[(FULL,)]))
    assert judge.verdict(begin, placing(begin, 68, 1)) == RulesKept(certain=False)
    assert len(list(judge.allowed_moves(begin))) == 50


def test_a_full_row_is_the_end() -> None:
    judge, begin = ascending_judge(told(RISING, FULL))
    end = begin
    for column, value in enumerate((19, 34, 46, 63, 68), start=1):
        end = end.after(placing(end, value, column))
    assert judge.may_end(end)
    assert not list(judge.allowed_moves(end))
    token = next(one.id for one in NUMBER_DECK.tokens if one.value("value") == 23)
    move = Move(token, end.now.cells[token], Cell(Row(4), Column(5)))
    assert judge.verdict(end, move) == RowDone()


def test_rules_speak_only_of_moves_from_storage_to_the_goal_row() -> None:
    judge, begin = ascending_judge(told(RISING, FULL))
    first = placing(begin, 19, 1)
    after = begin.after(first)
    within = Move(first.token, first.destination, Cell(Row(1), Column(2)))
    back = Move(first.token, first.destination, first.origin)
    for move in (within, back):
        assert judge.verdict(after, move) == NoPlacement()


def test_a_move_that_no_board_could_make_is_no_verdict() -> None:
    judge, begin = ascending_judge(told(RISING, FULL))
    move = placing(begin, 19, 1)
    with pytest.raises(IllegalMoveError):
        judge.verdict(begin, replace(move, origin=Cell(Row(4), Column(5))))
    with pytest.raises(IllegalMoveError, match=r"moves\[1\]\.destination"):
        judge.judge(begin.start, [move, placing(begin, 23, 1)])


# ------------------------------------------------------------------ other decks and boards


@pytest.mark.parametrize(("tokens", "columns"), [(7, 4), (12, 6), (10, 5), (5, 5)])
def test_ascending_goes_with_other_numbers_and_other_rows(tokens: int, columns: int) -> None:
    deck = deck_of("value", range(100, 100 + 3 * tokens, 3))
    board = Board(4, columns)
    judge = Judge(told(RISING, FULL), deck)
    begin = Position.begin(in_storage(deck, board))
    ids = [token.id for token in deck.tokens]
    moves = [Move(ids[k], begin.now.cells[ids[k]], board.goal_cells[k]) for k in range(columns)]
    judged, end = judge.read(begin.start, moves)
    assert not any(one.is_refused for one in judged)
    assert all(one.is_certain for one in judged)
    assert judge.may_end(end)
    allowed = list(judge.allowed_moves(begin))
    assert len(allowed) == columns * (tokens - columns + 1)
    first = {move.token for move in allowed if move.destination == board.goal_cells[0]}
    assert first == set(ids[: tokens - columns + 1])


def test_vowels_go_with_other_letters() -> None:
    deck = deck_of("letter", "AXOYUZE")
    exercise = told(VOWELS, deck=deck_of("letter", "AEIBC"))
    judge = Judge(exercise, deck)
    begin = Position.begin(in_storage(deck, BOARD))
    assert {move.token for move in judge.allowed_moves(begin)} == set("AOUE")


def test_a_deck_without_what_the_rules_ask_for_is_refused() -> None:
    with pytest.raises(InvalidError, match="value: no token shows it"):
        Judge(told(RISING), deck_of("letter", "ABC"))


def test_alternatives_that_a_deck_cannot_be_asked_for_are_left_out() -> None:
    deck = deck_of("value", range(10))
    lettered = replace(
        told(RISING, FULL, deck=both_deck()),
        safe=(RISING, FULL, VOWELS),
        alternatives=(Alternative((VOWELS,), 0.1), Alternative((ODD,), 0.1)),
        status=LearnStatus.LEARNED,
    )
    judge = Judge(lettered, deck)
    begin = Position.begin(in_storage(deck, BOARD))

    def verdict(token: str, column: int) -> object:
        to = Cell(Row(1), Column(column))
        return judge.verdict(begin, Move(TokenId(token), begin.now.cells[TokenId(token)], to))

    assert verdict("0", 1) == RulesKept(certain=False)
    assert verdict("8", 1) == NoWayOn(certain=True)
    assert verdict("9", 1) == NoWayOn(certain=False)


def both_deck() -> Deck:
    """Tokens with a number and a letter."""
    return Deck(
        tuple(
            Token(TokenId(str(k)), (("value", k), ("letter", letter)))
            for k, letter in enumerate("ABCDEFGHIJ")
        )
    )


FAR = Place(5)
ODD_AT = At(FAR, has("odd", "value"))
BOARDLESS: Sequence[tuple[str, Rule]] = [
    ("place 5 of 4", ODD_AT),
    ("place -5 of 4", ExtremeAt("value", Extreme.LOWEST, Place(-5))),
    ("the middle of 4", TwoPlaces(Place(0), Place(1), same("value"))),
    ("place 5 of 4", Equation("value", (Place(1), FAR))),
    ("place 5 of 4", IfThen(At(Place(1), has("odd", "value")), ODD_AT)),
    ("4 goal cells", given_row("value", (1, 2, 3, 4, 5))),
    ("4 goal cells", Template("value", "AABBA")),
    ("2 storage rows", ModelRow(3, Reading.COPIED, same("value"))),
    ("2 storage rows", Cue(3, 1, same("value"))),
    ("4 columns", Cue(2, 5, same("value"))),
]


@pytest.mark.parametrize(("found", "rule"), BOARDLESS)
def test_a_board_without_a_place_that_the_rules_speak_of_is_refused(
    found: str, rule: Rule
) -> None:
    board = Board(3, 4)
    deck = deck_of("value", range(8))
    judge = Judge(told(rule, deck=deck), deck)
    begin = Position.begin(in_storage(deck, board))
    with pytest.raises(InvalidError, match=f"board: {found}"):
        judge.judge(begin.start, ())
    with pytest.raises(InvalidError):
        list(judge.allowed_moves(begin))
    with pytest.raises(InvalidError):
        judge.may_end(begin)


def test_a_board_that_has_the_places_will_do() -> None:
    deck = deck_of("value", range(8))
    in_time = At(FAR, has("odd", "value"), Line.TIME)
    rules = (Template("value", "AB"), Cue(2, 4, same("value")), in_time, RISING)
    judge = Judge(told(*rules, deck=deck), deck)
    assert judge.judge(in_storage(deck, Board(3, 4)), ()) == ()


def test_on_the_board_it_was_taught_on_every_rule_has_its_meaning() -> None:
    board = Board(3, 4)
    deck = deck_of("value", range(8))
    judge = RuledJudge(told(given_row("value", (0, 1, 2, 3, 4)), deck=deck, board=board), deck)
    begin = Position.begin(in_storage(deck, board))
    assert {move.token for move in judge.allowed_moves(begin)} == set("0123")
    assert Setting(deck, begin.start).length == 4
