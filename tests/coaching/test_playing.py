"""A patient's session, fact by fact."""

from __future__ import annotations

from dataclasses import replace

import pytest

from maestra.coaching.commands import (
    AskCaregiver,
    LookAt,
    Matter,
    MoveToken,
    PointAt,
    Say,
    Show,
    View,
)
from maestra.coaching.events import (
    Answered,
    Begun,
    BoardBack,
    BoardLost,
    DoneSaid,
    EndOrdered,
    HelpAsked,
    HintOrdered,
    Paused,
    Resumed,
    RobotDone,
    RobotFailed,
    SeveralTokens,
    Skipped,
    TimePassed,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    VerdictOverridden,
)
from maestra.coaching.notes import Note
from maestra.coaching.session import Ending, Phase, due
from maestra.coaching.settings import Helper, Modality, Persona, PolicyName, Settings
from maestra.core.tokens import TokenId
from maestra.language.coach_keys import CoachKey
from maestra.rules.answers import Reply
from tests.coaching.driving import Driver, fields_of, noted, of_kind, said
from tests.coaching.plain_referee import (
    ANYTHING,
    ASCENDING,
    NOTHING,
    ONE_OR_TWO_RISING,
    START,
    Row,
    cell,
    game,
    token,
)

FIXED = Settings(policy=PolicyName.FIXED, level=0)


def begun(settings: Settings = FIXED, rows: frozenset[Row] = ASCENDING) -> Driver:
    driver = Driver.of(game(settings, rows))
    driver.feed(Begun())
    return driver


def fixed(level: int) -> Settings:
    return replace(FIXED, level=level)


# ---------------------------------------------------------------- moves


def test_a_session_begins_with_a_greeting_the_rules_and_the_turn() -> None:
    driver = Driver.of(game(FIXED))
    commands = driver.feed(Begun())
    assert said(commands) == [CoachKey.WELCOME, CoachKey.YOUR_TURN]
    shown = [c for c in commands if isinstance(c, Show)]
    assert shown[0].view is View.RULES
    assert len(shown[0].lines) == 2


def test_whoever_moves_first_has_begun() -> None:
    driver = Driver.of(game(FIXED))
    assert CoachKey.WELCOME in said(driver.feed(TokenLifted(token(3))))
    assert driver.session.phase is Phase.PLAYING


def test_a_right_move_is_praised_and_a_finished_row_ends_the_session() -> None:
    driver = begun()
    assert said(driver.move(3, 1, 1)) == [CoachKey.PRAISE]
    assert said(driver.move(8, 1, 2)) == [CoachKey.PRAISE]
    commands = driver.move(21, 1, 3)
    assert said(commands) == [CoachKey.PRAISE, CoachKey.COMPLETE]
    assert driver.session.ending is Ending.COMPLETE
    assert fields_of(commands, Note.ENDED)["moves"] == 3
    assert fields_of(commands, Note.ENDED)["first_time"] == 3


def test_a_refused_move_has_its_reason_and_is_to_be_put_back() -> None:
    driver = begun()
    commands = driver.move(21, 1, 1)
    assert said(commands) == [CoachKey.REFUSED, CoachKey.PLEASE_PUT_BACK]
    (first, *_) = [c for c in commands if isinstance(c, Say)]
    assert first.arguments == {"reason": "It is not larger than the one on its left."}
    assert driver.astray() == (token(21),)
    commands = driver.home(21)
    assert said(commands)[0] is CoachKey.THANKS_FOR_PUTTING_BACK
    assert driver.astray() == ()
    assert said(driver.move(3, 1, 1)) == [CoachKey.PRAISE_OWN_CORRECTION]


def test_a_refused_token_may_go_straight_on_to_where_it_is_right() -> None:
    driver = begun()
    driver.move(3, 1, 2)
    assert said(driver.move(3, 1, 1)) == [CoachKey.PRAISE_OWN_CORRECTION]


def test_a_right_move_counts_while_another_token_is_still_to_be_put_back() -> None:
    driver = begun()
    driver.move(21, 1, 3)
    commands = driver.move(3, 1, 1)
    assert said(commands)[-1] is CoachKey.PLEASE_PUT_BACK
    assert len(driver.session.position.moves) == 1


def test_a_token_put_where_another_is_missing_from_is_unclear() -> None:
    driver = begun()
    driver.feed(TokenLifted(token(3)))
    commands = driver.move(21, 2, 3)
    assert Note.UNCLEAR in noted(commands)
    assert driver.session.waiting is not None


