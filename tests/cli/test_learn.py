import json
from pathlib import Path

import pytest

from maestra.cli import shown_file
from maestra.cli.lesson import Speech
from maestra.core.formats import decode_demonstration
from maestra.language import NO_LEXICON, Language
from maestra.learning.planning import (
    NoEngine,
    Outcome,
    OutOfMemory,
    OutOfTime,
    ProvenUnsolvable,
    Unsupported,
)
from maestra.rules.exercise import Exercise, GroundedExercise, RuledExercise
from maestra.rules.exercise_format import decode_exercise
from maestra.rules.summaries.summary import summarise
from tests.cli.running import EXAMPLES, GROUNDED, maestra

ASCENDING = EXAMPLES / "ascending.jsonl"
RULES = (
    "Put the tokens in the top row from left to right. "
    "Each token must be larger than the one on its left.\n"
)


@pytest.fixture(name="few")
def a_file_of_too_few(tmp_path: Path) -> Path:
    path = tmp_path / "few.jsonl"
    path.write_bytes(b"".join(ASCENDING.read_bytes().splitlines(keepends=True)[:3]))
    return path


def grounded(content: bytes) -> GroundedExercise:
    exercise = decode_exercise(content)
    assert isinstance(exercise, GroundedExercise)
    return exercise


def kind_of(path: Path) -> type[Exercise]:
    return type(decode_exercise(path.read_bytes()))


def test_learn_says_the_rules_and_writes_the_exercise(tmp_path: Path) -> None:
    output = tmp_path / "x.json"
    ran = maestra("learn", ASCENDING, "-o", output)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == (
        "Fill the whole of the top row. "
        "Each token must be larger than the one on its left.\n"
        f"\nI am 99 % sure of this.\nSaved in {output}.\n"
    )
    assert kind_of(output) is RuledExercise


def test_rules_are_learned_unless_something_else_is_asked_for(tmp_path: Path) -> None:
    output, named = tmp_path / "x.json", tmp_path / "named.json"
    assert maestra("learn", ASCENDING, "-o", output).code == 0
    assert maestra("learn", ASCENDING, "-o", named, "--learner", "fewshot").code == 0
    assert output.read_bytes() == named.read_bytes()


@pytest.mark.parametrize("options", [("--features", "less-than"), ("--level", "A")])
def test_features_or_a_level_alone_ask_for_actions(
    tmp_path: Path, options: tuple[str, str]
) -> None:
    output, named = tmp_path / "x.json", tmp_path / "named.json"
    ran = maestra("learn", ASCENDING, "-o", output, *options)
    assert (ran.code, ran.err) == (0, "")
    assert kind_of(output) is GroundedExercise
    maestra("learn", ASCENDING, "-o", named, *options, *GROUNDED)
    assert output.read_bytes() == named.read_bytes()


@pytest.mark.parametrize("option", [("--features", "odd"), ("--level", "B")])
def test_what_actions_may_speak_of_is_refused_where_rules_are_learned(
    tmp_path: Path, option: tuple[str, str]
) -> None:
    output = tmp_path / "x.json"
    ran = maestra("learn", ASCENDING, "-o", output, "--learner", "fewshot", *option)
    fault = f"maestra: Invalid value: {option[0]} needs --learner grounded or compiled\n"
    assert (ran.code, ran.out, ran.err) == (2, "", fault)
    assert not output.exists()


def test_learning_actions_says_the_rules_and_writes_the_exercise(tmp_path: Path) -> None:
    output = tmp_path / "x.json"
    ran = maestra("learn", ASCENDING, "-o", output, *GROUNDED)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(RULES)
    assert ran.out.endswith(
        f"\nDemonstrations seen: 12. Actions learned: 30. Saved in {output}.\n"
    )
    assert grounded(output.read_bytes()).demonstrations == 12


