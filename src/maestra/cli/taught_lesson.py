"""What a few-shot lesson came to, as JSON and as lines to read: for `learn` and `teach`."""

from collections.abc import Iterator, Sequence
from typing import Final

from maestra.cli.outputs import Output, Said, Tone
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey as Key
from maestra.learning.fewshot.lesson import Lesson
from maestra.rules.exercise import LearnStatus
from maestra.rules.setting import play_of

MAX_MAYBE: Final = 3
"""Alternatives that a person reads; a program gets all."""
MIN_WEIGHT: Final = 0.05
"""An alternative that is less likely than that is not worth a sentence."""
_DIGITS: Final = 4
"""Of a confidence in JSON."""


def lesson_json(
    lesson: Lesson,
    status: LearnStatus,
    teacher: Teacher,
    seconds: float,
    counting: Sequence[int] | None = None,
) -> dict[str, object]:
    """The lesson as `learn --json` prints it.

    Args:
        lesson: what was learned.
        status: what it came to in the end.
        teacher: who says it.
        seconds: how long it took.
        counting: the numbers of the demonstrations that it was learned from; None: all.
    """
    return {
        "status": status.value,
        "rules": rules_json(lesson, teacher),
        "alternatives": [
            {
                "rules": [{"id": one.id, "text": one.text} for one in teacher.rules(other.rules)],
                "weight": _share(other.weight),
            }
            for other in lesson.alternatives
        ],
        "slips": slips_json(lesson, teacher, counting),
        "seconds": seconds,
        "confidence": _share(lesson.confidence),
        "demonstrations": len(lesson.demonstrations),
    }


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


def verdict(lesson: Lesson, status: LearnStatus, teacher: Teacher) -> Iterator[Output]:
    """How sure it is in the end, and what else it may be."""
    match status:
        case LearnStatus.LEARNED | LearnStatus.TOLD:
            yield Said(teacher.say(Key.SURE), Tone.GOOD)
        case LearnStatus.AMBIGUOUS:
            yield Said(teacher.say(Key.NOT_SURE), Tone.WRONG)
            likely = [one for one in lesson.alternatives if one.weight >= MIN_WEIGHT]
            if likely:
                yield Said(teacher.say(Key.MAYBE))
            for other in likely[:MAX_MAYBE]:
                text = " ".join(teacher.rule(rule) for rule in other.rules)
                yield Said(f"  - {text} ({min(other.weight, 1):.0%})", Tone.ASIDE)
        case LearnStatus.OUTSIDE:
            yield Said(teacher.say(Key.OUTSIDE), Tone.WRONG)
        case LearnStatus.CONTRADICTORY:
            yield Said(teacher.say(Key.CONTRADICTORY), Tone.WRONG)


def _share(share: float) -> float:
    return round(min(share, 1.0), _DIGITS)
