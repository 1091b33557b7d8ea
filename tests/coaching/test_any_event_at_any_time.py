"""Whatever happens, in whatever order: never stuck, hints true and within their level."""

from __future__ import annotations

import json
from collections.abc import Sequence

from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from maestra.coaching.commands import (
    Command,
    Commands,
    LookAt,
    MoveToken,
    PointAt,
    Record,
    Say,
    decode_command,
    encode_command,
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
    decode_event,
    encode_event,
)
from maestra.coaching.notes import Note
from maestra.coaching.session import Phase, Session
from maestra.coaching.settings import (
    Behaviour,
    Helper,
    Mental,
    Modality,
    Persona,
    PolicyName,
    Profile,
    Reach,
    Settings,
)
from maestra.core.tokens import TokenId
from maestra.language import Language
from maestra.language.coach_keys import CoachKey
from maestra.rules.answers import Reply
from tests.coaching.driving import Driver
from tests.coaching.plain_referee import (
    ANYTHING,
    ASCENDING,
    BOARD,
    NOTHING,
    ONE_OR_TWO_RISING,
    TOKENS,
    cell,
    game,
)

tokens = st.sampled_from((*TOKENS, TokenId("stranger")))
cells = st.one_of(st.sampled_from(BOARD.cells), st.just(cell(9, 9)))
SHOWN = {CoachKey.THIS_ONE.value, CoachKey.TOGETHER.value}
MOST_STEPS_TO_THE_END = 60


@st.composite
def settings(draw: st.DrawFn) -> Settings:
    least = draw(st.integers(0, 5))
    most = draw(st.integers(least, 5))
    return Settings(
        profile=Profile(draw(st.sampled_from(Mental)), reach=draw(st.sampled_from(Reach))),
        language=draw(st.sampled_from(Language)),
        modalities=tuple(draw(st.sets(st.sampled_from(Modality), min_size=1))),
        behaviour=draw(st.sampled_from(Behaviour)),
        persona=draw(st.sampled_from(Persona)),
        put_back=draw(st.sampled_from(Helper)),
        robot_moves=draw(st.booleans()),
        errorless=draw(st.booleans()),
        attempts=draw(st.integers(1, 3)),
        policy=draw(st.sampled_from(PolicyName)),
        level=draw(st.integers(least, most)),
        least_level=least,
        most_level=most,
    )


