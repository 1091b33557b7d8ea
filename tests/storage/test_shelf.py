import pytest

from maestra.core.faults import InvalidError
from maestra.storage.shelf import Shelf, Source
from maestra.storage.store import SqlStore

ANA = Source("taught", "a" * 32, "2026-05-04T12:00:00+00:00")
BEA = Source("imported", "b" * 32, "2026-05-05T12:00:00+00:00")


@pytest.fixture
def shelf(store: SqlStore) -> Shelf:
    shelf = Shelf(store)
    shelf.keep("numbers", "one", "", ANA)
    return shelf


def test_each_version_knows_where_it_comes_from(shelf: Shelf) -> None:
    assert shelf.keep("numbers", "two", "", BEA) == 2
    assert dict(shelf.sources()) == {("numbers", 1): ANA, ("numbers", 2): BEA}
    assert [one.exercise for one in shelf.versions("numbers")] == ["two", "one"]


def test_what_is_kept_again_keeps_its_source(shelf: Shelf) -> None:
    assert shelf.keep("numbers", "one", "", BEA) == 1
    assert dict(shelf.sources()) == {("numbers", 1): ANA}


def test_what_was_removed_is_in_no_list_and_comes_back_whole(
    shelf: Shelf, store: SqlStore
) -> None:
    shelf.retitle("numbers", "Numbers up")
    shelf.remove("numbers", "2026-05-06T12:00:00+00:00")
    assert store.exercises() == ()
    assert dict(shelf.removed()) == {"numbers": "2026-05-06T12:00:00+00:00"}
    assert shelf.names() == {"numbers"}
    assert store.exercise("numbers").exercise == "one"
    shelf.restore("numbers")
    assert [one.name for one in store.exercises()] == ["numbers"]
    assert dict(shelf.titles()) == {"numbers": "Numbers up"}
    assert dict(shelf.removed()) == {}


def test_what_was_removed_is_back_when_a_version_is_kept(shelf: Shelf, store: SqlStore) -> None:
    shelf.remove("numbers", "2026-05-06T12:00:00+00:00")
    store.save_exercise("numbers", "two")
    assert [(one.name, one.version) for one in store.exercises()] == [("numbers", 2)]


def test_no_two_exercises_have_the_same_title(shelf: Shelf) -> None:
    shelf.keep("letters", "three", "", ANA)
    with pytest.raises(InvalidError, match="taken"):
        shelf.retitle("letters", "numbers")
    shelf.retitle("numbers", "Numbers")
    shelf.retitle("letters", "numbers")
    with pytest.raises(InvalidError, match="taken"):
        shelf.retitle("numbers", "numbers")


def test_a_removed_exercise_keeps_no_title_from_others(shelf: Shelf) -> None:
    shelf.keep("letters", "three", "", ANA)
    shelf.remove("numbers", "2026-05-06T12:00:00+00:00")
    shelf.retitle("letters", "numbers")
    assert dict(shelf.titles()) == {"letters": "numbers"}


def test_of_an_unknown_exercise_nothing_is_known(shelf: Shelf) -> None:
    for ask in (
        lambda: shelf.versions("nothing"),
        lambda: shelf.restore("nothing"),
        lambda: shelf.remove("nothing", ""),
        lambda: shelf.retitle("nothing", "something"),
    ):
        with pytest.raises(KeyError):
            ask()
