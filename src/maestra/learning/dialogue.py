"""Teaching as a dialogue: what is known, what is asked next, and what a reply changes.

A pure state machine: `begin` and `step` make the next state; what to ask is in its `ask`. One
thing is asked at a time. First what cannot both be, then a likely mistake in a demonstration,
then the question that tells most; it stops when it is sure, when the budget is used up, or when
the caregiver says that it is enough. A contradiction is shown and never settled here: the
caregiver picks what counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Final, TypeAlias, assert_never

from maestra.core.demonstration import Demonstration
from maestra.learning.contradictions import (
    Contradiction,
    Moment,
    Said,
    Shown,
    Understood,
    clashes,
    overruled,
)
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Lesson, Slip
from maestra.learning.fewshot.questions import ALL_KINDS, QuestionKind, next_question
from maestra.rules.answers import Answer, Question, Reply, RowQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.setting import Index, play_of

DEFAULT_QUESTIONS: Final = 3
MAX_QUESTIONS: Final = 5
"""More than five tire a caregiver, whatever they would tell."""


@dataclass(frozen=True, slots=True)
class AskQuestion:
    """Asked: is this row, this move, this rule right? Answered by `Replied`."""

    question: Question


@dataclass(frozen=True, slots=True)
class AskCell:
    """Asked: which token of the row is wrong? Answered by `CellIsWrong`."""

    answer: Index
    """The "no" it is about, by its number from 0."""


@dataclass(frozen=True, slots=True)
class AskSlip:
    """Asked: was this meant? Answered by `SlipReplied` or `ShownAgain`."""

    slip: Slip
    """Counted over all demonstrations, those taken back too."""


@dataclass(frozen=True, slots=True)
class AskWhichCounts:
    """Asked: which of two moments counts? Answered by `Counts`."""

    contradiction: Contradiction


@dataclass(frozen=True, slots=True)
class AskAgain:
    """Asked, where only questions are understood: the same as before. Answered by `Replied`."""

    contradiction: Contradiction
    question: Question


class Ending(Enum):
    """Why nothing more is asked."""

    SURE = "sure"
    NOTHING_HELPS = "nothing-helps"
    """No question would tell anything."""
    ASKED_ENOUGH = "asked-enough"
    """The budget is used up."""
    TOLD_TO_STOP = "told-to-stop"
    NOTHING_LEFT = "nothing-left"
    """Every demonstration was taken back."""


@dataclass(frozen=True, slots=True)
class Finished:
    """Nothing is asked."""

    ending: Ending
    unsettled: tuple[Contradiction, ...]
    """What still cannot both be."""


Ask: TypeAlias = AskQuestion | AskCell | AskSlip | AskWhichCounts | AskAgain | Finished


@dataclass(frozen=True, slots=True)
class Replied:
    """To a question."""

    reply: Reply


@dataclass(frozen=True, slots=True)
class CellIsWrong:
    """Which goal cell is wrong, from 0; None: the caregiver cannot tell."""

    cell: Index | None


class SlipReply(Enum):
    """What is to become of a demonstration with a likely mistake."""

    TAKEN_BACK = "taken-back"
    CONFIRMED = "confirmed"
    """It was meant as it was shown: the same as to be asked about that row, and to say yes."""


@dataclass(frozen=True, slots=True)
class SlipReplied:
    """To a likely mistake."""

    reply: SlipReply


@dataclass(frozen=True, slots=True)
class ShownAgain:
    """The demonstration with the mistake is taken back and played again."""

    demonstration: Demonstration


class Side(Enum):
    """Which of two moments counts."""

    EARLIER = "earlier"
    LATER = "later"
    NEITHER = "neither"


@dataclass(frozen=True, slots=True)
class Counts:
    """Which of two moments counts."""

    side: Side


@dataclass(frozen=True, slots=True)
class Enough:
    """That's enough: nothing more shall be asked."""


Event: TypeAlias = Replied | CellIsWrong | SlipReplied | ShownAgain | Counts | Enough


class NotAskedError(ValueError):
    """A reply to something that was not asked."""


@dataclass(frozen=True, slots=True)
class Terms:
    """What may be asked, and how much."""

    questions: int = DEFAULT_QUESTIONS
    """About rows, moves and rules, at most `MAX_QUESTIONS`."""
    kinds: frozenset[QuestionKind] = ALL_KINDS
    follow_ups: bool = True
    """Whether anything else than questions may be asked: where not, a contradiction is shown by
    asking again, out of the same budget."""
    seed: int = 0

    def __post_init__(self) -> None:
        """Refuse more questions than anybody should be asked.

        Raises:
            ValueError: they are.
        """
        if not 0 <= self.questions <= MAX_QUESTIONS:
            raise ValueError(f"{self.questions} questions, expected 0 to {MAX_QUESTIONS}")


