import pytest

from maestra.experiments.fewshot_paper import (
    RULES,
    allows_the_same,
    paper_sample,
    paper_trials,
    right_demonstrations,
)
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.rule import holds
from maestra.rules.setting import play_of


def test_the_rules_are_those_of_all_the_papers_exercises() -> None:
    assert list(RULES) == list(PAPER_EXERCISES)


@pytest.mark.parametrize("key", RULES)
def test_every_right_play_of_the_paper_keeps_the_rules(key: str) -> None:
    plays = PAPER_EXERCISES[key].plays()
    for number in range(0, plays.count, plays.count // 10):
        play = play_of(plays.play(number))
        assert all(holds(rule, play) for rule in RULES[key])


@pytest.mark.parametrize("key", RULES)
def test_demonstrations_are_right_and_filled_from_the_left(key: str) -> None:
    for moves_tokens in (True, False):
        sample = paper_sample(key, 1, moves_tokens=moves_tokens)
        shown = right_demonstrations(sample, 2)
        assert (shown[0].start == shown[1].start) is not moves_tokens
        for one in shown:
            assert all(holds(rule, play_of(one)) for rule in sample.truth)
            assert [move.destination.column for move in one.moves] == [1, 2, 3, 4, 5]


def test_only_what_allows_the_same_rows_is_exact() -> None:
    sample = paper_sample("ascending", 0, moves_tokens=True)
    assert allows_the_same(sample, sample.truth)
    assert not allows_the_same(sample, RULES["odd-ascending"])
    habit = FillOrder(Filling.LEFT_TO_RIGHT)
    assert not allows_the_same(sample, (*sample.truth, habit))
    assert not allows_the_same(sample, (FullRow(),))


def test_an_exercise_of_the_paper_is_learned_from_two_demonstrations() -> None:
    before, after = paper_trials("odd-ascending", 0, 2, (0, 3), moves_tokens=True)
    assert (before.demonstrations, before.asked, before.questions) == (2, 0, 0)
    assert after.asked <= 3
    assert before.exact
    assert after.exact
