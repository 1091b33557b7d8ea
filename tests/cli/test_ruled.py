"""The commands with exercises made of rules."""

import json
from pathlib import Path
from typing import Any

import pytest

from maestra.core.board import Board
from maestra.core.demonstration import Play
from maestra.core.formats import encode_demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, TokenId
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.forms.counting import Count
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.paper import BOARD, NUMBER_DECK
from maestra.rules.setting import ORIGIN_COLUMN
from maestra.rules.token_tests import Comparison, Extreme, has
from tests.cli.running import Ran, maestra
from tests.rules.told_exercises import FULL, ODD, RISING, VOWELS, deck_of, in_storage, told

LEFT_TO_RIGHT = FillOrder(Filling.LEFT_TO_RIGHT)
UNSURE = told(
    RISING, FULL, status=LearnStatus.AMBIGUOUS, safe=(RISING, FULL, ODD), others=[(ODD, FULL)]
)
OUTSIDE = told(FULL, status=LearnStatus.OUTSIDE, safe=(RISING, FULL))


def saved(folder: Path, exercise: RuledExercise) -> Path:
    file = folder / "exercise.json"
    file.write_text(encode_exercise(exercise))
    return file


def played(*values: int, deck: Deck = NUMBER_DECK, board: Board = BOARD) -> bytes:
    """A play that puts these values on the goal cells from the left, however wrong."""
    start: State = in_storage(deck, board)
    moves: list[Move] = []
    free = list(board.goal_cells)
    for value in values:
        token = next(one.id for one in deck.tokens if one.value("value") == value)
        moves.append(Move(token, start.cells[token], free.pop(0)))
    return (encode_demonstration(Play(deck, start, tuple(moves))) + "\n").encode()


def answer(ran: Ran) -> Any:  # noqa: ANN401 - JSON
    return json.loads(ran.out)


def verdict(what: str, certainty: str, *broken: str, reason: str = "") -> dict[str, object]:
    return {"verdict": what, "certainty": certainty, "broken": [*broken], "reason": reason}


ALLOWED = verdict("allowed", "certain")


# ------------------------------------------------------------------ judge


def test_a_right_play_is_allowed_and_complete(tmp_path: Path) -> None:
    file = saved(tmp_path, told(RISING, FULL))
    ran = maestra("judge", file, "-", typed=played(19, 32, 46, 57, 68))
    assert (ran.code, ran.err) == (0, "")
    assert answer(ran) == {"moves": [ALLOWED] * 5, "complete": True}


@pytest.mark.parametrize(
    ("language", "reason"),
    [
        ("en", "32 is not larger than 46 on its left."),
        ("es", "El 32 no es mayor que el 46 de su izquierda."),
        ("ca", "El 32 no és més gran que el 46 de l'esquerra."),
    ],
)
def test_a_broken_rule_is_named_with_a_short_reason(
    tmp_path: Path, language: str, reason: str
) -> None:
    file = saved(tmp_path, told(RISING, FULL))
    ran = maestra("judge", file, "-", "--lang", language, typed=played(46, 32))
    assert ran.code == 1
    wrong = verdict("refused", "certain", "increasing-value", reason=reason)
    assert answer(ran) == {"moves": [ALLOWED, wrong], "complete": False}
    assert len(reason.split()) <= 12


def test_a_dead_end_breaks_no_single_rule(tmp_path: Path) -> None:
    file = saved(tmp_path, told(RISING, FULL))
    ran = maestra("judge", file, "-", typed=played(68))
    reason = "Then the row can no longer come out right."
    assert answer(ran)["moves"] == [verdict("refused", "certain", reason=reason)]


def test_what_may_be_meant_otherwise_is_only_probable(tmp_path: Path) -> None:
    file = saved(tmp_path, UNSURE)
    ran = maestra("judge", file, "-", typed=played(19, 32, 23))
    first, other, wrong = answer(ran)["moves"]
    assert first == ALLOWED
    assert other == verdict("allowed", "probable")
    assert (wrong["verdict"], wrong["certainty"]) == ("refused", "certain")


def test_outside_the_language_the_caregiver_is_to_be_asked(tmp_path: Path) -> None:
    ran = maestra("judge", saved(tmp_path, OUTSIDE), "-", typed=played(23, 19))
    reason = "I have not seen this yet: please ask the caregiver."
    asked = {**verdict("refused", "probable", reason=reason), "ask": True}
    assert answer(ran) == {"moves": [ALLOWED, asked], "complete": False}


def test_other_tokens_and_another_board_can_be_played_with(tmp_path: Path) -> None:
    file = saved(tmp_path, told(RISING, FULL))
    for count, columns in ((7, 4), (12, 6)):
        deck, board = deck_of("value", range(count)), Board(4, columns)
        play = played(*range(columns), deck=deck, board=board)
        ran = maestra("judge", file, "-", typed=play)
        assert answer(ran) == {"moves": [ALLOWED] * columns, "complete": True}


