import pytest

from maestra.learning.showings import Showings, count_showings
from maestra.learning.teaching_sets import open_literals
from maestra.rules.paper import PAPER_EXERCISES


def showings(key: str) -> Showings:
    exercise = PAPER_EXERCISES[key]
    plays, vocabulary = exercise.plays(), exercise.vocabulary()
    return count_showings(plays, vocabulary, open_literals(plays, vocabulary))


@pytest.mark.parametrize(
    ("key", "actions", "times"),
    [("odd-ascending", 5, 2), ("ascending", 30, 2), ("first-row", 50, 1), ("curie", 5, 2)],
)
def test_each_action_of_the_papers_exercises_must_be_shown_so_often(
    key: str, actions: int, times: int
) -> None:
    assert showings(key).needed.tolist() == [times] * actions


def test_each_cover_shows_every_action_as_often_as_it_must_be() -> None:
    counted = showings("ascending")
    chosen = next(counted.covers(1_000_000))
    rows = [counted.places.index(place) for place in chosen]
    shown = counted.sequences[rows].ravel().tolist()
    assert len(chosen) == counted.lower_bound == 12
    assert all(shown.count(action) >= 2 for action in range(30))


def test_a_search_without_means_finds_no_cover() -> None:
    assert list(showings("ascending").covers(0)) == []