class AnyEventAtAnyTime(RuleBasedStateMachine):
    """A session that anything can happen to."""

    driver: Driver

    @initialize(
        settings=settings(),
        rows=st.sampled_from([ASCENDING, ONE_OR_TWO_RISING, ANYTHING, NOTHING]),
        seed=st.integers(0, 2**64 - 1),
    )
    def begin(self, settings: Settings, rows: frozenset[tuple[TokenId, ...]], seed: int) -> None:
        self.driver = Driver.of(game(settings, rows, seed, settings.language))
        self.heard: list[str] = []
        self.feed(Begun())

    @rule(token=tokens)
    def lift(self, token: TokenId) -> None:
        self.feed(TokenLifted(token))

    @rule(token=tokens, where=cells)
    def place(self, token: TokenId, where: object) -> None:
        self.feed(TokenPlaced(token, where))  # type: ignore[arg-type] # a cell

    @rule(data=st.data())
    def move_rightly(self, data: st.DataObject) -> None:
        session = self.session
        right = session.game.referee.right_moves(session.position)
        if right:
            move = data.draw(st.sampled_from(right))
            self.feed(TokenLifted(move.token))
            self.feed(TokenPlaced(move.token, move.destination))

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
                DoneSaid(),
                Paused(),
                Resumed(),
                Skipped(),
                VerdictOverridden(allowed=True),
                VerdictOverridden(allowed=False),
            ]
        )
    )
    def anything_else(self, event: Event) -> None:
        self.feed(event)

    @rule(level=st.integers(0, 5))
    def order_hint(self, level: int) -> None:
        self.feed(HintOrdered(level))

    @rule(number=st.integers(0, 12), failed=st.booleans())
    def hear_from_robot(self, number: int, *, failed: bool) -> None:
        self.feed(RobotFailed(number, "stuck") if failed else RobotDone(number))

    @rule(number=st.integers(0, 12), reply=st.sampled_from(Reply))
    def answer(self, number: int, reply: Reply) -> None:
        self.feed(Answered(number, reply))

    @rule(after_ms=st.integers(-1_000, 60_000))
    def let_time_pass(self, after_ms: int) -> None:
        self.feed(TimePassed(), after_ms)

    @property
    def session(self) -> Session:
        return self.driver.session

    def feed(self, event: Event, after_ms: int = 700) -> None:
        commands = self.driver.feed(event, max(after_ms, -self.session.now))
        if not isinstance(event, TimePassed):
            assert commands
        self.check_words(commands)
        self.check_hints(commands)
        for command in commands:
            written = json.loads(json.dumps(encode_command(command)))
            assert decode_command(written) == command
        timed = self.driver.events[-1]
        assert decode_event(json.loads(json.dumps(encode_event(timed)))) == timed

    def check_words(self, commands: Commands) -> None:
        for command in commands:
            if isinstance(command, Say):
                assert command.text not in self.heard[-3:]
                self.heard.append(command.text)

    def check_hints(self, commands: Commands) -> None:
        limits = self.session.game.limits
        for number, command in enumerate(commands):
            match command:
                case Record(Note.HELP.value, fields):
                    level = fields["level"]
                    assert isinstance(level, int)
                    assert level <= limits.most
                case Say():
                    self.check_hint(command, commands[number + 1 :])
                case _:
                    pass

    def check_hint(self, hint: Say, after: Sequence[Command]) -> None:
        session = self.session
        right = session.game.referee.right_moves(session.position)
        right = tuple(move for move in right if move not in session.step.vetoed)
        lies_at = {where: token for token, where in session.position.now.cells.items()}
        match CoachKey(hint.key):
            case CoachKey.REMIND:
                assert hint.arguments["rule"] in session.game.referee.rules
            case CoachKey.LOOK_AT_ROW:
                shown = next((c.cells for c in after if isinstance(c, LookAt)), None)
                if shown is not None:
                    assert {move.origin for move in right} & set(shown)
            case CoachKey.ONE_OF_THESE:
                pointed = next(c.cells for c in after if isinstance(c, PointAt))
                movable = {move.token for move in right}
                assert sum(lies_at[where] in movable for where in pointed) == 1
            case CoachKey.THIS_ONE | CoachKey.TOGETHER:
                pointed = next(c.cells for c in after if isinstance(c, PointAt))
                assert pointed in {(move.origin, move.destination) for move in right}
            case CoachKey.I_PLACE:
                moved = next(c for c in after if isinstance(c, MoveToken))
                moves = {(move.token, move.origin, move.destination) for move in right}
                assert (moved.token, moved.origin, moved.destination) in moves
            case _:
                pass

    @invariant()
    def somebody_is_always_asked_to_put_back(self) -> None:
        session = self.session
        astray = session.table.astray(session.position.now)
        if session.phase is Phase.PLAYING and session.connected:
            assert (session.waiting is not None) == bool(astray)

    @invariant()
    def something_is_always_due(self) -> None:
        session = self.session
        if session.phase is Phase.PLAYING and session.connected:
            assert (
                session.prompt_at if session.waiting is None else session.waiting.until
            ) is not None

    def teardown(self) -> None:
        """With people who do what they are asked, every session ends, and is recorded."""
        if not hasattr(self, "driver"):
            return
        if self.session.phase is not Phase.ENDED:
            self.come_to_order()
        for _ in range(MOST_STEPS_TO_THE_END):
            if self.session.phase is Phase.ENDED:
                break
            self.do_what_is_due()
        if self.session.phase is not Phase.ENDED:
            right = self.session.game.referee.right_moves(self.session.position)
            assert not set(right) - self.session.step.vetoed
            assert self.session.question is not None
            self.feed(EndOrdered())
        notes = [c.note for step in self.driver.commands for c in step if isinstance(c, Record)]
        assert notes.count(Note.ENDED.value) == 1
        self.check_replay()

    def come_to_order(self) -> None:
        """The session goes on, the board answers, and nobody holds a token."""
        if self.session.phase is Phase.PAUSED:
            self.feed(Resumed())
        table = self.session.table
        taken = set(table.cells.values())
        lying = dict(table.cells)
        for held in table.air:
            free = next(where for where in BOARD.cells if where not in taken)
            lying[held] = free
            taken.add(free)
        self.feed(BoardBack(lying))

    def do_what_is_due(self) -> None:
        session = self.session
        astray = session.table.astray(session.position.now)
        if astray:
            before = session.waiting
            assert before is not None
            self.feed(TimePassed(), before.until - session.now)
            after = self.session.waiting
            assert after is not None
            ready = session.game.settings.ready_helpers
            assert len(ready) == 1 or after.helper is not before.helper
            for token in astray:
                self.feed(TokenLifted(token))
            for token in astray:
                self.feed(TokenPlaced(token, session.position.now.cells[token]))
            return
        right = set(session.game.referee.right_moves(session.position)) - session.step.vetoed
        if right:
            move = min(right, key=lambda one: one.origin)
            self.feed(TokenLifted(move.token))
            self.feed(TokenPlaced(move.token, move.destination))
        else:
            prompt = session.prompt_at
            assert prompt is not None
            self.feed(TimePassed(), prompt - session.now)

    def check_replay(self) -> None:
        again = Driver.of(self.session.game)
        for timed, commands in zip(self.driver.events, self.driver.commands, strict=True):
            assert again.feed(timed.what, timed.at - again.session.now) == commands
        assert again.session == self.session


TestAnyEventAtAnyTime = AnyEventAtAnyTime.TestCase
