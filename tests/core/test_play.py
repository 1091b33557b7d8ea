import pytest
from hypothesis import given

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration, Play
from maestra.core.faults import Fault, InvalidError
from maestra.core.formats import encode_demonstration, read_plays
from maestra.core.json_lines import FormatError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from tests.strategies import demonstrations

T1, T2 = TokenId("T1"), TokenId("T2")
DECK = Deck((Token(T1, (("value", 19),)), Token(T2, (("value", 23),))))


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


START = State(Board(), {T1: cell(2, 1), T2: cell(3, 4)})
PUT_BACK = (Move(T1, cell(2, 1), cell(1, 1)), Move(T2, cell(3, 4), cell(1, 1)))

LINE = (
    '{"format": "maestra.demonstration/1", "board": {}, "tokens": {"T1": {"value": 19}, '
    '"T2": {"value": 23}}, "start": {"T1": [2, 1], "T2": [3, 4]}, "moves": [%s]}'
)
FIRST = '{"token": "T1", "origin": [2, 1], "destination": [1, 1]}'
AGAIN = '{"token": "T2", "origin": [3, 4], "destination": [1, 1]}'


def test_a_play_may_hold_moves_that_make_sense_only_once_others_are_put_back() -> None:
    assert Play(DECK, START, PUT_BACK).moves == PUT_BACK
    with pytest.raises(InvalidError, match="is taken by T1"):
        Demonstration(DECK, START, PUT_BACK)


def test_a_play_with_unknown_tokens_or_cells_is_refused_with_every_fault() -> None:
    moves = (Move(TokenId("T9"), cell(2, 1), cell(9, 1)), Move(T1, cell(0, 1), cell(1, 1)))
    with pytest.raises(InvalidError) as caught:
        Play(DECK, START, moves)
    assert caught.value.faults == (
        Fault("moves[0].token", "unknown token T9", "a token of the deck"),
        Fault("moves[0].destination", "[9, 1] is off the board", "row 1 to 4 and column 1 to 5"),
        Fault("moves[1].origin", "[0, 1] is off the board", "row 1 to 4 and column 1 to 5"),
    )


def test_a_play_with_more_moves_than_a_working_day_has_is_refused() -> None:
    with pytest.raises(InvalidError, match="10002 moves, expected at most 10000"):
        Play(DECK, START, PUT_BACK * 5_001)


def test_plays_are_read_with_the_numbers_of_their_lines() -> None:
    lines = f"\n{LINE % FIRST}\n\n{LINE % f'{FIRST}, {AGAIN}'}\n".encode()
    read = list(read_plays([lines], "plays.jsonl"))
    assert [(number, len(play.moves)) for number, play in read] == [(2, 1), (4, 2)]
    assert read[1][1] == Play(DECK, START, PUT_BACK)


@given(demonstrations())
def test_every_demonstration_is_also_a_play(shown: Demonstration) -> None:
    ((_, play),) = read_plays([encode_demonstration(shown).encode()], "-")
    assert play == Play(
        shown.deck, shown.start, shown.moves, shown.label, shown.times_ms, shown.source
    )


def test_a_play_on_another_board_than_the_first_is_refused() -> None:
    other = (LINE % FIRST).replace('"board": {}', '"board": {"rows": 5}')
    with pytest.raises(FormatError, match="line 2: board: 5 x 5 with goal row 1, expected 4 x 5"):
        list(read_plays([f"{LINE % FIRST}\n{other}".encode()], "plays.jsonl"))


def test_a_file_without_any_play_is_refused() -> None:
    with pytest.raises(FormatError, match="an empty file, expected at least one"):
        list(read_plays([b"\n"], "plays.jsonl"))