def test_a_token_lifted_and_returned_is_no_move() -> None:
    driver = begun()
    before = driver.session.prompt_at
    driver.feed(TokenLifted(token(3)))
    commands = driver.feed(TokenPutBack(token(3)))
    assert noted(commands) == [Note.RETURNED]
    assert driver.session.prompt_at != before
    assert driver.session.position.moves == ()


def test_a_token_that_never_left_can_be_put_back() -> None:
    driver = begun()
    assert noted(driver.feed(TokenPutBack(token(3)))) == [Note.RETURNED]


def test_tokens_returned_while_another_is_astray_change_nothing() -> None:
    driver = begun()
    driver.move(21, 1, 1)
    driver.feed(TokenLifted(token(3)))
    assert said(driver.feed(TokenPutBack(token(3)))) == []


def test_two_tokens_in_the_air_are_one_too_many() -> None:
    driver = begun()
    driver.feed(TokenLifted(token(3)))
    assert CoachKey.ONE_AT_A_TIME in said(driver.feed(TokenLifted(token(5))))
    assert noted(driver.feed(TokenLifted(token(5)))) == [Note.UNEXPECTED]
    commands = driver.feed(SeveralTokens((token(3), token(8), TokenId("stranger"))))
    assert CoachKey.ONE_AT_A_TIME in said(commands)
    assert Note.UNKNOWN_TOKEN in noted(commands)


def test_several_strangers_are_no_tokens() -> None:
    driver = begun()
    commands = driver.feed(SeveralTokens((TokenId("stranger"),)))
    assert said(commands) == [CoachKey.UNKNOWN_TOKEN, CoachKey.ONE_AT_A_TIME]


@pytest.mark.parametrize("event", [TokenLifted, TokenPutBack])
def test_a_stranger_is_left_aside(event: type[TokenLifted | TokenPutBack]) -> None:
    commands = begun().feed(event(TokenId("stranger")))
    assert said(commands) == [CoachKey.UNKNOWN_TOKEN]


def test_what_the_board_says_of_cells_that_it_does_not_have_is_asked_about() -> None:
    (asked,) = of_kind(begun().feed(TokenPlaced(token(3), cell(9, 9))), AskCaregiver)
    assert isinstance(asked, AskCaregiver)
    assert asked.matter is Matter.CHECK_BOARD


def test_a_token_placed_on_another_means_that_the_other_is_gone() -> None:
    driver = begun()
    driver.feed(TokenPlaced(token(3), cell(2, 1)))
    assert token(13) in driver.session.table.air


# ---------------------------------------------------------------- putting back


def test_helpers_are_asked_in_turn_until_the_token_is_back() -> None:
    driver = begun(replace(FIXED, robot_moves=True, put_back=Helper.ROBOT))
    commands = driver.move(21, 1, 1)
    (moved,) = of_kind(commands, MoveToken)
    assert isinstance(moved, MoveToken)
    assert moved.destination == START.cells[token(21)]
    assert said(driver.wait()) == [CoachKey.PLEASE_PUT_BACK]
    assert said(driver.wait()) == [CoachKey.HELP_COMES]
    assert said(driver.wait()) == [CoachKey.I_PUT_BACK]
    assert driver.feed(TimePassed()) == ()


def test_a_robot_that_failed_is_not_asked_again() -> None:
    driver = begun(replace(FIXED, robot_moves=True, put_back=Helper.ROBOT))
    driver.move(21, 1, 1)
    assert driver.session.waiting is not None
    number = driver.session.waiting.number
    assert number is not None
    commands = driver.feed(RobotFailed(number, "stuck"))
    assert said(commands) == [CoachKey.I_CANNOT, CoachKey.PLEASE_PUT_BACK]
    assert said(driver.wait()) == [CoachKey.HELP_COMES]
    assert said(driver.wait()) == [CoachKey.PLEASE_PUT_BACK]
    assert noted(driver.feed(RobotFailed(77, "again"))) == [Note.ROBOT_FAILED]
    assert noted(driver.feed(RobotDone(77))) == [Note.ROBOT_DONE]


def test_a_robot_is_not_asked_for_a_token_that_is_held_or_whose_cell_is_taken() -> None:
    driver = begun(replace(FIXED, robot_moves=True, put_back=Helper.ROBOT))
    driver.move(21, 1, 1)
    driver.feed(TokenLifted(token(21)))
    assert said(driver.wait()) == [CoachKey.PLEASE_PUT_BACK]
    assert said(driver.wait()) == [CoachKey.HELP_COMES]