def test_the_json_of_a_lesson_that_is_clear(tmp_path: Path) -> None:
    ran = maestra("learn", ASCENDING, "-o", tmp_path / "x.json", "--json", *GROUNDED)
    assert (ran.code, ran.err, ran.out.count("\n")) == (0, "", 1)
    answer = json.loads(ran.out)
    assert 0 < answer.pop("seconds") < 60
    assert answer == {
        "status": "learned",
        "rules": [
            {
                "id": "left-to-right",
                "text": "Put the tokens in the top row from left to right.",
                "confidence": 1.0,
            },
            {
                "id": "increasing-value",
                "text": "Each token must be larger than the one on its left.",
                "confidence": 1.0,
            },
        ],
        "alternatives": [],
        "slips": [],
        "demonstrations": 12,
        "gaps": [],
        "next_demonstration": None,
    }


def test_what_is_not_clear_yet_is_said_with_what_to_show_next(tmp_path: Path, few: Path) -> None:
    ran = maestra("learn", few, "-o", tmp_path / "x.json", *GROUNDED)
    assert (ran.code, ran.err) == (1, "")
    assert ran.out.startswith(f"{RULES}\nNot clear yet:\n- So far I have only seen 19 or 23 go")
    assert "\nTo settle most of it, show this next:\n" in ran.out
    assert " goes to column 5.\n" in ran.out


def test_the_json_of_a_lesson_that_is_not_clear(tmp_path: Path, few: Path) -> None:
    ran = maestra("learn", few, "-o", tmp_path / "x.json", "--json", *GROUNDED)
    assert (ran.code, ran.err) == (1, "")
    answer = json.loads(ran.out)
    assert answer["status"] == "ambiguous"
    assert all(0 < rule["confidence"] < 1 for rule in answer["rules"])
    assert {"id", "text"} == answer["gaps"][0].keys()
    shown = decode_demonstration(json.dumps(answer["next_demonstration"]).encode())
    assert shown.moves


def test_showing_what_is_asked_for_makes_all_clear_in_the_end(tmp_path: Path, few: Path) -> None:
    lines = few.read_text()
    sure: list[float] = []
    while len(sure) < 20:
        ran = maestra(
            "learn", "-", "-o", tmp_path / "x.json", "--json", *GROUNDED, typed=lines.encode()
        )
        answer = json.loads(ran.out)
        sure.append(answer["rules"][0]["confidence"])
        if answer["status"] == "learned":
            break
        lines += json.dumps(answer["next_demonstration"]) + "\n"
    assert sure == sorted(sure)
    assert sure[-1] == 1.0


def test_a_shown_play_is_asked_for_again_where_the_rules_allow_too_much_to_list(
    tmp_path: Path,
) -> None:
    shown = EXAMPLES / "first-row.jsonl"
    ran = maestra("learn", shown, "-o", tmp_path / "x.json", "--json", *GROUNDED)
    assert ran.code == 1
    asked = json.loads(ran.out)["next_demonstration"]["moves"]
    placed = [(move["token"], move["destination"]) for move in asked]
    plays = [json.loads(line)["moves"] for line in shown.read_text().splitlines()]
    assert placed in [[(move["token"], move["destination"]) for move in play] for play in plays]


@pytest.mark.parametrize(
    ("language", "line"),
    [
        ("es", "Demostraciones vistas: 12. Acciones aprendidas: 30. Guardado en "),
        ("ca", "Demostracions vistes: 12. Accions apreses: 30. Desat a "),
    ],
)
def test_a_lesson_is_told_in_each_language(tmp_path: Path, language: str, line: str) -> None:
    output = tmp_path / "x.json"
    ran = maestra("learn", ASCENDING, "-o", output, "--lang", language, *GROUNDED)
    speech = Speech(Language(language), NO_LEXICON)
    rules = speech.rules(summarise(grounded(output.read_bytes())))
    assert ran.out.startswith(" ".join(rule.text for rule in rules) + "\n")
    assert ran.out.splitlines()[-1].startswith(line)


def test_the_exercise_may_go_to_standard_output(few: Path) -> None:
    ran = maestra("learn", few, "-o", "-", *GROUNDED)
    assert grounded(ran.out.encode()).demonstrations == 3
    assert ran.err.startswith(RULES)
    assert ran.err.endswith("\nDemonstrations seen: 3. Actions learned: 10.\n")


