"""The search agrees with looking at every way to go on."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from maestra.rules.completability import (
    Completable,
    Conjunction,
    DeadEnd,
    MoveAllowed,
    MoveRefused,
)
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.rule import Rule, broken_rules
from maestra.rules.setting import Play, bits
from tests.rules.rule_strategies import decks, every_way_on, plays_from, rules_for, settings_with


@st.composite
def _conjunctions(draw: st.DrawFn) -> tuple[Conjunction, Play]:
    deck = draw(decks())
    setting = draw(settings_with(deck))
    board = setting.start.board
    rules: list[Rule] = draw(st.lists(rules_for(deck, board), min_size=1, max_size=4))
    if draw(st.booleans()):
        rules.append(FullRow())
    if draw(st.booleans()):
        rules.append(FillOrder(draw(st.sampled_from(Filling))))
    return Conjunction(tuple(rules), setting), draw(plays_from(setting, 150))


@given(_conjunctions())
def test_an_outlook_agrees_with_every_way_to_go_on(case: tuple[Conjunction, Play]) -> None:
    conjunction, play = case
    right = [way for way in every_way_on(play) if conjunction.may_end(way)]
    outlook = conjunction.outlook(play)
    if right:
        assert isinstance(outlook, Completable)
        assert outlook.example in right
    else:
        assert outlook == DeadEnd()


@given(_conjunctions())
def test_allowed_moves_are_those_that_some_right_play_makes(
    case: tuple[Conjunction, Play],
) -> None:
    conjunction, play = case
    moves = [(token, cell) for cell in play.free for token in bits(play.left)]
    right = [
        move for move in moves if any(map(conjunction.may_end, every_way_on(play.after(*move))))
    ]
    assert list(conjunction.allowed_moves(play)) == right
    for move in moves:
        verdict = conjunction.judge(play, *move)
        if move in right:
            assert verdict == MoveAllowed()
        else:
            broken = broken_rules(conjunction.rules, play.after(*move))
            assert verdict == MoveRefused(broken)
