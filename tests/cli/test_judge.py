import json
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import EXAMPLES, GROUNDED, learned, maestra

PLAYS = EXAMPLES / "plays" / "ascending.jsonl"
POSITIONS = EXAMPLES / "positions" / "ascending.jsonl"
RIGHT: dict[str, object] = {
    "verdict": "allowed",
    "certainty": "certain",
    "broken": [],
    "reason": "",
}


@pytest.fixture(name="exercise", scope="module")
def an_exercise(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return learned(tmp_path_factory.mktemp("exercise"), "ascending")


@pytest.fixture(name="actions", scope="module")
def an_exercise_of_actions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return learned(tmp_path_factory.mktemp("actions"), "ascending", *GROUNDED)


def plays(path: Path = PLAYS) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def played(*lines: object) -> bytes:
    return b"".join(json.dumps(line).encode() + b"\n" for line in lines)


def answers(out: str) -> list[dict[str, Any]]:
    return [json.loads(line) for line in out.splitlines()]


@pytest.mark.parametrize("options", [(), ("--json",)])
def test_a_right_play_is_allowed_and_complete(exercise: Path, options: tuple[str, ...]) -> None:
    ran = maestra("judge", exercise, "-", *options, typed=played(plays()[0]))
    assert (ran.code, ran.err) == (0, "")
    assert answers(ran.out) == [{"moves": [RIGHT] * 5, "complete": True}]


@pytest.mark.parametrize(
    ("made_of", "certainty"), [("exercise", "certain"), ("actions", "probable")]
)
def test_a_refused_move_says_why_and_the_next_is_judged_without_it(
    request: pytest.FixtureRequest, made_of: str, certainty: str
) -> None:
    exercise = request.getfixturevalue(made_of)
    ran = maestra("judge", exercise, "-", typed=played(plays()[1]))
    assert (ran.code, ran.err) == (1, "")
    wrong = {
        "verdict": "refused",
        "certainty": certainty,
        "broken": ["increasing-value"],
        "reason": "32 is not larger than 34 on its left.",
    }
    assert answers(ran.out) == [
        {"moves": [RIGHT, RIGHT, wrong, RIGHT, RIGHT, RIGHT], "complete": True}
    ]


def test_reasons_are_given_in_each_language(exercise: Path) -> None:
    reasons: set[str] = set()
    for language in ("en", "es", "ca"):
        ran = maestra("judge", exercise, "-", "--lang", language, typed=played(plays()[1]))
        (answer,) = answers(ran.out)
        reasons |= {move["reason"] for move in answer["moves"] if move["reason"]}
    assert len(reasons) == 3


def test_one_line_is_printed_for_each_play(exercise: Path) -> None:
    ran = maestra("judge", exercise, PLAYS)
    assert (ran.code, ran.err) == (1, "")
    assert [answer["complete"] for answer in answers(ran.out)] == [True] * 4 + [False]


def test_a_move_after_the_end_is_refused_for_certain(exercise: Path) -> None:
    play = plays()[0]
    token = next(token for token in play["tokens"] if play["start"][token][0] == 4)
    moved = {move["token"] for move in play["moves"]}
    token = next(token for token in play["tokens"] if token not in moved)
    taken = [*play["start"].values()]
    empty = next([4, column] for column in range(1, 6) if [4, column] not in taken)
    play["moves"].append({"token": token, "origin": play["start"][token], "destination": empty})
    play.pop("times_ms", None)
    (answer,) = answers(maestra("judge", exercise, "-", typed=played(play)).out)
    assert answer["moves"][-1]["verdict"] == "refused"
    assert answer["moves"][-1]["certainty"] == "certain"
    assert answer["complete"]


def test_moving_a_refused_token_back_is_no_move_of_the_play(exercise: Path) -> None:
    play = plays()[1]
    wrong = play["moves"][2]
    back = {**wrong, "origin": wrong["destination"], "destination": wrong["origin"]}
    play["moves"].insert(3, back)
    play.pop("times_ms", None)
    ran = maestra("judge", exercise, "-", typed=played(play))
    (answer,) = answers(ran.out)
    assert answer["moves"][3] == RIGHT
    assert [move["verdict"] for move in answer["moves"]].count("refused") == 1
    assert answer["complete"]


@pytest.mark.parametrize(
    ("made_of", "numbers"),
    # The rules leave the order of filling open, the actions fill from left to right.
    [("exercise", [30, 12, 2, 0]), ("actions", [6, 4, 2, 0])],
)
def test_the_right_moves_of_a_position_are_listed(
    request: pytest.FixtureRequest, made_of: str, numbers: list[int]
) -> None:
    exercise = request.getfixturevalue(made_of)
    ran = maestra("moves", exercise, POSITIONS)
    assert (ran.code, ran.err) == (0, "")
    found = answers(ran.out)
    assert [sorted(answer) for answer in found] == [["allowed", "complete"]] * 4
    assert [len(answer["allowed"]) for answer in found] == numbers
    assert [answer["complete"] for answer in found] == [False, False, False, True]
    assert found[0]["allowed"][0].keys() == {"token", "origin", "destination"}


def test_each_listed_move_is_judged_right_and_no_other(exercise: Path) -> None:
    position = plays(POSITIONS)[1]
    position.pop("times_ms", None)
    (answer,) = answers(maestra("moves", exercise, "-", typed=played(position)).out)
    allowed = {(move["token"], tuple(move["destination"])) for move in answer["allowed"]}
    lying = dict(position["start"])
    lying |= {move["token"]: move["destination"] for move in position["moves"]}
    for token, cell in lying.items():
        for column in range(3, 6):
            move = {"token": token, "origin": cell, "destination": [1, column]}
            longer = position | {"moves": [*position["moves"], move]}
            ran = maestra("judge", exercise, "-", typed=played(longer))
            assert (ran.code == 0) == ((token, (1, column)) in allowed), move


def test_a_position_with_a_refused_move_is_taken_as_if_it_were_put_back(exercise: Path) -> None:
    play = plays()[1]
    play["moves"] = play["moves"][:3]
    play.pop("times_ms", None)
    ran = maestra("moves", exercise, "-", typed=played(play))
    assert (ran.code, ran.err) == (1, "")
    (answer,) = answers(ran.out)
    assert answer["refused"] == [3]
    clean = play | {"moves": play["moves"][:2]}
    (expected,) = answers(maestra("moves", exercise, "-", typed=played(clean)).out)
    assert answer["allowed"] == expected["allowed"]


def test_plays_with_different_tokens_are_judged_in_one_file(exercise: Path) -> None:
    play = plays()[0]
    renamed = json.loads(json.dumps(play).replace('"04', '"05'))
    ran = maestra("judge", exercise, "-", typed=played(play, renamed, play))
    assert (ran.code, ran.err) == (0, "")
    assert answers(ran.out) == [{"moves": [RIGHT] * 5, "complete": True}] * 3
