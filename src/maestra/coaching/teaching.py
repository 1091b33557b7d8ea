"""A caregiver's teaching by demonstration as a state machine: event in, commands out.

Each play that is shown is one move after another from storage to the goal row. A token taken out
of the row again is a move that does not count; tokens moved about in storage are another start.
Where several tokens are in the air, nothing is recorded until the board is as it was. A play ends
when the row is full or somebody says that this is all; then what is understood is said back, a
question may be asked, and the row is cleared for the next.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Final, assert_never

from maestra.coaching.commands import (
    AskCaregiver,
    Command,
    Commands,
    Express,
    Expression,
    Matter,
    Record,
    Show,
    View,
)
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
from maestra.coaching.lesson import Lesson, Stage
from maestra.coaching.notes import Note
from maestra.coaching.table import Table
from maestra.core.board import Cell
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import TokenId
from maestra.language.coach import question_to_caregiver
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.rules.answers import Reply


def step(lesson: Lesson, event: Event, now: Milliseconds) -> tuple[Lesson, Commands]:
    """The lesson after `event`, and what robot, screen and record do now.

    Args:
        lesson: the lesson before it.
        event: what happened; any event may come at any time.
        now: since the lesson began; earlier than the event before counts as the same time.
    """
    turn = _Turn(replace(lesson, now=max(now, lesson.now)))
    if lesson.stage is Stage.ENDED:
        turn.unexpected(event)
        turn.show(View.ENDED)
    else:
        begins = lesson.stage is Stage.READY
        if begins:
            turn.begin()
        if not (begins and isinstance(event, Begun)):
            _answer(turn, event)
    if not turn.commands and not isinstance(event, TimePassed):
        turn.note(Note.HEARD, event=event.event)
    return turn.lesson, tuple(turn.commands)


def _answer(turn: _Turn, event: Event) -> None:  # noqa: C901, PLR0912 - one case for each event
    match event:
        case TokenLifted(token):
            turn.lift((token,))
        case SeveralTokens(tokens):
            turn.lift(tokens)
        case TokenPlaced(token, cell):
            turn.place(token, cell)
        case TokenPutBack(token):
            turn.put_back(token)
        case BoardLost():
            turn.lose_board()
        case BoardBack(cells):
            turn.find_board(cells)
        case DoneSaid():
            turn.end_play()
        case Skipped():
            turn.forget()
        case Answered(number, reply):
            turn.answered(number, reply)
        case Paused():
            turn.halt(paused=True)
        case Resumed():
            turn.halt(paused=False)
        case EndOrdered():
            turn.stop()
        case HelpAsked() | HintOrdered():
            turn.say_where_we_are()
        case Begun() | VerdictOverridden():
            turn.unexpected(event)
            turn.say_where_we_are()
        case RobotDone(number):
            turn.note(Note.ROBOT_DONE, command=number)
        case RobotFailed(number, why):
            turn.note(Note.ROBOT_FAILED, command=number, why=why)
        case TimePassed():
            pass
        case _:
            assert_never(event)


_VIEWS: Final = {
    Stage.SHOWING: (CoachKey.SHOW_ME, View.SHOW_ME),
    Stage.CLEARING: (CoachKey.CLEAR_THE_ROW, View.CLEAR_THE_ROW),
}


class _Turn:
    """The lesson and the commands so far, while one event is answered."""

    def __init__(self, lesson: Lesson) -> None:
        self.lesson = lesson
        self.commands: list[Command] = []

    def say(self, key: CoachKey, **parts: str) -> None:
        lesson = self.lesson
        said, voice = lesson.voice.say(key, lesson, **parts)
        self.lesson = replace(lesson, voice=voice)
        self.commands.append(said)

    def show(self, view: View, tokens: Iterable[TokenId] = (), lines: Iterable[str] = ()) -> None:
        self.commands.append(Show(view, tuple(tokens), tuple(lines)))

    def note(self, note: Note, **fields: int | bool | str | None) -> None:
        self.commands.append(Record(note.value, fields))

    def unexpected(self, event: Event) -> None:
        self.note(Note.UNEXPECTED, event=event.event)

    def ask(self, matter: Matter, text: str) -> None:
        number = self.lesson.numbers + 1
        self.lesson = replace(self.lesson, numbers=number, question=number)
        self.commands.append(AskCaregiver(number, matter, text))

    def say_where_we_are(self) -> None:
        """What is to be done now."""
        lesson = self.lesson
        if lesson.is_paused:
            self.show(View.PAUSED)
        elif not lesson.is_connected:
            self.show(View.NO_BOARD)
        elif lesson.stage is Stage.ASKING:
            self._ask_on()
        else:
            key, view = _VIEWS[lesson.stage]
            self.say(key)
            self.show(view)

    def begin(self) -> None:
        self.lesson = replace(self.lesson, stage=Stage.SHOWING)
        self.note(Note.BEGUN)
        self.commands.append(Express(Expression.HAPPY))
        self.say(CoachKey.WELCOME)
        if self.lesson.in_row:
            self._clear()
        else:
            self.say(CoachKey.SHOW_ME)
            self.show(View.SHOW_ME)

    def lift(self, tokens: Iterable[TokenId]) -> None:
        lesson = self.lesson
        table = lesson.table
        for token in filter(self._is_known, tokens):
            if token in table.cells:
                table = table.lifted(token)
        self.lesson = replace(self.lesson, table=table)
        if len(table.air) > 1 and lesson.stage is Stage.SHOWING and not lesson.unclear:
            self._wait_for_order()

    def place(self, token: TokenId, cell: Cell) -> None:
        lesson = self.lesson
        if not self._is_known(token):
            return
        if cell not in lesson.start.board:
            self._check_board()
            return
        self.lesson = lesson = replace(lesson, table=lesson.table.placed(token, cell))
        if lesson.is_paused or not lesson.is_connected:
            self.say_where_we_are()
        elif lesson.stage is Stage.SHOWING:
            self._record_move(token, cell)
        else:
            self._go_on_when_clear()

    def put_back(self, token: TokenId) -> None:
        table = self.lesson.table
        where = table.air.get(token, table.cells.get(token))
        if where is None:
            self._is_known(token)
        else:
            self.place(token, where)

    def lose_board(self) -> None:
        self.lesson = replace(self.lesson, is_connected=False)
        self.note(Note.BOARD_LOST)
        self.say(CoachKey.BOARD_LOST)
        self.show(View.NO_BOARD)

    def find_board(self, cells: dict[TokenId, Cell]) -> None:
        """No move is made up for what happened unseen."""
        lesson = self.lesson
        board = lesson.start.board
        lying = {token: cell for token, cell in cells.items() if cell in board}
        table = Table.seen(lying, lesson.expected)
        self.lesson = replace(lesson, is_connected=True, table=table)
        astray = table.astray(lesson.expected)
        self.note(Note.BOARD_BACK, astray=len(astray), missing=len(table.air))
        self.say(CoachKey.BOARD_BACK)
        if len(lying) < len(cells) or any(token not in lesson.start.cells for token in lying):
            self._check_board()
        if lesson.stage is Stage.SHOWING and (astray or table.air):
            self._wait_for_order()
        elif lesson.stage is Stage.CLEARING:
            self._go_on_when_clear()

    def halt(self, *, paused: bool) -> None:
        if self.lesson.is_paused is paused:
            self.note(Note.UNEXPECTED, event="paused" if paused else "resumed")
            self.say_where_we_are()
            return
        self.lesson = replace(self.lesson, is_paused=paused)
        self.note(Note.PAUSED if paused else Note.RESUMED)
        self.say(CoachKey.PAUSED if paused else CoachKey.RESUMED)
        astray = self.lesson.table.astray(self.lesson.expected)
        if not paused and self.lesson.stage is Stage.SHOWING and astray:
            self._wait_for_order()
        self.say_where_we_are()

    def end_play(self) -> None:
        lesson = self.lesson
        if lesson.stage is not Stage.SHOWING or lesson.is_paused or lesson.unclear:
            self.say_where_we_are()
        elif not lesson.moves:
            self.say(CoachKey.NOTHING_SHOWN)
            self.show(View.SHOW_ME)
        else:
            self._learn(Demonstration(lesson.deck, lesson.start, lesson.moves))

    def forget(self) -> None:
        """The play that is being shown does not count; a question is left open."""
        lesson = self.lesson
        if lesson.stage is Stage.ASKING and lesson.question is not None:
            self.answered(lesson.question, Reply.UNSURE)
        elif lesson.stage is Stage.SHOWING:
            self.say(CoachKey.FORGOTTEN)
            self._clear()
        else:
            self.say_where_we_are()

    def answered(self, number: int, reply: Reply) -> None:
        lesson = self.lesson
        self.note(Note.ANSWERED, question=number, reply=reply.value)
        if lesson.stage is not Stage.ASKING or number != lesson.question:
            return
        self.lesson = replace(lesson, teacher=lesson.teacher.answered(reply), question=None)
        self.say(CoachKey.THANKS)
        self._say_back()

    def stop(self) -> None:
        lesson = self.lesson
        self.lesson = replace(lesson, stage=Stage.ENDED)
        self.say(CoachKey.LEARNED if lesson.is_clear else CoachKey.NOT_CLEAR)
        self.show(View.ENDED)
        self.note(Note.LEARNED, learned=lesson.is_clear, demonstrations=len(lesson.plays))
        self.note(Note.ENDED, ending="stopped", ms=lesson.now)

    def _is_known(self, token: TokenId) -> bool:
        if token in self.lesson.start.cells:
            return True
        self.note(Note.UNKNOWN_TOKEN, token=token)
        self.say(CoachKey.UNKNOWN_TOKEN)
        return False

    def _check_board(self) -> None:
        lesson = self.lesson
        text = question_to_caregiver(AskKey.CHECK_BOARD, lesson.language, lesson.speaker, {})
        number = lesson.numbers + 1
        self.lesson = replace(lesson, numbers=number)
        self.commands.append(AskCaregiver(number, Matter.CHECK_BOARD, text))

    def _wait_for_order(self) -> None:
        self.lesson = replace(self.lesson, unclear=True)
        lesson = self.lesson
        wrong = (*lesson.table.astray(lesson.expected), *lesson.table.air)
        self.note(Note.UNCLEAR, token=wrong[-1] if wrong else None)
        self.say(CoachKey.ONE_AT_A_TIME)
        self.show(View.ONE_AT_A_TIME, dict.fromkeys(wrong))

    def _record_move(self, token: TokenId, cell: Cell) -> None:
        lesson = self.lesson
        expected = lesson.expected
        if lesson.unclear:
            if not lesson.table.air and not lesson.table.astray(expected):
                self.lesson = replace(lesson, unclear=False)
                self.say(CoachKey.THANKS)
                self.show(View.SHOW_ME)
            return
        home, goal_row = expected.cells[token], lesson.start.board.goal_row
        if cell == home:
            self.note(Note.RETURNED, token=token)
        elif cell in expected.tokens:
            self._wait_for_order()
        elif home.row == goal_row:
            self._take_back(token, cell)
        elif cell.row != goal_row:
            self._rearrange(token, cell)
        else:
            self.lesson = replace(lesson, moves=(*lesson.moves, Move(token, home, cell)))
            number = len(lesson.moves) + 1
            self.note(Note.MOVE, token=token, row=cell.row, column=cell.column, step=number)
            if all(one in self.lesson.expected.tokens for one in lesson.start.board.goal_cells):
                self.end_play()

    def _take_back(self, token: TokenId, cell: Cell) -> None:
        """A token of the row lies elsewhere: its move does not count, or is another one now."""
        lesson = self.lesson
        moves = tuple(move for move in lesson.moves if move.token != token)
        if cell.row == lesson.start.board.goal_row:
            self.lesson = replace(
                lesson, moves=(*moves, Move(token, lesson.start.cells[token], cell))
            )
            self.say(CoachKey.TAKEN_BACK)
            return
        self.lesson = replace(lesson, moves=moves)
        if cell != lesson.start.cells[token]:
            self._rearrange(token, cell)
        self.say(CoachKey.TAKEN_BACK)

    def _rearrange(self, token: TokenId, cell: Cell) -> None:
        """A token lies elsewhere in storage: the play began so, if that cell was empty then."""
        lesson = self.lesson
        if cell in lesson.start.tokens:
            self._wait_for_order()
            return
        start = State(lesson.start.board, {**lesson.start.cells, token: cell})
        self.lesson = replace(lesson, start=start)

    def _learn(self, play: Demonstration) -> None:
        lesson = self.lesson
        number = len(lesson.plays) + 1
        try:
            teacher = lesson.teacher.shown(play)
        except InvalidError:
            text = question_to_caregiver(AskKey.DEMONSTRATION, lesson.language, lesson.speaker, {})
            self.ask(Matter.DEMONSTRATION, text)
            self._clear()
            return
        self.lesson = replace(lesson, teacher=teacher, plays=(*lesson.plays, play))
        self.note(Note.DEMONSTRATION, number=number, moves=len(play.moves))
        self.say(CoachKey.SEEN)
        self._say_back()

    def _say_back(self) -> None:
        """What is understood; then the next question, or the next play."""
        understood = self.lesson.teacher.understood
        self.lesson = replace(self.lesson, is_clear=understood.is_clear)
        self.show(View.RULES, lines=understood.rules)
        self.say(CoachKey.UNDERSTOOD, rules=" ".join(understood.rules))
        if understood.question is not None:
            self.lesson = replace(self.lesson, stage=Stage.ASKING)
            self._ask_on()
            return
        if not understood.is_clear:
            self.say(CoachKey.SHOW_ANOTHER)
        self._clear()

    def _ask_on(self) -> None:
        question = self.lesson.teacher.understood.question
        self.ask(Matter.QUESTION, question or "")

    def _clear(self) -> None:
        self.lesson = replace(self.lesson, stage=Stage.CLEARING, unclear=False)
        self._go_on_when_clear()
        if self.lesson.stage is Stage.CLEARING:
            self.say(CoachKey.CLEAR_THE_ROW)
            self.show(View.CLEAR_THE_ROW, self.lesson.in_row)

    def _go_on_when_clear(self) -> None:
        """The next play begins as the tokens lie once the row is empty and nobody holds one."""
        lesson = self.lesson
        if lesson.stage is not Stage.CLEARING or lesson.table.air or self.lesson.in_row:
            return
        start = State(lesson.start.board, lesson.table.cells)
        self.lesson = replace(lesson, stage=Stage.SHOWING, start=start, moves=())
        self.show(View.SHOW_ME)
