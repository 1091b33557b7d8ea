"""What can be done with a draft: each action makes the next one, or says why it cannot be."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from typing import Final, TypeAlias, assert_never

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import Deck, TokenId
from maestra.rules.answers import Reply
from maestra.storage.drafts import Digest
from maestra.web.teach.draft import (
    BroughtBack,
    Draft,
    Examined,
    ExamUnderWay,
    Recalled,
    Replied,
    Shown,
    Step,
    TakenBack,
    Told,
    Trial,
)
from maestra.web.teach.showing import CannotTouchError, Showing, Touch, dealt, laid

MAX_SHOWN: Final = 30
"""Demonstrations of one draft: people show three, and each is weighed against every other."""
MAX_STEPS: Final = 300
"""Demonstrations, answers and changes in words: an afternoon of them."""


class Why(Enum):
    """Why something cannot be done now."""

    CELL = "cell"
    """No token can be put there."""
    NOTHING_SHOWN = "nothing-shown"
    NOTHING_TO_UNDO = "nothing-to-undo"
    TOO_MUCH = "too-much"
    NO_SUCH = "no-such"
    """There is no such demonstration, or it is so already."""
    IN_USE = "in-use"
    """Demonstrations need the tokens and the board as they are."""
    NO_ROOM = "no-room"
    """More tokens than storage cells."""
    NO_EXAM = "no-exam"
    TOO_MANY_DRAFTS = "too-many-drafts"
    NO_NAME = "no-name"
    """Empty, too long, or with letters that no name may have."""
    NAME_TAKEN = "name-taken"
    """Another exercise of the library has it."""


class CannotError(Exception):
    """This cannot be done now."""

    def __init__(self, why: Why) -> None:
        """Say why."""
        super().__init__(why.value)
        self.why: Why = why


def new_draft(deck: Deck, board: Board, seed: int) -> Draft:
    """Nothing shown yet, the tokens dealt.

    Raises:
        CannotError: there is no room for the tokens.
    """
    return Draft(deck, Showing(_dealt(deck, board, seed)), seed)


@dataclass(frozen=True, slots=True)
class Put:
    """A token is put on a cell."""

    touch: Touch


@dataclass(frozen=True, slots=True)
class Hold:
    """A token is in the hand, or none."""

    token: TokenId | None


@dataclass(frozen=True, slots=True)
class LayOut:
    """A token begins on this cell; nothing is moved yet."""

    touch: Touch


@dataclass(frozen=True, slots=True)
class Deal:
    """The tokens are dealt anew."""


@dataclass(frozen=True, slots=True)
class Finish:
    """This demonstration is done."""


@dataclass(frozen=True, slots=True)
class Show:
    """A whole demonstration at once, on the draft's board."""

    showing: Showing


@dataclass(frozen=True, slots=True)
class Undo:
    """As if the last touch or step had not been."""

    whole: bool = False
    """Of a demonstration all of it: its touches are not brought back."""


@dataclass(frozen=True, slots=True)
class Take:
    """A step of teaching."""

    step: TakenBack | BroughtBack | Replied | Told | Examined


@dataclass(frozen=True, slots=True)
class Equip:
    """Other tokens, another board."""

    deck: Deck
    board: Board
    pictures: Mapping[str, Digest]


@dataclass(frozen=True, slots=True)
class Choose:
    """These features count; None: whatever explains what was shown."""

    features: tuple[str, ...] | None


@dataclass(frozen=True, slots=True)
class Try:
    """A move is tried; the caller knows whether it is allowed."""

    touch: Touch
    allowed: bool


@dataclass(frozen=True, slots=True)
class TryAgain:
    """From the start."""


@dataclass(frozen=True, slots=True)
class BeginExam:
    """Maestra plays, with plays drawn by this seed."""

    seed: int


@dataclass(frozen=True, slots=True)
class JudgePlay:
    """What the caregiver says of the play shown."""

    reply: Reply


@dataclass(frozen=True, slots=True)
class LeaveExam:
    """It does not count."""


@dataclass(frozen=True, slots=True)
class Rename:
    """What the exercise is to be called."""

    name: str


@dataclass(frozen=True, slots=True)
class Keep:
    """It was saved in the library."""

    name: str
    version: int


Action: TypeAlias = (
    Put
    | Hold
    | LayOut
    | Deal
    | Finish
    | Show
    | Undo
    | Take
    | Equip
    | Choose
    | Try
    | TryAgain
    | BeginExam
    | JudgePlay
    | LeaveExam
    | Rename
    | Keep
)


