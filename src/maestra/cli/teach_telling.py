"""What is said and drawn of a dialogue: the same words for the terminal and for programs."""

from collections.abc import Iterator

from maestra.cli.lesson_of_rules import ruled_lines
from maestra.cli.outputs import Drawn, Output, Said, Tone
from maestra.cli.taught_lesson import speech_of, understood
from maestra.coaching.asking import as_demonstration, asked_play, moments, question_text
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey as Key
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    Dialogue,
    Finished,
)
from maestra.rules.exercise import RuledExercise
from maestra.rules.setting import Play


def drawn(play: Play) -> Drawn:
    """What lies where at the end of a play."""
    return Drawn(as_demonstration(play).end, play.setting.deck)


def asking(dialogue: Dialogue, teacher: Teacher) -> Iterator[Output]:
    """What a person reads before the next reply."""
    text = Said(question_text(dialogue, teacher), Tone.HEADING)
    match dialogue.ask:
        case AskQuestion(question):
            yield from understood(dialogue.lesson, teacher)
            play = asked_play(question)
            if play is not None:
                yield drawn(play)
            yield text
            yield how_to(teacher, Key.HOW_TO_REPLY)
        case AskCell():
            yield text
            yield how_to(teacher, Key.HOW_TO_NAME)
        case AskSlip(slip):
            shown = dialogue.demonstrations[slip.demonstration]
            yield Drawn(shown.end, shown.deck)
            yield text
            yield how_to(teacher, Key.HOW_TO_MEND)
        case AskWhichCounts(contradiction) | AskAgain(contradiction, _):
            earlier, later = moments(dialogue, contradiction, teacher)
            yield Said(teacher.say(Key.DISAGREE), Tone.WRONG)
            yield Said(f"  1  {earlier}")
            yield Said(f"  2  {later}")
            yield text
            yield how_to(teacher, Key.HOW_TO_PICK)
        case Finished():
            return


def ended(
    dialogue: Dialogue, end: Finished, exercise: RuledExercise | None, teacher: Teacher
) -> Iterator[Output]:
    """What a person reads when nothing more is asked; None: nothing is left to learn from."""
    if exercise is None:
        yield Said(teacher.say(Key.NOTHING_LEFT), Tone.WRONG)
        return
    yield Said(teacher.say(Key.NOW), Tone.HEADING)
    yield from (Said(line) for line in ruled_lines(exercise, speech_of(teacher)))
    for contradiction in end.unsettled:
        yield Said(teacher.say(Key.DISAGREE), Tone.WRONG)
        yield from (Said(f"- {one}") for one in moments(dialogue, contradiction, teacher))


def how_to(teacher: Teacher, key: Key) -> Said:
    """What can be typed now."""
    words = {
        name.name.removeprefix("TYPE_").lower(): teacher.say(name)
        for name in Key
        if name.name.startswith("TYPE_")
    }
    return Said(teacher.say(key, **words), Tone.ASIDE)