def test_asking_for_help_while_a_token_is_astray_says_what_to_put_back() -> None:
    driver = begun()
    driver.move(21, 1, 1)
    assert said(driver.feed(HelpAsked())) == [CoachKey.PLEASE_PUT_BACK]
    assert said(driver.feed(DoneSaid())) == [CoachKey.PLEASE_PUT_BACK]
    assert noted(driver.feed(HintOrdered(3))) == [Note.UNEXPECTED]
    assert said(driver.feed(Skipped())) == [CoachKey.HELP_COMES]


# ---------------------------------------------------------------- help


@pytest.mark.parametrize(
    ("level", "key"),
    [
        (0, CoachKey.YOUR_TURN),
        (1, CoachKey.ENCOURAGE),
        (2, CoachKey.LOOK_AT_ROW),
        (3, CoachKey.ONE_OF_THESE),
        (4, CoachKey.THIS_ONE),
        (5, CoachKey.TOGETHER),
    ],
)
def test_each_level_says_its_own(level: int, key: CoachKey) -> None:
    commands = Driver.of(game(fixed(level))).feed(Begun())
    assert said(commands) == [CoachKey.WELCOME, key]
    assert fields_of(commands, Note.HELP)["level"] == level


def test_the_second_step_reminds_of_a_rule_that_is_short() -> None:
    driver = begun(fixed(1))
    commands = driver.move(3, 1, 1)
    (reminder,) = [c for c in commands if isinstance(c, Say) and c.key == CoachKey.REMIND.value]
    assert reminder.arguments == {"rule": "Each token must be larger than the one on its left."}


def test_where_every_token_fits_a_few_would_give_it_away() -> None:
    driver = begun(fixed(3), ANYTHING)
    assert fields_of(driver.commands[0], Note.HELP)["level"] == 2


def test_asking_for_help_brings_one_level_more_up_to_the_limit() -> None:
    driver = begun(replace(FIXED, most_level=2))
    levels = [fields_of(driver.feed(HelpAsked()), Note.HELP)["level"] for _ in range(3)]
    assert levels == [1, 2, 2]


def test_hints_of_one_step_are_about_one_move() -> None:
    driver = begun(fixed(4))
    pointed = [next(c.cells for c in driver.commands[0] if isinstance(c, PointAt))]
    for _ in range(4):
        commands = driver.feed(HintOrdered(4))
        pointed.append(next(c.cells for c in commands if isinstance(c, PointAt)))
    assert len(set(pointed)) == 1


def test_silence_prompts_and_a_human_centred_robot_waits_longer_each_time() -> None:
    driver = begun(fixed(4))
    waits: list[int] = []
    levels: list[object] = []
    for _ in range(4):
        at = due(driver.session)
        assert at is not None
        waits.append(at - driver.session.now)
        levels.append(fields_of(driver.wait(), Note.HELP)["level"])
    assert waits == [15_000, 22_500, 30_000, 37_500]
    assert levels == [1, 4, 4, 4]


def test_an_exercise_centred_robot_drives_on() -> None:
    driver = begun(replace(fixed(4), persona=Persona.EXERCISE_CENTRED))
    for _ in range(3):
        before = driver.session.now
        assert fields_of(driver.wait(), Note.HELP)["level"] == 4
        assert driver.session.now - before == 15_000


def test_after_a_long_silence_the_caregiver_is_asked_and_may_pause() -> None:
    driver = begun()
    driver.wait()
    driver.wait()
    (asked,) = of_kind(driver.wait(), AskCaregiver)
    assert isinstance(asked, AskCaregiver)
    assert asked.matter is Matter.LONG_SILENCE
    driver.feed(Answered(asked.number, Reply.NO))
    assert driver.session.phase is Phase.PLAYING
    assert said(driver.feed(Answered(asked.number, Reply.YES))) == [CoachKey.PAUSED]


def test_after_so_many_attempts_the_token_is_shown() -> None:
    driver = begun(replace(FIXED, attempts=2))
    driver.move(21, 1, 1)
    assert CoachKey.THIS_ONE not in said(driver.home(21))
    driver.move(21, 1, 1)
    assert CoachKey.THIS_ONE in said(driver.home(21))


def test_without_errors_the_hint_comes_first() -> None:
    driver = begun(replace(FIXED, errorless=True))
    assert CoachKey.THIS_ONE in said(driver.commands[0])


def test_the_robot_places_the_token_where_it_may() -> None:
    driver = begun(replace(fixed(5), robot_moves=True))
    (moved,) = of_kind(driver.commands[0], MoveToken)
    assert isinstance(moved, MoveToken)
    assert said(driver.feed(HelpAsked())) == [CoachKey.I_AM_HERE]
    driver.feed(TokenLifted(moved.token))
    commands = driver.feed(TokenPlaced(moved.token, moved.destination))
    assert said(commands)[0] is CoachKey.LET_US_GO_ON
    assert fields_of(commands, Note.MOVE)["by"] == "helper"
    assert driver.session.tally.by_others == 1


