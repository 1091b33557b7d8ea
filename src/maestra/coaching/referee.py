"""What is right in a play, with the reasons in words: a judge and a language together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, TypeAlias

from maestra.core.state import Move, State
from maestra.core.tokens import Deck
from maestra.language import NO_LEXICON, Language, Lexicon, reason, rule_sentences
from maestra.language.languages import speaker_for
from maestra.language.speaker import Speaker
from maestra.rules.account import account_of, broken_ids
from maestra.rules.exercise import Exercise
from maestra.rules.judging import Judge
from maestra.rules.position import Position
from maestra.rules.verdicts import JudgedMove


@dataclass(frozen=True, slots=True)
class Right:
    """The move keeps all rules, and the exercise can still be completed."""


@dataclass(frozen=True, slots=True)
class Refused:
    """The move does not."""

    reason: str
    """A sentence for the patient."""
    broken: tuple[str, ...]
    """The ids of the broken rules; none for a dead end."""


Ruling: TypeAlias = Right | Refused


class Referee(Protocol):
    """Knows one exercise, played with one deck, in one language."""

    @property
    def deck(self) -> Deck:
        """The tokens."""
        ...

    @property
    def speaker(self) -> Speaker:
        """Says things about them."""
        ...

    @property
    def language(self) -> Language:
        """In which."""
        ...

    @property
    def rules(self) -> tuple[str, ...]:
        """What the exercise asks for, in sentences."""
        ...

    def judge(self, position: Position, move: Move) -> Ruling:
        """Whether `move` is right here.

        Raises:
            IllegalMoveError: no board could make it.
        """
        ...

    def right_moves(self, position: Position) -> tuple[Move, ...]:
        """Every right move, in a fixed order."""
        ...

    def may_end(self, position: Position) -> bool:
        """Whether the exercise may end here."""
        ...


class ExerciseReferee:
    """The referee of an exercise; remembers what it worked out."""

    def __init__(
        self,
        exercise: Exercise,
        deck: Deck,
        language: Language,
        lexicon: Lexicon = NO_LEXICON,
    ) -> None:
        """Prepare for plays of `exercise` with the tokens of `deck`.

        Raises:
            InvalidError: the deck does not fit the exercise.
        """
        self.deck = deck
        self.language = language
        self._judge = Judge(exercise, deck)
        self._account = account_of(exercise)
        self._lexicon = lexicon
        self.speaker = speaker_for(language, exercise.board, deck, lexicon)
        said = rule_sentences(self._account, language, lexicon)
        self.rules = tuple(sentence.text for sentence in said)
        self._moves: dict[tuple[State, tuple[Move, ...]], tuple[Move, ...]] = {}

    def judge(self, position: Position, move: Move) -> Ruling:
        """Whether `move` is right here, and if not, why."""
        verdict = self._judge.verdict(position, move)
        judged = JudgedMove(position.now, move, verdict)
        if not judged.is_refused:
            return Right()
        why = reason(judged, self._account, self.deck, self.language, self._lexicon)
        return Refused(why, broken_ids(judged, self._account, self.deck))

    def right_moves(self, position: Position) -> tuple[Move, ...]:
        """Every right move, by destination and origin."""
        key = position.start, position.moves
        if key not in self._moves:
            found = self._judge.allowed_moves(position)
            self._moves[key] = tuple(sorted(found, key=lambda m: (m.destination, m.origin)))
        return self._moves[key]

    def may_end(self, position: Position) -> bool:
        """Whether the exercise may end here."""
        return self._judge.may_end(position)
