"""Simulated caregivers: they mean certain rules, and answer what a dialogue asks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.contradictions import Said, Shown
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    CellIsWrong,
    Counts,
    Dialogue,
    Enough,
    Event,
    Finished,
    Replied,
    Side,
    SlipReplied,
    SlipReply,
    step,
)
from maestra.rules.answers import MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.completability import Conjunction, MoveAllowed
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play, play_of

SMALL_DECK = Deck(
    tuple(
        Token(TokenId(name), (("value", value), ("colour", colour)))
        for name, value, colour in (
            ("a", 1, "red"),
            ("b", 2, "blue"),
            ("c", 5, "red"),
            ("d", 6, "blue"),
            ("e", 9, "red"),
        )
    )
)
SMALL_BOARD = Board(3, 3)


def small(tokens: str, turn: int = 0, cells: Sequence[int] | None = None) -> Demonstration:
    """These tokens of the small deck onto the goal cells, from the left unless `cells` says."""
    storage = SMALL_BOARD.storage_cells
    start = State(
        SMALL_BOARD,
        {
            token.id: storage[(5 * k + turn) % len(storage)]
            for k, token in enumerate(SMALL_DECK.tokens)
        },
    )
    goal = SMALL_BOARD.goal_cells
    moves = tuple(
        Move(TokenId(token), start.cells[TokenId(token)], goal[cell])
        for token, cell in zip(tokens, cells or range(len(tokens)), strict=True)
    )
    return Demonstration(SMALL_DECK, start, moves)


@dataclass(frozen=True)
class Caregiver:
    """Means these rules and no others."""

    rules: tuple[Rule, ...]

    def is_right(self, play: Play) -> bool:
        """Whether a finished play is right."""
        return all(rule.holds(play) for rule in self.rules)

    def reply(self, question: Question) -> Reply:
        """The true answer."""
        match question:
            case RowQuestion(play):
                return _reply(self.is_right(play))
            case MoveQuestion(position, token, cell):
                all_rules = Conjunction(self.rules, position.setting)
                verdict = all_rules.judge(position, token, cell)
                return _reply(isinstance(verdict, MoveAllowed))
            case RuleQuestion(rule):
                return _reply(rule in self.rules)

    def wrong_cell(self, play: Play) -> Index | None:
        """A cell whose token, changed for another, would make the row right; the first."""
        for cell, token in enumerate(play.row):
            for other in range(len(play.setting.deck.tokens)):
                if token is not None and other not in play.row:
                    row = [*play.row[:cell], other, *play.row[cell + 1 :]]
                    again = Play.begin(play.setting)
                    for place, one in enumerate(row):
                        again = again if one is None else again.after(one, place)
                    if self.is_right(again):
                        return cell
        return None

    def event(self, dialogue: Dialogue) -> Event:
        """What this caregiver does about what is asked."""
        match dialogue.ask:
            case AskQuestion(question) | AskAgain(_, question):
                return Replied(self.reply(question))
            case AskCell(number):
                question = dialogue.answers[number].question
                assert isinstance(question, RowQuestion)
                return CellIsWrong(self.wrong_cell(question.play))
            case AskSlip(slip):
                play = play_of(dialogue.demonstrations[slip.demonstration])
                meant = self.is_right(play)
                return SlipReplied(SlipReply.CONFIRMED if meant else SlipReply.TAKEN_BACK)
            case AskWhichCounts(contradiction):
                return Counts(self._side(dialogue, contradiction.earlier, contradiction.later))
            case Finished():
                return Enough()

    def _side(self, dialogue: Dialogue, earlier: object, later: Said) -> Side:
        answer = dialogue.answers[later.answer]
        if answer.reply is not self.reply(answer.question):
            return Side.EARLIER
        if isinstance(earlier, Shown):
            play = play_of(dialogue.demonstrations[earlier.demonstration])
            return Side.NEITHER if self.is_right(play) else Side.LATER
        return Side.LATER

    def lead(self, dialogue: Dialogue) -> Dialogue:
        """The dialogue led to its end."""
        while not isinstance(dialogue.ask, Finished):
            dialogue = step(dialogue, self.event(dialogue))
        return dialogue


def _reply(yes: object) -> Reply:
    return Reply.YES if yes else Reply.NO
