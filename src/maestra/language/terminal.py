"""What the commands and the session in the terminal say, besides rules and reasons."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from maestra.language.ca.terminal import FEATURES as FEATURES_CA
from maestra.language.ca.terminal import SENTENCES as SENTENCES_CA
from maestra.language.en.terminal import FEATURES as FEATURES_EN
from maestra.language.en.terminal import SENTENCES as SENTENCES_EN
from maestra.language.es.terminal import FEATURES as FEATURES_ES
from maestra.language.es.terminal import SENTENCES as SENTENCES_ES

if TYPE_CHECKING:
    from maestra.language import Language


class TerminalKey(Enum):
    """A sentence, a heading or a word to type."""

    # learn and explain
    LEARNED = "learned"
    WRITTEN = "written"
    STILL_NARROW = "still-narrow"
    SURE = "sure"
    NOT_SURE = "not-sure"
    COULD_ALSO_BE = "could-also-be"
    NO_SIMPLE_RULE = "no-simple-rule"
    DOES_NOT_FIT = "does-not-fit"
    TOLD = "told"
    NO_RULE = "no-rule"
    SHOW_NEXT = "show-next"
    PLANNED = "planned"
    NOT_UNDERSTOOD = "not-understood"
    COULD_SAY = "could-say"
    SEVERAL_MEANINGS = "several-meanings"
    CANNOT_KEEP = "cannot-keep"
    BEFORE = "before"
    AFTER = "after"
    TIMES_SHOWN = "times-shown"
    # features
    OF_CELLS = "of-cells"
    OF_TOKENS = "of-tokens"
    OF_PAIRS = "of-pairs"
    RELATION = "relation"
    # the session: choosing
    WELCOME = "welcome"
    WHICH_EXERCISE = "which-exercise"
    ODD_ASCENDING = "odd-ascending"
    ASCENDING = "ascending"
    DESCENDING = "descending"
    FIRST_ROW = "first-row"
    CURIE = "curie"
    LETTERS = "letters"
    OWN_NUMBERS = "own-numbers"
    OWN_LETTERS = "own-letters"
    PLEASE_CHOOSE = "please-choose"
    HOW_TO_TEACH = "how-to-teach"
    HOW_TO_ACCOMPANY = "how-to-accompany"
    # accompanying
    KEPT = "kept"
    NOT_KEPT = "not-kept"
    REST = "rest"
    # teaching
    TEACH = "teach"
    HOW_TO_MOVE = "how-to-move"
    HOW_TO_SHOW = "how-to-show"
    NTH_DEMONSTRATION = "nth-demonstration"
    I_MOVE = "i-move"
    UNDERSTOOD = "understood"
    AND_MORE = "and-more"
    ALL_CLEAR = "all-clear"
    NOTHING_SHOWN = "nothing-shown"
    NOTHING_MOVED = "nothing-moved"
    NOTHING_TO_UNDO = "nothing-to-undo"
    CANNOT_SHOW = "cannot-show"
    NEXT_STEP = "next-step"
    # playing
    YOUR_TURN = "your-turn"
    RIGHT = "right"
    PUT_BACK = "put-back"
    COMPLETE = "complete"
    NOT_YET = "not-yet"
    HINT = "hint"
    NO_HINT = "no-hint"
    # any time
    UNKNOWN_COMMAND = "unknown-command"
    UNKNOWN_TOKEN = "unknown-token"
    NO_SUCH_COLUMN = "no-such-column"
    TAKEN = "taken"
    ALREADY_THERE = "already-there"
    ROW_IS_FULL = "row-is-full"
    HELP_TEACHING = "help-teaching"
    HELP_PLAYING = "help-playing"
    HELP_SESSION = "help-session"
    HELP_CHOOSING = "help-choosing"
    GOODBYE = "goodbye"
    GOAL = "goal"
    # what is typed
    TYPE_UNDO = "type-undo"
    TYPE_DONE = "type-done"
    TYPE_SHOW = "type-show"
    TYPE_PLAY = "type-play"
    TYPE_TEACH = "type-teach"
    TYPE_MENU = "type-menu"
    TYPE_HINT = "type-hint"
    TYPE_ACCOMPANY = "type-accompany"
    TYPE_HELP = "type-help"
    TYPE_QUIT = "type-quit"


_SENTENCES: Final[Mapping[str, Mapping[str, str]]] = MappingProxyType(
    {"en": SENTENCES_EN, "es": SENTENCES_ES, "ca": SENTENCES_CA}
)
_FEATURES: Final[Mapping[str, Mapping[str, str]]] = MappingProxyType(
    {"en": FEATURES_EN, "es": FEATURES_ES, "ca": FEATURES_CA}
)


def terminal_sentence(key: TerminalKey, language: Language, **parts: object) -> str:
    """The sentence with its parts filled in.

    Raises:
        KeyError: a part that the sentence needs is missing.
    """
    return _SENTENCES[language.value][key.value].format(**parts)


def feature_words(name: str, language: Language) -> str:
    """What a feature says, by the name that `select_features` takes (a parameter is ``K``)."""
    words = _FEATURES[language.value].get(name)
    if words is not None:
        return words
    return terminal_sentence(TerminalKey.RELATION, language, name=name)
