"""`maestra demo`: the guided session on a terminal, or on what is piped into it."""

import contextlib
import importlib
import os
import random
import sys
from collections.abc import Iterator
from typing import Final

from rich.console import Console
from rich.text import Text

from maestra.cli.demo_session import begin, end, step
from maestra.cli.demo_stages import Drawn, Ended, Output, Said, Tone
from maestra.cli.drawing import Look, draw, strokes_for
from maestra.cli.lesson import Speech
from maestra.language import NO_LEXICON, Language
from maestra.language.terminal import TerminalKey

PROMPT: Final = "> "
_LOOKS: Final = {
    Look.LINE: "",
    Look.GOAL: "on grey93",
    Look.STORAGE: "on blue",
    Look.TOKEN: "bold black on bright_yellow",
    Look.NOTE: "",
}
_TONES: Final = {
    Tone.PLAIN: "",
    Tone.HEADING: "bold",
    Tone.GOOD: "green",
    Tone.WRONG: "yellow",
    Tone.NEW: "bold cyan",
    Tone.ASIDE: "italic",
}
_MAX_CHANCE: Final = 2**32


def play(language: str | None, seed: int | None) -> None:
    """Lead the session until its end or the end of what is typed."""
    speech = Speech(own_language() if language is None else Language(language), NO_LEXICON)
    chance = random.Random(seed)  # noqa: S311 - it deals tokens
    screen = _Screen(speech)
    stage, outputs = begin(speech)
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


class _Screen:
    """Where the session is shown and typed."""

    def __init__(self, speech: Speech) -> None:
        self._goal = speech.say(TerminalKey.GOAL)
        self._console = Console(highlight=False, soft_wrap=True)
        self._strokes = strokes_for(sys.stdout.encoding)

    def show(self, outputs: tuple[Output, ...]) -> None:
        """Say and draw."""
        for output in outputs:
            if isinstance(output, Said):
                if output.tone is Tone.HEADING:
                    self._console.print()
                self._console.print(Text(output.text, style=_TONES[output.tone]))
            else:
                self._draw(output)

    def lines(self) -> Iterator[str]:
        """What is typed, line by line, to the end."""
        if sys.stdin.isatty():
            # Once it is loaded, input() lets a line be edited.
            with contextlib.suppress(ImportError):
                importlib.import_module("readline")
        while True:
            try:
                line = input(PROMPT)
            except EOFError:
                self._console.print()
                return
            except KeyboardInterrupt:
                # The shell's prompt shall not stand behind ours.
                self._console.print()
                raise
            except UnicodeDecodeError:
                line = "?"
            if not sys.stdin.isatty():
                # A terminal shows what is typed; a transcript shall too.
                self._console.print(Text(line))
            yield line

    def _draw(self, drawn: Drawn) -> None:
        for pieces in draw(drawn.state, drawn.deck, self._goal, self._strokes):
            self._console.print(Text.assemble(*((text, _LOOKS[look]) for text, look in pieces)))
