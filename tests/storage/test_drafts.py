from dataclasses import replace
from pathlib import Path

import pytest

from maestra.storage.drafts import (
    Digest,
    DraftId,
    Drafts,
    OutdatedError,
    StoredDraft,
    StoredPicture,
)
from maestra.storage.opening import open_store, place
from maestra.storage.store import SqlStore

FIRST = StoredDraft(DraftId("d1"), "ana", 1, "2026-05-04T12:00:00+00:00", "{}")
PICTURE = StoredPicture("image/png", b"\x89PNG")


@pytest.fixture
def store(tmp_path: Path) -> SqlStore:
    return open_store(place(str(tmp_path / "data"), str(tmp_path / "keys")))


@pytest.fixture
def drafts(store: SqlStore) -> Drafts:
    return Drafts(store)


def test_a_draft_is_there_after_a_restart(tmp_path: Path, store: SqlStore) -> None:
    Drafts(store).add(FIRST)
    store.close()
    again = open_store(place(str(tmp_path / "data"), str(tmp_path / "keys")))
    assert Drafts(again).draft(FIRST.draft) == FIRST
    again.close()


def test_a_change_is_kept_only_instead_of_the_version_before_it(drafts: Drafts) -> None:
    drafts.add(FIRST)
    second = replace(FIRST, version=2, content='{"more": 1}')
    drafts.change(second)
    assert drafts.draft(FIRST.draft) == second
    with pytest.raises(OutdatedError):
        drafts.change(second)
    with pytest.raises(OutdatedError):
        drafts.change(replace(second, draft=DraftId("d2"), version=3))


def test_drafts_are_listed_by_account_the_last_changed_first(drafts: Drafts) -> None:
    later = replace(FIRST, draft=DraftId("d2"), changed_utc="2026-05-05T12:00:00+00:00")
    for one in (FIRST, later, replace(FIRST, draft=DraftId("d3"), account="pau")):
        drafts.add(one)
    assert [one.draft for one in drafts.of("ana")] == ["d2", "d1"]


def test_what_was_forgotten_is_not_there(drafts: Drafts) -> None:
    drafts.add(FIRST)
    drafts.delete(FIRST.draft)
    with pytest.raises(KeyError):
        drafts.draft(FIRST.draft)


def test_a_picture_is_kept_once_and_found_by_its_bytes(drafts: Drafts) -> None:
    digest = drafts.keep_picture(PICTURE)
    assert drafts.keep_picture(PICTURE) == digest
    assert drafts.picture(digest) == PICTURE
    with pytest.raises(KeyError):
        drafts.picture(Digest("0" * 64))


def test_each_version_of_an_exercise_has_its_pictures(drafts: Drafts) -> None:
    one, other = Digest("1" * 64), Digest("2" * 64)
    drafts.save_shown("cups", 1, {"cup": one, "dog": other})
    drafts.save_shown("cups", 2, {"cup": other})
    drafts.save_shown("cups", 1, {"cup": one})
    assert drafts.shown("cups", 1) == {"cup": one}
    assert drafts.shown("cups", 2) == {"cup": other}
    assert drafts.shown("other", 1) == {}