def test_a_robot_that_cannot_place_shows_the_token() -> None:
    driver = begun(replace(fixed(5), robot_moves=True))
    (moved,) = of_kind(driver.commands[0], MoveToken)
    assert isinstance(moved, MoveToken)
    assert said(driver.feed(RobotFailed(moved.number, "stuck"))) == [
        CoachKey.I_CANNOT,
        CoachKey.THIS_ONE,
    ]


def test_a_robot_that_fails_in_a_pause_is_silent_about_hints() -> None:
    driver = begun(replace(fixed(5), robot_moves=True))
    (moved,) = of_kind(driver.commands[0], MoveToken)
    assert isinstance(moved, MoveToken)
    driver.feed(Paused())
    assert said(driver.feed(RobotFailed(moved.number, "stuck"))) == [CoachKey.I_CANNOT]


def test_a_token_in_the_hand_is_offered_not_taken() -> None:
    driver = begun(replace(FIXED, robot_moves=True))
    aim = next(c.cells for c in driver.feed(HintOrdered(4)) if isinstance(c, PointAt))[0]
    held = START.tokens[aim]
    driver.feed(TokenLifted(held))
    assert said(driver.feed(HintOrdered(5))) == [CoachKey.TOGETHER]


def test_without_speech_and_text_nothing_is_said() -> None:
    driver = begun(replace(fixed(2), modalities=(Modality.GESTURE,)))
    assert said(driver.commands[0]) == []
    assert of_kind(driver.commands[0], LookAt)


def test_without_gestures_nothing_is_looked_at() -> None:
    driver = begun(replace(fixed(5), modalities=(Modality.TEXT,)))
    assert not of_kind(driver.commands[0], LookAt)
    assert noted(driver.feed(TokenLifted(token(3)))) == [Note.HEARD]


# ---------------------------------------------------------------- the caregiver


def test_in_a_pause_moves_are_seen_but_not_judged() -> None:
    driver = begun()
    driver.feed(Paused())
    assert due(driver.session) is None
    commands = driver.move(21, 1, 1)
    assert noted(commands) == [Note.UNCLEAR]
    assert noted(driver.feed(Paused())) == [Note.UNEXPECTED]
    assert noted(driver.feed(HelpAsked())) == [Note.UNEXPECTED]
    assert noted(driver.feed(DoneSaid())) == [Note.UNEXPECTED]
    assert noted(driver.feed(Skipped())) == [Note.UNEXPECTED]
    assert driver.feed(TimePassed()) == ()
    assert CoachKey.PLEASE_PUT_BACK in said(driver.feed(Resumed()))
    assert noted(driver.feed(Resumed())) == [Note.UNEXPECTED]


def test_a_skipped_step_is_made_by_the_caregiver_or_the_robot() -> None:
    driver = begun()
    (asked,) = of_kind(driver.feed(Skipped()), AskCaregiver)
    assert isinstance(asked, AskCaregiver)
    assert asked.matter is Matter.PLACE
    robot = begun(replace(FIXED, robot_moves=True))
    (moved,) = of_kind(robot.feed(Skipped()), MoveToken)
    assert isinstance(moved, MoveToken)
    assert of_kind(robot.feed(RobotFailed(moved.number, "stuck")), AskCaregiver)


def test_where_nothing_is_right_the_caregiver_is_asked_once() -> None:
    driver = begun(FIXED, NOTHING)
    (asked,) = of_kind(driver.commands[0], AskCaregiver)
    assert isinstance(asked, AskCaregiver)
    assert asked.matter is Matter.NO_WAY_ON
    assert not of_kind(driver.feed(Skipped()), AskCaregiver)


def test_a_refused_move_can_be_granted() -> None:
    driver = begun()
    driver.move(21, 1, 3)
    commands = driver.feed(VerdictOverridden(allowed=True))
    assert CoachKey.ACCEPTED in said(commands)
    assert driver.session.tally.errors == 0
    assert len(driver.session.position.moves) == 1


def test_a_refused_move_that_is_back_cannot_be_granted() -> None:
    driver = begun()
    driver.move(21, 1, 3)
    driver.home(21)
    assert noted(driver.feed(VerdictOverridden(allowed=True))) == [Note.UNEXPECTED]


