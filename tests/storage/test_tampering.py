"""Whoever changes the record behind Maestra's back is found out, up to the last signed head."""

from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from hypothesis import given
from hypothesis import strategies as st
from sqlalchemy import Connection, delete, insert

from maestra.storage.chain import (
    GENESIS,
    Finding,
    Head,
    HeadKind,
    Link,
    SignedHead,
    Sound,
    Tampered,
    Verification,
    digest_after,
    read_head,
    verify,
)
from maestra.storage.opening import Place
from maestra.storage.record import links
from maestra.storage.store import SqlStore
from maestra.storage.tables import EVENTS
from maestra.storage.vault import is_signature
from tests.storage.samples import behind, entry, session, untie

LENGTH = 12
Opening = Callable[[Place], SqlStore]
Change = Callable[[list[Link]], list[Link]]


def changed(rows: list[Link]) -> list[Link]:
    rows[5] = replace(rows[5], sealed=rows[5].sealed[:-1] + bytes([rows[5].sealed[-1] ^ 1]))
    return rows


def redated(rows: list[Link]) -> list[Link]:
    rows[5] = replace(rows[5], utc="2020-01-01T00:00:00+00:00")
    return rows


def given_to_another(rows: list[Link]) -> list[Link]:
    rows[5] = replace(rows[5], subject="0" * 32)
    return rows


def deleted(rows: list[Link]) -> list[Link]:
    return rows[:5] + rows[6:]


def closed_up(rows: list[Link]) -> list[Link]:
    return [replace(row, sequence=k) for k, row in enumerate(deleted(rows), 1)]


def inserted(rows: list[Link]) -> list[Link]:
    rows.insert(5, replace(rows[5], key_tag="f" * 32))
    return [replace(row, sequence=k) for k, row in enumerate(rows, 1)]


def reordered(rows: list[Link]) -> list[Link]:
    rows[5], rows[6] = replace(rows[6], sequence=6), replace(rows[5], sequence=7)
    return rows


def truncated(rows: list[Link]) -> list[Link]:
    return rows[:-1]


def emptied(rows: list[Link]) -> list[Link]:
    return rows[:0]


def chained_anew(rows: list[Link]) -> list[Link]:
    previous, made = GENESIS, list[Link]()
    for row in rows:
        previous = digest_after(previous, row)
        made.append(replace(row, digest=previous))
    return made


CHANGES = (
    changed,
    redated,
    given_to_another,
    deleted,
    closed_up,
    inserted,
    reordered,
    truncated,
    emptied,
)


def rewrite(connection: Connection, change: Change) -> None:
    """Replace all events by what `change` makes of them."""
    rows = change(list(links(connection)))
    untie(connection)
    connection.execute(delete(EVENTS))
    for row in rows:
        connection.execute(insert(EVENTS).values(asdict(row)))


@pytest.fixture
def played(place: Place, opened: Opening) -> Place:
    store = opened(place)
    store.save_session(session())
    for number in range(LENGTH):
        store.events.append([entry(number)])
    assert store.verify() == Sound(LENGTH, LENGTH, 0, LENGTH + 1)
    store.close()
    return place


@pytest.mark.parametrize("again", [False, True], ids=["chain left", "chained anew"])
@pytest.mark.parametrize("change", CHANGES)
def test_tampering_is_found(
    played: Place, opened: Opening, change: Change, *, again: bool
) -> None:
    with behind(played) as connection:
        rewrite(connection, lambda rows: chained_anew(change(rows)) if again else change(rows))
    found = opened(played).verify()
    assert isinstance(found, Tampered), found


def test_nothing_is_found_where_nothing_was_changed(played: Place, opened: Opening) -> None:
    with behind(played) as connection:
        rewrite(connection, chained_anew)
    assert opened(played).verify() == Sound(LENGTH, LENGTH, 0, LENGTH + 1)


def test_events_that_a_crash_left_unsigned_are_signed_as_recovered(
    played: Place, opened: Opening
) -> None:
    store = opened(played)
    heads = store.vault.folder / "heads.jsonl"
    store.close()
    heads.write_text("".join(heads.read_text().splitlines(keepends=True)[:-2]))
    again = opened(played)
    assert again.verify() == Sound(LENGTH, LENGTH, 2, LENGTH)


def test_a_torn_last_line_of_the_heads_is_dropped(played: Place, opened: Opening) -> None:
    store = opened(played)
    heads = store.vault.folder / "heads.jsonl"
    store.close()
    whole = heads.read_text()
    heads.write_text(whole[:-10])
    assert opened(played).verify() == Sound(LENGTH, LENGTH, 1, LENGTH + 1)


def resequenced(text: str) -> str:
    return text.replace('"sequence": 12', '"sequence": 11')


def of_another_store(text: str) -> str:
    return text.replace('"store": "', '"store": "f')