def test_demonstrations_may_come_from_standard_input(tmp_path: Path) -> None:
    direct, piped = tmp_path / "direct.json", tmp_path / "piped.json"
    maestra("learn", ASCENDING, "-o", direct)
    ran = maestra("learn", "-", "-o", piped, typed=ASCENDING.read_bytes())
    assert (ran.code, ran.err) == (0, "")
    assert piped.read_text() == direct.read_text()


@pytest.mark.parametrize("path", [str(ASCENDING), "-"])
def test_a_file_too_long_to_keep_is_read_twice_and_teaches_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, path: str
) -> None:
    whole, parted = tmp_path / "whole.json", tmp_path / "parted.json"
    maestra("learn", ASCENDING, "-o", whole, *GROUNDED)
    monkeypatch.setattr(shown_file, "MAX_KEPT", 2)
    ran = maestra("learn", path, "-o", parted, *GROUNDED, typed=ASCENDING.read_bytes())
    assert (ran.code, ran.err) == (0, "")
    assert parted.read_text() == whole.read_text()


def test_features_and_level_are_those_that_were_asked_for(tmp_path: Path) -> None:
    output = tmp_path / "x.json"
    shown = EXAMPLES / "first-row.jsonl"
    ran = maestra("learn", shown, "-o", output, "--features", "cells", "--level", "B")
    assert ran.err == ""
    exercise = grounded(output.read_bytes())
    assert exercise.model.vocabulary.level.value == "B"
    assert {feature.label for feature in exercise.model.vocabulary.features} == {
        "from-storage",
        "to-goal-row",
        "destination",
        "origin",
    }


def test_planning_learns_the_same_and_says_how(tmp_path: Path) -> None:
    direct, planned = tmp_path / "direct.json", tmp_path / "planned.json"
    maestra("learn", ASCENDING, "-o", direct, *GROUNDED)
    ran = maestra(
        *("learn", ASCENDING, "-o", planned, "--learner", "compiled"),
        *("--compiled-pddl", tmp_path / "pddl", "--engine", "clingo"),
    )
    assert (ran.code, ran.err) == (0, "")
    assert "\nPlanned by clingo in " in ran.out
    assert planned.read_text() == direct.read_text()
    assert (tmp_path / "pddl" / "domain.pddl").read_text().startswith("(define (domain ")
    assert (tmp_path / "pddl" / "problem.pddl").read_text().startswith("(define (problem ")


def test_the_json_of_planning_names_the_engine(tmp_path: Path) -> None:
    options = ("--learner", "compiled", "--json")
    ran = maestra("learn", EXAMPLES / "curie.jsonl", "-o", tmp_path / "x.json", *options)
    planning = json.loads(ran.out)["planning"]
    assert planning.keys() == {"engine", "problems", "superfluous", "seconds"}
    assert planning["superfluous"] == 0


@pytest.mark.parametrize(
    ("outcome", "fault"),
    [
        (NoEngine("clingo", "it is gone"), "it is gone, expected an engine that is installed"),
        (Unsupported("clingo", "too odd"), "too odd, expected another engine"),
        (OutOfTime("clingo", 9.0), "no plan in 300 s, expected more time, with --time-limit"),
        (
            OutOfMemory("clingo", 9.0),
            "no plan in 2048 MB, expected more memory, with --memory-limit",
        ),
        (
            ProvenUnsolvable("clingo", 9.0),
            "no plan, though there always is one, expected another engine",
        ),
    ],
)
def test_an_engine_without_an_answer_is_bad_input(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, outcome: Outcome, fault: str
) -> None:
    def learn_compiled(*_arguments: object) -> Outcome:
        return outcome

    monkeypatch.setattr("maestra.cli.learning.learn_compiled", learn_compiled)
    ran = maestra("learn", ASCENDING, "-o", tmp_path / "x.json", "--learner", "compiled")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == f"maestra: --engine clingo: {fault}\n"


def test_a_planner_is_not_given_more_than_can_be_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(shown_file, "MAX_KEPT", 2)
    monkeypatch.setattr("maestra.cli.learning.MAX_KEPT", 2)
    ran = maestra("learn", ASCENDING, "-o", tmp_path / "x.json", "--learner", "compiled")
    assert ran.code == 2
    assert ran.err == (
        f"maestra: {ASCENDING}, line 1: 12 demonstrations, expected at most 2 for a planner\n"
    )
