"""The keys of what the coach says: each language has several ways to say each."""

from __future__ import annotations

from enum import Enum


class CoachKey(Enum):
    """A phrase of the coach; what stands in braces there is filled in."""

    # a session
    WELCOME = "welcome"
    YOUR_TURN = "your-turn"
    COMPLETE = "complete"
    GOODBYE = "goodbye"
    PAUSED = "paused"
    RESUMED = "resumed"
    BOARD_LOST = "board-lost"
    BOARD_BACK = "board-back"
    MAY_STOP = "may-stop"
    NOT_YET = "not-yet"
    LET_US_GO_ON = "let-us-go-on"
    ACCEPTED = "accepted"
    # moves
    PRAISE = "praise"
    PRAISE_OWN_CORRECTION = "praise-own-correction"
    THANKS_FOR_PUTTING_BACK = "thanks-for-putting-back"
    REFUSED = "refused"
    REFUSED_BY_CAREGIVER = "refused-by-caregiver"
    PLEASE_PUT_BACK = "please-put-back"
    I_PUT_BACK = "i-put-back"
    HELP_COMES = "help-comes"
    ONE_AT_A_TIME = "one-at-a-time"
    UNKNOWN_TOKEN = "unknown-token"
    # help
    ENCOURAGE = "encourage"
    REMIND = "remind"
    LOOK_AT_ROW = "look-at-row"
    ONE_OF_THESE = "one-of-these"
    THIS_ONE = "this-one"
    TOGETHER = "together"
    I_PLACE = "i-place"
    I_CANNOT = "i-cannot"
    I_AM_HERE = "i-am-here"
    # teaching
    SHOW_ME = "show-me"
    SEEN = "seen"
    SHOW_ANOTHER = "show-another"
    CLEAR_THE_ROW = "clear-the-row"
    TAKEN_BACK = "taken-back"
    NOTHING_SHOWN = "nothing-shown"
    FORGOTTEN = "forgotten"
    UNDERSTOOD = "understood"
    NOT_CLEAR = "not-clear"
    LEARNED = "learned"
    THANKS = "thanks"


class AskKey(Enum):
    """What the coach asks a caregiver for; one way each."""

    PUT_BACK = "put-back"
    CHECK_BOARD = "check-board"
    PLACE = "place"
    NO_WAY_ON = "no-way-on"
    LONG_SILENCE = "long-silence"
    DEMONSTRATION = "demonstration"
