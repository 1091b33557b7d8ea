"""An exercise that is being taught: all that was shown, answered and said, and what lies where.

A draft is a value; `actions.act` gives the next one. What was taught is a list of steps, so that
the last one can always be undone. What it comes to is worked out in `understanding`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, reduce
from types import MappingProxyType
from typing import TypeAlias, assert_never

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.tokens import Deck, TokenId
from maestra.learning.dialogue import CellIsWrong, Counts, Enough, SlipReplied
from maestra.learning.dialogue import Replied as Answered
from maestra.rules.answers import Answer, RuleQuestion
from maestra.rules.answers import Reply as Word
from maestra.rules.exercise import Exam
from maestra.rules.rule import Rule
from maestra.rules.setting import Index
from maestra.storage.drafts import Digest
from maestra.web.teach.showing import Showing, Touch

# ---------------------------------------------------------------- what was taught, step by step


@dataclass(frozen=True, slots=True)
class Shown:
    """A demonstration, as it was played."""

    showing: Showing


@dataclass(frozen=True, slots=True)
class TakenBack:
    """A demonstration, by its number from 0, counts no more."""

    number: Index


@dataclass(frozen=True, slots=True)
class BroughtBack:
    """It counts again."""

    number: Index


Reply: TypeAlias = Answered | CellIsWrong | SlipReplied | Counts | Enough
"""What is said to what is asked. A demonstration is shown again by taking it back."""


@dataclass(frozen=True, slots=True)
class Replied:
    """What was said to what was asked, and what the dialogue made of it."""

    said: Reply
    answers: tuple[Answer, ...]
    """All that count after it, those before it too."""
    out: frozenset[Index]
    """The demonstrations that count no more after it."""


@dataclass(frozen=True, slots=True)
class Told:
    """From now on just these rules: they were said in words. None: what was shown counts again."""

    rules: tuple[Rule, ...] | None


@dataclass(frozen=True, slots=True)
class Examined:
    """An exam was held."""

    exam: Exam
    objections: tuple[Answer, ...]
    """What the caregiver judged otherwise."""


@dataclass(frozen=True, slots=True)
class Recalled:
    """What was answered and examined before the exercise was taken from the library."""

    answers: tuple[Answer, ...]
    exams: tuple[Exam, ...]


Step: TypeAlias = Shown | TakenBack | BroughtBack | Replied | Told | Examined | Recalled


@dataclass(frozen=True, slots=True)
class Taught:
    """What the steps come to."""

    showings: tuple[Showing, ...] = ()
    out: frozenset[Index] = frozenset()
    answers: tuple[Answer, ...] = ()
    told: tuple[Rule, ...] | None = None
    """Rules that count instead of what is learned."""
    exams: tuple[Exam, ...] = ()
    base: tuple[tuple[Index, ...], tuple[Answer, ...]] = ((), ())
    """The demonstrations that counted and the answers when the dialogue began."""
    replies: tuple[Reply, ...] = ()
    """What was said in it since."""

    @property
    def counting(self) -> tuple[Index, ...]:
        """The demonstrations that count."""
        return tuple(k for k in range(len(self.showings)) if k not in self.out)


def after(taught: Taught, step: Step) -> Taught:
    """What was taught, with one more step."""
    match step:
        case Shown(showing):
            return _learned_on(replace(taught, showings=(*taught.showings, showing)))
        case TakenBack(number):
            return _begun(replace(taught, out=taught.out | {number}))
        case BroughtBack(number):
            return _begun(replace(taught, out=taught.out - {number}))
        case Replied(said, answers, out):
            return replace(taught, answers=answers, out=out, replies=(*taught.replies, said))
        case Told(rules):
            return replace(taught, told=rules)
        case Examined(exam, objections):
            held = replace(taught, exams=(*taught.exams, exam))
            if not objections:
                return held
            held = replace(held, answers=(*held.answers, *objections))
            return _learned_on(held) if held.counting else held
        case Recalled(answers, exams):
            recalled = replace(taught, answers=(*taught.answers, *answers))
            return _begun(replace(recalled, exams=(*taught.exams, *exams)))
        case _:
            assert_never(step)


def _learned_on(taught: Taught) -> Taught:
    """What was told is evidence from now on, like an answer."""
    said = tuple(Answer(RuleQuestion(rule), Word.YES) for rule in taught.told or ())
    return _begun(replace(taught, answers=(*taught.answers, *said), told=None))


def _begun(taught: Taught) -> Taught:
    """The dialogue begins anew with what counts."""
    return replace(taught, base=(taught.counting, taught.answers), replies=())


# ---------------------------------------------------------------- the draft


@dataclass(frozen=True, slots=True)
class Trial:
    """The caregiver plays what has been taught."""

    moves: tuple[Touch, ...] = ()
    """Those that were allowed."""
    refused: Touch | None = None
    """The last one, if it was not."""


@dataclass(frozen=True, slots=True)
class ExamUnderWay:
    """Maestra plays, and the caregiver judges."""

    seed: int
    replies: tuple[Word, ...] = ()


@dataclass(frozen=True)
class Draft:
    """An exercise that is being taught."""

    deck: Deck
    showing: Showing
    """The demonstration that is being played."""
    seed: int = 0
    """Of how the tokens were dealt last."""
    steps: tuple[Step, ...] = ()
    features: tuple[str, ...] | None = None
    """What counts, where the caregiver says it beforehand; then the actions are learned that the
    paper describes, and nothing is asked."""
    pictures: Mapping[str, Digest] = field(default_factory=dict[str, Digest])
    """What tokens show under `picture`, with their pictures."""
    name: str = ""
    saved: tuple[str, int] | None = None
    """Under which name and as which version it was saved last."""
    held: TokenId | None = None
    """The token in somebody's hand."""
    trial: Trial = Trial()
    exam: ExamUnderWay | None = None

    def __post_init__(self) -> None:
        """Freeze the pictures."""
        object.__setattr__(self, "pictures", MappingProxyType(dict(self.pictures)))

    @property
    def board(self) -> Board:
        """The board it is taught on."""
        return self.showing.dealt.board

    @property
    def mark(self) -> str:
        """How far teaching is: a form of a page with another mark answers what was before."""
        judged = 0 if self.exam is None else 1 + len(self.exam.replies)
        return f"{len(self.steps)}.{len(self.showing.touches)}.{judged}"

    @cached_property
    def taught(self) -> Taught:
        """What the steps come to."""
        return reduce(after, self.steps, Taught())

    @cached_property
    def demonstrations(self) -> tuple[Demonstration, ...]:
        """All that were shown, also those that count no more."""
        return tuple(one.demonstration(self.deck) for one in self.taught.showings)
