"""What is learned while a caregiver shows plays: two ways, by one pattern.

A teacher's state is a value: each play shown and each answer makes the next one.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Protocol

from maestra.core.demonstration import Demonstration
from maestra.language import NO_LEXICON, Language, Lexicon, rule_sentences
from maestra.language.teaching import Teacher as Speech
from maestra.learning.dialogue import (
    AskAgain,
    AskQuestion,
    Dialogue,
    Ending,
    Finished,
    Replied,
    Terms,
    begin,
    step,
)
from maestra.learning.grounded import learn_grounded
from maestra.learning.taught import taught_exercise
from maestra.rules.account import account_of
from maestra.rules.answers import Answer, Question, Reply
from maestra.rules.decks import merge_decks
from maestra.rules.exercise import Exercise, GroundedExercise, LearnStatus
from maestra.rules.summaries.summary import Check, summarise


@dataclass(frozen=True, slots=True)
class Understood:
    """What has been learned so far."""

    rules: tuple[str, ...]
    """In sentences."""
    is_clear: bool
    """Whether nothing more need be shown or asked."""
    question: str | None
    """What would settle most; None if nothing is asked."""


class Teacher(Protocol):
    """Learns from plays and answers."""

    def shown(self, play: Demonstration) -> Teacher:
        """The teacher once another play was shown.

        Raises:
            InvalidError: it cannot be learned from.
        """
        ...

    def answered(self, reply: Reply) -> Teacher:
        """The teacher once the question was answered."""
        ...

    @property
    def understood(self) -> Understood:
        """What has been learned; of at least one play."""
        ...

    @property
    def exercise(self) -> Exercise:
        """What can be played now; of at least one play."""
        ...


@dataclass(frozen=True)
class GroundedTeacher:
    """The paper's learner: no questions, but plays until the sentences say just what it knows."""

    language: Language
    lexicon: Lexicon = NO_LEXICON
    plays: tuple[Demonstration, ...] = ()

    def shown(self, play: Demonstration) -> GroundedTeacher:
        """Learned from all plays at once."""
        after = replace(self, plays=(*self.plays, play))
        _ = after.exercise
        return after

    def answered(self, reply: Reply) -> GroundedTeacher:
        """Nothing was asked."""
        _ = reply
        return self

    @property
    def understood(self) -> Understood:
        """The rules in sentences; clear if they accept the same plays as what was learned."""
        sentences = rule_sentences(account_of(self.exercise), self.language, self.lexicon)
        same = summarise(self.exercise).check is Check.SAME
        return Understood(tuple(one.text for one in sentences), same, None)

    @property
    def exercise(self) -> GroundedExercise:
        """Preconditions for each token and step."""
        return self._learned

    @cached_property
    def _learned(self) -> GroundedExercise:
        return learn_grounded(self.plays)


@dataclass(frozen=True)
class AskingTeacher:
    """The few-shot learner: one to three plays, and a few questions to be answered yes or no."""

    language: Language
    lexicon: Lexicon = NO_LEXICON
    terms: Terms = field(default_factory=lambda: Terms(follow_ups=False))
    plays: tuple[Demonstration, ...] = ()
    answers: tuple[Answer, ...] = ()
    dialogue: Dialogue | None = None

    def shown(self, play: Demonstration) -> AskingTeacher:
        """Learned anew, with the answers given so far."""
        plays = (*self.plays, play)
        return replace(self, plays=plays, dialogue=begin(plays, self.answers, self.terms))

    def answered(self, reply: Reply) -> AskingTeacher:
        """Learned from the answer too."""
        if self.dialogue is None or isinstance(self.dialogue.ask, Finished):
            return self
        dialogue = step(self.dialogue, Replied(reply))
        return replace(self, dialogue=dialogue, answers=dialogue.answers)

    @property
    def understood(self) -> Understood:
        """The likeliest rules; clear once no question would tell more."""
        dialogue = self._begun
        rules = tuple(one.text for one in self._speech.rules(dialogue.lesson.rules))
        sure = isinstance(dialogue.ask, Finished) and dialogue.ask.ending is Ending.SURE
        clear = sure and dialogue.status is LearnStatus.LEARNED
        asked = _question(dialogue)
        return Understood(rules, clear, None if asked is None else self._speech.question(asked))

    @property
    def exercise(self) -> Exercise:
        """The likeliest rules, with how sure they are."""
        return taught_exercise(self._begun.lesson, self._begun.status)

    @property
    def _begun(self) -> Dialogue:
        if self.dialogue is None:
            raise ValueError("nothing has been shown yet")
        return self.dialogue

    @property
    def _speech(self) -> Speech:
        deck = merge_decks([play.deck for play in self.plays])
        return Speech(self.language, self.plays[0].board, deck, self.lexicon)


def _question(dialogue: Dialogue) -> Question | None:
    match dialogue.ask:
        case AskQuestion(question) | AskAgain(_, question):
            return question
        case _:
            return None
