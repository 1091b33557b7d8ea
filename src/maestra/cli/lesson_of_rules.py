"""An exercise made of rules, as JSON and as lines to read: honest about what is not sure."""

from collections.abc import Iterator, Sequence
from typing import Final, assert_never

from maestra.cli.lesson import Speech
from maestra.language import conjunction_sentences, rule_sentences
from maestra.language.terminal import TerminalKey
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.rule import Rule

MAX_ALTERNATIVES: Final = 3
"""Said in words; JSON has them all."""


def ruled_json(exercise: RuledExercise, speech: Speech) -> dict[str, object]:
    """The rules with their ids, the alternatives, and what learning came to."""
    sentences = rule_sentences(exercise, speech.language, speech.words)
    confidences = [one.confidence for one in exercise.rules]
    return {
        "status": exercise.status.value,
        "confidence": exercise.confidence,
        "rules": [
            {"id": one.id, "text": one.text, "confidence": confidence}
            for one, confidence in zip(sentences, confidences, strict=True)
        ],
        "alternatives": [
            {"text": _paragraph(exercise, other.rules, speech), "weight": other.weight}
            for other in exercise.alternatives
        ],
    }


def ruled_lines(exercise: RuledExercise, speech: Speech) -> Iterator[str]:
    """The rules as one paragraph, then how sure they are, and what else may be meant."""
    yield _paragraph(exercise, exercise.conjunction, speech)
    yield ""
    yield _how_sure(exercise, speech)
    if exercise.status in (LearnStatus.LEARNED, LearnStatus.TOLD):
        return
    if exercise.status is LearnStatus.OUTSIDE:
        yield f"- {_paragraph(exercise, exercise.safe, speech)}"
        return
    for other in exercise.alternatives[:MAX_ALTERNATIVES]:
        yield f"- {_paragraph(exercise, other.rules, speech)}"


def _how_sure(exercise: RuledExercise, speech: Speech) -> str:
    percent = round(100 * exercise.confidence)
    match exercise.status:
        case LearnStatus.LEARNED:
            return speech.say(TerminalKey.SURE, percent=percent)
        case LearnStatus.AMBIGUOUS if not exercise.alternatives:
            return speech.say(TerminalKey.NOT_SURE, percent=percent)
        case LearnStatus.AMBIGUOUS:
            return speech.say(TerminalKey.COULD_ALSO_BE, percent=percent)
        case LearnStatus.OUTSIDE:
            return speech.say(TerminalKey.NO_SIMPLE_RULE)
        case LearnStatus.CONTRADICTORY:
            return speech.say(TerminalKey.DOES_NOT_FIT)
        case LearnStatus.TOLD:
            return speech.say(TerminalKey.TOLD)
        case _:
            assert_never(exercise.status)


def _paragraph(exercise: RuledExercise, rules: Sequence[Rule], speech: Speech) -> str:
    """Some rules about the exercise's tokens, one sentence after the other."""
    if not rules:
        return speech.say(TerminalKey.NO_RULE)
    return " ".join(conjunction_sentences(exercise, rules, speech.language, speech.words))
