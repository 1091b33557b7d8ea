"""The guided session's questions: what `maestra teach` asks, before the user plays."""

from dataclasses import replace

from maestra.cli.demo_stages import Asking, Taught
from maestra.cli.lesson import Speech
from maestra.cli.outputs import Output, Said, Tone
from maestra.cli.teach_telling import asking as told_asking
from maestra.cli.teach_telling import ended
from maestra.cli.teach_words import event_typed
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey
from maestra.learning.dialogue import Finished, step


def asked(stage: Asking, speech: Speech) -> tuple[Output, ...]:
    """What is asked now, or what it came to when nothing is."""
    teacher = _teacher(stage.taught, speech)
    match stage.dialogue.ask:
        case Finished() as end:
            taught = answered(stage)
            exercise = taught.ruled if taught.shown else None
            return tuple(ended(stage.dialogue, end, exercise, teacher))
        case _:
            return tuple(told_asking(stage.dialogue, teacher))


def replied(stage: Asking, line: str, speech: Speech) -> tuple[Asking, tuple[Output, ...]]:
    """The stage after a reply, and what is asked next."""
    teacher = _teacher(stage.taught, speech)
    event = event_typed(line, stage.dialogue, teacher)
    if event is None:
        return stage, (Said(teacher.say(TeachKey.NOT_UNDERSTOOD), Tone.WRONG),)
    after = replace(stage, dialogue=step(stage.dialogue, event))
    return after, asked(after, speech)


def answered(stage: Asking) -> Taught:
    """What was taught, with what was replied; nothing that was taken back is left of it."""
    dialogue = stage.dialogue
    shown = tuple(dialogue.demonstrations[k] for k in dialogue.counting)
    return replace(stage.taught, shown=shown, answers=dialogue.answers)


def _teacher(taught: Taught, speech: Speech) -> Teacher:
    subject = taught.subject
    return Teacher(speech.language, subject.board, subject.deck, speech.words)
