"""A robot that has only a screen: what is said stands there as a line."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from maestra.coaching.commands import AskCaregiver, Command, MoveToken, PointAt, Say, Show, View
from maestra.coaching.events import Event, RobotDone, RobotFailed
from maestra.core.board import Cell
from maestra.core.faults import InvalidError
from maestra.core.tokens import TokenId

NO_HAND = "a screen has no hand"


class ScreenRobot:
    """Writes sentences; moves tokens only on a board that it is given a hand for."""

    def __init__(
        self,
        write: Callable[[str], None],
        hand: Callable[[TokenId, Cell], None] | None = None,
    ) -> None:
        """Write lines with `write`; move tokens with `hand`, if there is one.

        Args:
            write: puts one line on the screen.
            hand: moves a token, or raises InvalidError if it cannot.
        """
        self._write = write
        self._hand = hand
        self.pointed_at: tuple[Cell, ...] = ()
        """The cells that were pointed at last."""

    def carry_out(self, command: Command) -> Sequence[Event]:
        """Write what is said, shown or asked; move a token."""
        match command:
            case Say(text=text):
                self._write(text)
            case AskCaregiver(text=text):
                self._write(f"[{text}]")
            case Show(View.RULES, lines=lines):
                for line in lines:
                    self._write(line)
            case PointAt(cells):
                self.pointed_at = cells
            case MoveToken(number, token, _, destination):
                return [self._move(number, token, destination)]
            case _:
                pass
        return []

    def outcomes(self) -> Sequence[Event]:
        """None: every outcome is told at once."""
        return []

    def close(self) -> None:
        """Nothing to let go of."""

    def _move(self, number: int, token: TokenId, destination: Cell) -> Event:
        if self._hand is None:
            return RobotFailed(number, NO_HAND)
        try:
            self._hand(token, destination)
        except InvalidError as error:
            return RobotFailed(number, str(error))
        return RobotDone(number)
