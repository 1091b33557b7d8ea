"""Laws that every form of the rule language keeps."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.rules.forms.base import Form
from maestra.rules.plays import Plays
from maestra.rules.rule import Prospect, holding, holds, prospect
from tests.rules.rule_strategies import (
    FORMS,
    RULES,
    decks,
    every_way_on,
    plays_from,
    settings_with,
)


def test_every_form_has_a_strategy() -> None:
    assert set(RULES) == set(FORMS)


@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.__name__)
@given(data=st.data())
def test_prospects_agree_with_every_way_to_go_on(form: type[Form], data: st.DataObject) -> None:
    deck = data.draw(decks())
    setting = data.draw(settings_with(deck))
    rule = data.draw(RULES[form](deck, setting.start.board))
    play = data.draw(plays_from(setting))
    ways = every_way_on(play)
    right = [holds(rule, way) for way in ways]
    expected = Prospect.KEPT if all(right) else Prospect.OPEN if any(right) else Prospect.BROKEN
    assert prospect(rule, play) is expected
    assert rule.certain(play) is all(right)
    assert rule.possible_with(play, 0) or not any(right)
    assert holding([rule], Plays.of(setting, ways)).tolist() == right
