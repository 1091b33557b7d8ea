"""The keys of what the commands on the record say."""

from __future__ import annotations

from enum import Enum


class RecordKey(Enum):
    """A sentence about the record; each language has each."""

    SOUND = "sound"
    RECOVERED = "recovered"
    NOT_SOUND = "not-sound"
    BROKEN_CHAIN = "broken-chain"
    GAP = "gap"
    NOT_AS_SIGNED = "not-as-signed"
    CUT_OFF = "cut-off"
    BAD_HEAD = "bad-head"
    NO_HEAD = "no-head"
    BACKED_UP = "backed-up"
    RESTORED = "restored"
    LEFT_OUT = "left-out"
    ASK_NAME = "ask-name"
    ASK_ERASE = "ask-erase"
    YES = "yes"
    """What may be answered, with blanks between."""
    ERASED = "erased"
