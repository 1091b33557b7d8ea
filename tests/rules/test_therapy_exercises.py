"""What therapists want can be said, kept, just missed, written and learned about move by move."""

from __future__ import annotations

import json

import pytest

from maestra.rules.completability import Completable, Conjunction
from maestra.rules.rule_json import decode_rule, encode_rule
from maestra.rules.setting import Play
from tests.rules.therapy_boards import TherapyExercise
from tests.rules.therapy_exercises import LISTED
from tests.rules.therapy_variations import MORE

ALL = pytest.mark.parametrize("exercise", [*LISTED, *MORE], ids=lambda one: one.words)


def test_all_forty_five_are_there_and_more_of_their_families() -> None:
    assert [int(one.words.split()[0]) for one in LISTED] == list(range(1, 46))
    assert len(MORE) > len(LISTED)


@ALL
def test_a_right_play_is_right_and_can_be_completed_after_each_move(
    exercise: TherapyExercise,
) -> None:
    rules = [decode_rule(json.loads(json.dumps(encode_rule(rule)))) for rule in exercise.rules]
    conjunction = Conjunction(tuple(rules), exercise.setting)
    right = exercise.play(exercise.right)
    assert conjunction.may_end(right)
    play = Play.begin(exercise.setting)
    for move in right.placed:
        assert isinstance(conjunction.outlook(play), Completable)
        play = play.after(*move)


@ALL
def test_a_near_miss_is_refused(exercise: TherapyExercise) -> None:
    conjunction = Conjunction(exercise.rules, exercise.setting)
    assert not conjunction.may_end(exercise.play(exercise.wrong))
