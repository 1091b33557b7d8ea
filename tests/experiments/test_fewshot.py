from __future__ import annotations

from random import Random

import pytest

from maestra.experiments.fewshot import (
    agrees,
    demonstrate,
    learned_wrongly,
    reply_to,
    trial,
    visible,
)
from maestra.experiments.random_exercises import (
    FAMILIES,
    HIDDEN,
    Person,
    is_exercise,
    orders_for,
    sample_of,
    start_of,
)
from maestra.rules.answers import MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.rule import holds
from maestra.rules.setting import Play, Setting, play_of


@pytest.mark.parametrize("seed", range(0, 40, 4))
def test_demonstrations_are_right_but_for_the_slip(seed: int) -> None:
    sample = sample_of(seed)
    shown, slipped = demonstrate(sample, 3)
    for k, one in enumerate(shown):
        play = play_of(one)
        right = all(holds(rule, play) for rule in sample.truth)
        assert right is not (slipped is not None and slipped[0] == k)


def test_the_same_seed_gives_the_same() -> None:
    assert sample_of(7) == sample_of(7)
    assert demonstrate(sample_of(7), 2) == demonstrate(sample_of(7), 2)


def test_every_family_and_person_comes() -> None:
    samples = [sample_of(seed) for seed in range(120)]
    assert {sample.family for sample in samples} == set(FAMILIES)
    assert {sample.person for sample in samples} == set(Person)


def test_the_truth_agrees_with_itself_only() -> None:
    sample = sample_of(3)
    assert agrees(sample, sample.truth, sample.deck, "a")
    assert not agrees(sample, sample.truth[:1], sample.deck, "a")


def test_what_is_hidden_is_not_shown() -> None:
    sample = sample_of(5, outside=True)
    assert HIDDEN in sample.deck.scales
    assert HIDDEN not in visible(sample.deck).scales
    outcome = trial(5, 2, outside=True)
    assert learned_wrongly(outcome) is (outcome.status == "learned" and not outcome.exact)


def test_who_knows_the_truth_answers_by_it() -> None:
    sample = sample_of(3)
    play = play_of(demonstrate(sample, 1)[0][0])
    token, cell = play.placed[0]
    assert reply_to(sample, RowQuestion(play)) is Reply.YES
    assert reply_to(sample, MoveQuestion(Play.begin(play.setting), token, cell)) is Reply.YES
    assert reply_to(sample, RuleQuestion(sample.truth[-1])) is Reply.YES


def test_questions_are_asked_and_counted() -> None:
    outcome = trial(3, 1, asked=1)
    assert outcome.asked == 1


def test_an_exercise_that_allows_everything_is_none() -> None:
    sample, draws = sample_of(3), Random(0)  # noqa: S311 - no secret
    assert not is_exercise(sample.truth[:1], sample.deck, sample.board, "order", draws)
    setting = Setting(sample.deck, start_of(sample.deck, sample.board, draws))
    assert orders_for(sample.truth[:1], setting)
