"""A session's screen: a terminal, or what is piped in and out."""

import contextlib
import importlib
import select
import sys
from collections.abc import Iterator
from typing import Final

from rich.console import Console
from rich.text import Text

from maestra.cli.drawing import Look, draw, strokes_for
from maestra.cli.outputs import Drawn, Output, Said, Tone

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


class Screen:
    """Where the session is shown and typed."""

    def __init__(self, goal: str) -> None:
        """Draw boards with `goal` beside the goal row."""
        self._goal = goal
        self._console = Console(highlight=False, soft_wrap=True)
        self._strokes = strokes_for(sys.stdout.encoding)
        self._is_asking = False

    def show(self, outputs: tuple[Output, ...]) -> None:
        """Say and draw; not behind a prompt."""
        if self._is_asking and outputs:
            self._console.print()
            self._is_asking = False
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

    def line_within(self, seconds: float | None) -> str | None:
        """The line that is typed at the terminal until then; None when none was.

        Raises:
            EOFError: nothing more is typed.
        """
        if not self._is_asking:
            self._console.print(PROMPT, end="")
            self._is_asking = True
        try:
            # The terminal hands over whole lines.
            if not select.select([sys.stdin], [], [], seconds)[0]:
                return None
            line = sys.stdin.readline()
        except KeyboardInterrupt:
            self._console.print()
            raise
        except UnicodeDecodeError:
            line = "?\n"
        self._is_asking = False
        if not line:
            self._console.print()
            raise EOFError
        return line.rstrip("\n")

    def _draw(self, drawn: Drawn) -> None:
        for pieces in draw(drawn.state, drawn.deck, self._goal, self._strokes):
            self._console.print(Text.assemble(*((text, _LOOKS[look]) for text, look in pieces)))
