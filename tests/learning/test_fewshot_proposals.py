"""What is proposed: from what was shown, at what cost, and what survives it."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import pytest

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.fewshot.families.choice import MAX_EITHER
from maestra.learning.fewshot.prior import (
    CROWD_BITS,
    KIND_BITS,
    Kind,
    amount_bits,
    and_bits,
    one_of,
    round_bits,
)
from maestra.learning.fewshot.proposals import Survivor, proposed, surviving
from maestra.learning.fewshot.shown import Shown, as_number, quotient
from maestra.learning.fewshot.token_tests import extremes, naming, simple, thresholds
from maestra.rules.forms.base import FIRST, Position
from maestra.rules.forms.conditions import At
from maestra.rules.forms.context import ModelRow, Reading
from maestra.rules.forms.counting import Count, Equation, Total
from maestra.rules.forms.length import UntilTotal
from maestra.rules.forms.order import CyclicOrdered, EqualSteps, Ordered
from maestra.rules.forms.patterns import Template, given_row
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Apart, Named, Step, Times, same
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, Setting, play_of
from maestra.rules.token_tests import Anything, Comparison, Either, Extreme, Has, Not, has
from tests.learning.fewshot_plays import DECK, RICH_DECK, SMALL_BOARD, rich, row, shown, start

ODD = has("odd", "value")
RISING = Ordered("value")


def rules_after(*tokens: tuple[int, ...], timed: bool = False) -> dict[Rule, float]:
    """What holds after these rows of the rich deck, with what it costs."""
    plays = [play_of(rich(one, turn)) for turn, one in enumerate(tokens)]
    found = surviving(plays, timed=timed, slips=0)
    return {rule: one.bits for one in found for rule in one.rules}


def test_every_kind_has_its_bits() -> None:
    assert set(KIND_BITS) == set(Kind)


def test_everything_proposed_costs_something_and_is_proposed_once() -> None:
    plays = [play_of(rich((0, 1, 3), order=(1, 0, 2))), play_of(rich((2, 3), 1))]
    found = proposed(plays, timed=True)
    assert all(bits > 0 for _, bits in found)
    assert len({one.rules for one, _ in found}) == len(found)


def test_a_deck_of_everything_suggests_every_kind_of_rule() -> None:
    plays = [
        *(play_of(rich(tokens, turn)) for turn, tokens in enumerate([(0, 1), (0, 1)])),
        *(play_of(rich(tokens)) for tokens in [(0, 1, 2), (0, 2, 4), (0, 2, 1), (1, 2, 0)]),
    ]
    kinds = {
        one.kind
        for timed in (True, False)
        for play in plays
        for one, _ in proposed([play], timed=timed)
    }
    wide = [play_of(shown((0, 1, 2, 3), deck=RICH_DECK, board=Board(4, 4)))]
    kinds |= {one.kind for one, _ in proposed(wide, timed=True)}
    assert set(Kind) - kinds == set()


@pytest.mark.parametrize(
    "rule",
    [
        Word(),
        Word(relation="category", value="dog"),
        EachPair(Pairs.NEIGHBOURS, Times("value", 2)),
        EachPair(Pairs.NEIGHBOURS, Step("day", 1)),
        Ordered("value"),
        EqualSteps("value", ratio=True),
        given_row("letter", tuple("CUR")),
        Template("kind", "ABA"),
        Total("value", Comparison.EQUAL, 7),
        CyclicOrdered("day"),
        Before(has("is-a", "name"), has("is-b", "name"), Line.ROW),
    ],
    ids=str,
)
def test_what_a_row_shows_is_proposed(rule: Rule) -> None:
    assert rule in rules_after((0, 1, 2))


def test_only_what_holds_of_all_plays_survives() -> None:
    rules = rules_after((0, 1, 2), (1, 2, 3))
    assert EachPair(Pairs.NEIGHBOURS, Times("value", 2)) in rules
    assert EachPair(Pairs.NEIGHBOURS, Apart("value", 1)) not in rules
    assert given_row("letter", tuple("CUR")) not in rules
    assert Total("value", Comparison.EQUAL, 7) not in rules


def test_what_breaks_one_play_survives_where_slips_are_thought_of() -> None:
    plays = [row((0, 2, 5, 7, 8)), row((1, 3, 4, 6, 9)), row((0, 1, 3, 2, 4))]
    found = {one.rules: one for one in surviving(plays, timed=False, slips=1)}
    assert found[RISING,].broken == 0b100
    assert (RISING,) not in {one.rules for one in surviving(plays, timed=False, slips=0)}


def test_what_two_generators_propose_costs_what_the_later_one_says() -> None:
    found = {one.rules: (one, bits) for one, bits in proposed([row((0, 1, 2, 3, 4))], timed=False)}
    pair = found[EveryToken(has("is-red", "colour")), AllOfThem(has("is-red", "colour"))]
    assert pair[0].kind is Kind.ALL_OF_THEM
    assert isinstance(pair[1], float)


def test_time_is_thought_of_only_where_it_tells_something() -> None:
    in_time = Ordered("value", line=Line.TIME)
    assert in_time not in rules_after((0, 1, 2))
    timed = rules_after((0, 1, 2), timed=True)
    assert timed[in_time] > timed[Ordered("value")]
    assert Before(has("is-a", "name"), has("is-b", "name"), Line.TIME) in timed
    assert At(FIRST, has("is-red", "kind"), Line.TIME) in timed


def test_features_that_few_think_of_cost_more() -> None:
    bits = {one.rules: cost for one, cost in proposed([row((0, 1, 6, 7, 9))], timed=False)}
    prime = has("prime", "value")
    for rule in (EveryToken, AllOfThem):
        alike = [cost for rules, cost in bits.items() if rules == (rule(ODD),)]
        fewer = [cost for rules, cost in bits.items() if rules == (rule(prime),)]
        assert alike < fewer
    assert bits[EveryToken(Not(ODD)),] < bits[EveryToken(Not(prime)),]
    green = has("is-green", "colour")
    eithers = {
        frozenset((rules[0].test.first, rules[0].test.second)): cost
        for rules, cost in bits.items()
        if isinstance(rules[0], EveryToken) and isinstance(rules[0].test, Either)
    }
    assert eithers[frozenset((green, ODD))] < eithers[frozenset((green, prime))]


def test_more_proposals_cost_more_than_their_sum_unless_they_are_usually_added() -> None:
    assert and_bits([]) == CROWD_BITS[0]
    assert and_bits([3.5]) == CROWD_BITS[1]
    assert and_bits([3.5, -0.5]) == CROWD_BITS[2] - 0.5
    assert and_bits([3.5, 3.5]) == CROWD_BITS[2] + 3.5
    assert and_bits([-0.5, -0.5]) == CROWD_BITS[2] - 1.0


def test_round_and_small_amounts_cost_less() -> None:
    assert amount_bits(1) < amount_bits(7) < amount_bits(Decimal("7.5"))
    assert round_bits(100, 500) < round_bits(103, 500)
    assert round_bits(10, 2) == 0.0
    assert one_of(0) == one_of(1) == 0.0


# ------------------------------------------------------------------ what was shown
def test_a_third_cannot_be_written() -> None:
    assert as_number(Fraction(1, 3)) is None
    assert as_number(Fraction(1, 2)) == Decimal("0.5")
    assert as_number(4) == 4
    assert quotient(0, 3) is None


def test_amounts_are_those_of_the_first_two_tokens() -> None:
    play = Shown((play_of(rich((0, 1, 4))), play_of(rich((3, 4, 0), 1))), timed=False)
    assert play.amounts("value", quotient) == [2, Decimal("0.625")]
    assert play.steps("day") == [1]


def test_a_row_without_numbers_adds_up_to_nothing() -> None:
    deck = Deck(
        (
            Token(TokenId("a"), (("value", 1),)),
            Token(TokenId("b"), (("value", 5),)),
            Token(TokenId("c"), (("colour", "red"),)),
            Token(TokenId("d"), (("colour", "red"),)),
            Token(TokenId("e"), (("colour", "blue"),)),
        )
    )
    play = play_of(shown((0, 2, 4), deck=deck, board=SMALL_BOARD))
    found = Shown((play,), timed=False)
    assert found.sum_of(play, "value") is None
    assert found.rows_of("colour") == []
    assert found.templates_of("colour", Line.ROW) == []
    assert found.amounts("value", quotient) == []
    rules = {rule for one, _ in proposed([play], timed=False) for rule in one.rules}
    assert not any(isinstance(rule, Total | UntilTotal) for rule in rules)


def test_a_row_that_stays_is_a_model() -> None:
    setting = Setting(RICH_DECK, start(0, RICH_DECK, SMALL_BOARD))
    first = [k for k, v in enumerate(setting.values("origin:row")) if v == 1]
    rest = tuple(k for k in range(6) if k not in first)[:3]
    rules = {rule for one, _ in proposed([play_of(rich(rest))], timed=False) for rule in one.rules}
    assert ModelRow(1, Reading.COPIED, same("kind")) in rules


def test_as_many_as_were_placed_each_time_is_a_length() -> None:
    plays = [row((2, 4, 5)), row((4, 6, 8), 3)]
    found = {rule for one in surviving(plays, timed=False, slips=0) for rule in one.rules}
    assert Count(Anything(), Comparison.EQUAL, 3) in found
    other = [row((2, 4, 5)), row((4, 6), 3)]
    found = {rule for one in surviving(other, timed=False, slips=0) for rule in one.rules}
    assert not any(isinstance(rule, Count) and rule.test == Anything() for rule in found)


def test_of_many_values_no_two_are_paired_by_or() -> None:
    tokens = tuple(Token(TokenId(f"t{k:03}"), (("name", f"n{k // 2}"),)) for k in range(100))
    play = play_of(shown((0, 1), deck=Deck(tokens), board=Board(52, 2)))
    assert len(simple(play.setting)) > MAX_EITHER
    kinds = {one.kind for one, _ in proposed([play], timed=False)}
    assert Kind.ONLY in kinds
    assert Kind.ONLY_EITHER not in kinds


def test_tests_of_tokens_are_those_the_deck_suggests() -> None:
    setting = Setting(DECK, start())
    assert has("is-red", "colour") in naming(setting, "colour")
    assert naming(setting, "value") == []
    assert {test.attribute for test in thresholds(setting)} == {"value", "letter"}
    assert {test.attribute for test in extremes(setting)} == {"value", "letter"}
    assert all(isinstance(test, Has) for test in simple(setting))


def test_the_least_left_is_taken_next() -> None:
    plays = [row((0, 1, 2, 3, 4)), row((0, 1, 2, 3, 4), 3)]
    found = {rule for one in surviving(plays, timed=False, slips=0) for rule in one.rules}
    assert TakeExtreme("value", Extreme.LOWEST) in found
    assert StraightUp() not in found


def test_a_survivor_says_what_it_costs_to_be_added() -> None:
    found = surviving([row((0, 1, 2, 3, 4))], timed=False, slips=0)
    by_rules: dict[tuple[Rule, ...], Survivor] = {one.rules: one for one in found}
    assert by_rules[RISING,].added < by_rules[given_row("letter", tuple("CURIE")),].added
    assert Equation("value", (FIRST, Position(2)), (Position(3),)) not in {
        rule for rules in by_rules for rule in rules
    }
    assert EachPair(Pairs.TWO_BY_TWO, AddUp("value", 42)) not in {r for x in by_rules for r in x}
    assert EachPair(Pairs.NEIGHBOURS, Named("partner")) not in {r for x in by_rules for r in x}
