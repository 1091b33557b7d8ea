"""Write examples/: the paper's six exercises as a caregiver would show them, and as patients play.

    python scripts/write_examples.py

Each file of demonstrations is as small as one that teaches its exercise can be, and right in the
one way that matters: every action is shown, and shown again from another row and another column,
so that nothing but the rule is the same each time. The numbers and letters are the paper's where
it prints them.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Final

from maestra.core.board import Board, Cell
from maestra.core.demonstration import Demonstration, Play
from maestra.core.formats import encode_demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId, Value

FOLDER: Final = Path(__file__).parents[1] / "examples"
SEED: Final = 2019
"""The year of the paper."""

BOARD: Final = Board()
NUMBERS: Final = (19, 23, 32, 34, 36, 46, 51, 57, 63, 68)
"""Exactly five are odd, so that (i) has one right row; six may go first in ascending order."""
LETTERS: Final = tuple("CURIEAGBDO")

Row = tuple[Value, ...]
"""What the goal row shows at the end, from left to right."""


@dataclass(frozen=True, slots=True)
class Slip:
    """A wrong move, and where in a right play it happens; it is put back, and the play goes on."""

    label: str
    shown: Value
    column: int
    before: int
    """The number of right moves made by then."""


@dataclass(frozen=True, slots=True)
class Exercise:
    """One of the paper's six: how it is shown, and how it is played."""

    attribute: str
    values: tuple[Value, ...]
    shown: tuple[Row, ...]
    """The row that each demonstration makes; neighbours with the same row differ in the start."""
    played: Row
    """A right row."""
    slips: tuple[Slip, ...]


def windows(values: Sequence[Value]) -> tuple[Row, ...]:
    """Each five neighbours, twice: every action of an ordering, and each in two contexts."""
    starts = range(len(values) - len(BOARD.goal_cells) + 1)
    return tuple(tuple(values[at : at + 5]) for at in starts for _ in range(2))


def turns(values: Sequence[Value]) -> tuple[Row, ...]:
    """Each value once on each of the five cells."""
    return tuple(
        tuple(values[(first + cell) % len(values)] for cell in range(5))
        for first in range(len(values))
    )


ODD: Final = tuple(number for number in NUMBERS if number % 2)
SORTED_LETTERS: Final = tuple(sorted(LETTERS))

EXERCISES: Final[Mapping[str, Exercise]] = {
    "odd-ascending": Exercise(
        "value",
        NUMBERS,
        (ODD, ODD),
        ODD,
        (Slip("an even number", 32, 2, 1), Slip("a number left out", 51, 2, 1)),
    ),
    "ascending": Exercise(
        "value",
        NUMBERS,
        windows(NUMBERS),
        (19, 34, 46, 57, 68),
        (
            Slip("smaller than the one on its left", 32, 3, 2),
            Slip("too large for the row to be filled", 51, 1, 0),
            Slip("not the next cell", 19, 3, 0),
        ),
    ),
    "descending": Exercise(
        "value",
        NUMBERS,
        windows(NUMBERS[::-1]),
        (68, 57, 46, 34, 19),
        (
            Slip("larger than the one on its left", 63, 3, 2),
            Slip("too small for the row to be filled", 34, 1, 0),
        ),
    ),
    "first-row": Exercise(
        "value",
        NUMBERS,
        turns(NUMBERS),
        (36, 19, 68, 23, 51),
        (Slip("from another row", 46, 2, 1), Slip("not straight up", 68, 2, 1)),
    ),
    "curie": Exercise(
        "letter",
        LETTERS,
        (tuple("CURIE"), tuple("CURIE")),
        tuple("CURIE"),
        (Slip("a letter of another word", "A", 2, 1), Slip("a letter too early", "R", 2, 1)),
    ),
    "letters": Exercise(
        "letter",
        LETTERS,
        windows(SORTED_LETTERS),
        tuple("ACEIU"),
        (
            Slip("before the one on its left", "B", 3, 2),
            Slip("too late for the row to be filled", "O", 1, 0),
        ),
    ),
}


def main() -> None:
    """Write every file."""
    for name, content in files().items():
        path = FOLDER / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
        print(FOLDER.name, name, sep="/")


def files() -> dict[str, str]:
    """The name of each file under examples/ with its content; the same on every run."""
    written: dict[str, str] = {}
    for name, exercise in EXERCISES.items():
        chance = Random(f"{SEED} {name}")
        deck = deck_of(exercise.attribute, exercise.values)
        written[f"{name}.jsonl"] = _lines(demonstrations(name, exercise, deck, chance))
        written[f"plays/{name}.jsonl"] = _lines(plays(name, exercise, deck, chance))
        written[f"positions/{name}.jsonl"] = _lines(positions(name, exercise, deck, chance))
    return written


