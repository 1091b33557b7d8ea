"""The files in examples/ are what their script writes, and teach what they are to teach."""

from collections.abc import Iterator

import pytest

from maestra.core.demonstration import Demonstration
from maestra.core.formats import read_demonstrations, read_plays
from maestra.learning.grounded import learn_grounded
from maestra.rules.ground_truth import ground_truth
from maestra.rules.judging import Judge
from maestra.rules.paper import PAPER_EXERCISES, PaperExercise
from scripts.write_examples import EXERCISES, FOLDER, files
from tests.rules.positions import positions_of

NAMES = pytest.mark.parametrize("name", EXERCISES)


def content(name: str) -> Iterator[bytes]:
    yield (FOLDER / name).read_bytes()


def shown(name: str) -> list[Demonstration]:
    return list(read_demonstrations(content(f"{name}.jsonl"), name))


def judge(name: str) -> Judge:
    demonstrations = shown(name)
    exercise = learn_grounded(demonstrations, features=PAPER_EXERCISES[name].features)
    return Judge(exercise, demonstrations[0].deck)


def test_the_examples_are_those_that_the_script_writes() -> None:
    written = {
        str(path.relative_to(FOLDER)): path.read_text(encoding="utf-8")
        for path in FOLDER.rglob("*.jsonl")
    }
    assert written == files(), "run: make examples"


def test_there_are_examples_of_the_papers_six_exercises() -> None:
    assert EXERCISES.keys() == PAPER_EXERCISES.keys()


@pytest.mark.parametrize(("name", "paper"), PAPER_EXERCISES.items())
def test_an_examples_demonstrations_are_as_few_as_the_papers(
    name: str, paper: PaperExercise
) -> None:
    assert len(shown(name)) == paper.fewest


@pytest.mark.parametrize(("name", "paper"), PAPER_EXERCISES.items())
def test_an_examples_demonstrations_teach_the_exercise_exactly(
    name: str, paper: PaperExercise
) -> None:
    model = learn_grounded(shown(name), features=paper.features).model
    truth = ground_truth(paper.plays(), model.vocabulary)
    assert model.preconditions == truth.preconditions


@pytest.mark.parametrize("left_out", range(12))
def test_none_of_the_demonstrations_of_an_ordering_can_be_spared(left_out: int) -> None:
    demonstrations = shown("ascending")
    del demonstrations[left_out]
    model = learn_grounded(demonstrations).model
    truth = ground_truth(PAPER_EXERCISES["ascending"].plays(), model.vocabulary)
    assert model.preconditions != truth.preconditions


@NAMES
def test_right_plays_are_right_and_wrong_ones_wrong_where_they_say(name: str) -> None:
    judging = judge(name)
    plays = [play for _, play in read_plays(content(f"plays/{name}.jsonl"), name)]
    right, *wrong = plays
    assert right.label == "right"
    assert not any(one.is_refused for one in judging.judge(right.start, right.moves))
    slips = EXERCISES[name].slips
    for play, slip in zip(wrong, (*slips, slips[0]), strict=True):
        judged = judging.judge(play.start, play.moves)
        refused = [at for at, one in enumerate(judged) if one.is_refused]
        assert refused == [slip.before], play.label


@NAMES
def test_positions_can_be_completed_until_they_are_complete(name: str) -> None:
    judging = judge(name)
    positions = list(read_demonstrations(content(f"positions/{name}.jsonl"), name))
    assert [len(one.moves) for one in positions] == [0, 2, 4, 5]
    for position in positions:
        made = len(position.moves)
        *_, end = positions_of(position)
        assert any(judging.allowed_moves(end)) == (made < 5)
        assert judging.may_end(end) == (made == 5)


@NAMES
def test_ids_look_like_those_of_tags(name: str) -> None:
    for token in shown(name)[0].deck.tokens:
        uid = bytes.fromhex(token.id)
        assert len(uid) == 7
        assert uid[0] == 0x04


@NAMES
def test_demonstrations_have_a_time_for_each_move_and_say_where_they_are_from(name: str) -> None:
    for one in shown(name):
        assert one.times_ms is not None
        assert len(one.times_ms) == len(one.moves) == 5
        assert one.source == "simulated"
        assert one.label is not None
        assert one.label.startswith(name)
