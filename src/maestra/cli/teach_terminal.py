"""`maestra teach` on the terminal: what is understood, a board, one question, a word typed."""

from collections.abc import Iterator

from maestra.cli.outputs import Drawn, Output, Said, Tone
from maestra.cli.screen import Screen
from maestra.cli.teach_telling import asking, ended
from maestra.cli.teach_words import event_typed, row_typed, word_typed
from maestra.core.demonstration import Demonstration
from maestra.language.phrases import Joint, Listing, Named
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey as Key
from maestra.language.terminal import TerminalKey, terminal_sentence
from maestra.learning.dialogue import AskSlip, Dialogue, Enough, Event, Finished, ShownAgain
from maestra.rules.exercise import RuledExercise

_MENDING = (Key.TYPE_YES, Key.TYPE_NO, Key.TYPE_AGAIN, Key.TYPE_ENOUGH)


class TeachTerminal:
    """Asks a person."""

    def __init__(self, teacher: Teacher) -> None:
        """Speak as `teacher`."""
        self._teacher = teacher
        self._screen = Screen(terminal_sentence(TerminalKey.GOAL, teacher.language))
        self._lines = self._screen.lines()

    def event(self, dialogue: Dialogue) -> Event:
        """What the person does about what is asked; the end of input is enough."""
        self._show(asking(dialogue, self._teacher))
        for line in self._lines:
            if isinstance(dialogue.ask, AskSlip) and self._means_again(line):
                shown = self._shown_again(dialogue.demonstrations[dialogue.ask.slip.demonstration])
                return Enough() if shown is None else ShownAgain(shown)
            event = event_typed(line, dialogue, self._teacher)
            if event is not None:
                return event
            if line.strip():
                self._show([Said(self._teacher.say(Key.NOT_UNDERSTOOD), Tone.WRONG)])
        return Enough()

    def finish(
        self,
        dialogue: Dialogue,
        end: Finished,
        exercise: RuledExercise | None,
        seconds: float,  # noqa: ARG002 - only programs are told how long it took
    ) -> None:
        """Say what it came to."""
        self._show(ended(dialogue, end, exercise, self._teacher))

    def _means_again(self, line: str) -> bool:
        return word_typed(line, _MENDING, self._teacher.language) is Key.TYPE_AGAIN

    def _shown_again(self, like: Demonstration) -> Demonstration | None:
        """The demonstration played again; None at the end of input."""
        example = Listing(tuple(Named(t.attributes) for t in like.deck.tokens[:3]), Joint.COMMA)
        how = Said(self._teacher.say(Key.HOW_TO_SHOW_AGAIN, tokens=example), Tone.ASIDE)
        self._show([Drawn(like.start, like.deck), how])
        for line in self._lines:
            shown = row_typed(line, like)
            if isinstance(shown, Demonstration):
                return shown
            if shown is None:
                self._show([how])
            else:
                text = self._teacher.say(Key.NO_TOKEN, token=shown)
                self._show([Said(text, Tone.WRONG)])
        return None

    def _show(self, outputs: "Iterator[Output] | list[Output]") -> None:
        self._screen.show(tuple(outputs))