def preceded_by_nonsense(text: str) -> str:
    return f"nonsense{text}"


def all_removed(text: str) -> str:
    return text[:0]


def first_removed(text: str) -> str:
    return text[text.index("\n") + 1 :]


@pytest.mark.parametrize(
    ("spoil", "finding"),
    [
        (resequenced, Finding.BAD_HEAD),
        (of_another_store, Finding.BAD_HEAD),
        (preceded_by_nonsense, Finding.BAD_HEAD),
        (all_removed, Finding.NO_HEAD),
        (first_removed, Finding.NO_HEAD),
    ],
)
def test_heads_that_were_forged_or_removed_are_found(
    played: Place,
    opened: Opening,
    spoil: Callable[[str], str],
    finding: Finding,
) -> None:
    store = opened(played)
    heads = store.vault.folder / "heads.jsonl"
    heads.write_text(spoil(heads.read_text()))
    for _ in range(2):
        found = store.verify()
        assert isinstance(found, Tampered)
        assert found.finding is finding
        store.close()
        store = opened(played)


def test_whoever_signs_with_another_key_is_found(played: Place, opened: Opening) -> None:
    store = opened(played)
    heads = store.vault.folder / "heads.jsonl"
    last = read_head(heads.read_text().splitlines()[-1])
    forged = replace(last, signature=Ed25519PrivateKey.generate().sign(last.head.message()))
    with heads.open("a") as file:
        file.write(forged.line())
    assert store.verify() == Tampered(Finding.BAD_HEAD, LENGTH + 2)


# ---------------------------------------------------------------- the law, without a database

KEY = Ed25519PrivateKey.generate()
STORE = "5" * 32


def make_chain(length: int) -> list[Link]:
    rows = [Link(k, "t", f"key {k}", None, k, "now", b"%d" % k, b"") for k in range(1, length + 1)]
    return chained_anew(rows)


def head_at(rows: list[Link], sequence: int, kind: HeadKind = HeadKind.WRITTEN) -> SignedHead:
    head = Head(STORE, kind, sequence, rows[sequence - 1].digest if sequence else GENESIS, "now")
    return SignedHead(head, KEY.sign(head.message()))


def check(rows: list[Link], heads: list[SignedHead]) -> Verification:
    lines = [one.line() for one in (head_at(rows, 0, HeadKind.BEGUN), *heads)]
    return verify(rows, lines, STORE, check_signature)


def check_signature(signature: bytes, message: bytes) -> bool:
    return is_signature(KEY.public_key(), signature, message)


@given(st.data())
def test_any_other_history_up_to_the_last_head_is_found(data: st.DataObject) -> None:
    rows = make_chain(data.draw(st.integers(2, 10)))
    signed = data.draw(st.lists(st.integers(1, len(rows)), min_size=1, unique=True).map(sorted))
    heads = [head_at(rows, sequence) for sequence in signed]
    assert check(rows, heads) == Sound(len(rows), signed[-1], 0, len(signed) + 1)
    order = data.draw(st.lists(st.sampled_from(rows), max_size=12))
    other = chained_anew([replace(row, sequence=k) for k, row in enumerate(order, 1)])
    same = [row.key_tag for row in other[: signed[-1]]] == [
        row.key_tag for row in rows[: signed[-1]]
    ]
    assert isinstance(check(other, heads), Sound) == same


def test_after_restoring_a_backup_older_heads_beyond_its_end_no_longer_hold() -> None:
    rows = make_chain(5)
    heads = [head_at(rows, 3), head_at(rows, 5), head_at(rows, 3, HeadKind.RESTORED)]
    assert check(rows[:3], heads) == Sound(3, 3, 0, 3)
    assert check(rows[:3], heads[:2]) == Tampered(Finding.CUT_OFF, 4)


@given(
    st.text("0123456789abcdef", min_size=32, max_size=32),
    st.sampled_from(HeadKind),
    st.integers(0, 2**62),
    st.binary(min_size=32, max_size=32),
)
def test_a_head_reads_as_it_was_written(
    store: str, kind: HeadKind, at: int, digest: bytes
) -> None:
    signed = SignedHead(Head(store, kind, at, digest, "now"), b"s" * 64)
    assert read_head(signed.line()) == signed


@pytest.mark.parametrize("line", ["", "[]", "{}", '{"format": "maestra.head/2"}', '{"format": 1'])
def test_what_is_no_head_is_refused(line: str) -> None:
    with pytest.raises(ValueError, match="HeadJson"):
        read_head(line)


def test_keys_are_readable_for_their_owner_alone(played: Place, opened: Opening) -> None:
    folder: Path = opened(played).vault.folder
    assert {path.stat().st_mode & 0o077 for path in (folder, *folder.rglob("*.key"))} == {0}