def act(draft: Draft, action: Action) -> Draft:  # noqa: C901, PLR0912 - a case for each action
    """The draft after `action`.

    Raises:
        CannotError: it cannot be done now.
    """
    match action:
        case Put(touch):
            return _put(draft, touch)
        case Hold(token):
            return replace(draft, held=token)
        case LayOut(touch):
            return _laid_out(draft, touch)
        case Deal():
            return _dealt_anew(draft)
        case Finish():
            return _finished(draft)
        case Show(showing):
            if showing.dealt.board != draft.board:
                raise CannotError(Why.IN_USE)
            return _finished(replace(draft, showing=showing))
        case Undo(whole):
            return _undone(draft, whole=whole)
        case Take(step):
            return _taken(draft, step)
        case Equip(deck, board, pictures):
            return _equipped(draft, deck, board, pictures)
        case Choose(features):
            return _settled(replace(draft, features=features))
        case Try(touch, allowed):
            return _tried(draft, touch, allowed=allowed)
        case TryAgain():
            return replace(draft, trial=Trial(), held=None)
        case BeginExam(seed):
            return replace(draft, exam=ExamUnderWay(seed))
        case JudgePlay(reply):
            if draft.exam is None:
                raise CannotError(Why.NO_EXAM)
            exam = replace(draft.exam, replies=(*draft.exam.replies, reply))
            return replace(draft, exam=exam)
        case LeaveExam():
            return replace(draft, exam=None)
        case Rename(name):
            return replace(draft, name=name)
        case Keep(name, version):
            return replace(draft, name=name, saved=(name, version))
        case _:
            assert_never(action)


def _put(draft: Draft, touch: Touch) -> Draft:
    try:
        showing = draft.showing.after(touch)
    except CannotTouchError:
        raise CannotError(Why.CELL) from None
    after = replace(draft, showing=showing, held=None)
    return _finished(after) if showing.moves and showing.is_full else after


def _laid_out(draft: Draft, touch: Touch) -> Draft:
    if draft.showing.moves:
        raise CannotError(Why.IN_USE)
    try:
        start = laid(draft.showing.start, touch)
    except CannotTouchError:
        raise CannotError(Why.CELL) from None
    return replace(draft, showing=Showing(start), held=None, trial=Trial())


def _dealt_anew(draft: Draft) -> Draft:
    if draft.showing.moves:
        raise CannotError(Why.IN_USE)
    seed = draft.seed + 1
    start = _dealt(draft.deck, draft.board, seed)
    return replace(draft, seed=seed, showing=Showing(start), held=None, trial=Trial())


def _finished(draft: Draft) -> Draft:
    showing = draft.showing
    if not showing.moves:
        raise CannotError(Why.NOTHING_SHOWN)
    if len(draft.taught.showings) >= MAX_SHOWN:
        raise CannotError(Why.TOO_MUCH)
    # The tokens lie again where they lay: the same row can be shown otherwise at once.
    again = Showing(showing.start)
    return _with_step(replace(draft, showing=again, held=None), Shown(showing))


def _undone(draft: Draft, *, whole: bool) -> Draft:
    if draft.showing.touches and not whole:
        return replace(draft, showing=draft.showing.before(), held=None)
    if not draft.steps or isinstance(draft.steps[-1], Recalled):
        raise CannotError(Why.NOTHING_TO_UNDO)
    *rest, last = draft.steps
    before = _settled(replace(draft, steps=tuple(rest), held=None))
    if whole or not isinstance(last, Shown):
        return before
    showing = last.showing
    # A full row ended by itself, with its last touch.
    return replace(before, showing=showing.before() if showing.is_full else showing)


def _taken(draft: Draft, step: TakenBack | BroughtBack | Replied | Told | Examined) -> Draft:
    taught = draft.taught
    match step:
        case TakenBack(number) if number not in taught.counting:
            raise CannotError(Why.NO_SUCH)
        case BroughtBack(number) if number not in taught.out:
            raise CannotError(Why.NO_SUCH)
        case _:
            return _with_step(draft, step)


def _with_step(draft: Draft, step: Step) -> Draft:
    if len(draft.steps) >= MAX_STEPS:
        raise CannotError(Why.TOO_MUCH)
    return _settled(replace(draft, steps=(*draft.steps, step)))


def _settled(draft: Draft) -> Draft:
    """The draft with other rules than before: what was tried or examined was about the old."""
    return replace(draft, trial=Trial(), exam=None)


def _equipped(draft: Draft, deck: Deck, board: Board, pictures: Mapping[str, Digest]) -> Draft:
    if draft.steps or draft.showing.moves:
        raise CannotError(Why.IN_USE)
    start = _dealt(deck, board, draft.seed)
    after = replace(draft, deck=deck, showing=Showing(start), pictures=pictures, features=None)
    return replace(_settled(after), held=None)


def _tried(draft: Draft, touch: Touch, *, allowed: bool) -> Draft:
    trial = draft.trial
    after = Trial((*trial.moves, touch)) if allowed else replace(trial, refused=touch)
    return replace(draft, trial=after, held=None)


def _dealt(deck: Deck, board: Board, seed: int) -> State:
    if len(deck.tokens) > len(board.storage_cells):
        raise CannotError(Why.NO_ROOM)
    return dealt(deck, board, seed)