@dataclass(frozen=True, slots=True)
class _Put:
    """What the caregiver has been asked already besides questions."""

    contradictions: frozenset[Contradiction] = frozenset()
    slips: frozenset[Index] = frozenset()


@dataclass(frozen=True, slots=True)
class Dialogue:
    """What was shown and said, what it comes to, and what is asked now."""

    terms: Terms
    demonstrations: tuple[Demonstration, ...]
    """All that were shown, also those that no longer count."""
    answers: tuple[Answer, ...]
    """All that were given; one that no longer counts is unsure."""
    lesson: Lesson
    """What is understood."""
    ask: Ask
    contradictions: tuple[Contradiction, ...] = ()
    """What was shown and said that cannot both be."""
    taken_back: frozenset[Index] = frozenset()
    """The demonstrations that no longer count."""
    asked: int = 0
    """Questions asked, out of the budget."""
    put: _Put = field(default=_Put())

    @property
    def counting(self) -> tuple[Index, ...]:
        """The demonstrations that count."""
        return tuple(k for k in range(len(self.demonstrations)) if k not in self.taken_back)

    @property
    def status(self) -> LearnStatus:
        """What it came to; nothing is learned while something is contradictory."""
        match self.ask:
            case Finished(Ending.NOTHING_LEFT):
                return LearnStatus.AMBIGUOUS
            case Finished(_, unsettled) if unsettled:
                return LearnStatus.CONTRADICTORY
            case _:
                pass
        return LearnStatus(self.lesson.status.value)


def begin(
    demonstrations: Sequence[Demonstration],
    answers: Sequence[Answer] = (),
    terms: Terms | None = None,
) -> Dialogue:
    """The dialogue after at least one demonstration, and perhaps answers from another day.

    Raises:
        ValueError: no demonstration.
        InvalidError: a move that is not from a storage cell to a goal cell.
    """
    terms = terms or Terms()
    lesson = learn(demonstrations, answers, terms.seed)
    nothing_yet = Finished(Ending.SURE, ())
    begun = Dialogue(terms, tuple(demonstrations), tuple(answers), lesson, nothing_yet)
    return _ask_on(replace(begun, contradictions=_found(begun)))


def step(dialogue: Dialogue, event: Event) -> Dialogue:
    """The dialogue after a reply; once it is finished nothing changes it.

    Raises:
        NotAskedError: the event is no reply to what is asked.
        InvalidError: a cell that is not on the row; a demonstration that cannot be learned from.
    """
    match dialogue.ask, event:
        case Finished(), _:
            return dialogue
        case _, Enough():
            return _finished(dialogue, Ending.TOLD_TO_STOP)
        case AskQuestion(question), Replied(reply):
            return _answered(dialogue, Answer(question, reply))
        case AskCell(number), CellIsWrong(cell):
            known = replace(dialogue.answers[number], wrong=cell)
            return _learned(_with_answer(dialogue, number, known))
        case AskSlip(slip), SlipReplied(reply):
            return _slip_replied(dialogue, slip.demonstration, reply)
        case AskSlip(slip), ShownAgain(demonstration):
            again = replace(dialogue, demonstrations=(*dialogue.demonstrations, demonstration))
            return _learned(_without(again, Shown(slip.demonstration)))
        case AskWhichCounts(contradiction), Counts(side):
            return _decided(dialogue, contradiction, side)
        case AskAgain(contradiction), Replied(reply):
            return _said_again(dialogue, contradiction, reply)
        case _:
            raise NotAskedError(f"{event} to {dialogue.ask}")


def _answered(dialogue: Dialogue, answer: Answer) -> Dialogue:
    """The dialogue with one more answer; a "no" to a row may be asked about at once."""
    answers = (*dialogue.answers, answer)
    after = _relearned(replace(dialogue, answers=answers, asked=dialogue.asked + 1))
    refused_row = isinstance(answer.question, RowQuestion) and answer.reply is Reply.NO
    if refused_row and after.terms.follow_ups and after.lesson.status is not LearnStatus.LEARNED:
        number = len(answers) - 1
        if all(one.later != Said(number) for one in after.contradictions):
            return replace(after, ask=AskCell(number))
    return _ask_on(after)


def _slip_replied(dialogue: Dialogue, number: Index, reply: SlipReply) -> Dialogue:
    match reply:
        case SlipReply.CONFIRMED:
            # That is an answer like any other: this row is right.
            meant = Answer(RowQuestion(play_of(dialogue.demonstrations[number])), Reply.YES)
            return _learned(replace(dialogue, answers=(*dialogue.answers, meant)))
        case SlipReply.TAKEN_BACK:
            return _learned(_without(dialogue, Shown(number)))
        case _:
            assert_never(reply)


