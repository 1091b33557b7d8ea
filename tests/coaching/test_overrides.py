"""What a caregiver judged otherwise becomes evidence."""

from maestra.coaching.events import (
    Begun,
    Event,
    TimedEvent,
    TokenLifted,
    TokenPlaced,
    VerdictOverridden,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.overrides import overrides
from maestra.coaching.playing import step
from maestra.coaching.recording import Start
from maestra.coaching.session import Phase
from maestra.core.board import Cell
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move
from maestra.learning.fewshot.learner import learn
from maestra.rules.answers import MoveQuestion, Reply
from maestra.rules.forms.selection import EveryToken
from tests.coaching.test_recording import start


class Played:
    """A session that is played, and all that happened."""

    def __init__(self) -> None:
        self.start: Start = start()
        self.session = self.start.session()
        self.events: list[TimedEvent] = []
        self.tell(Begun())

    def tell(self, event: Event) -> None:
        at = Milliseconds(1_000 * len(self.events))
        self.session, _ = step(self.session, event, at)
        self.events.append(TimedEvent(at, event))

    def make(self, move: Move, cell: Cell | None = None) -> None:
        self.tell(TokenLifted(move.token))
        self.tell(TokenPlaced(move.token, cell or move.destination))

    @property
    def right(self) -> Move:
        return self.session.game.referee.right_moves(self.session.position)[0]

    @property
    def wrong(self) -> Move:
        """The first of them."""
        return self.wrongs[0]

    @property
    def wrongs(self) -> list[Move]:
        """Onto the last free goal cell, against the order of placement."""
        now = self.session.position.now
        allowed = set(self.session.game.referee.right_moves(self.session.position))
        free = [cell for cell in now.board.goal_cells if cell not in now.tokens]
        stored = [one for one in now.cells.items() if one[1] not in now.board.goal_cells]
        moves = [Move(token, origin, cell) for cell in reversed(free) for token, origin in stored]
        return [move for move in moves if move not in allowed]


def test_a_refused_move_that_was_granted_is_a_yes_where_it_was_made() -> None:
    played = Played()
    played.make(played.right)
    before, wrong = played.session.position, played.wrong
    played.make(wrong)
    played.tell(VerdictOverridden(allowed=True))
    (found,) = overrides(played.start, played.events)
    assert (found.position, found.move, found.allowed) == (before, wrong, True)
    assert found.broken != ()
    answer = found.answer
    assert answer is not None
    assert answer.reply is Reply.YES
    assert isinstance(answer.question, MoveQuestion)
    asked = answer.question.position.after(answer.question.token, answer.question.cell)
    assert asked.moves() == (*before.moves, wrong)


def test_a_right_move_that_was_taken_back_is_a_no() -> None:
    played = Played()
    before, right = played.session.position, played.right
    played.make(right)
    played.tell(VerdictOverridden(allowed=False))
    (found,) = overrides(played.start, played.events)
    assert (found.position, found.move, found.allowed, found.broken) == (before, right, False, ())
    assert found.answer is not None
    assert found.answer.reply is Reply.NO


def test_of_one_move_the_last_word_counts() -> None:
    played = Played()
    wrong = played.wrong
    played.make(wrong)
    played.tell(VerdictOverridden(allowed=True))
    played.tell(VerdictOverridden(allowed=False))
    (found,) = overrides(played.start, played.events)
    assert (found.move, found.allowed) == (wrong, False)


def test_what_changed_no_verdict_is_no_evidence() -> None:
    played = Played()
    played.tell(VerdictOverridden(allowed=True))
    played.make(played.right)
    played.tell(VerdictOverridden(allowed=True))
    assert overrides(played.start, played.events) == ()


def test_a_move_that_rules_cannot_speak_of_is_no_answer() -> None:
    played = Played()
    wrong = played.wrong
    storage = played.start.state.board.storage_cells
    empty = next(cell for cell in storage if cell not in played.start.state.tokens)
    played.make(wrong, empty)
    played.tell(VerdictOverridden(allowed=True))
    (found,) = overrides(played.start, played.events)
    assert found.move.destination == empty
    assert found.answer is None


def test_what_was_granted_changes_what_is_learned() -> None:
    shown, played = Played(), Played()
    while shown.session.phase is Phase.PLAYING:
        shown.make(shown.right)
    position = shown.session.position
    demonstration = Demonstration(shown.start.deck, position.start, position.moves)
    # The tokens shown lay next to the goal row by chance; one from elsewhere may be placed, too.
    move = next(one for one in played.wrongs if one.origin.row == 3)
    played.make(move)
    played.tell(VerdictOverridden(allowed=True))
    answers = [one.answer for one in overrides(played.start, played.events) if one.answer]
    assert any(isinstance(one, EveryToken) for one in learn([demonstration]).rules)
    assert not any(isinstance(one, EveryToken) for one in learn([demonstration], answers).rules)
