import copy
import pickle
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.faults import (
    MAX_PIECE,
    MAX_QUOTED,
    MAX_SAID,
    Fault,
    InvalidError,
    one_line,
    refuse,
    shorten,
)
from maestra.core.json_lines import FormatError

FAULT = Fault("moves[2].origin", "T1 is not on [2, 1]", "[3, 1], where it lies")


def test_a_fault_says_where_what_and_what_was_expected() -> None:
    said = "moves[2].origin: T1 is not on [2, 1], expected [3, 1], where it lies"
    assert str(FAULT) == said
    assert str(Fault("", "an empty file", "a demonstration")) == (
        "an empty file, expected a demonstration"
    )


def test_a_fault_seen_from_outside_has_the_longer_path() -> None:
    assert Fault("origin", "a", "b").under("moves[2]") == Fault("moves[2].origin", "a", "b")
    assert Fault("", "a", "b").under("board") == Fault("board", "a", "b")


def test_nothing_is_refused_for_no_fault() -> None:
    refuse([])


def test_all_faults_are_said_on_one_line() -> None:
    with pytest.raises(InvalidError, match=r"^rows: 0, expected 1; b, expected c$"):
        refuse([Fault("rows", "0", "1"), Fault("", "b", "c")])


def test_of_very_many_faults_the_first_are_said_and_all_kept() -> None:
    error = InvalidError([FAULT] * (MAX_SAID + 7))
    assert str(error).count("moves[2]") == MAX_SAID
    assert str(error).endswith("; and 7 more")
    assert len(error.faults) == MAX_SAID + 7
    assert "more" not in str(InvalidError([FAULT] * MAX_SAID))


@given(where=st.text(), found=st.text(), expected=st.text(), file=st.text())
def test_a_message_is_one_printable_line_whatever_the_input_holds(
    where: str, found: str, expected: str, file: str
) -> None:
    said = str(FormatError(file, 3, (Fault(where, found, expected),)))
    assert said.isprintable()
    assert len(said.splitlines()) == 1
    said.encode()


def test_a_long_piece_of_a_message_is_cut() -> None:
    assert one_line("x" * MAX_PIECE) == "x" * MAX_PIECE
    assert one_line("x" * (MAX_PIECE + 1)) == "x" * (MAX_PIECE - 3) + "..."


@pytest.mark.parametrize("text", ["a\nb", "\x1b[31m", "\x9b31m", "\u2028", "\u202e", "\ud800"])
def test_what_a_terminal_would_obey_is_escaped(text: str) -> None:
    assert one_line(text).isprintable()
    assert "\\" in one_line(text)


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("ñ", '"ñ"'),
        (19, "19"),
        (Decimal("1.5"), "1.5"),
        ([1, None], "[1, null]"),
        ({"a": True}, '{"a": true}'),
        (frozenset[int](), '"frozenset()"'),
        ("x" * 100, '"' + "x" * (MAX_QUOTED - 4) + "..."),
    ],
)
def test_a_value_is_quoted_as_json_writes_it(value: object, said: str) -> None:
    assert shorten(value) == said


def test_a_value_nested_beyond_recursion_is_quoted_in_words() -> None:
    nested: list[object] = []
    for _ in range(100_000):
        nested = [nested]
    assert shorten(nested) == "brackets nested too deep"


@pytest.mark.parametrize("error", [InvalidError([FAULT]), FormatError("a.jsonl", 3, (FAULT,))])
def test_an_error_survives_pickling_and_copying(error: InvalidError) -> None:
    for twin in (pickle.loads(pickle.dumps(error)), copy.copy(error)):  # noqa: S301 - pickled here
        assert type(twin) is type(error)
        assert str(twin) == str(error)
        assert twin.faults == (FAULT,)
