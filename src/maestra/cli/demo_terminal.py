"""`maestra demo`: the guided session on a terminal, or on what is piped into it."""

import contextlib
import os
import random
from typing import Final

from maestra.cli.demo_session import begin, end, step
from maestra.cli.demo_stages import Ended
from maestra.cli.lesson import Speech
from maestra.cli.screen import Screen
from maestra.language import NO_LEXICON, Language
from maestra.language.terminal import TerminalKey

_MAX_CHANCE: Final = 2**32


def play(language: str | None, seed: int | None, *, by_few: bool) -> None:
    """Lead the session until its end or the end of what is typed."""
    speech = Speech(own_language() if language is None else Language(language), NO_LEXICON)
    chance = random.Random(seed)  # noqa: S311 - it deals tokens
    screen = Screen(speech.say(TerminalKey.GOAL))
    stage, outputs = begin(speech, by_few=by_few)
    screen.show(outputs)
    for line in screen.lines():
        stage, outputs = step(stage, line, chance.randrange(_MAX_CHANCE), speech)
        screen.show(outputs)
        if isinstance(stage, Ended):
            return
    screen.show(end(speech)[1])


def own_language() -> Language:
    """The language of the user's environment, or English."""
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if value := os.environ.get(variable):
            with contextlib.suppress(ValueError):
                return Language(value[:2].lower())
            break
    return Language.EN