def test_a_right_move_can_be_vetoed_and_is_then_refused_and_not_hinted_at() -> None:
    driver = begun()
    driver.move(3, 1, 1)
    commands = driver.feed(VerdictOverridden(allowed=False))
    assert said(commands) == [CoachKey.REFUSED_BY_CAREGIVER, CoachKey.PLEASE_PUT_BACK]
    assert driver.session.tally.moves == 0
    assert driver.session.tally.first_time == 0
    driver.home(3)
    assert said(driver.move(3, 1, 1))[0] is CoachKey.REFUSED_BY_CAREGIVER
    driver.home(3)
    for level in (4, 5):
        pointed = next(c.cells for c in driver.feed(HintOrdered(level)) if isinstance(c, PointAt))
        assert START.tokens[pointed[0]] != token(3)


def test_only_the_last_move_can_be_vetoed() -> None:
    driver = begun()
    assert noted(driver.feed(VerdictOverridden(allowed=False))) == [Note.UNEXPECTED]
    driver.move(3, 1, 1)
    driver.feed(VerdictOverridden(allowed=False))
    driver.feed(VerdictOverridden(allowed=True))
    driver.move(21, 1, 3)
    assert noted(driver.feed(VerdictOverridden(allowed=False))) == [Note.UNEXPECTED]


def test_a_veto_of_a_move_that_was_taken_back_means_nothing() -> None:
    driver = begun()
    driver.move(3, 1, 1)
    driver.session = replace(driver.session, position=driver.session.position.without_last())
    assert noted(driver.feed(VerdictOverridden(allowed=False))) == [Note.UNEXPECTED]


def test_the_caregiver_can_end_at_any_time_and_loose_tokens_are_told() -> None:
    driver = begun()
    driver.move(21, 1, 1)
    commands = driver.feed(EndOrdered())
    assert said(commands) == [CoachKey.GOODBYE]
    assert fields_of(commands, Note.ENDED)["ending"] == "stopped"
    assert of_kind(commands, AskCaregiver)
    after = driver.feed(TokenLifted(token(3)))
    assert noted(after) == [Note.UNEXPECTED]
    assert due(driver.session) is None


def test_an_exercise_that_may_end_says_so_once_and_ends_when_told() -> None:
    driver = begun(FIXED, ONE_OR_TWO_RISING)
    early = driver.feed(DoneSaid())
    assert said(early)[0] is CoachKey.NOT_YET
    assert CoachKey.MAY_STOP in said(driver.move(3, 1, 1))
    driver.feed(TokenLifted(token(5)))
    assert CoachKey.MAY_STOP not in said(driver.feed(TokenPutBack(token(5))))
    assert CoachKey.COMPLETE in said(driver.feed(DoneSaid()))


def test_a_second_beginning_means_nothing() -> None:
    assert noted(begun().feed(Begun())) == [Note.UNEXPECTED]


# ---------------------------------------------------------------- the board lost


def test_while_the_board_is_lost_nothing_is_judged_and_nothing_made_up_afterwards() -> None:
    driver = begun()
    assert said(driver.feed(BoardLost())) == [CoachKey.BOARD_LOST]
    assert due(driver.session) is None
    assert noted(driver.move(3, 1, 1)) == [Note.UNCLEAR]
    assert noted(driver.feed(HelpAsked())) == [Note.UNEXPECTED]
    lying = {**START.cells, token(3): cell(1, 1)}
    commands = driver.feed(BoardBack(lying))
    assert said(commands) == [CoachKey.BOARD_BACK, CoachKey.PLEASE_PUT_BACK]
    assert driver.session.position.moves == ()


def test_a_board_that_comes_back_as_it_was_goes_on() -> None:
    driver = begun()
    driver.feed(BoardLost())
    commands = driver.feed(BoardBack(dict(START.cells)))
    assert said(commands) == [CoachKey.BOARD_BACK, CoachKey.YOUR_TURN]
    assert due(driver.session) is not None


def test_tokens_that_are_missing_or_strange_are_asked_about() -> None:
    driver = begun()
    lying = {TokenId("stranger"): cell(1, 1), token(3): cell(9, 9)}
    commands = driver.feed(BoardBack(lying))
    assert fields_of(commands, Note.BOARD_BACK)["missing"] == 5
    assert of_kind(commands, AskCaregiver)


def test_resuming_while_the_board_is_lost_waits_for_the_board() -> None:
    driver = begun()
    driver.feed(BoardLost())
    driver.feed(Paused())
    assert said(driver.feed(Resumed())) == [CoachKey.RESUMED]
    driver.feed(Paused())
    assert said(driver.feed(BoardBack(dict(START.cells)))) == [CoachKey.BOARD_BACK]


def test_time_never_runs_backwards() -> None:
    driver = begun()
    driver.feed(HelpAsked(), -900)
    assert driver.session.now == 1_000
