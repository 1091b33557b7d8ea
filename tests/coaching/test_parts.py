"""Chance, difficulty, settings, policies and hints: what each promises."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import islice

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.coaching.assistance import InThisRow, ThisMove, hint
from maestra.coaching.chance import Chance, shares
from maestra.coaching.difficulty import QUARTERS, Difficulty, Staircase, deal, fits, ladder
from maestra.coaching.policies import (
    MEMORY,
    Adaptive,
    Fixed,
    Ladder,
    Policy,
    choose,
    decode_policy,
    encode_policy,
    learn,
    odds,
    policy_for,
    rested,
)
from maestra.coaching.remembered import Remembered, read_remembered, write_remembered
from maestra.coaching.session import Tally, new_session
from maestra.coaching.settings import (
    Hand,
    Helper,
    Mental,
    Modality,
    Physical,
    PolicyName,
    Profile,
    Reach,
    Settings,
    decode_settings,
    encode_settings,
    settings_for,
)
from maestra.coaching.situation import Limits, Outcome, Situation
from maestra.core.faults import InvalidError
from maestra.core.json_lines import FormatError
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.paper import LETTER_DECK, NUMBER_DECK
from maestra.rules.position import Position
from tests.coaching.plain_referee import ASCENDING, START, PlainReferee, cell, game, token

seeds = st.integers(0, 2**64 - 1)
profiles = st.builds(
    Profile,
    st.sampled_from(Mental),
    st.sampled_from(Physical),
    st.sampled_from(Hand),
    st.sampled_from(Reach),
)
situations = st.builds(
    Situation, st.integers(1, 12), st.sampled_from(Outcome), st.integers(0, 3), st.integers(0, 5)
)
FIRST = Situation(5)
CAREFUL = Adaptive((0, 0, 0, 0, 4, 4), 0.01)


# ---------------------------------------------------------------- chance


def test_the_numbers_are_those_of_the_reference() -> None:
    chance, words = Chance(1234567), list[int]()
    for _ in range(5):
        word, chance = chance.word()
        words.append(word)
    assert words == [
        6457827717110365317,
        3203168211198807973,
        9817491932198370423,
        4593380528125082431,
        16408922859458223821,
    ]


@given(seeds, st.integers(1, 50))
def test_draws_stay_in_their_bounds(seed: int, count: int) -> None:
    below, chance = Chance(seed).below(count)
    assert 0 <= below < count
    share, chance = chance.share()
    assert 0 <= share < 1
    order, chance = chance.shuffled(range(count))
    assert sorted(order) == list(range(count))
    assert all(0 <= one < 1 for one in islice(shares(chance), 3))


@given(seeds)
def test_streams_apart_have_other_numbers(seed: int) -> None:
    chance = Chance(seed)
    assert len({chance.split(number).state for number in range(20)}) == 20


# ---------------------------------------------------------------- difficulty


@given(seeds, st.integers(1, 3), st.integers(1, 5))
def test_a_dealt_deck_has_the_digits_and_different_numbers(
    seed: int, digits: int, similarity: int
) -> None:
    deck, _ = deal(NUMBER_DECK, Difficulty(digits, similarity), Chance(seed))
    values = [one.value("value") for one in deck.tokens]
    assert {len(str(value)) for value in values} == {digits}
    assert len(set(values)) == len(NUMBER_DECK.tokens)
    assert [one.id for one in deck.tokens] == [one.id for one in NUMBER_DECK.tokens]


def test_similar_numbers_lie_closer_together() -> None:
    def spread(similarity: int) -> int:
        deck, _ = deal(NUMBER_DECK, Difficulty(3, similarity), Chance(1))
        values = [one.value("value") for one in deck.tokens]
        numbers = [value for value in values if isinstance(value, int)]
        return max(numbers) - min(numbers)

    assert spread(5) < 90 < spread(1)


def test_decks_that_do_not_fit_are_left_as_they_are() -> None:
    assert deal(LETTER_DECK, Difficulty(), Chance(1))[0] == LETTER_DECK
    two = Deck((Token(TokenId("a"), (("value", 1), ("size", 2))),))
    assert fits(two) is None
    many = Deck(tuple(Token(TokenId(str(k)), (("value", k),)) for k in range(11)))
    assert deal(many, Difficulty(1, 1), Chance(1))[0] == many


@given(st.lists(st.booleans(), max_size=200), st.integers(1, 3), st.integers(1, 5))
def test_the_staircase_never_leaves_the_bounds(
    tries: list[bool], digits: int, similarity: int
) -> None:
    easiest, hardest = Difficulty(1, 1), Difficulty(digits, similarity)
    stairs = Staircase.at(Difficulty(2, 2), easiest, hardest)
    for right in tries:
        stairs = stairs.after(right_at_first=right)
        assert stairs.difficulty.is_between(easiest, hardest)


def test_the_staircase_settles_where_four_of_five_are_right() -> None:
    stairs = Staircase.at(Difficulty(1, 1), Difficulty.easiest(), Difficulty.hardest())
    steps = ladder(stairs.easiest, stairs.hardest)
    right = 0
    draws = islice(shares(Chance(5)), 4_000)
    for draw in draws:
        # One chance in fourteen less at each step up the ladder.
        hit = draw < 1 - steps.index(stairs.difficulty) / 14
        right += hit
        stairs = stairs.after(right_at_first=hit)
    assert 0.7 < right / 4_000 < 0.9
    assert round(0.8 / (1 - 0.8)) == QUARTERS


# ---------------------------------------------------------------- settings


@given(profiles)
def test_settings_and_what_is_remembered_survive_a_file(profile: Profile) -> None:
    settings = settings_for(profile)
    assert decode_settings(json.loads(json.dumps(encode_settings(settings)))) == settings
    learned = learn(policy_for(settings), 2, Outcome.RIGHT)
    for policy in (None, learned):
        known = Remembered(settings, policy)
        assert read_remembered(write_remembered(known).encode()) == known


def test_more_impairment_brings_more_help_more_time_and_slower_speech() -> None:
    rising = [settings_for(Profile(mental)) for mental in Mental]
    assert [s.level for s in rising] == sorted(s.level for s in rising)
    assert [s.patience_s for s in rising] == sorted(s.patience_s for s in rising)
    assert [-s.speech_wpm for s in rising] == sorted(-s.speech_wpm for s in rising)
    assert [s.errorless for s in rising] == [False] * 4 + [True]
    marked = settings_for(Profile(physical=Physical.MARKED))
    assert marked.ready_helpers[0] is Helper.ROBOT
    assert marked.patience == 25_000


def test_helpers_follow_one_another_and_a_robot_without_hands_is_none() -> None:
    assert Settings(put_back=Helper.CAREGIVER).ready_helpers == (Helper.CAREGIVER, Helper.PATIENT)
    robot = Settings(put_back=Helper.ROBOT)
    assert robot.ready_helpers == (Helper.PATIENT, Helper.CAREGIVER)
    able = replace(robot, robot_moves=True)
    assert able.ready_helpers == (Helper.ROBOT, Helper.PATIENT, Helper.CAREGIVER)


@pytest.mark.parametrize(
    ("changes", "where"),
    [
        ({"modalities": []}, "modalities"),
        ({"level": 4, "most_level": 3}, "level"),
        ({"hardest": {"digits": 1, "similarity": 5}}, "difficulty"),
    ],
)
def test_settings_that_contradict_one_another_are_refused(
    changes: dict[str, object], where: str
) -> None:
    with pytest.raises(InvalidError, match=where):
        decode_settings({**encode_settings(Settings()), **changes})


@pytest.mark.parametrize(
    "text",
    [
        b"{}",
        b'{"format": "maestra.settings/1"}',
        b'{"format": "maestra.settings/1", "settings": {"volume": 101}}',
        b'{"format": "maestra.settings/1", "settings": {}, "policy": {"policy": "none"}}',
        b'{"format": "maestra.settings/1", "settings": {}, "other": 1}',
    ],
)
def test_a_file_that_holds_no_settings_is_refused(text: bytes) -> None:
    with pytest.raises(FormatError):
        read_remembered(text, "s.json")


def test_modalities_are_kept_in_one_order() -> None:
    assert Settings(modalities=(Modality.GESTURE, Modality.SPEECH)).modalities == (
        Modality.SPEECH,
        Modality.GESTURE,
    )


# ---------------------------------------------------------------- policies


@given(
    st.sampled_from(PolicyName),
    st.sampled_from(Mental),
    st.lists(st.tuples(st.integers(0, 5), st.sampled_from(Outcome)), max_size=80),
    situations,
    st.builds(sorted, st.tuples(st.integers(0, 5), st.integers(0, 5))),
    st.booleans(),
)
def test_whatever_was_learned_a_policy_keeps_to_the_limits(
    name: PolicyName,
    mental: Mental,
    history: list[tuple[int, Outcome]],
    situation: Situation,
    allowed: list[int],
    waits: bool,  # noqa: FBT001 - drawn
) -> None:
    policy = policy_for(replace(settings_for(Profile(mental)), policy=name))
    for level, outcome in history:
        policy = learn(policy, level, outcome)
    limits = Limits(allowed[0], allowed[1], waits)
    assert limits.least <= choose(policy, situation, limits) <= limits.most
    assert decode_policy(json.loads(json.dumps(encode_policy(policy)))) == policy


def test_a_fixed_policy_learns_nothing() -> None:
    assert learn(Fixed(2), 2, Outcome.WRONG) == Fixed(2)
    assert rested(Fixed(2)) == Fixed(2)


def test_the_ladder_rises_with_errors_and_silence_and_falls_with_success() -> None:
    policy: Policy = Ladder(2)
    policy = learn(policy, 2, Outcome.WRONG)
    policy = learn(policy, 3, Outcome.SILENCE)
    assert policy == Ladder(4)
    policy = learn(policy, 4, Outcome.RIGHT)
    assert policy == Ladder(4, 1)
    assert learn(policy, 4, Outcome.RIGHT) == Ladder(3)


def after(policy: Policy, level: int, outcome: Outcome, times: int) -> Adaptive:
    for _ in range(times):
        policy = learn(policy, level, outcome)
    rest = rested(policy)
    assert isinstance(rest, Adaptive)
    return rest


def test_the_adaptive_policy_learns_how_little_help_is_enough() -> None:
    assert choose(CAREFUL, FIRST, Limits()) == 4
    learned = after(CAREFUL, 1, Outcome.RIGHT, 20)
    assert odds(learned).right[1] > 0.75 > odds(CAREFUL).right[1]
    assert choose(learned, FIRST, Limits()) == 1


def test_the_adaptive_policy_helps_more_when_little_help_fails() -> None:
    easy = Adaptive((4, 4, 4, 4, 4, 4), 0.01)
    assert choose(easy, FIRST, Limits()) == 0
    assert choose(after(easy, 0, Outcome.WRONG, 20), FIRST, Limits()) > 0


def test_the_adaptive_policy_helps_more_while_a_session_goes_badly() -> None:
    able = Adaptive((3, 3, 3, 4, 4, 4), 0.012)
    levels = [choose(replace(able, strain=strain), FIRST, Limits()) for strain in range(20)]
    assert levels[0] == 0
    assert levels[-1] == 3


@given(st.tuples(*[st.integers(0, 4)] * 6), st.floats(0.0, 0.1), st.integers(1, 9))
def test_nobody_who_struggles_more_is_helped_less(
    first: tuple[int, ...], price: float, left: int
) -> None:
    policy = Adaptive(tuple(sorted(first)), price)
    levels = [
        choose(replace(policy, strain=strain), Situation(left), Limits()) for strain in range(20)
    ]
    assert levels == sorted(levels)


def test_the_dearer_help_is_the_less_is_given() -> None:
    able = Adaptive((2, 3, 3, 3, 4, 4), 0.0)
    prices = (0.0, 0.02, 0.2)
    levels = [choose(replace(able, price=price), FIRST, Limits()) for price in prices]
    assert levels == sorted(levels, reverse=True)
    assert levels[0] > levels[-1] == 0


def test_after_a_silence_what_was_shown_stands() -> None:
    shown = Situation(5, Outcome.SILENCE, silences=1, standing=4)
    assert choose(CAREFUL, shown, Limits()) == 0
    assert choose(CAREFUL, shown, Limits(2)) == 4
    assert choose(CAREFUL, replace(shown, standing=0), Limits()) == 4
    assert choose(CAREFUL, replace(shown, standing=0), Limits(waits=True)) <= 1
    assert choose(CAREFUL, shown, Limits(most=0)) == 0
    worn, again = replace(CAREFUL, strain=8), replace(shown, standing=0, silences=2)
    assert choose(worn, again, Limits(waits=True)) == 4


def test_what_was_long_ago_weighs_less() -> None:
    policy = after(CAREFUL, 0, Outcome.RIGHT, MEMORY)
    assert policy.seen[0] == (MEMORY, 0, 0)
    assert after(policy, 0, Outcome.WRONG, 1).seen[0] == (MEMORY // 2, 0, 0)


def test_silence_wears_and_says_nothing_of_the_level() -> None:
    policy = learn(CAREFUL, 0, Outcome.SILENCE)
    assert isinstance(policy, Adaptive)
    assert policy.strain == 1
    assert rested(policy) == replace(CAREFUL, seen=policy.seen)
    assert odds(policy).right == odds(CAREFUL).right
    assert odds(policy).silent > odds(CAREFUL).silent


def test_the_odds_are_the_means_of_the_beliefs() -> None:
    learned = after(after(CAREFUL, 4, Outcome.RIGHT, 3), 4, Outcome.WRONG, 1)
    assert odds(learned).right[4] == (1 + 4 + 3) / (2 + 4 + 4)
    assert odds(learned).silent == 1 / (4 + 4)


def test_what_was_learned_is_used_only_where_the_settings_want_it() -> None:
    learned = learn(CAREFUL, 0, Outcome.WRONG)
    assert Remembered(Settings(), learned).best_policy == rested(learned)
    fixed = Settings(policy=PolicyName.FIXED)
    assert Remembered(fixed, learned).best_policy == Fixed(1)
    assert isinstance(Remembered(Settings()).best_policy, Adaptive)


# ---------------------------------------------------------------- hints


@given(seeds, st.sampled_from(Hand))
def test_a_short_reach_prefers_what_lies_near_and_beside_the_hand(seed: int, hand: Hand) -> None:
    profile = Profile(hand=hand, reach=Reach.NEAR_ROWS)
    referee, position = PlainReferee(ASCENDING), Position.begin(START)
    found = hint(referee, position, 4, profile, Chance(seed))
    assert isinstance(found, ThisMove)
    # Of 3, 5 and 8, which may come first, only 3 lies in the near row.
    assert found.move.token == token(3)
    row = hint(referee, position, 2, profile, Chance(seed))
    assert isinstance(row, InThisRow)
    assert row.cells == (cell(2, 1), cell(2, 2), cell(2, 3))


def test_tokens_get_harder_after_right_first_attempts_and_easier_after_others() -> None:
    settings = Settings(easiest=Difficulty(1, 1), hardest=Difficulty(3, 5))
    known = Remembered(settings)
    session = new_session(game(settings))
    well = replace(session, tally=Tally(moves=5, first_time=5))
    harder = known.after(well)
    assert harder.quarters == known.staircase.quarters + 5
    assert harder.settings.difficulty == Difficulty(2, 2)
    assert harder.staircase.quarters == harder.quarters
    badly = replace(session, tally=Tally(moves=5, first_time=2))
    assert harder.after(badly).settings.difficulty == Difficulty(1, 4)
    assert read_remembered(write_remembered(harder).encode()) == harder
    changed = replace(harder, settings=replace(settings, difficulty=Difficulty(1, 1)))
    assert changed.staircase.quarters == 0
