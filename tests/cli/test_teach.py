"""`maestra teach`, typed by a person and answered by a program."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from maestra.core.formats import decode_demonstration, encode_demonstration
from maestra.learning import dialogue
from maestra.learning.dialogue import MAX_QUESTIONS
from maestra.learning.fewshot.lesson import Lesson
from maestra.rules.answers import MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.exercise_format import decode_exercise, encode_exercise
from maestra.rules.forms.length import FullRow
from maestra.rules.setting import play_of
from tests.cli.running import EXAMPLES, Ran, learned, maestra
from tests.learning.caregivers import small
from tests.learning.scripts import (
    AMBIGUOUS,
    LEARNED,
    OUTSIDE,
    RISING,
    Install,
    Scene,
    scripted,
    slip,
)
from tests.learning.test_exam import told

GOLDEN = Path(__file__).parent / "golden"
SCENES: dict[str, tuple[list[str], list[Scene], str]] = {
    "asked": (["abc", "cde"], [AMBIGUOUS, AMBIGUOUS, AMBIGUOUS, LEARNED], "y\nperhaps\nn\n9\n1\n"),
    "contradicted": (["abe", "cde"], [AMBIGUOUS, AMBIGUOUS, LEARNED], "n\n3\n1\nu\n"),
    "mistaken": (
        ["abc", "cba", "bac"],
        [(LearnStatus.LEARNED, (slip(1),)), (LearnStatus.LEARNED, (slip(1),)), LEARNED],
        "again\n\n9 4\n1 2 5\nn\n",
    ),
    "unsettled": (["abe"], [AMBIGUOUS], "n\nenough\n"),
    "outside": (["abe"], [OUTSIDE], ""),
    "nothing": (["cba"], [(LearnStatus.LEARNED, (slip(0),))], "no\n"),
}


@pytest.fixture(name="script")
def a_script(monkeypatch: pytest.MonkeyPatch) -> Install:
    return lambda *scenes: scripted(monkeypatch, *scenes)


def demonstrations(folder: Path, rows: Sequence[str]) -> Path:
    path = folder / "demos.jsonl"
    shown = [encode_demonstration(small(tokens, turn)) for turn, tokens in enumerate(rows)]
    path.write_text("".join(f"{line}\n" for line in shown))
    return path


def exercise_in(path: Path) -> RuledExercise:
    exercise = decode_exercise(path.read_bytes(), "-")
    assert isinstance(exercise, RuledExercise)
    return exercise


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("language", ["en", "es", "ca"])
def test_a_person_reads_what_was_read_and_approved(
    name: str, language: str, script: Install, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows, scenes, typed = SCENES[name]
    script(*scenes)
    monkeypatch.chdir(tmp_path)
    demonstrations(tmp_path, rows)
    ran = maestra(
        *("teach", "demos.jsonl", "-o", "x.json", "--lang", language), typed=typed.encode()
    )
    transcript = f"{ran.out}exit {ran.code}\n"
    golden = GOLDEN / f"teach-{name}.{language}.txt"
    assert ran.err == ""
    assert transcript == golden.read_text(encoding="utf-8")


def test_what_was_taught_is_kept_with_what_it_rests_on(script: Install, tmp_path: Path) -> None:
    script(AMBIGUOUS, AMBIGUOUS, LEARNED)
    path = demonstrations(tmp_path, ["abc"])
    ran = maestra("teach", path, "-o", tmp_path / "x.json", typed=b"y\nn\n")
    assert ran.code == 0, ran
    exercise = exercise_in(tmp_path / "x.json")
    assert exercise.status is LearnStatus.LEARNED
    assert exercise.evidence.demonstrations == (small("abc"),)
    assert [answer.reply for answer in exercise.evidence.answers] == [Reply.YES, Reply.NO]


def test_nothing_is_written_where_nothing_is_left(script: Install, tmp_path: Path) -> None:
    script((LearnStatus.LEARNED, (slip(0),)))
    path = demonstrations(tmp_path, ["cba"])
    ran = maestra("teach", path, "-o", tmp_path / "x.json", typed=b"no\n")
    assert ran.code == 1
    assert not (tmp_path / "x.json").exists()


def test_teaching_goes_on_from_where_it_stopped(script: Install, tmp_path: Path) -> None:
    script(AMBIGUOUS)
    first, second = tmp_path / "1.json", tmp_path / "2.json"
    assert maestra("teach", demonstrations(tmp_path, ["abc"]), "-o", first, typed=b"y\n").code == 1
    learner = script(LEARNED)
    more = tmp_path / "more.jsonl"
    more.write_text(encode_demonstration(small("bcd", 3)))
    ran = maestra("teach", more, "--continue", first, "-o", second)
    assert ran.code == 0
    assert learner.shown == [("abc", "bcd")]
    evidence = exercise_in(second).evidence
    assert len(evidence.demonstrations) == 2
    assert len(evidence.answers) == 1
    assert maestra("teach", "--continue", second, "-o", second).code == 0
    assert exercise_in(second).evidence == evidence


def test_rules_that_were_told_count_as_answers(script: Install, tmp_path: Path) -> None:
    script(LEARNED)
    old = tmp_path / "told.json"
    old.write_text(encode_exercise(told(FullRow(), RISING)))
    path = demonstrations(tmp_path, ["abc"])
    assert maestra("teach", path, "--continue", old, "-o", tmp_path / "x.json").code == 0
    answers = exercise_in(tmp_path / "x.json").evidence.answers
    assert [answer.reply for answer in answers] == [Reply.YES, Reply.YES]


Answering = Callable[[dict[str, Any]], dict[str, Any]]


class Client:
    """A program that answers; it knows no more than docs/how-to/answer-from-a-program.md says."""

    def __init__(self, answering: Answering) -> None:
        """Answer each line with `answering`."""
        self.answering = answering
        self.lines: list[dict[str, Any]] = []

    def talk(self, *arguments: str | Path) -> int:
        """Run `maestra` with `arguments` to its end; its exit code."""
        with subprocess.Popen(
            [sys.executable, "-m", "maestra", *map(str, arguments), "--protocol", "jsonl"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        ) as process:
            assert process.stdin is not None
            assert process.stdout is not None
            for line in process.stdout:
                self.lines.append(json.loads(line))
                if "id" in self.lines[-1]:
                    answer = {"id": self.lines[-1]["id"], **self.answering(self.lines[-1])}
                    process.stdin.write(f"{json.dumps(answer)}\n")
                    process.stdin.flush()
        return process.returncode


def ascending(question: dict[str, Any]) -> dict[str, Any]:
    """What somebody answers who means "each number larger than the one on its left"."""
    if question["kind"] == "rule":
        meant = question["rule"]["form"] in {"ordered", "full-row"}
        return {"answer": "yes" if meant else "no"}
    position = json.loads(json.dumps(question["position"]))
    if question["kind"] == "move":
        position["moves"].append(question["move"])
    by_column = {move["destination"][1]: move["token"] for move in position["moves"]}
    values = [position["tokens"][by_column[column]]["value"] for column in sorted(by_column)]
    return {"answer": "yes" if values == sorted(values) else "no"}


@pytest.mark.parametrize("kinds", ["move,row,rule", "row", "move,row"])
def test_a_program_answers_line_by_line(kinds: str, tmp_path: Path) -> None:
    path = tmp_path / "demos.jsonl"
    lines = (EXAMPLES / "ascending.jsonl").read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(lines[:2]))
    client = Client(ascending)
    code = client.talk("teach", path, "-o", tmp_path / "x.json", "--kinds", kinds)
    *questions, last = client.lines
    assert [line["type"] for line in questions] == ["question"] * len(questions)
    assert [line["id"] for line in questions] == list(range(1, len(questions) + 1))
    assert {line["kind"] for line in questions} <= set(kinds.split(","))
    assert len(questions) <= 3
    for question in questions:
        assert question["text"]
        if question["kind"] != "rule":
            decode_demonstration(json.dumps(question["position"]).encode())
    assert last["type"] == "learned"
    assert last["status"] == exercise_in(tmp_path / "x.json").status.value
    assert code == (0 if last["status"] == "learned" else 1)
    assert {"rules", "alternatives", "slips", "seconds"} <= set(last)
    for rule in last["rules"]:
        assert set(rule) == {"id", "text", "confidence"}


def lines_of(ran: Ran) -> list[dict[str, Any]]:
    return [json.loads(line) for line in ran.out.splitlines()]


def teach(folder: Path, rows: Sequence[str], answers: Sequence[object], *more: str) -> Ran:
    typed = "".join(f"{json.dumps(answer)}\n" for answer in answers).encode()
    path = demonstrations(folder, rows)
    arguments: tuple[str | Path, ...] = ("teach", path, "-o", folder / "x.json", *LINES, *more)
    return maestra(*arguments, typed=typed)


FULL = ("--dialogue", "full")
LINES = ("--protocol", "jsonl")


def test_a_program_that_knows_only_questions_is_asked_again(
    script: Install, tmp_path: Path
) -> None:
    script(AMBIGUOUS, AMBIGUOUS, AMBIGUOUS, LEARNED)
    answers = [{"id": 1, "answer": "no"}, {"id": 2, "answer": "yes"}, {"id": 3, "answer": "no"}]
    ran = teach(tmp_path, ["abe"], answers)
    first, again, third, last = lines_of(ran)
    assert (first["type"], again["type"], last["type"]) == ("question", "question", "learned")
    assert again["position"] == first["position"]
    assert again["contradiction"] == {
        "earlier": {
            "demonstration": 1,
            "text": "In the first demonstration you made this row: 1, 2, 9.",
        },
        "later": {"answer": 1, "text": "You said that this row is wrong: 1, 2, 9."},
    }
    assert "contradiction" not in third
    assert ran.code == 0


def test_a_program_that_knows_more_is_shown_two_moments(script: Install, tmp_path: Path) -> None:
    script(AMBIGUOUS, AMBIGUOUS, LEARNED)
    answers = [{"id": 1, "answer": "no"}, {"id": 2, "answer": "earlier"}]
    ran = teach(tmp_path, ["abe"], answers, *FULL)
    _, contradiction, last = lines_of(ran)
    assert contradiction["type"] == "contradiction"
    assert contradiction["earlier"]["demonstration"] == 1
    assert contradiction["later"] == {
        "answer": 1,
        "text": "You said that this row is wrong: 1, 2, 9.",
    }
    assert (last["status"], last["questions"], last["contradictions"]) == ("learned", 1, [])


def test_a_contradiction_with_an_answer_from_another_day_names_it(
    script: Install, tmp_path: Path
) -> None:
    script(OUTSIDE)
    old = tmp_path / "told.json"
    old.write_text(encode_exercise(told(FullRow(), RISING)))
    answers = [
        {"id": 1, "answer": "yes"},
        {"id": 2, "answer": "yes"},
        {"id": 3, "answer": "later"},
    ]
    ran = teach(tmp_path, ["abc"], answers, *FULL, "--continue", str(old))
    contradiction = lines_of(ran)[2]
    assert contradiction["earlier"] == {
        "answer": 2,
        "text": "You said that this is meant: Each token must be larger than the one on its left.",
    }
    assert contradiction["later"]["answer"] == 4
    kept = [a.reply for a in exercise_in(tmp_path / "x.json").evidence.answers]
    assert kept == [Reply.YES, Reply.UNSURE, Reply.YES, Reply.YES]


MOVE = MoveQuestion(play_of(small("a")), 1, 1)


@pytest.fixture(name="moves_and_rules")
def a_learner_that_asks_about_moves_and_rules(monkeypatch: pytest.MonkeyPatch) -> None:
    scripted(monkeypatch, OUTSIDE)
    asked: Iterator[Question] = iter((MOVE, RuleQuestion(RISING)))

    def in_turn(lesson: Lesson, kinds: object) -> Question:
        assert lesson.rules
        assert kinds
        return next(asked)

    monkeypatch.setattr(dialogue, "next_question", in_turn)


@pytest.mark.usefixtures("moves_and_rules")
def test_a_program_is_asked_about_moves_and_rules(tmp_path: Path) -> None:
    answers = [{"id": 1, "answer": "yes"}, {"id": 2, "answer": "yes"}]
    move, rule, _ = lines_of(teach(tmp_path, ["abc"], answers, "--questions", "2"))
    assert move["kind"] == "move"
    assert move["move"]["token"] == "b"
    assert move["move"]["destination"] == [1, 2]
    assert [one["token"] for one in move["position"]["moves"]] == ["a"]
    assert move["text"] == "Is it right to put 2 in column 2 after 1?"
    assert (rule["kind"], rule["rule"]["form"]) == ("rule", "ordered")
    assert "position" not in rule


@pytest.mark.usefixtures("moves_and_rules")
def test_a_person_is_asked_about_moves_and_rules(tmp_path: Path) -> None:
    path = demonstrations(tmp_path, ["abc"])
    arguments = ("--questions", "2")
    ran = maestra("teach", path, "-o", tmp_path / "x.json", *arguments, typed=b"Y\nu\n")
    assert ran.out.count("goal") == 1
    assert "Is it right to put 2 in column 2 after 1?" in ran.out
    assert "Do you mean this? Each token must be larger than the one on its left." in ran.out


TYPED = [
    (b"n\nneither\n", AMBIGUOUS, ["abe", "cde"], (Reply.UNSURE,)),
    (b"n\n2\n", AMBIGUOUS, ["abe", "cde"], (Reply.NO,)),
    (b"no\nu\n", OUTSIDE, ["abc"], (Reply.NO,)),
    (b"y\n", (LearnStatus.LEARNED, (slip(0),)), ["abc"], (Reply.YES,)),
    (b"again\n", (LearnStatus.LEARNED, (slip(0),)), ["cba"], ()),
    (b"again\n1 2 3 5\n1, 2, 5\n", (LearnStatus.LEARNED, (slip(0),)), ["cba"], ()),
    (b"", AMBIGUOUS, ["abc"], ()),
]


@pytest.mark.parametrize(("typed", "scene", "rows", "replies"), TYPED)
def test_what_is_typed_is_understood(
    script: Install,
    tmp_path: Path,
    typed: bytes,
    scene: Scene,
    rows: list[str],
    replies: tuple[Reply, ...],
) -> None:
    script(scene)
    path = demonstrations(tmp_path, rows)
    maestra("teach", path, "-o", tmp_path / "x.json", typed=typed)
    evidence = exercise_in(tmp_path / "x.json").evidence
    assert tuple(answer.reply for answer in evidence.answers) == replies
    # What does not count any more is not kept.
    assert len(evidence.demonstrations) == 1


def test_a_contradiction_with_the_rules_names_them(script: Install, tmp_path: Path) -> None:
    script(AMBIGUOUS)
    answers = [{"id": 1, "answer": "no"}, {"id": 2, "answer": "later"}]
    ran = teach(tmp_path, ["cde"], [*answers, {"id": 3, "answer": "enough"}], *FULL)
    assert lines_of(ran)[1]["earlier"] == {
        "text": "From all the rest I understood: Fill the whole of the top row. "
        "Each token must be larger than the one on its left."
    }
    assert lines_of(ran)[-1]["status"] == "contradictory"
    assert len(lines_of(ran)[-1]["contradictions"]) == 1


def test_a_program_points_at_the_wrong_cell(script: Install, tmp_path: Path) -> None:
    script(AMBIGUOUS)
    answers = [
        {"id": 1, "answer": "yes"},
        {"id": 2, "answer": "no"},
        {"id": 3, "column": 2},
        {"id": 4, "answer": "enough"},
    ]
    ran = teach(tmp_path, ["abc"], answers, *FULL)
    which = lines_of(ran)[2]
    assert (which["type"], which["text"]) == ("which", "Which token is wrong in this row?")
    wrong = exercise_in(tmp_path / "x.json").evidence.answers[1]
    assert isinstance(wrong.question, RowQuestion)
    assert wrong.wrong == 1
    unsure = [*answers[:2], {"id": 3, "answer": "unsure"}]
    assert teach(tmp_path, ["abc"], unsure, *FULL).code == 1
    assert exercise_in(tmp_path / "x.json").evidence.answers[1].wrong is None


@pytest.mark.parametrize(
    ("answer", "left"),
    [
        ({"answer": "yes"}, ("abc", "cba")),
        ({"answer": "no"}, ("abc",)),
        ({"answer": "again"}, ("abc", "abd")),
        ({"answer": "enough"}, ("abc", "cba")),
    ],
)
def test_a_program_is_asked_about_a_likely_mistake(
    script: Install, tmp_path: Path, answer: dict[str, Any], left: tuple[str, ...]
) -> None:
    script((LearnStatus.LEARNED, (slip(1, 2),)), LEARNED)
    if answer["answer"] == "again":
        answer = {**answer, "demonstration": json.loads(encode_demonstration(small("abd")))}
    ran = teach(tmp_path, ["abc", "cba"], [{"id": 1, **answer}], *FULL)
    mistake = lines_of(ran)[0]
    assert (mistake["type"], mistake["demonstration"], mistake["move"]) == ("slip", 2, 3)
    assert mistake["text"] == "In the second demonstration, was 2 meant to come before 1?"
    shown = exercise_in(tmp_path / "x.json").evidence.demonstrations
    assert tuple("".join(move.token for move in one.moves) for one in shown) == left


def test_what_else_may_be_wrong_is_in_the_last_line(script: Install, tmp_path: Path) -> None:
    script((LearnStatus.LEARNED, (slip(1, 2),)))
    last = lines_of(teach(tmp_path, ["abc", "cba"], []))[-1]
    text = "In the second demonstration, was 2 meant to come before 1?"
    assert last["slips"] == [{"demonstration": 2, "move": 3, "text": text}]
    (other,) = last["alternatives"]
    assert other["text"].endswith("Each token must not be smaller than the one on its left.")
    assert other["weight"] == pytest.approx(0.02)


WRONG = {
    "not JSON": (b"yes\n", "not JSON (Expecting value at character 1), expected one JSON object"),
    "no object": (b"3\n", "3, expected a JSON object"),
    "no id": (b'{"answer": "yes"}\n', "id: missing, expected a field of this name"),
    "another id": (b'{"id": 2, "answer": "yes"}\n', "id: 2, expected 1, the id of the question"),
    "no answer": (b'{"id": 1}\n', "answer: missing, expected one of yes, no, unsure, enough"),
    "another word": (
        b'{"id": 1, "answer": "maybe"}\n',
        'answer: "maybe", expected one of yes, no, unsure, enough',
    ),
    "a number": (b'{"id": 1, "answer": 1}\n', "answer: 1, expected a word"),
    "another field": (
        b'{"id": 1, "reply": "yes"}\n',
        "reply: unknown field, expected one of answer, column, demonstration, id",
    ),
    "a column": (b'{"id": 1, "column": 1}\n', "column: 1, expected no column beside an answer"),
    "a demonstration": (
        b'{"id": 1, "answer": "yes", "demonstration": {}}\n',
        'demonstration: a demonstration, expected one just with the answer "again"',
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_line_that_is_no_answer_is_refused_and_nothing_is_written(
    name: str, script: Install, tmp_path: Path
) -> None:
    script(AMBIGUOUS)
    line, fault = WRONG[name]
    path = demonstrations(tmp_path, ["abc"])
    arguments = ("teach", path, "-o", tmp_path / "x.json", "--protocol", "jsonl")
    ran = maestra(*arguments, typed=line)
    assert ran.code == 2
    assert ran.err.startswith(f"maestra: standard input, line 1: {fault}")
    assert ran.err.count("\n") == 1
    assert not (tmp_path / "x.json").exists()


@pytest.mark.parametrize(
    ("answer", "fault"),
    [
        ({"column": 4}, "column: 4, expected 1 to 3"),
        ({"column": 1, "answer": "no"}, "column: 1, expected no column beside an answer"),
    ],
)
def test_a_cell_that_is_not_there_is_refused(
    script: Install, tmp_path: Path, answer: dict[str, Any], fault: str
) -> None:
    script(OUTSIDE, OUTSIDE, AMBIGUOUS)
    answers = [{"id": 1, "answer": "no"}, {"id": 2, **answer}]
    ran = teach(tmp_path, ["abc"], answers, *FULL)
    assert (ran.code, ran.err) == (2, f"maestra: standard input, line 2: {fault}\n")


@pytest.mark.parametrize(
    ("shown", "fault"),
    [
        (None, 'demonstration: missing, expected one just with the answer "again"'),
        ({"format": "x"}, 'demonstration.format: "x", expected "maestra.demonstration/1"'),
        (
            "another board",
            (
                "demonstration: another board or other tokens, expected the board and the tokens "
                "of the one it stands for"
            ),
        ),
    ],
)
def test_a_demonstration_that_is_none_is_refused(
    script: Install, tmp_path: Path, shown: object, fault: str
) -> None:
    script((LearnStatus.LEARNED, (slip(0),)))
    answer: dict[str, object] = {"id": 1, "answer": "again"}
    if shown == "another board":
        line = (EXAMPLES / "curie.jsonl").read_bytes().splitlines()[0]
        answer["demonstration"] = json.loads(line)
    elif shown is not None:
        answer["demonstration"] = shown
    ran = teach(tmp_path, ["abc"], [answer], *FULL)
    assert (ran.code, ran.err) == (2, f"maestra: standard input, line 1: {fault}\n")


@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        (["-o", "x.json"], "DEMOS.jsonl or --continue is needed"),
        (["-", "-o", "x.json"], "answers come from standard input, so no file can"),
        (["d", "-o", "-"], "questions go to standard output, so the exercise cannot"),
        (["d", "-o", "x", "--dialogue", "full"], "--dialogue needs --protocol jsonl"),
        (["d", "-o", "x", "--kinds", "rows"], "--kinds rows: expected some of move, row, rule"),
        (["d", "-o", "x", "--questions", "6"], "Input should be less than or equal to 5"),
    ],
)
def test_options_that_make_no_sense_are_refused(arguments: list[str], fault: str) -> None:
    ran = maestra("teach", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert fault in ran.err
    assert MAX_QUESTIONS == 5


def test_an_exercise_made_of_actions_cannot_be_taught_further(tmp_path: Path) -> None:
    old = learned(tmp_path, "curie", "--learner", "grounded")
    ran = maestra("teach", "--continue", old, "-o", tmp_path / "x.json")
    expected = (
        f'maestra: {old}, line 1: kind: "grounded", expected "ruled": an exercise that '
        "`teach`, `tell` or `learn --learner fewshot` wrote\n"
    )
    assert (ran.code, ran.err) == (2, expected)


def test_demonstrations_on_another_board_cannot_follow(script: Install, tmp_path: Path) -> None:
    script(LEARNED)
    old = tmp_path / "old.json"
    assert maestra("teach", demonstrations(tmp_path, ["abc"]), "-o", old).code == 0
    more = EXAMPLES / "ascending.jsonl"
    ran = maestra("teach", more, "--continue", old, "-o", tmp_path / "x.json")
    assert ran.code == 2
    assert ran.err == (
        f"maestra: {more}, line 1: board: another board, expected the board of the exercise to "
        "go on with\n"
    )


def test_more_demonstrations_than_anybody_shows_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "many.jsonl"
    path.write_text(f"{encode_demonstration(small('abc'))}\n" * 201)
    ran = maestra("teach", path, "-o", tmp_path / "x.json")
    fault = "201 demonstrations, expected at most 200 in all"
    assert (ran.code, ran.err) == (2, f"maestra: {path}, line 1: {fault}\n")


@pytest.mark.parametrize("command", [["teach"], ["learn", "--learner", "fewshot"]])
def test_a_move_that_no_rule_speaks_of_is_named(command: list[str], tmp_path: Path) -> None:
    shown = json.loads(encode_demonstration(small("abc")))
    shown["moves"][1]["destination"] = [3, 3]
    shown["start"]["b"], shown["start"]["c"] = [2, 2], [2, 3]
    shown["moves"][1]["origin"], shown["moves"][2]["origin"] = [2, 2], [2, 3]
    shown["start"]["a"], shown["moves"][0]["origin"] = [2, 1], [2, 1]
    shown["start"]["d"], shown["start"]["e"] = [3, 1], [3, 2]
    path = tmp_path / "demos.jsonl"
    path.write_text(json.dumps(shown))
    ran = maestra(*command, path, "-o", tmp_path / "x.json")
    assert ran.code == 2
    assert ran.err == (
        f"maestra: {path}, line 1: moves[1]: a move from row 2 to row 3, expected one from a "
        "storage row to the goal row, 1\n"
    )


def test_learn_by_few_asks_nothing(script: Install, tmp_path: Path) -> None:
    script(LEARNED)
    path, out = demonstrations(tmp_path, ["abc"]), tmp_path / "x.json"
    ran = maestra("learn", path, "--learner", "fewshot", "-o", out, "--json")
    (last,) = lines_of(ran)
    assert (ran.code, last["status"], last["demonstrations"]) == (0, "learned", 1)
    assert [rule["id"] for rule in last["rules"]] == ["full-row", "increasing-value"]
    assert exercise_in(out).conjunction == (FullRow(), RISING)


def test_learn_by_few_says_what_else_it_may_be(script: Install, tmp_path: Path) -> None:
    script(AMBIGUOUS)
    path = demonstrations(tmp_path, ["abc"])
    ran = maestra("learn", path, "--learner", "fewshot", "-o", tmp_path / "x.json")
    assert (ran.code, ran.out.splitlines()) == (
        1,
        [
            "Fill the whole of the top row. Each token must be larger than the one on its left.",
            "",
            "I am not sure: 60 %. It could also be:",
            (
                "- Fill the whole of the top row. Each token must not be smaller than the one "
                "on its left."
            ),
            f"Saved in {tmp_path / 'x.json'}.",
        ],
    )
    ran = maestra("learn", path, "--learner", "fewshot", "-o", "-")
    assert json.loads(ran.out)["kind"] == "ruled"
    assert ran.err.startswith("Fill the whole of the top row.")
