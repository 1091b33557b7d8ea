"""`maestra demo`: the guided session on a terminal, or on what is piped into it."""

import random
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Final

from maestra.cli.demo_session import begin, come_back, end, step
from maestra.cli.demo_stages import Accompanying, Ended
from maestra.cli.lesson import Speech
from maestra.cli.outputs import Said, Tone
from maestra.cli.own_language import own_language
from maestra.cli.playing import Wanted, accompany
from maestra.cli.screen import Screen
from maestra.core.faults import InvalidError
from maestra.language import NO_LEXICON, Language
from maestra.language.terminal import TerminalKey

NOBODY: Final = "nobody"
"""The pseudonym in a record that is thrown away."""
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
        if isinstance(stage, Accompanying):
            _accompany(stage, language, chance.randrange(_MAX_CHANCE), screen)
            stage, outputs = come_back(stage, speech)
            screen.show(outputs)
        if isinstance(stage, Ended):
            return
    screen.show(end(speech)[1])


def _accompany(stage: Accompanying, language: str | None, seed: int, screen: Screen) -> None:
    """Let the coach lead a session: kept for a patient who was named, else for nobody."""
    wanted = Wanted(
        stage.name,
        stage.patient or NOBODY,
        settings=None,
        language=language,
        seed=seed,
        record=None,
        data=None,
        keys=None,
        speak=sys.stdin.isatty(),
    )
    try:
        if stage.patient is not None:
            accompany(stage.exercise, wanted)
            return
        with tempfile.TemporaryDirectory() as folder:
            data, keys = (str(Path(folder, name)) for name in ("data", "keys"))
            accompany(stage.exercise, replace(wanted, data=data, keys=keys))
    except InvalidError as error:
        screen.show((Said(str(error), Tone.WRONG),))
