"""What a person types in the session: a command, or a token and a column."""

import re
from dataclasses import dataclass
from enum import Enum
from typing import Final, TypeAlias

from maestra.language import Language
from maestra.language.terminal import TerminalKey, terminal_sentence

MAX_DIGITS: Final = 4
"""Of a number that is typed; what is longer is no number of ours."""


class Word(Enum):
    """A command, by the key of what is typed for it."""

    UNDO = TerminalKey.TYPE_UNDO
    DONE = TerminalKey.TYPE_DONE
    SHOW = TerminalKey.TYPE_SHOW
    PLAY = TerminalKey.TYPE_PLAY
    TEACH = TerminalKey.TYPE_TEACH
    MENU = TerminalKey.TYPE_MENU
    HINT = TerminalKey.TYPE_HINT
    HELP = TerminalKey.TYPE_HELP
    QUIT = TerminalKey.TYPE_QUIT


@dataclass(frozen=True, slots=True)
class Command:
    """A word to act on, and how many times."""

    word: Word
    count: int = 1


@dataclass(frozen=True, slots=True)
class Wish:
    """A token, as it was typed, and the column it shall go to; None: the first empty one."""

    token: str
    column: int | None


@dataclass(frozen=True, slots=True)
class Accompany:
    """To accompany a patient, with the exercise of this number or the one that was taught."""

    number: int | None
    patient: str | None
    """Who plays, if it was said."""


@dataclass(frozen=True, slots=True)
class Unclear:
    """Neither."""


Typed: TypeAlias = Command | Wish | Unclear


def understand(line: str, language: Language) -> Typed:
    """What was typed; commands are known in `language` and in English."""
    text = " ".join(line.casefold().split())
    counted = re.fullmatch(rf"(.*\D) ?(\d{{1,{MAX_DIGITS}}})", text)
    for tongue in (language, Language.EN):
        for word in Word:
            typed = terminal_sentence(word.value, tongue)
            if text in {typed, typed.split()[0]}:
                return Command(word)
            if counted and counted[1].strip() in {typed, typed.split()[0]}:
                return Command(word, int(counted[2]))
    parts = re.split(r"[\s,]+", text)
    match parts:
        case [token] if token:
            return Wish(token, None)
        case [token, column] | [token, _, column] if _is_number(column):
            return Wish(token, int(column))
        case _:
            return Unclear()


def accompany_typed(line: str, language: Language) -> Accompany | None:
    """What was typed to accompany a patient; None when something else was."""
    first, *rest = line.split() or [""]
    words = {terminal_sentence(TerminalKey.TYPE_ACCOMPANY, one) for one in (language, Language.EN)}
    if first.casefold() not in words:
        return None
    match rest:
        case []:
            return Accompany(None, None)
        case [number] if _is_number(number):
            return Accompany(int(number), None)
        case [patient]:
            return Accompany(None, patient)
        case [number, patient] if _is_number(number):
            return Accompany(int(number), patient)
        case _:
            return None


def _is_number(text: str) -> bool:
    return text.isascii() and text.isdecimal() and len(text) <= MAX_DIGITS