def deck_of(attribute: str, values: Iterable[Value]) -> Deck:
    """Tokens with UIDs as the tags of the board have them: seven bytes, NXP's 04 first."""
    chance = Random(f"{SEED} {attribute}")
    return Deck(
        tuple(
            Token(TokenId(f"04{chance.randbytes(5).hex()}80".upper()), ((attribute, value),))
            for value in values
        )
    )


def demonstrations(
    name: str, exercise: Exercise, deck: Deck, chance: Random
) -> Iterator[Demonstration]:
    """The rows to be shown; the same row again starts elsewhere, in other rows and columns."""
    before: Demonstration | None = None
    total = len(exercise.shown)
    for number, row in enumerate(exercise.shown, start=1):
        tokens = _tokens(deck, row)
        start = _start(name, deck, tokens, chance)
        while before is not None and _repeats(before, tokens, start):
            start = _start(name, deck, tokens, chance)
        label = f"{name}, {number} of {total}"
        before = Demonstration(
            deck, start, _moves(start, tokens), label, _times(len(tokens), chance), "simulated"
        )
        yield before


def plays(name: str, exercise: Exercise, deck: Deck, chance: Random) -> Iterator[Play]:
    """A right play, then the same with each slip, then one with all that left the row open."""
    tokens = _tokens(deck, exercise.played)
    yield _play(deck, _start(name, deck, tokens, chance), tokens, (), "right", chance)
    for slip in exercise.slips:
        start = _start(name, deck, tokens, chance)
        label = f"wrong and put back: {slip.label}"
        yield _play(deck, start, tokens, (slip,), label, chance)
    start = _start(name, deck, tokens, chance)
    yield _play(deck, start, tokens[:3], exercise.slips[:1], "given up after a slip", chance)


def positions(
    name: str, exercise: Exercise, deck: Deck, chance: Random
) -> Iterator[Demonstration]:
    """The right play before its first move, under way, and done."""
    tokens = _tokens(deck, exercise.played)
    start = _start(name, deck, tokens, chance)
    whole = Demonstration(deck, start, _moves(start, tokens), source="simulated")
    for moves in (0, 2, 4, 5):
        yield whole.until(moves)


def _start(name: str, deck: Deck, moved: Sequence[TokenId], chance: Random) -> State:
    """Any storage cells; for first-row the moved tokens lie below where they go."""
    above = BOARD.storage_cells[:5] if name == "first-row" else ()
    free = [cell for cell in BOARD.storage_cells if cell not in above]
    placed: dict[TokenId, Cell] = dict(zip(moved, above, strict=False))
    others = [token.id for token in deck.tokens if token.id not in placed]
    return State(BOARD, placed | dict(zip(others, chance.sample(free, len(others)), strict=True)))


def _repeats(before: Demonstration, tokens: Sequence[TokenId], start: State) -> bool:
    """Whether the same row starts with a token in the row or column where it started before."""
    if [move.token for move in before.moves] != list(tokens):
        return False
    pairs = [(before.start.cells[token], start.cells[token]) for token in tokens]
    return any(one.row == other.row or one.column == other.column for one, other in pairs)


def _play(
    deck: Deck,
    start: State,
    tokens: Sequence[TokenId],
    slips: Iterable[Slip],
    label: str,
    chance: Random,
) -> Play:
    moves = list(_moves(start, tokens))
    for slip in slips:
        (token,) = _tokens(deck, (slip.shown,))
        destination = BOARD.goal_cells[slip.column - 1]
        moves.insert(slip.before, Move(token, start.cells[token], destination))
    times = _times(len(moves), chance)
    return Play(deck, start, tuple(moves), label, times, "simulated")


def _moves(start: State, tokens: Sequence[TokenId]) -> tuple[Move, ...]:
    """The tokens to the goal row from left to right."""
    cells = zip(tokens, BOARD.goal_cells, strict=False)
    return tuple(Move(token, start.cells[token], cell) for token, cell in cells)


def _tokens(deck: Deck, shown: Iterable[Value]) -> list[TokenId]:
    by_value = {value: token.id for token in deck.tokens for _, value in token.attributes}
    return [by_value[value] for value in shown]


def _times(moves: int, chance: Random) -> tuple[int, ...]:
    """Two to nine seconds a move."""
    times: list[int] = []
    for _ in range(moves):
        times.append((times or [0])[-1] + chance.randrange(2_000, 9_000))
    return tuple(times)


def _lines(played: Iterable[Play]) -> str:
    return "".join(f"{encode_demonstration(one)}\n" for one in played)


if __name__ == "__main__":
    main()
