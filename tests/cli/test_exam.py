"""`maestra exam`, judged by a person and by a program."""

from __future__ import annotations

import datetime as dt
import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from maestra.coaching import examining
from maestra.core.demonstration import Demonstration
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Lesson
from maestra.learning.taught import taught_exercise
from maestra.rules.answers import Answer, Reply
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.selection import EveryToken
from maestra.rules.rule import Rule
from maestra.rules.token_tests import has
from tests.cli.running import Ran, learned, maestra
from tests.cli.test_teach import exercise_in
from tests.learning.caregivers import small
from tests.learning.scripts import RISING, Scripted
from tests.learning.test_exam import told

BLUE = EveryToken(has("is-blue", "colour"))


def written(folder: Path, exercise: RuledExercise) -> Path:
    path = folder / "exercise.json"
    path.write_text(encode_exercise(exercise))
    return path


def taught(folder: Path) -> Path:
    return written(
        folder, taught_exercise(Scripted((LearnStatus.LEARNED, ())).learn([small("abe")]))
    )


def ascending(line: dict[str, Any]) -> str:
    """What somebody says who means ascending rows."""
    moves = sorted(line["position"]["moves"], key=lambda move: move["destination"])
    values = [line["position"]["tokens"][move["token"]]["value"] for move in moves]
    return "yes" if values == sorted(values) else "no"


def examined(
    path: Path, answer: Callable[[dict[str, Any]], str], *more: str
) -> tuple[Ran, list[dict[str, Any]]]:
    """An exam answered line by line; its questions do not depend on the answers."""
    arguments: tuple[str | Path, ...] = ("exam", path, "--protocol", "jsonl", *more)
    # Without answers every question but the first stays unasked: so all are asked for first.
    asked: list[dict[str, Any]] = []
    typed = b""
    while True:
        ran = maestra(*arguments, "-o", path.with_suffix(".out"), typed=typed)
        lines = [json.loads(line) for line in ran.out.splitlines()]
        if len(lines) - 1 == len(asked):
            return ran, lines
        asked = lines[:-1]
        last = asked[-1]
        typed += json.dumps({"id": last["id"], "answer": answer(last)}).encode() + b"\n"


def test_ten_of_ten_is_said_in_plain_words(tmp_path: Path) -> None:
    path = written(tmp_path, told(FullRow(), RISING))
    ran, lines = examined(path, ascending, "--plays", "4")
    last = lines[-1]
    assert (ran.code, last["type"]) == (0, "examined")
    assert (last["plays"], last["agreed"]) == (4, 4)
    assert (last["near_misses"], last["near_misses_agreed"]) == (4, 4)
    assert last["most_wrong"] == pytest.approx(1 - 0.05 ** (1 / 4), abs=1e-4)
    assert last["text"] == (
        "You agreed with 4 of 4 plays. With 95 % confidence fewer than 53 % of my plays would be "
        "wrong. Of 4 rows that I hold for wrong you called 4 wrong too."
    )
    assert [line["kind"] for line in lines[:-1]] == ["row"] * 8


def test_the_exam_is_saved_with_the_exercise(tmp_path: Path) -> None:
    path = taught(tmp_path)
    typed = b"".join(b"unsure\n" for _ in range(3)) + b"enough\n"
    before = exercise_in(path)
    ran = maestra("exam", path, "--plays", "3", typed=typed)
    assert ran.code == 0, ran
    after = exercise_in(path)
    (exam,) = after.evidence.exams
    assert (exam.plays, exam.near_misses) == (0, 0)
    assert exam.date == dt.datetime.now(dt.UTC).date().isoformat()
    assert after.rules == before.rules
    assert "You judged none of my plays" in ran.out


def test_what_is_judged_otherwise_goes_back_to_learning(tmp_path: Path) -> None:
    path = written(tmp_path, taught_exercise(learn([small("ace")])))
    _, lines = examined(path, lambda _: "no", "--plays", "2")
    last = lines[-1]
    assert last["learned_again"]
    exercise = exercise_in(path.with_suffix(".out"))
    evidence = exercise.evidence
    assert len(evidence.answers) == last["plays"]
    assert {answer.reply for answer in evidence.answers} == {Reply.NO}
    assert len(evidence.exams) == 1
    old = {one.id for one in exercise_in(path).rules}
    new = {one.id for one in exercise.rules}
    assert {one["id"] for one in last["added"]} == new - old
    assert {one["id"] for one in last["dropped"]} == old - new


