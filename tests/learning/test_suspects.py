import pytest

from maestra.learning.grounded import learn_grounded
from maestra.learning.suspects import doubts, doubts_without_rule
from maestra.learning.teaching_sets import teaching_set
from maestra.rules.ground_truth import ground_truth
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.strips.literals import formula

ASCENDING = PAPER_EXERCISES["ascending"]
SHOWN = [ASCENDING.plays().play(number) for number in (7, 10**12, 2 * 10**12)]


def test_with_a_rule_the_suspects_are_what_separates_the_lesson_from_it() -> None:
    exercise = learn_grounded(SHOWN)
    truth = ground_truth(ASCENDING.plays(), exercise.model.vocabulary)
    found = doubts(exercise, ASCENDING.plays())
    for action in exercise.model.preconditions:
        suspect = {one.literal for one in found.suspects if one.action == action}
        learned = set(exercise.model.precondition(action))
        assert suspect == learned - set(truth.precondition(action))
    assert set(found.unseen) == set(truth.preconditions) - set(exercise.model.preconditions)
    assert found.suspects
    assert found.unseen


def test_the_suspects_of_the_least_shown_actions_come_first() -> None:
    exercise = learn_grounded([*SHOWN, SHOWN[0]])
    seen = [one.seen for one in doubts(exercise, ASCENDING.plays()).suspects]
    assert seen == sorted(seen)
    assert set(seen) == {1, 2}


def test_the_next_demonstration_settles_what_it_promises() -> None:
    exercise = learn_grounded(SHOWN)
    before = doubts(exercise, ASCENDING.plays())
    assert before.next_demonstration is not None
    after = doubts(learn_grounded([*SHOWN, before.next_demonstration]), ASCENDING.plays())
    assert len(after.unseen) < len(before.unseen)
    assert before.settled > 100


def test_showing_what_is_asked_for_ends_with_the_rule_learned_exactly() -> None:
    shown = list(SHOWN)
    while play := doubts(learn_grounded(shown), ASCENDING.plays()).next_demonstration:
        shown.append(play)
    learned = learn_grounded(shown).model
    assert (
        learned.preconditions == ground_truth(ASCENDING.plays(), learned.vocabulary).preconditions
    )
    assert len(shown) < 30


def test_a_fully_taught_exercise_leaves_no_doubt() -> None:
    shown = teaching_set(ASCENDING.plays(), ASCENDING.vocabulary()).demonstrations
    found = doubts(learn_grounded(shown), ASCENDING.plays())
    assert not found.suspects
    assert not found.unseen
    assert found.next_demonstration is None
    assert found.settled == 0


def test_without_a_rule_every_literal_but_the_frame_is_suspect() -> None:
    exercise = learn_grounded(SHOWN)
    found = doubts_without_rule(exercise, SHOWN)
    texts = {formula(one.literal, one.action.shown) for one in found.suspects}
    assert not texts & {"goal(to)", "storage(from)"}
    assert "to = l11" in texts
    total = sum(bits.bit_count() for bits in exercise.model.preconditions.values())
    assert len(found.suspects) == total - 2 * len(exercise.model.preconditions)


@pytest.mark.parametrize("count", [1, 3])
def test_without_a_rule_the_next_demonstration_is_a_shown_one_rearranged(count: int) -> None:
    shown = SHOWN[:count]
    found = doubts_without_rule(learn_grounded(shown), shown)
    assert found.next_demonstration is not None
    asked = found.next_demonstration.moves
    (same,) = (
        one.moves
        for one in shown
        if [(move.token, move.destination) for move in one.moves]
        == [(move.token, move.destination) for move in asked]
    )
    pairs = zip(asked, same, strict=True)
    assert all(move.origin != shown_move.origin for move, shown_move in pairs)
    assert found.settled >= 5
