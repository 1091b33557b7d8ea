"""How the exercises that therapists want are written: tokens, rules, a right play, a near miss.

A play is written as the tokens in the order of placement, from left to right; ``token@3`` goes
onto the third goal cell instead. Tokens lie in storage row by row in the order of their deck.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from maestra.core.board import Board, Row
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, Play, Setting
from maestra.rules.token_tests import (
    Comparison,
    Extreme,
    TokenTest,
    has,
)


@dataclass(frozen=True)
class TherapyExercise:
    """Rules in a caregiver's words, with a play that keeps them and one that just does not."""

    words: str
    setting: Setting
    rules: tuple[Rule, ...]
    right: str
    wrong: str

    def play(self, text: str) -> Play:
        """The play that is written so."""
        play = Play.begin(self.setting)
        for number, move in enumerate(text.split()):
            token, _, cell = move.partition("@")
            place = int(cell) - 1 if cell else number
            play = play.after(self.setting.number_of[TokenId(token)], place)
        return play


def laid_out(deck: Deck, columns: int = 5, order: str = "") -> Setting:
    """The deck's tokens in storage row by row, on a board of their own width."""
    names = order.split() or list(deck.by_id)
    rows = max(4, 1 + -(-len(names) // columns))
    board = Board(rows, columns, Row(1))
    places = {TokenId(n): c for n, c in zip(names, board.storage_cells, strict=False) if n != "-"}
    return Setting(deck, State(board, places))


def deck_of(shown: dict[str, dict[str, Value]], **meaning: object) -> Deck:
    tokens = tuple(Token(TokenId(name), tuple(one.items())) for name, one in shown.items())
    return Deck(tokens, **meaning)  # type: ignore[arg-type]  # each caller names a field of Deck


def numbers(*values: int) -> Setting:
    shown: dict[str, dict[str, Value]] = {str(value): {"value": value} for value in values}
    return laid_out(deck_of(shown), order=" ".join(shown))


_COLOURS: Final = {"r": "red", "b": "blue", "g": "green"}
_KINDS: Final = {"a": "animal", "p": "plant", "t": "tool", "f": "fruit"}
_DAYS: Final = ("Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun")
_SIZES: Final = ("tiny", "small", "medium", "large", "huge")


def coloured(names: str, order: str = "", columns: int = 5) -> Setting:
    """``r3``: red, 3, and round or square as the number is even or odd."""
    shown: dict[str, dict[str, Value]] = {
        name: {
            "colour": _COLOURS[name[0]],
            "number": int(name[1:]),
            "shape": "square" if int(name[1:]) % 2 else "round",
        }
        for name in names.split()
    }
    return laid_out(deck_of(shown), columns, order or names)


def kinds(names: str, order: str = "", columns: int = 5) -> Setting:
    """``a3``: an animal that weighs 3."""
    shown: dict[str, dict[str, Value]] = {
        name: {"category": _KINDS[name[0]], "weight": int(name[1:])} for name in names.split()
    }
    return laid_out(deck_of(shown), columns, order or names)


def letters(names: str, lexicon: tuple[str, ...] = (), **relations: object) -> Setting:
    """A token for each letter; a digit tells equal ones apart."""
    shown: dict[str, dict[str, Value]] = {name: {"letter": name[0]} for name in names.split()}
    return laid_out(deck_of(shown, lexicon=lexicon, relations=relations), order=names)


def named(names: str, **relations: object) -> Setting:
    shown: dict[str, dict[str, Value]] = {name: {"name": name} for name in names.split()}
    return laid_out(deck_of(shown, relations=relations), order=names)


def days(columns: int = 5) -> Setting:
    return laid_out(deck_of({d: {"day": d} for d in _DAYS}, cycles={"day": _DAYS}), columns)


def sized() -> Setting:
    return laid_out(deck_of({s: {"size": s} for s in _SIZES[::-1]}, orders={"size": _SIZES}))


def colour(name: str) -> TokenTest:
    return has(f"is-{name}", "colour")


def kind(name: str) -> TokenTest:
    return has(f"is-{name}", "category")


FULL: Final = FullRow()
LEFT_TO_RIGHT: Final = FillOrder(Filling.LEFT_TO_RIGHT)
TIME, ROW = Line.TIME, Line.ROW
EQUAL, AT_LEAST, AT_MOST = Comparison.EQUAL, Comparison.AT_LEAST, Comparison.AT_MOST
LOWEST, HIGHEST = Extreme.LOWEST, Extreme.HIGHEST

TEN: Final = numbers(19, 23, 32, 34, 36, 46, 51, 57, 63, 77)
SMALL: Final = numbers(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16)
TOYS: Final = coloured("r1 r2 r3 r4 b1 b2 b3 b4 g1 g2 g3")
THINGS: Final = kinds("a1 a2 a3 p1 p2 p3 t1 t2 f1 f2")
CAST: Final = letters("C U R I E A G B D O")
WORDS: Final = letters("B R E A D C H I K O N", ("BREAD", "CHAIR", "BACON", "radio"))
ROWS: Final = numbers(5, 1, 4, 2, 3, 9, 6, 8, 7, 10)
