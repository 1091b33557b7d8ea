"""The guided session's way to the coach: which exercise a patient plays, and what is kept."""

from typing import Final

from maestra.cli.demo_stages import SUBJECTS, Accompanying, Choosing, Playing, Teaching
from maestra.cli.demo_words import Accompany
from maestra.cli.lesson import Speech
from maestra.cli.outputs import Outputs, Said, Tone
from maestra.language.terminal import TerminalKey as Key
from maestra.rules.exercise import Exercise
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.paper_rules import paper_exercise

EXAMPLE: Final = 2
"""The exercise that examples name."""
NICKNAME: Final = "anna"
"""The patient that examples name."""


def accompanied(
    stage: Choosing | Teaching | Playing, wanted: Accompany, speech: Speech
) -> tuple[Choosing | Teaching | Playing | Accompanying, Outputs]:
    """The stage in which the patient plays, or the one before and why they cannot."""
    found = _exercise(stage, wanted.number, speech)
    if isinstance(found, Said):
        return stage, (found,)
    name, exercise = found
    return Accompanying(name, exercise, wanted.patient, stage), (_kept(wanted, speech),)


def _exercise(
    stage: Choosing | Teaching | Playing, number: int | None, speech: Speech
) -> tuple[str, Exercise] | Said:
    """The exercise of the menu with its name, or the rules of the one that was taught.

    Rules, however it was learned: actions learned from a few plays fit few arrangements.
    """
    if number is not None:
        return _of_the_menu(number, speech)
    if isinstance(stage, Choosing):
        return Said(speech.say(Key.PLEASE_CHOOSE, last=len(PAPER_EXERCISES)))
    if not stage.taught.shown:
        return Said(speech.say(Key.NOTHING_SHOWN))
    return stage.taught.subject.title.value, stage.taught.ruled


def _of_the_menu(number: int, speech: Speech) -> tuple[str, Exercise] | Said:
    if not 1 <= number <= len(SUBJECTS):
        return Said(speech.say(Key.PLEASE_CHOOSE, last=len(PAPER_EXERCISES)))
    name = SUBJECTS[number - 1].title.value
    if name not in PAPER_EXERCISES:
        return Said(speech.say(Key.CANNOT_SHOW))
    return name, paper_exercise(name)


def _kept(wanted: Accompany, speech: Speech) -> Said:
    """Whether what is played is kept, and how to have it kept."""
    if wanted.patient is not None:
        return Said(speech.say(Key.KEPT, patient=wanted.patient), Tone.ASIDE)
    typed = speech.say(Key.TYPE_ACCOMPANY)
    if wanted.number is not None:
        typed = f"{typed} {wanted.number}"
    said = speech.say(Key.NOT_KEPT, accompany=typed, patient=NICKNAME)
    return Said(said, Tone.ASIDE)