def to(rules: tuple[Rule, ...]) -> Callable[..., object]:
    def learn_these(shown: Sequence[Demonstration], answers: Sequence[Answer]) -> Lesson:
        lesson = Scripted((LearnStatus.AMBIGUOUS, ())).learn(shown, answers)
        return replace(lesson, rules=rules, confidences=(1.0,) * len(rules))

    return learn_these


def test_a_person_reads_what_changed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(examining, "learn", to((FullRow(), BLUE)))
    ran = maestra("exam", taught(tmp_path), "--plays", "1", typed=b"what?\n\nn\nn\n")
    assert ran.code == 1
    said = ran.out[ran.out.index("You agreed") :]
    assert said == (
        "You agreed with 0 of 1 plays.\n"
        "Of 1 rows that I hold for wrong you called 1 wrong too.\n"
        "I have learned from that. What changed:\n"
        "- Each token must be larger than the one on its left.\n"
        "+ Use only blue tokens.\n"
        "\n"
        "What I understand now:\n"
        "Fill the whole of the top row. Use only blue tokens.\n"
        "\n"
        "I am not sure: 60 %. It could also be:\n"
        "- Fill the whole of the top row. Each token must not be smaller than the one on its "
        "left.\n"
        "\n"
        "Please examine me again: this exam was about my old rules.\n"
        f"Saved in {tmp_path / 'exercise.json'}.\n"
    )
    assert "Sorry, I did not understand that." in ran.out


def test_a_person_reads_that_nothing_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(examining, "learn", to((FullRow(), RISING)))
    ran = maestra("exam", taught(tmp_path), "--plays", "1", "--lang", "es", typed=b"no\nno\n")
    assert "He aprendido de ello, pero mis reglas siguen igual." in ran.out


def test_rules_that_were_told_are_not_learned_again(tmp_path: Path) -> None:
    path = written(tmp_path, told(FullRow(), RISING))
    ran = maestra("exam", path, "--plays", "2", typed=b"n\n" * 4)
    assert ran.code == 1
    assert "These rules were told to me in words. Please change the words." in ran.out
    exercise = exercise_in(path)
    assert exercise.status is LearnStatus.TOLD
    assert exercise.conjunction == (FullRow(), RISING)
    assert len(exercise.evidence.answers) == 2


def test_an_exam_without_right_plays_is_none(tmp_path: Path) -> None:
    path = written(tmp_path, told(FullRow(), BLUE))
    ran = maestra("exam", path)
    fault = "rules: no right play, expected rules of which a right play can be found"
    assert (ran.code, ran.err) == (2, f"maestra: {path}, line 1: {fault}\n")


def test_a_line_that_is_no_answer_leaves_the_exercise_as_it_was(tmp_path: Path) -> None:
    path = taught(tmp_path)
    before = path.read_bytes()
    ran = maestra("exam", path, "--protocol", "jsonl", typed=b'{"id": 1, "answer": "perhaps"}\n')
    fault = 'answer: "perhaps", expected one of yes, no, unsure, enough'
    assert (ran.code, ran.err) == (2, f"maestra: standard input, line 1: {fault}\n")
    assert path.read_bytes() == before


def test_an_exercise_made_of_actions_cannot_be_examined(tmp_path: Path) -> None:
    path = learned(tmp_path, "curie", "--learner", "grounded")
    ran = maestra("exam", path)
    assert (ran.code, ran.err.count("\n")) == (2, 1)
    assert 'kind: "grounded", expected "ruled"' in ran.err


@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        (["-"], "answers come from standard input, so the exercise cannot"),
        (["x.json", "-o", "-"], "questions go to standard output, so the exercise cannot"),
        (["x.json", "--plays", "0"], "Input should be greater than or equal to 1"),
    ],
)
def test_options_that_make_no_sense_are_refused(arguments: list[str], fault: str) -> None:
    ran = maestra("exam", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert fault in ran.err
