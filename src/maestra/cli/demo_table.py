"""The guided session's table: what is typed becomes a move, or the reason why not."""

from dataclasses import dataclass

from maestra.cli.demo_words import Wish
from maestra.cli.drawing import label
from maestra.cli.lesson import Speech
from maestra.cli.outputs import Said
from maestra.core.board import Cell
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, TokenId
from maestra.language.terminal import TerminalKey as Key


@dataclass(frozen=True, slots=True)
class Table:
    """What lies on the table, and moves on it as they are typed."""

    state: State
    deck: Deck
    speech: Speech

    def move(self, wish: Wish) -> Move | Said:
        """The move that is wished for, or why it cannot be made."""
        token = self._named(wish.token)
        if token is None:
            return Said(self.speech.say(Key.UNKNOWN_TOKEN, token=wish.token))
        origin = self.state.cells[token]
        goals = self.state.board.goal_cells
        if origin in goals:
            name = label(self.deck.by_id[token])
            return Said(self.speech.say(Key.ALREADY_THERE, token=name))
        destination = self._destination(wish.column, goals)
        return destination if isinstance(destination, Said) else Move(token, origin, destination)

    def _destination(self, column: int | None, goals: tuple[Cell, ...]) -> Cell | Said:
        empty = [cell for cell in goals if cell not in self.state.tokens]
        if column is None:
            return empty[0] if empty else Said(self.speech.say(Key.ROW_IS_FULL))
        if not 1 <= column <= len(goals):
            return Said(self.speech.say(Key.NO_SUCH_COLUMN, last=len(goals)))
        goal = goals[column - 1]
        return goal if goal in empty else Said(self.speech.say(Key.TAKEN, column=column))

    def _named(self, typed: str) -> TokenId | None:
        found = (one.id for one in self.deck.tokens if label(one).casefold() == typed)
        return next(found, None)