def _decided(dialogue: Dialogue, contradiction: Contradiction, side: Side) -> Dialogue:
    """The dialogue without what does not count."""
    if side is not Side.EARLIER:
        dialogue = _without(dialogue, contradiction.earlier)
    if side is not Side.LATER:
        dialogue = _without(dialogue, contradiction.later)
    return _learned(dialogue)


def _said_again(dialogue: Dialogue, contradiction: Contradiction, reply: Reply) -> Dialogue:
    """What is said again counts, and what is said otherwise now counts instead."""
    number = contradiction.later.answer
    before = dialogue.answers[number]
    dialogue = replace(dialogue, asked=dialogue.asked + 1)
    if reply is before.reply:
        return _learned(_without(dialogue, contradiction.earlier))
    return _learned(_with_answer(dialogue, number, Answer(before.question, reply)))


def _without(dialogue: Dialogue, moment: Moment) -> Dialogue:
    """The dialogue in which a moment no longer counts; what is understood cannot be dropped."""
    match moment:
        case Shown(number):
            return replace(dialogue, taken_back=dialogue.taken_back | {number})
        case Said(number):
            unsure = Answer(dialogue.answers[number].question, Reply.UNSURE)
            return _with_answer(dialogue, number, unsure)
        case Understood():
            return dialogue
        case _:
            assert_never(moment)


def _with_answer(dialogue: Dialogue, number: Index, answer: Answer) -> Dialogue:
    answers = (*dialogue.answers[:number], answer, *dialogue.answers[number + 1 :])
    return replace(dialogue, answers=answers)


def _learned(dialogue: Dialogue) -> Dialogue:
    """The dialogue with what now follows from what counts, and what is asked next."""
    if not dialogue.counting:
        return replace(dialogue, ask=Finished(Ending.NOTHING_LEFT, ()))
    return _ask_on(_relearned(dialogue))


def _relearned(dialogue: Dialogue) -> Dialogue:
    shown = [dialogue.demonstrations[k] for k in dialogue.counting]
    lesson = learn(shown, dialogue.answers, dialogue.terms.seed)
    after = replace(dialogue, lesson=lesson)
    return replace(after, contradictions=_found(after))


def _found(dialogue: Dialogue) -> tuple[Contradiction, ...]:
    """What cannot both be; rules that are only a guess overrule nobody."""
    shown = {k: play_of(dialogue.demonstrations[k]) for k in dialogue.counting}
    clashing = clashes(shown, dialogue.answers)
    if dialogue.lesson.status is LearnStatus.OUTSIDE:
        return clashing
    known = {one.later for one in clashing}
    plays, rules = tuple(shown.values()), dialogue.lesson.rules
    more = overruled(rules, dialogue.answers, plays, dialogue.terms.seed)
    return (*clashing, *(one for one in more if one.later not in known))


def _ask_on(dialogue: Dialogue) -> Dialogue:
    """The dialogue with the next thing to ask."""
    terms, put = dialogue.terms, dialogue.put
    may_ask = dialogue.asked < terms.questions
    new = [one for one in dialogue.contradictions if one not in put.contradictions]
    if new and (terms.follow_ups or may_ask):
        put = replace(put, contradictions=put.contradictions | {new[0]})
        question = dialogue.answers[new[0].later.answer].question
        ask = AskWhichCounts(new[0]) if terms.follow_ups else AskAgain(new[0], question)
        return replace(dialogue, ask=ask, put=put)
    slip = _new_slip(dialogue)
    if slip is not None and terms.follow_ups:
        put = replace(put, slips=put.slips | {slip.demonstration})
        return replace(dialogue, ask=AskSlip(slip), put=put)
    if dialogue.lesson.status is LearnStatus.LEARNED:
        return _finished(dialogue, Ending.SURE)
    if not may_ask:
        return _finished(dialogue, Ending.ASKED_ENOUGH)
    question_next = next_question(dialogue.lesson, terms.kinds)
    if question_next is None:
        return _finished(dialogue, Ending.NOTHING_HELPS)
    return replace(dialogue, ask=AskQuestion(question_next))


def _new_slip(dialogue: Dialogue) -> Slip | None:
    """A likely mistake that was not asked about, by the number of its demonstration."""
    right = {a.question for a in dialogue.answers if a.reply is Reply.YES}
    found = (
        replace(slip, demonstration=dialogue.counting[slip.demonstration])
        for slip in dialogue.lesson.slips
    )
    return next(
        (
            slip
            for slip in found
            if slip.demonstration not in dialogue.put.slips
            and RowQuestion(play_of(dialogue.demonstrations[slip.demonstration])) not in right
        ),
        None,
    )


def _finished(dialogue: Dialogue, ending: Ending) -> Dialogue:
    return replace(dialogue, ask=Finished(ending, dialogue.contradictions))
