"""`maestra tell` and `maestra edit`."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.exercise_format import decode_exercise
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.rule import Rule
from maestra.rules.token_tests import has
from tests.cli.running import EXAMPLES, learned, maestra

DECK = EXAMPLES / "ascending.jsonl"
EVEN_FALLING = (
    EveryToken(has("even", "value")),
    Ordered("value", Direction.FALLING),
    FullRow(),
)


def rules_in(path: Path) -> tuple[Rule, ...]:
    exercise = decode_exercise(path.read_bytes())
    assert isinstance(exercise, RuledExercise)
    assert exercise.status is LearnStatus.TOLD
    return exercise.conjunction


@pytest.fixture(name="told")
def an_exercise_that_was_told(tmp_path: Path) -> Path:
    path = tmp_path / "told.json"
    assert maestra("tell", "Only odd numbers", "--deck", DECK, "-o", path).code == 0
    return path


def test_a_sentence_becomes_an_exercise(tmp_path: Path) -> None:
    path = tmp_path / "exercise.json"
    sentence = "No odd numbers, from large to small, fill the row"
    ran = maestra("tell", sentence, "--deck", DECK, "-o", path)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == (
        "Use no odd numbers. Each token must be smaller than the one on its left. "
        f"Fill the whole of the top row.\n\nYou told me so.\nSaved in {path}.\n"
    )
    assert maestra("explain", path).out == ran.out.rpartition("Saved")[0]


def test_it_works_in_a_process_of_its_own_and_in_spanish(tmp_path: Path) -> None:
    path = tmp_path / "exercise.json"
    sentence = "Solo números impares, de mayor a menor"
    command = [sys.executable, "-m", "maestra", "tell", sentence, "--deck", str(DECK)]
    options = ["-o", str(path), "--lang", "es", "--json"]
    ran = subprocess.run([*command, *options], capture_output=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, b"")
    answer = json.loads(ran.stdout)
    assert answer["status"] == "told"
    assert [rule["text"] for rule in answer["rules"]] == [
        "Use solo números impares.",
        "Cada ficha debe ser menor que la de su izquierda.",
        "Llene toda la fila de arriba.",
    ]


def test_without_a_file_the_rules_are_only_said() -> None:
    ran = maestra("tell", "rising", "--deck", DECK)
    assert ran.out.startswith("Each token must be larger than the one on its left.")
    assert "Saved" not in ran.out


def test_the_exercise_can_go_to_standard_output() -> None:
    ran = maestra("tell", "rising", "--deck", DECK, "-o", "-")
    assert isinstance(decode_exercise(ran.out.encode()), RuledExercise)


def test_another_board_can_be_named(tmp_path: Path) -> None:
    path = tmp_path / "exercise.json"
    assert maestra("tell", "rising", "--deck", DECK, "--board", "6x4", "-o", path).code == 0
    board = decode_exercise(path.read_bytes()).board
    assert (board.rows, board.columns) == (6, 4)


@pytest.mark.parametrize(
    ("board", "expected"),
    [
        ("4", "--board: 4, expected ROWSxCOLUMNS"),
        ("axb", "--board: axb, expected"),
        ("2x2", "10 tokens for 2 storage cells"),
    ],
)
def test_a_board_that_is_none_is_refused(board: str, expected: str) -> None:
    ran = maestra("tell", "rising", "--deck", DECK, "--board", board)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert expected in ran.err


def test_a_file_without_plays_is_refused(tmp_path: Path) -> None:
    empty = tmp_path / "empty.jsonl"
    empty.write_text("")
    ran = maestra("tell", "rising", "--deck", empty)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)


def test_what_is_not_understood_is_quoted_with_sentences_that_are(tmp_path: Path) -> None:
    path = tmp_path / "exercise.json"
    ran = maestra("tell", "Only odd numbers, then dance", "--deck", DECK, "-o", path)
    assert (ran.code, ran.err) == (1, "")
    lines = ran.out.splitlines()
    assert lines[:2] == ["I did not understand: “then dance”.", "You could say:"]
    assert len(lines) == 5
    assert not path.exists()
    for line in lines[2:]:
        assert maestra("tell", line.removeprefix("- "), "--deck", DECK).code == 0


def test_the_json_of_what_is_not_understood() -> None:
    ran = maestra("tell", "sing", "--deck", DECK, "--json")
    answer = json.loads(ran.out)
    assert (ran.code, answer["status"]) == (1, "unknown")
    assert answer["quotes"][0]["text"] == "sing"
    assert len(answer["quotes"][0]["nearest"]) == 3


def test_of_several_meanings_one_must_be_chosen(tmp_path: Path) -> None:
    deck = tmp_path / "deck.jsonl"
    play = json.loads(DECK.read_text().splitlines()[0])
    for number, shown in enumerate(play["tokens"].values()):
        shown["weight"] = number
    deck.write_text(json.dumps(play))
    ran = maestra("tell", "only even tokens", "--deck", deck)
    assert ran.code == 1
    assert ran.out == (
        "That can mean several things. Which one?\n"
        "- Use only even tokens by number.\n- Use only even tokens by weight.\n"
    )
    ran = maestra("tell", "only even tokens", "--deck", deck, "--json")
    assert (ran.code, json.loads(ran.out)["status"]) == (1, "several")


def test_rules_that_no_row_can_keep_are_named() -> None:
    sentence = "only odd numbers, only even numbers, from left to right"
    ran = maestra("tell", sentence, "--deck", DECK)
    assert (ran.code, ran.err) == (1, "")
    assert ran.out == (
        "No row of these tokens keeps all of these rules:\n- Use only odd numbers.\n"
        "- Use only even numbers.\n- Fill the whole of the top row.\n"
    )
    ran = maestra("tell", sentence, "--deck", DECK, "--json")
    assert (ran.code, json.loads(ran.out)["status"]) == (1, "contradictory")


def test_a_sentence_that_is_too_long_is_refused() -> None:
    ran = maestra("tell", "odd " * 1_000, "--deck", DECK)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert "at most 1000" in ran.err


def test_a_caregivers_own_words_are_understood(tmp_path: Path) -> None:
    words = tmp_path / "words.json"
    noun = {"noun": "figure", "plural": "figures", "more": "greater", "less": "lesser"}
    file = {"format": "maestra.words/1", "attributes": {"value": {"en": noun}}}
    words.write_text(json.dumps(file))
    sentence = "Each token must be lesser than the one on its left."
    ran = maestra("tell", sentence, "--deck", DECK, "--words", words)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(sentence)


def test_the_rule_follows_its_sentence(told: Path, tmp_path: Path) -> None:
    before = told.read_bytes()
    (rule, *_) = json.loads(maestra("explain", told, "--json").out)["rules"]
    path = tmp_path / "edited.json"
    ran = maestra("edit", told, "--rule", rule["id"], "even numbers, descending", "-o", path)
    assert (ran.code, ran.err) == (0, "")
    assert rules_in(path) == EVEN_FALLING
    assert told.read_bytes() == before


def test_rules_are_added_and_removed(told: Path, tmp_path: Path) -> None:
    path = tmp_path / "edited.json"
    assert maestra("edit", told, "--add", "rising", "-o", path).code == 0
    odd, length = rules_in(told)
    assert rules_in(path) == (odd, length, Ordered("value"))
    ids = [one["id"] for one in json.loads(maestra("explain", path, "--json").out)["rules"]]
    both = ("--remove", ids[0], "--rule", ids[2], "falling")
    assert maestra("edit", path, *both, "-o", path, "--json").code == 0
    assert rules_in(path) == (length, Ordered("value", Direction.FALLING))


def test_the_same_rule_may_be_replaced_and_removed(told: Path, tmp_path: Path) -> None:
    path = tmp_path / "edited.json"
    name = json.loads(maestra("explain", told, "--json").out)["rules"][0]["id"]
    change = ("--remove", name, "--rule", name, "rising")
    assert maestra("edit", told, *change, "-o", path).code == 0
    assert rules_in(path) == (FullRow(), Ordered("value"))


def test_an_edit_that_no_row_can_keep_is_not_saved(told: Path, tmp_path: Path) -> None:
    path = tmp_path / "edited.json"
    ran = maestra("edit", told, "--add", "no odd numbers", "-o", path)
    assert (ran.code, path.exists()) == (1, False)


def test_an_unknown_rule_is_refused_with_those_there_are(told: Path, tmp_path: Path) -> None:
    ran = maestra("edit", told, "--remove", "nothing", "-o", tmp_path / "edited.json")
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert "nothing" in ran.err
    assert "one of" in ran.err


def test_rules_can_all_be_taken_away(told: Path, tmp_path: Path) -> None:
    path = tmp_path / "edited.json"
    for one in json.loads(maestra("explain", told, "--json").out)["rules"]:
        assert maestra("edit", told, "--remove", one["id"], "-o", told).code == 0
    ran = maestra("edit", told, "--remove", "nothing", "-o", path)
    assert "an exercise that has rules" in ran.err


def test_an_exercise_of_actions_is_refused(tmp_path: Path) -> None:
    exercise = learned(tmp_path, "ascending", "--learner", "grounded")
    ran = maestra("edit", exercise, "--add", "rising", "-o", tmp_path / "edited.json")
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert "grounded" in ran.err


@pytest.mark.parametrize(
    "arguments",
    [
        ("tell", "rising", "--deck", DECK, "--json", "-o", "-"),
        ("edit", "told.json", "-o", "out.json"),
        ("edit", "told.json", "--add", "rising", "--json", "-o", "-"),
    ],
)
def test_options_that_do_not_go_together_are_refused(arguments: tuple[str, ...]) -> None:
    ran = maestra(*arguments)
    assert (ran.code, ran.out) == (2, "")
