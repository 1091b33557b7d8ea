"""`maestra explain`: the rules of an exercise in words, and its actions one by one."""

from collections.abc import Iterator
from typing import assert_never

from maestra.cli.lesson import Speech, rule_lines, sentences_json
from maestra.cli.lesson_of_rules import ruled_json, ruled_lines
from maestra.cli.loading import exercise_in, words_in
from maestra.cli.streams import print_json, print_lines
from maestra.language import Language, explain_action
from maestra.language.terminal import TerminalKey
from maestra.rules.exercise import GroundedExercise, RuledExercise
from maestra.rules.strips.literals import formula
from maestra.rules.summaries.summary import summarise


def explain(
    exercise_file: str, language: str, words_file: str | None, *, detail: bool, as_json: bool
) -> None:
    """Print the rules of an exercise."""
    exercise = exercise_in(exercise_file)
    speech = Speech(Language(language), words_in(words_file))
    match exercise:
        case GroundedExercise():
            _explain_actions(exercise, speech, detail=detail, as_json=as_json)
        case RuledExercise() if as_json:
            print_json(ruled_json(exercise, speech))
        case RuledExercise():
            print_lines(ruled_lines(exercise, speech))
        case _:
            assert_never(exercise)


def _explain_actions(
    exercise: GroundedExercise, speech: Speech, *, detail: bool, as_json: bool
) -> None:
    summary = summarise(exercise)
    if as_json:
        answer: dict[str, object] = {
            "rules": sentences_json(speech.rules(summary)),
            "gaps": sentences_json(speech.gaps(summary)),
            "compared": summary.check.value,
        }
        if detail:
            answer["actions"] = list(_actions_json(exercise, speech))
        print_json(answer)
        return
    print_lines(rule_lines(summary, speech))
    if detail:
        print_lines(_action_lines(exercise, speech))


def _actions_json(exercise: GroundedExercise, speech: Speech) -> Iterator[dict[str, object]]:
    """Each action, and where its precondition comes from."""
    for action, provenance in exercise.provenance.items():
        explained = explain_action(exercise.model, action, speech.language, speech.words)
        yield {
            "name": explained.name,
            "precondition": list(explained.precondition),
            "effects": list(explained.effects),
            "text": explained.sentence,
            "seen": provenance.seen,
            "deleted": [
                {
                    "demonstration": deletion.demonstration,
                    "literals": [
                        formula(literal, action.shown)
                        for literal in exercise.model.vocabulary.select(deletion.literals)
                    ],
                }
                for deletion in provenance.deletions
            ],
        }


def _action_lines(exercise: GroundedExercise, speech: Speech) -> Iterator[str]:
    """Each action as in the paper's Fig. 4, and its sentence as in Fig. 6b."""
    for action, provenance in exercise.provenance.items():
        explained = explain_action(exercise.model, action, speech.language, speech.words)
        seen = speech.say(TerminalKey.TIMES_SHOWN, seen=provenance.seen)
        yield from (
            "",
            f"{explained.name}(from, to)",
            f"  {speech.say(TerminalKey.BEFORE)}: {', '.join(explained.precondition)}",
            f"  {speech.say(TerminalKey.AFTER)}: {', '.join(explained.effects)}",
            f"  {explained.sentence} {seen}",
        )
