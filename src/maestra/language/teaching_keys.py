"""The keys of what is said while a caregiver teaches by demonstrations and answers."""

from __future__ import annotations

from enum import Enum


class TeachKey(Enum):
    """A sentence or a word to type; each language has a template for each."""

    # questions
    IS_ROW_RIGHT = "is-row-right"
    IS_ROW_RIGHT_IN_TIME = "is-row-right-in-time"
    IS_EMPTY_ROW_RIGHT = "is-empty-row-right"
    IS_MOVE_RIGHT = "is-move-right"
    IS_FIRST_MOVE_RIGHT = "is-first-move-right"
    IS_RULE_MEANT = "is-rule-meant"
    WHICH_IS_WRONG = "which-is-wrong"
    # a likely mistake
    MEANT_TO_COME_BEFORE = "meant-to-come-before"
    MEANT_IN_ROW = "meant-in-row"
    MEANT_THERE = "meant-there"
    # two moments that cannot both be
    DISAGREE = "disagree"
    SHOWN_ROW = "shown-row"
    SHOWN_BEFORE = "shown-before"
    UNDERSTOOD_RULES = "understood-rules"
    SAID_ROW_RIGHT = "said-row-right"
    SAID_ROW_WRONG = "said-row-wrong"
    SAID_MOVE_RIGHT = "said-move-right"
    SAID_MOVE_WRONG = "said-move-wrong"
    SAID_RULE_MEANT = "said-rule-meant"
    SAID_RULE_NOT_MEANT = "said-rule-not-meant"
    WHICH_COUNTS = "which-counts"
    ASK_AGAIN = "ask-again"
    # what it comes to
    SO_FAR = "so-far"
    NO_RULE_YET = "no-rule-yet"
    NOTHING_LEFT = "nothing-left"
    SAVED = "saved"
    # what can be typed
    HOW_TO_REPLY = "how-to-reply"
    HOW_TO_NAME = "how-to-name"
    HOW_TO_MEND = "how-to-mend"
    HOW_TO_PICK = "how-to-pick"
    HOW_TO_SHOW_AGAIN = "how-to-show-again"
    NOT_UNDERSTOOD = "not-understood"
    NO_TOKEN = "no-token"
    TYPE_YES = "type-yes"
    TYPE_NO = "type-no"
    TYPE_UNSURE = "type-unsure"
    TYPE_ENOUGH = "type-enough"
    TYPE_AGAIN = "type-again"
    TYPE_NEITHER = "type-neither"
    # the exam
    EXAM = "exam"
    NTH_PLAY = "nth-play"
    AGREED = "agreed"
    BOUND = "bound"
    NEAR_MISSES = "near-misses"
    NOTHING_EXAMINED = "nothing-examined"
    NOW = "now"
    CHANGED = "changed"
    UNCHANGED = "unchanged"
    ONLY_TOLD = "only-told"
    EXAMINE_AGAIN = "examine-again"
