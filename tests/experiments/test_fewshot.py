from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from maestra.experiments import fewshot
from maestra.experiments.demonstrators import Mistake, demonstrate, visible
from maestra.experiments.exercise_families import FAMILIES
from maestra.experiments.fewshot import (
    Circumstances,
    Outcome,
    agrees,
    lessons,
    new_deck,
    reply_to,
    trials,
)
from maestra.experiments.random_exercises import (
    HIDDEN,
    Person,
    is_exercise,
    orders_for,
    sample_of,
    start_of,
)
from maestra.learning.fewshot.questions import QuestionKind
from maestra.rules.answers import MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.rule import holds
from maestra.rules.setting import Play, Setting, play_of

ASKED = 1001
"""A seed whose exercise leaves something to ask after two demonstrations."""


@pytest.mark.parametrize("seed", range(0, 40, 4))
@pytest.mark.parametrize("forced", [True, False])
def test_demonstrations_are_right_but_for_the_slip(seed: int, *, forced: bool) -> None:
    sample = sample_of(seed)
    shown, slipped = demonstrate(sample, 3, forced=forced)
    for k, one in enumerate(shown):
        play = play_of(one)
        right = all(holds(rule, play) for rule in sample.truth)
        assert right is not (slipped is not None and slipped.demonstration == k)


@pytest.mark.parametrize("seed", range(8))
def test_the_moves_of_a_slip_are_those_that_differ_from_what_was_meant(seed: int) -> None:
    sample = sample_of(seed, person=Person.UNIFORM)
    meant, _ = demonstrate(sample, 3)
    shown, slipped = demonstrate(sample, 3, forced=True)
    assert slipped is not None
    pairs = zip(
        meant[slipped.demonstration].moves, shown[slipped.demonstration].moves, strict=True
    )
    differing = tuple(k for k, (one, other) in enumerate(pairs) if one != other)
    assert slipped.moves == differing
    assert len(differing) in (1, 2)


def test_the_same_seed_gives_the_same() -> None:
    assert sample_of(7) == sample_of(7)
    assert demonstrate(sample_of(7), 2) == demonstrate(sample_of(7), 2)


def test_every_family_and_person_comes() -> None:
    samples = [sample_of(seed) for seed in range(120)]
    assert {sample.family for sample in samples} == set(FAMILIES)
    assert {sample.person for sample in samples} == set(Person)


@pytest.mark.parametrize("person", Person)
def test_each_person_shows_what_is_right(person: Person) -> None:
    sample = sample_of(1, person=person)
    shown, slipped = demonstrate(sample, 4)
    for k, one in enumerate(shown):
        if slipped is None or slipped.demonstration != k:
            assert all(holds(rule, play_of(one)) for rule in sample.truth)
    if person is Person.LAZY:
        rows = [tuple(sorted((m.destination, m.token) for m in one.moves)) for one in shown]
        assert len(set(rows)) < len(rows)


def test_the_truth_agrees_with_itself_only() -> None:
    sample = sample_of(3)
    assert agrees(sample, sample.truth, sample.deck, "a")
    assert not agrees(sample, sample.truth[:1], sample.deck, "a")


def test_a_new_deck_has_the_attributes_of_the_old_one_and_other_tokens() -> None:
    sample = sample_of(ASKED)
    other = new_deck(sample)
    assert other.scales == sample.deck.scales
    assert other.tokens != sample.deck.tokens


def test_a_deck_that_cannot_be_exchanged_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fewshot, "DECKS", 0)
    sample = sample_of(ASKED)
    assert new_deck(sample) is sample.deck


def test_what_is_hidden_is_not_shown() -> None:
    sample = sample_of(5, outside=True)
    assert any(name.startswith(HIDDEN) for name in sample.deck.scales)
    assert not any(name.startswith(HIDDEN) for name in visible(sample.deck).scales)
    (outcome,) = trials(5, 2, (0,), Circumstances(outside=True))
    assert not outcome.exact


def test_who_knows_the_truth_answers_by_it() -> None:
    sample = sample_of(3)
    play = play_of(demonstrate(sample, 1)[0][0])
    token, cell = play.placed[0]
    assert reply_to(sample, RowQuestion(play)) is Reply.YES
    assert reply_to(sample, MoveQuestion(Play.begin(play.setting), token, cell)) is Reply.YES
    assert reply_to(sample, RuleQuestion(sample.truth[-1])) is Reply.YES
    order = FillOrder(Filling.RIGHT_TO_LEFT)
    assert reply_to(sample, RuleQuestion(order)) is Reply.NO
    first = play.placed[0]
    swapped = Play.begin(play.setting).after(play.placed[1][0], first[1])
    for other in (first, *play.placed[2:]):
        swapped = swapped.after(other[0], play.placed[1][1] if other is first else other[1])
    right = all(holds(rule, swapped) for rule in sample.truth)
    assert reply_to(sample, RowQuestion(swapped)) is (Reply.YES if right else Reply.NO)


def test_one_dialogue_gives_the_outcome_after_each_number_of_questions() -> None:
    together = trials(ASKED, 2, (0, 1, 5))
    assert together[1] == trials(ASKED, 2, (1,))[0]
    assert [one.questions for one in together] == [0, 1, 5]
    assert [one.asked for one in together][:2] == [0, 1]
    assert together[2].asked <= 5


def test_somebody_may_not_want_to_be_asked_about_rules() -> None:
    sample = sample_of(ASKED)
    shown, _ = demonstrate(sample, 1)
    kinds = frozenset({QuestionKind.ROW, QuestionKind.MOVE})
    (lesson,) = lessons(sample, shown, (3,), Circumstances(kinds=kinds))
    assert lesson.answers
    assert not any(isinstance(a.question, RuleQuestion) for a in lesson.answers)


def test_somebody_may_answer_wrongly() -> None:
    sample = sample_of(ASKED)
    shown, _ = demonstrate(sample, 1)
    (right,) = lessons(sample, shown, (1,))
    (wrong,) = lessons(sample, shown, (1,), Circumstances(wrong=1.0))
    assert right.answers[0].question == wrong.answers[0].question
    assert {right.answers[0].reply, wrong.answers[0].reply} == {Reply.YES, Reply.NO}


def test_a_mistake_is_located_at_either_of_two_tokens_in_each_others_place() -> None:
    (outcome,) = trials(0, 3, (0,), Circumstances(slip=True))
    assert outcome.slipped is not None

    def pointing(*slips: tuple[int, int]) -> Outcome:
        return replace(outcome, slipped=Mistake(1, (0, 3)), slips=slips)

    assert pointing((1, 3)).located
    assert pointing((1, 0)).located
    assert not pointing((1, 1)).located
    assert not pointing((0, 3)).located
    assert not replace(pointing((1, 3)), slipped=None).located


def test_an_exercise_that_allows_everything_is_none() -> None:
    sample, draws = sample_of(3), Random(0)  # noqa: S311 - no secret
    assert not is_exercise(sample.truth[:1], sample.deck, sample.board, draws)
    setting = Setting(sample.deck, start_of(sample.deck, sample.board, draws))
    assert orders_for(sample.truth[:1], setting)
