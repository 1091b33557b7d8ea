import json
from pathlib import Path

import pytest

from tests.cli.running import EXAMPLES, GROUNDED, learned, maestra


@pytest.fixture(name="exercise", scope="module")
def an_exercise(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return learned(tmp_path_factory.mktemp("exercise"), "ascending", *GROUNDED)


def test_explain_says_the_rules(exercise: Path) -> None:
    ran = maestra("explain", exercise)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == (
        "Put the tokens in the top row from left to right. "
        "Each token must be larger than the one on its left.\n"
        "\nI have compared these sentences with what I learned: they say the same.\n"
    )


def test_an_exercise_may_come_from_standard_input(exercise: Path) -> None:
    assert maestra("explain", "-", typed=exercise.read_bytes()) == maestra("explain", exercise)


def test_the_json_of_an_explanation(exercise: Path) -> None:
    ran = maestra("explain", exercise, "--json")
    assert (ran.code, ran.err, ran.out.count("\n")) == (0, "", 1)
    assert json.loads(ran.out) == {
        "rules": [
            {"id": "left-to-right", "text": "Put the tokens in the top row from left to right."},
            {
                "id": "increasing-value",
                "text": "Each token must be larger than the one on its left.",
            },
        ],
        "gaps": [],
        "compared": "same",
    }


def test_the_detail_is_that_of_the_papers_figure_4(exercise: Path) -> None:
    ran = maestra("explain", exercise, "--detail")
    assert (
        "move-v23-t2(from, to)\n"
        "  before: to = l12, contains(from, v23), empty(to), "
        "∃v' (contains(l11, v') ∧ less-than(v', v23))\n"
        "  after: ¬contains(from, v23), contains(to, v23), empty(from), ¬empty(to)\n"
    ) in ran.out
    assert ran.out.count("(from, to)\n") == 30


def test_the_json_of_the_detail_tells_where_literals_went(exercise: Path) -> None:
    ran = maestra("explain", exercise, "--detail", "--json")
    actions = {action["name"]: action for action in json.loads(ran.out)["actions"]}
    assert len(actions) == 30
    action = actions["move-v19-t1"]
    assert action["precondition"] == ["to = l11", "contains(from, v19)", "empty(to)"]
    assert action["seen"] == 2
    assert [one["demonstration"] for one in action["deleted"]] == sorted(
        one["demonstration"] for one in action["deleted"]
    )
    gone = [literal for one in action["deleted"] for literal in one["literals"]]
    assert "to = l12" in gone
    assert len(gone) == len(set(gone))


def test_features_are_listed_with_words() -> None:
    ran = maestra("features")
    assert (ran.code, ran.err) == (0, "")
    assert "\n  less-than           the first is less than the second\n" in ran.out
    assert "\n  vowel " in ran.out


def test_only_the_features_of_the_tokens_shown_are_listed() -> None:
    ran = maestra("features", EXAMPLES / "ascending.jsonl")
    assert (ran.code, ran.err) == (0, "")
    assert "\n  odd " in ran.out
    assert "\n  is-K " in ran.out
    assert "\n  vowel " not in ran.out
    assert "\n  before " not in ran.out


def test_what_is_listed_can_be_selected(tmp_path: Path) -> None:
    shown = EXAMPLES / "ascending.jsonl"
    for line in maestra("features", shown, "--json").out.splitlines():
        name = json.loads(line)["name"].replace("-K", "-19")
        ran = maestra("learn", shown, "-o", tmp_path / "x.json", "--features", name)
        assert ran.code < 2, ran


def test_a_decks_own_relations_are_listed(tmp_path: Path) -> None:
    line: dict[str, object] = {
        "format": "maestra.demonstration/1",
        "board": {},
        "tokens": {"a": {"name": "cup"}, "b": {"name": "saucer"}},
        "relations": {"partner": [["cup", "saucer"]]},
        "start": {"a": [2, 1], "b": [2, 2]},
        "moves": [],
    }
    path = tmp_path / "demos.jsonl"
    path.write_text(json.dumps(line))
    assert "\n  partner " in maestra("features", path).out


@pytest.mark.parametrize(
    ("language", "heading"),
    [("es", "Sobre una ficha:"), ("ca", "Sobre una fitxa:")],
)
def test_features_are_listed_in_each_language(language: str, heading: str) -> None:
    assert heading in maestra("features", "--lang", language).out.splitlines()


def test_export_writes_domain_and_problem(exercise: Path, tmp_path: Path) -> None:
    folder = tmp_path / "new" / "pddl"
    ran = maestra("export", exercise, "--pddl", folder)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == f"{folder}/domain.pddl\n{folder}/problem.pddl\n"
    assert (folder / "domain.pddl").read_text().startswith("(define (domain ")
    assert (folder / "problem.pddl").read_text().startswith("(define (problem ")


def test_the_problem_starts_where_a_play_stands(exercise: Path, tmp_path: Path) -> None:
    positions = EXAMPLES / "positions" / "ascending.jsonl"
    maestra("export", exercise, "--pddl", tmp_path / "whole")
    ran = maestra(
        *("export", exercise, "--pddl", tmp_path / "rest", "--play", positions, "--json")
    )
    assert (ran.code, ran.err) == (0, "")
    written = json.loads(ran.out)
    assert written == {
        "domain": str(tmp_path / "rest" / "domain.pddl"),
        "problem": str(tmp_path / "rest" / "problem.pddl"),
    }
    whole = (tmp_path / "whole" / "problem.pddl").read_text()
    assert Path(written["problem"]).read_text() != whole


def test_a_folder_that_cannot_be_made_is_refused(exercise: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    ran = maestra("export", exercise, "--pddl", tmp_path / "file")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == f"maestra: {tmp_path}/file: a file, expected a folder\n"


def test_a_play_that_does_not_fit_the_exercise_is_refused_at_its_line(
    exercise: Path, tmp_path: Path
) -> None:
    plays = EXAMPLES / "plays" / "curie.jsonl"
    ran = maestra("export", exercise, "--pddl", tmp_path, "--play", plays)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"maestra: {plays}, line 1: ")