def test_tokens_without_what_the_rules_ask_for_are_bad_input(tmp_path: Path) -> None:
    file = saved(tmp_path, told(VOWELS, deck=deck_of("letter", "ABC")))
    ran = maestra("judge", file, "-", typed=played(19))
    assert (ran.code, ran.out) == (2, "")
    line = "maestra: -, line 1: letter: no token shows it, expected a deck with this attribute\n"
    assert ran.err.replace("standard input", "-") == line


# ------------------------------------------------------------------ moves


def test_the_right_moves_are_those_that_are_judged_so(tmp_path: Path) -> None:
    file = saved(tmp_path, told(RISING, FULL, LEFT_TO_RIGHT))
    ran = maestra("moves", file, "-", typed=played(19, 46))
    listed = answer(ran)
    assert listed["complete"] is False
    values = [move["token"] for move in listed["allowed"]]
    tokens = {token.id: token.value("value") for token in NUMBER_DECK.tokens}
    assert [tokens[TokenId(token)] for token in values] == [51, 57]
    assert {tuple(move["destination"]) for move in listed["allowed"]} == {(1, 3)}


# ------------------------------------------------------------------ explain


def test_rules_are_said_with_how_sure_they_are(tmp_path: Path) -> None:
    ran = maestra("explain", saved(tmp_path, told(RISING, FULL, status=LearnStatus.LEARNED)))
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == (
        "Each token must be larger than the one on its left. Fill the whole of the top row.\n\n"
        "I am 90 % sure of this.\n"
    )


@pytest.mark.parametrize(
    ("exercise", "said"),
    [
        (UNSURE, ["I am not sure: 90 %. It could also be:", "- Use only odd numbers. Fill"]),
        (told(FULL, status=LearnStatus.AMBIGUOUS), ["I am not sure of this: 90 %."]),
        (OUTSIDE, ["I am not sure: no simple rule explains what I saw.", "- Each token must be"]),
        (told(FULL, status=LearnStatus.CONTRADICTORY), ["does not fit together."]),
        (told(FULL), ["You told me so."]),
        (told(), ["Anything is right.\n\nYou told me so."]),
    ],
)
def test_what_is_not_sure_is_said(
    tmp_path: Path, exercise: RuledExercise, said: list[str]
) -> None:
    out = maestra("explain", saved(tmp_path, exercise)).out
    assert all(piece in out for piece in said), out


def test_explain_gives_ids_confidences_and_alternatives_as_json(tmp_path: Path) -> None:
    told_as = answer(maestra("explain", saved(tmp_path, UNSURE), "--json"))
    assert (told_as["status"], told_as["confidence"]) == ("ambiguous", 0.9)
    assert [rule["id"] for rule in told_as["rules"]] == ["increasing-value", "full-row"]
    assert [rule["confidence"] for rule in told_as["rules"]] == [0.9, 0.9]
    assert [other["weight"] for other in told_as["alternatives"]] == [0.05]
    assert "odd" in told_as["alternatives"][0]["text"]


# ------------------------------------------------------------------ export


def test_rules_that_actions_can_say_are_exported(tmp_path: Path) -> None:
    file = saved(tmp_path, told(RISING, FULL, LEFT_TO_RIGHT))
    ran = maestra("export", file, "--pddl", tmp_path / "pddl")
    assert (ran.code, ran.err) == (0, "")
    domain = (tmp_path / "pddl" / "domain.pddl").read_text()
    assert domain.count("(:action") == 30


@pytest.mark.parametrize(
    ("exercise", "told_line"),
    [
        (
            told(
                Count(has("odd", "value"), Comparison.EQUAL, 1),
                FULL,
                deck=deck_of("value", range(1, 7)),
                board=Board(3, 3),
            ),
            "rules: rules that preconditions of single cells cannot say, expected rules",
        ),
        (
            told(TakeExtreme(ORIGIN_COLUMN, Extreme.LOWEST)),
            "which looks at where other tokens began",
        ),
        (told(StraightUp(), LEFT_TO_RIGHT, RISING, ODD, FULL), ""),
        (told(ODD, FULL, deck=deck_of("value", range(0, 20, 2))), "rules: no right play"),
    ],
)
def test_rules_that_actions_cannot_say_are_one_line(
    tmp_path: Path, exercise: RuledExercise, told_line: str
) -> None:
    ran = maestra("export", saved(tmp_path, exercise), "--pddl", tmp_path / "pddl")
    assert ran.code == (2 if told_line else 0)
    assert told_line in ran.err
    assert ran.err.count("\n") == (1 if told_line else 0)
