"""What the guided session says of plays and of what it understood."""

from typing import Final

from maestra.cli.demo_stages import Taught
from maestra.cli.drawing import label
from maestra.cli.lesson import Speech
from maestra.cli.lesson_of_rules import ruled_lines
from maestra.cli.outputs import Drawn, Output, Said, Tone
from maestra.core.demonstration import Demonstration
from maestra.language import rule_sentences
from maestra.language.terminal import TerminalKey as Key
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.summaries.summary import Check, Summary

MAX_GAPS: Final = 5
"""What is not clear yet: as much as a person reads between two plays."""


def moves_of(play: Demonstration, speech: Speech, *, one_by_one: bool) -> list[Output]:
    """A play that Maestra shows: each move, or only the tokens in their order."""
    tokens = [label(play.deck.by_id[move.token]) for move in play.moves]
    if not one_by_one:
        return [Said("  ".join(tokens))]
    said = [
        Said(speech.say(Key.I_MOVE, token=token, column=move.destination.column))
        for token, move in zip(tokens, play.moves, strict=True)
    ]
    return [Drawn(play.start, play.deck), *said, Drawn(play.end, play.deck)]


def _rules(taught: Taught, speech: Speech) -> list[str]:
    """The rules in words; none before anything was shown."""
    if not taught.shown:
        return []
    said = rule_sentences(taught.account, speech.language, speech.words)
    return [one.text for one in said]


def new_rules(before: Taught, taught: Taught, speech: Speech) -> list[Output]:
    """The rules that were not there before."""
    known = _rules(before, speech)
    new = [text for text in _rules(taught, speech) if text not in known]
    return [Said(f"+ {text}", Tone.NEW) for text in new]


def understood(before: Taught, taught: Taught, speech: Speech) -> list[Output]:
    """All that is understood, what is new marked, and what is not clear yet."""
    known = _rules(before, speech)
    outputs: list[Output] = [Said(speech.say(Key.UNDERSTOOD), Tone.HEADING)]
    for text in _rules(taught, speech):
        is_new = text not in known
        outputs.append(
            Said(f"{'+' if is_new else ' '} {text}", Tone.NEW if is_new else Tone.PLAIN)
        )
    match taught.account:
        case RuledExercise() as exercise:
            outputs += _how_sure(exercise, speech)
        case summary:
            outputs += _how_clear(summary, speech)
    return outputs


def _how_sure(exercise: RuledExercise, speech: Speech) -> list[Output]:
    """How sure the rules are, and what else may be meant."""
    _, _, *lines = ruled_lines(exercise, speech)
    tone = Tone.GOOD if exercise.status is LearnStatus.LEARNED else Tone.ASIDE
    return [Said(line, tone) for line in lines]


def _how_clear(summary: Summary, speech: Speech) -> list[Output]:
    """What is not clear yet, or that everything is."""
    gaps = speech.gaps(summary)
    if not gaps:
        is_clear = summary.check is Check.SAME
        return [Said(speech.say(Key.ALL_CLEAR), Tone.GOOD)] if is_clear else []
    outputs: list[Output] = [Said(speech.say(Key.STILL_NARROW))]
    outputs += [Said(f"  - {gap.text}", Tone.ASIDE) for gap in gaps[:MAX_GAPS]]
    if len(gaps) > MAX_GAPS:
        more = speech.say(Key.AND_MORE, count=len(gaps) - MAX_GAPS)
        outputs.append(Said(f"  - {more}", Tone.ASIDE))
    return outputs
