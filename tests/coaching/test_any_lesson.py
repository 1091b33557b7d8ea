"""Whatever happens while a caregiver teaches: nothing is made up, and every lesson ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from maestra.coaching.commands import Commands, Record, Say, decode_command, encode_command
from maestra.coaching.events import (
    Answered,
    Begun,
    BoardBack,
    BoardLost,
    DoneSaid,
    EndOrdered,
    Event,
    HelpAsked,
    HintOrdered,
    Paused,
    Resumed,
    RobotDone,
    RobotFailed,
    SeveralTokens,
    Skipped,
    TimePassed,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    VerdictOverridden,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.lesson import Lesson, Stage, new_lesson
from maestra.coaching.notes import Note
from maestra.coaching.teachers import Understood
from maestra.coaching.teaching import step
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import TokenId
from maestra.language import Language
from maestra.rules.answers import Reply
from maestra.rules.exercise import Exercise
from tests.coaching.plain_referee import BOARD, DECK, START, TOKENS, cell

tokens = st.sampled_from((*TOKENS, TokenId("stranger")))
cells = st.one_of(st.sampled_from(BOARD.cells), st.just(cell(9, 9)))
MOST_STEPS = 40


@dataclass(frozen=True)
class SlowTeacher:
    """Asks about the first two plays, is sure after three, and cannot learn from one move."""

    plays: tuple[Demonstration, ...] = ()
    replies: tuple[Reply, ...] = ()

    def shown(self, play: Demonstration) -> SlowTeacher:
        if len(play.moves) == 1:
            raise InvalidError([Fault("moves", "one", "more")])
        return replace(self, plays=(*self.plays, play))

    def answered(self, reply: Reply) -> SlowTeacher:
        return replace(self, replies=(*self.replies, reply))

    @property
    def understood(self) -> Understood:
        asks = len(self.replies) < len(self.plays) < 3
        return Understood(("A rule.",), len(self.plays) > 2, "Is it so?" if asks else None)

    @property
    def exercise(self) -> Exercise:
        raise NotImplementedError


class AnyLesson(RuleBasedStateMachine):
    """A lesson that anything can happen to."""

    @initialize(language=st.sampled_from(Language), seed=st.integers(0, 2**64 - 1))
    def begin(self, language: Language, seed: int) -> None:
        self.first = self.lesson = new_lesson(DECK, START, SlowTeacher(), language, seed)
        self.log: list[tuple[Event, Milliseconds, Commands]] = []
        self.heard: list[str] = []

    @rule(token=tokens)
    def lift(self, token: TokenId) -> None:
        self.feed(TokenLifted(token))

    @rule(token=tokens, where=cells)
    def place(self, token: TokenId, where: object) -> None:
        self.feed(TokenPlaced(token, where))  # type: ignore[arg-type] # a cell

    @rule(token=st.sampled_from(TOKENS), column=st.integers(1, 3))
    def move_up(self, token: TokenId, column: int) -> None:
        self.feed(TokenLifted(token))
        self.feed(TokenPlaced(token, cell(1, column)))

    @rule(token=tokens)
    def put_back(self, token: TokenId) -> None:
        self.feed(TokenPutBack(token))

    @rule(several=st.lists(tokens, max_size=3))
    def lift_several(self, several: Sequence[TokenId]) -> None:
        self.feed(SeveralTokens(tuple(several)))

    @rule(lying=st.dictionaries(tokens, cells))
    def find_board(self, lying: dict[TokenId, object]) -> None:
        self.feed(BoardBack(lying))  # type: ignore[arg-type] # cells

    @rule(
        event=st.sampled_from(
            [
                Begun(),
                BoardLost(),
                HelpAsked(),
                HintOrdered(3),
                DoneSaid(),
                Paused(),
                Resumed(),
                Skipped(),
                TimePassed(),
                VerdictOverridden(allowed=True),
                RobotDone(1),
                RobotFailed(1, "stuck"),
            ]
        )
    )
    def anything_else(self, event: Event) -> None:
        self.feed(event)

    @rule(reply=st.sampled_from(Reply), late=st.booleans())
    def answer(self, reply: Reply, *, late: bool) -> None:
        number = self.lesson.question or 0
        self.feed(Answered(number + late, reply))

    def feed(self, event: Event) -> None:
        before = self.lesson
        now = Milliseconds(before.now + 500)
        self.lesson, commands = step(before, event, now)
        self.log.append((event, now, commands))
        assert commands or isinstance(event, TimePassed)
        for command in commands:
            assert decode_command(encode_command(command)) == command
            if isinstance(command, Say):
                assert command.text not in self.heard[-3:]
                self.heard.append(command.text)
        if len(self.lesson.plays) > len(before.plays):
            shown = self.lesson.plays[-1]
            assert shown.moves
            assert shown.start.board.goal_row not in {m.origin.row for m in shown.moves}

    @invariant()
    def the_board_is_as_recorded_while_all_is_clear(self) -> None:
        lesson = getattr(self, "lesson", None)
        if (
            isinstance(lesson, Lesson)
            and lesson.stage is Stage.SHOWING
            and not (lesson.unclear or lesson.is_paused or not lesson.is_connected)
        ):
            expected = lesson.expected
            assert not lesson.table.astray(expected)
            assert lesson.table.air.keys() | lesson.table.cells.keys() == expected.cells.keys()

    def teardown(self) -> None:
        """Whoever clears the row, answers and shows gets to the end, and it is recorded."""
        if not hasattr(self, "lesson"):
            return
        if self.lesson.stage is Stage.READY:
            self.feed(Begun())
        if self.lesson.is_paused:
            self.feed(Resumed())
        wanted = len(self.lesson.plays) + 1
        for _ in range(MOST_STEPS):
            if len(self.lesson.plays) >= wanted:
                break
            self.go_on()
        assert len(self.lesson.plays) >= wanted
        self.feed(EndOrdered())
        assert self.lesson.stage is Stage.ENDED
        self.feed(TokenLifted(TOKENS[0]))
        notes = [c.note for *_, cs in self.log for c in cs if isinstance(c, Record)]
        assert notes.count(Note.ENDED.value) == 1
        self.check_replay()

    def go_on(self) -> None:
        lesson = self.lesson
        if lesson.stage is Stage.ASKING:
            self.feed(Answered(lesson.question or 0, Reply.YES))
        elif lesson.stage is Stage.CLEARING or not lesson.is_connected:
            self.feed(BoardBack(dict(zip(TOKENS, BOARD.storage_cells, strict=False))))
        elif lesson.unclear:
            self.feed(BoardBack(dict(lesson.expected.cells)))
            for token, where in lesson.expected.cells.items():
                self.feed(TokenPlaced(token, where))
        else:
            free = [one for one in BOARD.goal_cells if one not in lesson.expected.tokens]
            low = [t for t, at in lesson.expected.cells.items() if at.row != 1]
            self.feed(TokenPlaced(low[0], free[0]))

    def check_replay(self) -> None:
        lesson = self.first
        for event, now, commands in self.log:
            lesson, again = step(lesson, event, now)
            assert again == commands
        assert lesson == self.lesson


TestAnyLesson = AnyLesson.TestCase
