"""What a person reads about a bad file, whichever command it was given to: golden lines."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from maestra.core.json_lines import MAX_LINE_BYTES
from tests.cli.running import EXAMPLES, GROUNDED, learned, maestra
from tests.core.bad_lines import GOOD, LINE, WRONG_PLAY, WRONG_SHAPE, changed


@pytest.fixture(name="exercise", scope="module")
def an_exercise(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return learned(tmp_path_factory.mktemp("exercise"), "ascending")


@pytest.fixture(name="actions", scope="module")
def an_exercise_of_actions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return learned(tmp_path_factory.mktemp("actions"), "ascending", *GROUNDED)


@pytest.mark.parametrize(
    ("line", "fault"),
    [pytest.param(line, fault, id=name) for name, line, fault in (*WRONG_SHAPE, *WRONG_PLAY)],
)
def test_learn_names_file_line_field_and_what_was_expected(
    tmp_path: Path, line: bytes, fault: str
) -> None:
    path = tmp_path / "demos.jsonl"
    path.write_bytes(LINE + b"\n" + line + b"\n")
    ran = maestra("learn", path, "-o", tmp_path / "x.json")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == f"maestra: {path}, line 2: {fault}\n"
    assert not (tmp_path / "x.json").exists()


@pytest.mark.parametrize("command", ["judge", "moves"])
@pytest.mark.parametrize(
    ("line", "fault"),
    [pytest.param(line, fault, id=name) for name, line, fault in WRONG_SHAPE],
)
def test_judge_and_moves_refuse_the_same(
    exercise: Path, command: str, line: bytes, fault: str
) -> None:
    ran = maestra(command, exercise, "-", typed=line)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == f"maestra: standard input, line 1: {fault}\n"


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (b"", "line 1: an empty file, expected at least one demonstration, one a line"),
        (
            b"token;from;to\n",
            "line 1: not JSON (Expecting value at character 1), expected one JSON object a line",
        ),
        (
            bytes(range(128, 256)),
            "line 1: bytes that are not UTF-8 text (0x80 at byte 1), expected JSON Lines in UTF-8",
        ),
        (
            b"[" * (MAX_LINE_BYTES + 1),
            "line 1: a line longer than 4 MB, expected one JSON object a line",
        ),
        (
            changed((("format",), "maestra.demonstration/2")),
            (
                'line 1: format: "maestra.demonstration/2", which needs a newer Maestra, '
                'expected "maestra.demonstration/1" or older'
            ),
        ),
        (
            changed((("format",), "maestra.exercise/1")),
            'line 1: format: "maestra.exercise/1", expected "maestra.demonstration/1"',
        ),
        (
            LINE + b"\n" + changed((("board", "rows"), 5)),
            "line 2: board: 5 x 5 with goal row 1, expected 4 x 5 with goal row 1 as on line 1",
        ),
        (
            LINE + b"\n\n" + changed((("tokens", "04A3B2", "value"), 20)),
            "line 3: tokens.04A3B2: something else than before, expected the same everywhere",
        ),
    ],
)
def test_a_file_that_holds_no_demonstrations_is_refused(
    tmp_path: Path, content: bytes, line: str
) -> None:
    path = tmp_path / "demos.jsonl"
    path.write_bytes(content)
    ran = maestra("learn", path, "-o", tmp_path / "x.json")
    assert (ran.code, ran.out, ran.err) == (2, "", f"maestra: {path}, {line}\n")


def test_a_line_of_a_gigabyte_is_refused_before_it_is_read(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    read = 0

    def endless(_path: str, _advance: object = None) -> Iterator[bytes]:
        nonlocal read
        for _ in range(2**14):
            read += 2**16
            yield b" {" * 2**15

    monkeypatch.setattr("maestra.cli.shown_file.read_chunks", endless)
    ran = maestra("learn", "big.jsonl", "-o", tmp_path / "x.json")
    assert ran.err == (
        "maestra: big.jsonl, line 1: a line longer than 4 MB, expected one JSON object a line\n"
    )
    assert read < 2 * MAX_LINE_BYTES


@pytest.mark.parametrize(
    ("features", "fault"),
    [
        (
            "less-then",
            (
                "--features less-then: unknown feature, "
                "expected a known one, the nearest is less-than"
            ),
        ),
        (
            "vowel",
            "--features vowel: no attribute it applies to, expected a feature of value (number)",
        ),
    ],
)
def test_an_unknown_feature_is_refused_with_the_nearest(
    tmp_path: Path, features: str, fault: str
) -> None:
    shown = EXAMPLES / "ascending.jsonl"
    ran = maestra("learn", shown, "-o", tmp_path / "x.json", "--features", features)
    assert (ran.code, ran.out, ran.err) == (2, "", f"maestra: {fault}\n")


@pytest.mark.parametrize(
    ("path", "fault"),
    [
        ("gone.jsonl", "no such file or folder, expected one that exists"),
        (".", "a folder, expected a file"),
    ],
)
@pytest.mark.parametrize("command", ["learn", "judge", "explain", "features"])
def test_a_file_that_is_not_there_is_refused(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    exercise: Path,
    command: str,
    path: str,
    fault: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    arguments: dict[str, tuple[str | Path, ...]] = {
        "learn": (path, "-o", "x.json"),
        "judge": (exercise, path),
        "explain": (path,),
        "features": (path,),
    }
    ran = maestra(command, *arguments[command])
    assert (ran.code, ran.out, ran.err) == (2, "", f"maestra: {path}: {fault}\n")


def test_a_play_on_another_board_than_that_of_the_actions_is_refused(actions: Path) -> None:
    play = json.loads((EXAMPLES / "plays" / "ascending.jsonl").read_text().splitlines()[0])
    play |= {"board": {"rows": 5}, "moves": [], "times_ms": []}
    for command in ("judge", "moves"):
        ran = maestra(command, actions, "-", typed=json.dumps(play).encode())
        assert (ran.code, ran.out) == (2, "")
        assert ran.err == (
            "maestra: standard input, line 1: board: 5 x 5, goal row 1, "
            "expected the exercise's, 4 x 5, goal row 1\n"
        )


def test_a_token_that_no_action_moves_is_refused(actions: Path) -> None:
    ran = maestra("judge", actions, "-", typed=LINE)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(
        "maestra: standard input, line 1: tokens.04A3B3: unknown to this exercise, expected "
    )


def test_a_move_that_no_board_could_make_is_refused_at_its_line(exercise: Path) -> None:
    first = (EXAMPLES / "plays" / "ascending.jsonl").read_bytes().splitlines()[0]
    play = json.loads(first)
    play["moves"][1]["destination"] = play["moves"][0]["destination"]
    ran = maestra("judge", exercise, "-", typed=first + b"\n" + json.dumps(play).encode())
    assert ran.code == 2
    assert ran.out.count("\n") == 1
    token = play["moves"][0]["token"]
    assert ran.err == (
        "maestra: standard input, line 2: moves[1].destination: "
        f"[1, 1] is taken by {token}, expected an empty cell\n"
    )


def test_what_is_no_exercise_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_text(json.dumps(GOOD))
    ran = maestra("explain", path)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        f'maestra: {path}, line 1: format: "maestra.demonstration/1", '
        'expected "maestra.exercise/1"\n'
    )
