"""Laws of the format: what is written is read again, however the bytes are cut."""

import json
from collections.abc import Iterable, Sequence
from decimal import Decimal
from itertools import islice, pairwise

from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.formats import (
    DEMONSTRATION_FORMAT,
    decode_demonstration,
    encode_attributes,
    encode_deck,
    encode_demonstration,
    encode_move,
    read_demonstrations,
)
from maestra.core.json_lines import FormatError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from tests.strategies import boards, demonstrations

T1, T2 = TokenId("04A3B2"), TokenId("04A3B3")


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


DECK = Deck((Token(T1, (("value", 19),)), Token(T2, (("value", 23), ("colour", "red")))))
SHOWN = Demonstration(
    DECK,
    State(Board(), {T1: cell(2, 1), T2: cell(3, 4)}),
    (Move(T1, cell(2, 1), cell(1, 1)),),
)
# As in the page that other programs are built on.
WRITTEN = """
{"format": "maestra.demonstration/1",
 "board": {"rows": 4, "columns": 5, "goal_row": 1},
 "tokens": {"04A3B2": {"value": 19}, "04A3B3": {"value": 23, "colour": "red"}},
 "start": {"04A3B2": [2, 1], "04A3B3": [3, 4]},
 "moves": [{"token": "04A3B2", "origin": [2, 1], "destination": [1, 1]}]}
""".replace("\n", "")


def test_the_documented_line_is_read() -> None:
    assert decode_demonstration(WRITTEN.encode()) == SHOWN


def test_the_documented_line_is_written() -> None:
    assert json.loads(encode_demonstration(SHOWN)) == json.loads(WRITTEN)


def test_every_optional_field_is_read_and_written() -> None:
    deck = Deck(
        (
            Token(
                T1,
                (("name", "cup"), ("day", "Monday"), ("month", "May"), ("size", Decimal("1.5"))),
            ),
        ),
        {"day": ("Monday", "Tuesday")},
        {"month": ("April", "May")},
        {"partner": frozenset({("cup", "saucer"), ("bread", "butter")})},
        ("CURIE", "rueda"),
    )
    start = State(Board(2, 3, Row(2)), {T1: cell(1, 1)})
    moves = (Move(T1, cell(1, 1), cell(2, 3)),)
    shown = Demonstration(deck, start, moves, "a note", (1_500,), "simulated")
    assert json.loads(encode_demonstration(shown)) == {
        "format": DEMONSTRATION_FORMAT,
        "board": {"rows": 2, "columns": 3, "goal_row": 2},
        "tokens": {T1: {"day": "Monday", "month": "May", "name": "cup", "size": 1.5}},
        "orders": {"day": ["Monday", "Tuesday"]},
        "cycles": {"month": ["April", "May"]},
        "relations": {"partner": [["bread", "butter"], ["cup", "saucer"]]},
        "lexicon": ["CURIE", "rueda"],
        "start": {T1: [1, 1]},
        "moves": [{"token": T1, "origin": [1, 1], "destination": [2, 3]}],
        "label": "a note",
        "times_ms": [1_500],
        "source": "simulated",
    }
    assert decode_demonstration(encode_demonstration(shown).encode()) == shown


def test_an_optional_field_may_be_null_and_the_boards_sides_left_out() -> None:
    fields = json.loads(WRITTEN) | {"board": {}, "label": None, "times_ms": None, "source": None}
    assert decode_demonstration(json.dumps(fields).encode()) == SHOWN


def test_parts_are_written_as_in_a_whole_line() -> None:
    whole = json.loads(encode_demonstration(SHOWN))
    assert encode_deck(DECK) == {"tokens": whole["tokens"]}
    assert encode_attributes((("size", Decimal("1.5")), ("value", 2))) == {"size": 1.5, "value": 2}
    assert json.loads(json.dumps(encode_move(SHOWN.moves[0]))) == whole["moves"][0]


@given(demonstrations())
def test_what_is_written_is_read_again(shown: Demonstration) -> None:
    line = encode_demonstration(shown)
    assert "\n" not in line
    assert decode_demonstration(line.encode()) == shown


@given(demonstrations())
def test_writing_is_a_function_of_the_demonstration_alone(shown: Demonstration) -> None:
    twin = decode_demonstration(encode_demonstration(shown).encode())
    assert encode_demonstration(twin).encode() == encode_demonstration(shown).encode()


@st.composite
def files(draw: st.DrawFn) -> tuple[list[Demonstration], bytes]:
    """Demonstrations on one board and a file of them: any line ends, blank lines, a BOM or not."""
    board = draw(boards(min_cells=3))
    shown = draw(st.lists(demonstrations(board=board, max_moves=2), min_size=1, max_size=4))
    content = draw(st.sampled_from([b"", b"\xef\xbb\xbf", b"\n \r\n"]))
    for one in shown:
        content += encode_demonstration(one).encode()
        content += draw(st.sampled_from([b"\n", b"\r\n", b"\n\n\t\n"]))
    return shown, content if draw(st.booleans()) else content.rstrip()


def cut(content: bytes, places: Sequence[int]) -> list[bytes]:
    at = [0, *sorted(places), len(content)]
    return [content[start:end] for start, end in pairwise(at)]


def outcome(chunks: Iterable[bytes]) -> tuple[list[Demonstration], str]:
    """What a reader gets: the demonstrations before the first error, and the error."""
    read: list[Demonstration] = []
    try:
        read.extend(read_demonstrations(chunks, "demos.jsonl"))
    except FormatError as error:
        return read, str(error)
    return read, ""


@given(files(), st.data())
def test_a_file_is_read_however_it_is_cut(
    file: tuple[list[Demonstration], bytes], data: st.DataObject
) -> None:
    shown, content = file
    places = data.draw(st.lists(st.integers(0, len(content)), max_size=5))
    assert outcome(cut(content, places)) == (shown, "")
    assert outcome([bytes([one]) for one in content]) == (shown, "")


@given(files(), st.data())
def test_a_damaged_file_gives_the_same_error_however_it_is_cut(
    file: tuple[list[Demonstration], bytes], data: st.DataObject
) -> None:
    content = bytearray(file[1])
    for _ in range(data.draw(st.integers(1, 3))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    whole = outcome([bytes(content)])
    assert outcome([bytes([one]) for one in content]) == whole
    assert whole[1].isprintable()


@given(st.binary(max_size=200))
def test_binary_noise_is_refused_in_words(noise: bytes) -> None:
    read, said = outcome([noise])
    assert not read
    assert said.startswith("demos.jsonl, line ")


def test_reading_stops_at_the_first_line_that_is_wrong() -> None:
    lines = iter([WRITTEN.encode() + b"\n", b"{}\n", b"never asked for"])
    read, said = outcome(lines)
    assert read == [SHOWN]
    assert said.startswith("demos.jsonl, line 2: format: missing")
    assert next(lines) == b"never asked for"


def test_demonstrations_of_one_file_share_their_deck_and_their_board() -> None:
    content = f"{WRITTEN}\n".encode() * 3
    first, second, third = islice(read_demonstrations([content], "demos.jsonl"), 3)
    assert first.deck is second.deck is third.deck
    assert first.board is second.board is third.board
