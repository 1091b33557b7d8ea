from collections.abc import Iterator

import pytest

from maestra.core.state import State
from maestra.rules.judging import Judge
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.paper_rules import paper_exercise
from maestra.rules.position import Position
from maestra.rules.right_plays import Placement, Placements, RightPlays


def finished(judge: Judge, position: Position) -> Iterator[Position]:
    """Every play that is allowed, move by move, and may end."""
    if judge.may_end(position):
        yield position
    for move in judge.allowed_moves(position):
        yield from finished(judge, position.after(move))


def placed(position: Position) -> Placements:
    return tuple(Placement(move.token, move.destination) for move in position.moves)


def right_from(plays: RightPlays, start: State) -> Iterator[Placements]:
    """The right sequences whose tokens lie where they may come from."""
    for group in plays.groups:
        for row in range(len(group.tokens)):
            sequence = plays.placements(group, row)
            origins = (plays.origins(step, one) for step, one in enumerate(sequence, start=1))
            lying = (start.cells[one.token] for one in sequence)
            pairs = zip(origins, lying, strict=True)
            if all(origin is None or cell in origin for origin, cell in pairs):
                yield sequence


@pytest.mark.parametrize("key", PAPER_EXERCISES)
def test_the_rules_allow_just_the_plays_that_are_right(key: str) -> None:
    plays = PAPER_EXERCISES[key].plays()
    start = plays.play(plays.count // 2).start
    exercise = paper_exercise(key)
    judge = Judge(exercise, exercise.deck)
    allowed = {placed(one) for one in finished(judge, Position.begin(start))}
    assert allowed == set(right_from(plays, start))
    assert allowed


def test_no_other_exercise_has_such_rules() -> None:
    with pytest.raises(KeyError):
        paper_exercise("own-numbers")
