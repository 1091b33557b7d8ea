import pytest

from maestra.experiments import compared
from maestra.experiments.compared import Needed, compared_table, needed
from maestra.experiments.table import TableRow


class Ticking:
    """A clock that goes on by one second each time it is read."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        self.now += 1.0
        return self.now


def test_demonstrations_are_added_until_they_are_enough() -> None:
    found = needed("odd-ascending", 0, 2, Ticking())
    assert found.exact >= compared.ENOUGH * found.draws
    assert 1 <= found.demonstrations <= compared.MOST_SHOWN
    assert found.learn_s == 1.0


def test_after_the_last_demonstration_it_stays_at_what_it_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(compared, "MOST_SHOWN", 1)
    monkeypatch.setattr(compared, "ENOUGH", 2.0)
    found = needed("odd-ascending", 0, 1, Ticking())
    assert (found.demonstrations, found.draws) == (1, 1)
    assert found.exact <= 1


def test_all_learners_stand_together_exercise_by_exercise() -> None:
    paper = TableRow("curie", "grounded", 2, 2, 2, "exact", 0.00123, 0.01)
    none = TableRow("letters", "compiled, clingo", 12, 12, 12, "no engine", None, None)
    mine = Needed("curie", 3, 1, 19, 20, 0.25)
    table = compared_table([paper, none], [mine, Needed("letters", 0, 2, 20, 20, 0.3)])
    assert table.rows == (
        ("`curie`", "grounded", "2 chosen", "0", "exact", "0.0012"),
        ("`curie`", "fewshot", "1 random", "up to 3", "19 of 20 draws", "0.25"),
        ("`letters`", "compiled, clingo", "12 chosen", "0", "no engine", "-"),
        ("`letters`", "fewshot", "2 random", "0", "20 of 20 draws", "0.30"),
    )
