"""What a few-shot lesson came to, as JSON and as lines to read: for `learn` and `teach`."""

from collections.abc import Iterator, Sequence
from typing import Final

from maestra.cli.lesson import Speech
from maestra.cli.lesson_of_rules import ruled_json
from maestra.cli.outputs import Output, Said, Tone
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey as Key
from maestra.learning.fewshot.lesson import Lesson
from maestra.rules.exercise import RuledExercise
from maestra.rules.setting import play_of

_DIGITS: Final = 4
"""Of a confidence in JSON."""


def lesson_json(
    exercise: RuledExercise,
    lesson: Lesson,
    teacher: Teacher,
    seconds: float,
    counting: Sequence[int] | None = None,
) -> dict[str, object]:
    """The lesson as `learn --json` prints it.

    Args:
        exercise: what it came to.
        lesson: what was learned.
        teacher: who says it.
        seconds: how long it took.
        counting: the numbers of the demonstrations that it was learned from; None: all.
    """
    return {
        **ruled_json(exercise, speech_of(teacher)),
        "slips": slips_json(lesson, teacher, counting),
        "seconds": seconds,
        "demonstrations": len(lesson.demonstrations),
    }


def speech_of(teacher: Teacher) -> Speech:
    """The same language and words, for what is said of any exercise."""
    return Speech(teacher.language, teacher.lexicon)


def rules_json(lesson: Lesson, teacher: Teacher) -> list[dict[str, object]]:
    """The rules with their confidences."""
    return [
        {"id": one.id, "text": one.text, "confidence": _share(sure)}
        for one, sure in zip(teacher.rules(lesson.rules), lesson.confidences, strict=True)
    ]


def slips_json(
    lesson: Lesson, teacher: Teacher, counting: Sequence[int] | None = None
) -> list[dict[str, object]]:
    """Likely mistakes, counted from 1, each with the question whether it was meant."""
    numbers = counting or range(len(lesson.demonstrations))
    return [
        {
            "demonstration": numbers[slip.demonstration] + 1,
            "move": slip.move + 1,
            "text": teacher.slip(
                numbers[slip.demonstration] + 1,
                play_of(lesson.demonstrations[slip.demonstration]),
                slip.move,
                lesson.rules,
            ),
        }
        for slip in lesson.slips
    ]


def understood(lesson: Lesson, teacher: Teacher) -> Iterator[Output]:
    """What is understood so far, a line a rule."""
    yield Said(teacher.say(Key.SO_FAR), Tone.HEADING)
    if not lesson.rules:
        yield Said(f"  {teacher.say(Key.NO_RULE_YET)}")
    for rule, sure in zip(lesson.rules, lesson.confidences, strict=True):
        yield Said(f"  {teacher.rule(rule)} ({min(sure, 1):.0%})")


def _share(share: float) -> float:
    return round(min(share, 1.0), _DIGITS)
