"""What was learned, as JSON and as lines to read: the same for `learn` and `explain`."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from maestra.cli.drawing import board_lines, label
from maestra.cli.streams import STANDARD
from maestra.core.demonstration import Demonstration
from maestra.core.formats import encode_demonstration
from maestra.language import (
    Language,
    Lexicon,
    Sentence,
    check_sentence,
    gap_sentences,
    rule_sentences,
)
from maestra.language.terminal import TerminalKey, terminal_sentence
from maestra.learning.compiled import CompiledReport
from maestra.learning.suspects import doubts, doubts_without_rule
from maestra.rules.exercise import GroundedExercise
from maestra.rules.summaries.accepted import accepted_plays
from maestra.rules.summaries.summary import Check, Narrow, Summary, Unseen

MAX_LOOKED_AT: Final = 200
"""Demonstrations among which the next one to show is looked for: it must not take long."""


@dataclass(frozen=True, slots=True)
class Speech:
    """In which language, with which words."""

    language: Language
    words: Lexicon

    def rules(self, summary: Summary) -> tuple[Sentence, ...]:
        """The rules in words."""
        return rule_sentences(summary, self.language, self.words)

    def gaps(self, summary: Summary) -> tuple[Sentence, ...]:
        """What is still too narrow, in words."""
        return gap_sentences(summary, self.language, self.words)

    def check(self, summary: Summary) -> str:
        """What the comparison of rules and preconditions came to, in words."""
        return check_sentence(summary, self.language, self.words)

    def say(self, key: TerminalKey, **parts: object) -> str:
        """A sentence of the commands."""
        return terminal_sentence(key, self.language, **parts)


@dataclass(frozen=True, slots=True)
class Lesson:
    """What was learned, and what to show next."""

    exercise: GroundedExercise
    summary: Summary
    next: Demonstration | None = None

    @property
    def is_clear(self) -> bool:
        """Whether the rules say the same as what was learned."""
        return self.summary.check is Check.SAME

    def as_json(
        self, speech: Speech, seconds: float, report: CompiledReport | None
    ) -> dict[str, object]:
        """The lesson as `maestra learn --json` prints it."""
        sure = confidence(self.exercise, self.summary)
        answer: dict[str, object] = {
            "status": "learned" if self.is_clear else "ambiguous",
            "rules": [
                {"id": one.id, "text": one.text, "confidence": sure}
                for one in speech.rules(self.summary)
            ],
            "alternatives": [],
            "slips": [],
            "seconds": seconds,
            "demonstrations": self.exercise.demonstrations,
            "gaps": sentences_json(speech.gaps(self.summary)),
            "next_demonstration": next_json(self.next),
        }
        if report is not None:
            answer["planning"] = {
                "engine": report.engine,
                "problems": report.problems,
                "superfluous": report.superfluous,
                "seconds": report.seconds,
            }
        return answer

    def as_lines(self, speech: Speech, report: CompiledReport | None, file: str) -> Iterator[str]:
        """The lesson as `maestra learn` prints it."""
        yield from rule_lines(self.summary, speech)
        if self.next is not None:
            yield from ("", speech.say(TerminalKey.SHOW_NEXT), *play_lines(self.next, speech))
        yield ""
        if report is not None:
            yield speech.say(
                TerminalKey.PLANNED,
                engine=report.engine,
                problems=report.problems,
                seconds=f"{report.seconds:.2f}",
                superfluous=report.superfluous,
            )
        learned = speech.say(
            TerminalKey.LEARNED,
            demonstrations=self.exercise.demonstrations,
            actions=len(self.exercise.provenance),
        )
        saved = "" if file == STANDARD else f" {speech.say(TerminalKey.WRITTEN, file=file)}"
        yield f"{learned}{saved}"


def next_to_show(
    exercise: GroundedExercise, summary: Summary, shown: Sequence[Demonstration]
) -> Demonstration | None:
    """The demonstration that would settle most; None when nothing is open.

    Of the plays that the rules accept, if these can be listed and one tells something; else a
    play that was shown, from another start.
    """
    if summary.check is Check.SAME:
        return None
    accepted = accepted_plays(summary)
    if accepted is not None and accepted.count:
        telling = doubts(exercise, accepted).next_demonstration
        if telling is not None:
            return telling
    return doubts_without_rule(exercise, shown[:MAX_LOOKED_AT]).next_demonstration


def confidence(exercise: GroundedExercise, summary: Summary) -> float | None:
    """The share of the actions that the rules allow whose preconditions say no more than they.

    None where that could not be compared.
    """
    if summary.check is Check.NOT_COMPARED:
        return None
    actions = len(exercise.provenance)
    narrow = {
        (gap.step, shown) for gap in summary.gaps if isinstance(gap, Narrow) for shown in gap.shown
    }
    missing = sum(len(gap.missing) for gap in summary.gaps if isinstance(gap, Unseen))
    return round((actions - len(narrow)) / (actions + missing), 3)


def rule_lines(summary: Summary, speech: Speech) -> Iterator[str]:
    """The rules as one paragraph, what is not clear as a list, and whether both were compared."""
    yield " ".join(sentence.text for sentence in speech.rules(summary))
    gaps = speech.gaps(summary)
    if gaps:
        yield from ("", speech.say(TerminalKey.STILL_NARROW))
        yield from (f"- {gap.text}" for gap in gaps)
    if check := speech.check(summary):
        yield from ("", check)


def play_lines(play: Demonstration, speech: Speech) -> Iterator[str]:
    """A play as a board and the moves from there."""
    yield from board_lines(play.start, play.deck, speech.say(TerminalKey.GOAL))
    for move in play.moves:
        token = label(play.deck.by_id[move.token])
        yield speech.say(TerminalKey.I_MOVE, token=token, column=move.destination.column)


def sentences_json(sentences: Sequence[Sentence]) -> list[dict[str, object]]:
    """Sentences as JSON."""
    return [{"id": one.id, "text": one.text} for one in sentences]


def next_json(play: Demonstration | None) -> object:
    """A demonstration as JSON, or null."""
    return None if play is None else json.loads(encode_demonstration(play))
