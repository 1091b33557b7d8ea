"""How long judging a move takes: `make bench`. A round is a move, so the median is a move's."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

import pytest

from benchmarks.lessons import (
    LARGE_BOARD,
    LARGE_DECK,
    PAPER_BOARD,
    PAPER_DECK,
    paper_lesson,
    random_lesson,
)
from benchmarks.stopwatch import Arguments, Stopwatch
from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move
from maestra.core.tokens import Deck
from maestra.learning.grounded import learn_grounded
from maestra.rules.judging import Judge
from maestra.rules.position import Position

PAPER = (PAPER_BOARD, PAPER_DECK)
LARGE = (LARGE_BOARD, LARGE_DECK)
BOARDS = [pytest.param(PAPER, id="4 x 5"), pytest.param(LARGE, id="20 x 20")]


def lesson_of(board: Board, deck: Deck) -> list[Demonstration]:
    """Enough for what follows to be allowed more often than not."""
    if board == PAPER_BOARD:
        return paper_lesson(Random(1))
    return random_lesson(board, deck, 100, Random(1))


def positions(plays: list[Demonstration]) -> Iterator[tuple[Position, Move]]:
    """Every move of the plays, with the position before it."""
    for play in plays:
        position = Position.begin(play.start)
        for move in play.moves:
            yield position, move
            position = position.after(move)


@pytest.mark.benchmark(group="judge a move")
@pytest.mark.parametrize("shown", [True, False], ids=["shown", "new"])
@pytest.mark.parametrize("setting", BOARDS)
def test_judge_a_move(benchmark: Stopwatch, setting: tuple[Board, Deck], *, shown: bool) -> None:
    lesson = lesson_of(*setting)
    plays = lesson if shown else random_lesson(*setting, len(lesson), Random(2))
    judge = Judge(learn_grounded(lesson), setting[1])
    moves = list(positions(plays)) * (5 if setting == PAPER else 1)
    judge.verdict(*moves[0])
    waiting = iter(moves)

    def next_move() -> Arguments:
        return next(waiting), {}

    benchmark.pedantic(judge.verdict, setup=next_move, rounds=len(moves))


@pytest.mark.benchmark(group="judge the first move of a deck")
@pytest.mark.parametrize("setting", BOARDS)
def test_judge_the_first_move(benchmark: Stopwatch, setting: tuple[Board, Deck]) -> None:
    lesson = lesson_of(*setting)
    first = next(positions(lesson))

    def judge_first(judge: Judge) -> None:
        judge.verdict(*first)

    def new_judge() -> Arguments:
        return (Judge(learn_grounded(lesson), setting[1]),), {}

    benchmark.pedantic(judge_first, setup=new_judge, rounds=5)


@pytest.mark.benchmark(group="every allowed move of a start")
@pytest.mark.parametrize("setting", BOARDS)
def test_every_allowed_move(benchmark: Stopwatch, setting: tuple[Board, Deck]) -> None:
    lesson = lesson_of(*setting)
    judge = Judge(learn_grounded(lesson), setting[1])
    assert benchmark(lambda: list(judge.allowed_moves(Position.begin(lesson[0].start))))
