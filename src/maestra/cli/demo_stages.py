"""The guided session's stages: what has been chosen, shown and played so far."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from random import Random
from typing import Final, TypeAlias

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck
from maestra.language.terminal import TerminalKey
from maestra.learning.dialogue import Dialogue, begin
from maestra.learning.grounded import learn_grounded
from maestra.learning.suspects import doubts
from maestra.learning.taught import taught_exercise
from maestra.rules.account import Account, account_of
from maestra.rules.answers import Answer
from maestra.rules.exercise import Exercise, RuledExercise
from maestra.rules.judging import Judge
from maestra.rules.paper import BOARD, LETTER_DECK, NUMBER_DECK, PAPER_EXERCISES
from maestra.rules.position import Position
from maestra.rules.right_plays import RightPlays


@dataclass(frozen=True, slots=True)
class Subject:
    """An exercise that can be chosen."""

    title: TerminalKey
    deck: Deck
    right: Callable[[], RightPlays] | None
    """Its right plays, found when first asked for; None: only the user knows them."""
    features: tuple[str, ...] | None = None
    """Those that count; None: the defaults."""
    board: Board = BOARD

    def start(self, chance: Random) -> State:
        """An arrangement from which the exercise can be played."""
        if self.right is not None:
            return self._any_right_play(chance).start
        cells = chance.sample(self.board.storage_cells, len(self.deck.tokens))
        ids = [token.id for token in self.deck.tokens]
        return State(self.board, dict(zip(ids, cells, strict=True)))

    def right_play(self, shown: tuple[Demonstration, ...], chance: Random) -> Demonstration:
        """A right play, after `shown` the one that tells most."""
        if self.right is not None and shown:
            exercise = learn_grounded(shown, features=self.features)
            telling = doubts(exercise, self.right()).next_demonstration
            if telling is not None:
                return telling
        return self._any_right_play(chance)

    def _any_right_play(self, chance: Random) -> Demonstration:
        if self.right is None:
            raise ValueError(self.title)
        plays = self.right()
        return plays.play(chance.randrange(plays.count))


SUBJECTS: Final = (
    *(
        Subject(TerminalKey(key), exercise.plays().deck, exercise.plays, exercise.features)
        for key, exercise in PAPER_EXERCISES.items()
    ),
    Subject(TerminalKey.OWN_NUMBERS, NUMBER_DECK, None),
    Subject(TerminalKey.OWN_LETTERS, LETTER_DECK, None),
)
"""What can be chosen, in this order."""


@dataclass(frozen=True, slots=True)
class Choosing:
    """An exercise is to be chosen."""

    by_few: bool = False
    """Whether rules are learned from a few demonstrations, or actions as in the paper."""


@dataclass(frozen=True)
class Taught:
    """What was shown of a subject, and what follows from it."""

    subject: Subject
    shown: tuple[Demonstration, ...] = ()
    by_few: bool = False
    answers: tuple[Answer, ...] = ()
    """What was replied to questions; only who learns by few asks any."""

    def with_shown(self, *more: Demonstration) -> "Taught":
        """The same with more demonstrations."""
        return replace(self, shown=(*self.shown, *more))

    @cached_property
    def dialogue(self) -> Dialogue:
        """What would be asked about it, from at least one play."""
        return begin(self.shown, self.answers)

    @cached_property
    def exercise(self) -> Exercise:
        """What was learned of what was shown, at least one play."""
        if self.by_few:
            return self.ruled
        return learn_grounded(self.shown, features=self.subject.features)

    @cached_property
    def ruled(self) -> RuledExercise:
        """The same as rules, learned by few."""
        return taught_exercise(self.dialogue.lesson)

    @cached_property
    def judge(self) -> Judge:
        """Judges plays by it."""
        return Judge(self.exercise, self.subject.deck)

    @cached_property
    def account(self) -> Account:
        """Its rules."""
        return account_of(self.exercise)


@dataclass(frozen=True, slots=True)
class Teaching:
    """The user shows how it goes."""

    taught: Taught
    start: State
    moves: tuple[Move, ...] = ()

    @property
    def state(self) -> State:
        """What lies where now."""
        return Demonstration(self.taught.subject.deck, self.start, self.moves).end


@dataclass(frozen=True, slots=True)
class Asking:
    """The user is asked what is not clear yet, before playing."""

    taught: Taught
    dialogue: Dialogue


@dataclass(frozen=True, slots=True)
class Playing:
    """The user plays, and each move is judged."""

    taught: Taught
    position: Position

    @property
    def state(self) -> State:
        """What lies where now."""
        return self.position.now


@dataclass(frozen=True, slots=True)
class Accompanying:
    """A patient plays; whoever leads this session lets the coach lead theirs, then comes back."""

    name: str
    """What the exercise is called in the record."""
    exercise: Exercise
    patient: str | None
    """For whom what is played is kept; None: it is not."""
    back: Choosing | Teaching | Playing
    """Where it was asked for."""


@dataclass(frozen=True, slots=True)
class Ended:
    """The session is over."""


Stage: TypeAlias = Choosing | Teaching | Asking | Playing | Accompanying | Ended
