"""What is said and drawn of a dialogue: the same words for the terminal and for programs."""

from collections.abc import Iterator

from maestra.cli.lesson_of_rules import ruled_lines
from maestra.cli.outputs import Drawn, Output, Said, Tone
from maestra.cli.taught_lesson import speech_of, understood
from maestra.core.demonstration import Demonstration
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey as Key
from maestra.learning.contradictions import Contradiction, Moment, Shown, Understood
from maestra.learning.contradictions import Said as SaidBefore
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    Dialogue,
    Finished,
)
from maestra.rules.answers import MoveQuestion, Question, RowQuestion, RuleQuestion
from maestra.rules.exercise import RuledExercise
from maestra.rules.setting import Play, play_of


def question_text(dialogue: Dialogue, teacher: Teacher) -> str:
    """What is asked, in one sentence or two."""
    match dialogue.ask:
        case AskQuestion(question):
            return teacher.question(question)
        case AskAgain(contradiction, question):
            earlier, later = moments(dialogue, contradiction, teacher)
            asked = teacher.question(question)
            return teacher.say(Key.ASK_AGAIN, earlier=earlier, later=later, question=asked)
        case AskCell():
            return teacher.say(Key.WHICH_IS_WRONG)
        case AskSlip(slip):
            play = play_of(dialogue.demonstrations[slip.demonstration])
            number, rules = slip.demonstration + 1, dialogue.lesson.rules
            return teacher.slip(number, play, slip.move, rules)
        case AskWhichCounts():
            return teacher.say(Key.WHICH_COUNTS)
        case Finished():
            return ""


def moments(dialogue: Dialogue, contradiction: Contradiction, teacher: Teacher) -> tuple[str, str]:
    """The two moments in words, the earlier first."""
    later = dialogue.answers[contradiction.later.answer]
    return _moment(dialogue, contradiction, teacher), teacher.said(later)


def _moment(dialogue: Dialogue, contradiction: Contradiction, teacher: Teacher) -> str:
    earlier: Moment = contradiction.earlier
    match earlier:
        case Shown(number):
            play = play_of(dialogue.demonstrations[number])
            against = dialogue.answers[contradiction.later.answer]
            return teacher.shown(number + 1, play, against)
        case SaidBefore(number):
            return teacher.said(dialogue.answers[number])
        case Understood():
            return teacher.understood(dialogue.lesson.rules)


def asked_play(question: Question) -> Play | None:
    """The play to show with a question: the finished one, or where the move is to be made."""
    match question:
        case RowQuestion(play):
            return play
        case MoveQuestion(position):
            return position
        case RuleQuestion():
            return None


def as_demonstration(play: Play) -> Demonstration:
    """A play as the board saw it."""
    return Demonstration(play.setting.deck, play.setting.start, play.moves())


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
