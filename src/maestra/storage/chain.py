"""The chain of events, and heads: signed words on how far it went, kept outside the database.

Each event's digest is SHA-256 over the digest before it and all of the event's columns, each
preceded by its length. Whoever changes, removes, adds or swaps events must work out all later
digests anew, and then the chain no longer meets the last signed head. Signatures are Ed25519:
who checks needs only the public key, and cannot sign (docs/decisions/0005-the-record.md).
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from hashlib import sha256
from typing import Final, Protocol, TypeAlias

from maestra.storage.formats import HEAD_FORMAT, HeadJson

GENESIS: Final = bytes(32)
"""Stands before the first event."""


class HeadKind(Enum):
    """Why a head was signed."""

    BEGUN = "begun"
    """The store was begun, with no events: every file of heads starts so."""
    WRITTEN = "written"
    """The events up to here have just been written."""
    RECOVERED = "recovered"
    """Events up to here were found when the store was opened: written, but not signed, when the
    program before was killed. Nobody was told that they are kept."""
    RESTORED = "restored"
    """A backup that ends here was restored: what older heads say beyond it no longer holds."""


@dataclass(frozen=True, slots=True)
class Link:
    """An event as the chain sees it."""

    sequence: int
    session_tag: str
    key_tag: str
    subject: str | None
    at_ms: int
    utc: str
    sealed: bytes
    digest: bytes


@dataclass(frozen=True, slots=True)
class Head:
    """How far the chain went, and the digest there."""

    store: str
    kind: HeadKind
    sequence: int
    digest: bytes
    utc: str

    def message(self) -> bytes:
        """What is signed."""
        return json.dumps(self.fields(), sort_keys=True, separators=(",", ":")).encode()

    def fields(self) -> dict[str, str | int]:
        """The head as its line has it, without the signature."""
        return {
            "format": HEAD_FORMAT,
            "store": self.store,
            "kind": self.kind.value,
            "sequence": self.sequence,
            "digest": self.digest.hex(),
            "utc": self.utc,
        }


@dataclass(frozen=True, slots=True)
class SignedHead:
    """A head and its signature."""

    head: Head
    signature: bytes

    def line(self) -> str:
        """A line of a file of heads."""
        return json.dumps({**self.head.fields(), "signature": self.signature.hex()}) + "\n"


class CheckSignature(Protocol):
    """Whether a signature is that of the store's key."""

    def __call__(self, signature: bytes, message: bytes) -> bool:
        """Whether `signature` fits `message`."""
        ...


class Finding(Enum):
    """What is wrong with a record."""

    BROKEN_CHAIN = "an event does not follow from the one before it"
    GAP = "events are missing"
    NOT_AS_SIGNED = "an event is not what was signed"
    CUT_OFF = "events that were signed are missing at the end"
    BAD_HEAD = "a head has a wrong signature, or is of another store"
    NO_HEAD = "signed heads are missing"


@dataclass(frozen=True, slots=True)
class Sound:
    """The record is what was written."""

    events: int
    signed: int
    """Up to which event a signed head vouches."""
    recovered: int
    """Events that a head vouches for only since the store was opened after a crash."""
    heads: int


@dataclass(frozen=True, slots=True)
class Tampered:
    """The record is not what was written."""

    finding: Finding
    sequence: int
    """The first event concerned; of a bad head, its line."""


Verification: TypeAlias = Sound | Tampered


def digest_after(previous: bytes, link: Link) -> bytes:
    """The digest of `link` when `previous` is that of the event before it; reads no digest."""
    subject = b"" if link.subject is None else link.subject.encode()
    fields = (
        previous,
        str(link.sequence).encode(),
        link.session_tag.encode(),
        link.key_tag.encode(),
        subject,
        str(link.at_ms).encode(),
        link.utc.encode(),
        link.sealed,
    )
    digest = sha256()
    for field in fields:
        digest.update(len(field).to_bytes(8, "big"))
        digest.update(field)
    return digest.digest()


def read_head(line: str) -> SignedHead:
    """The head in a line.

    Raises:
        ValueError: it holds none.
    """
    fields = HeadJson.model_validate_json(line)
    kind, digest = HeadKind(fields.kind), bytes.fromhex(fields.digest)
    head = Head(fields.store, kind, fields.sequence, digest, fields.utc)
    return SignedHead(head, bytes.fromhex(fields.signature))


def verify(
    links: Iterable[Link], lines: Iterable[str], store: str, check: CheckSignature
) -> Verification:
    """Whether the events are the ones that the lines of heads vouch for: O(events + heads)."""
    in_force: list[Head] = []
    for number, line in enumerate(lines, 1):
        head = _checked(line, store, check)
        if head is None:
            return Tampered(Finding.BAD_HEAD, number)
        if head.kind is HeadKind.RESTORED:
            in_force = [one for one in in_force if one.sequence <= head.sequence]
        in_force.append(head)
    if not in_force or in_force[0].kind is not HeadKind.BEGUN:
        return Tampered(Finding.NO_HEAD, 1)
    signed = {head.sequence: head.digest for head in in_force}
    walked = _walk(links, signed)
    if isinstance(walked, Tampered):
        return walked
    last = max(signed)
    if last > walked:
        return Tampered(Finding.CUT_OFF, walked + 1)
    return Sound(walked, last, _recovered(in_force), len(in_force))


def _checked(line: str, store: str, check: CheckSignature) -> Head | None:
    """The head in a line; None if it is none of this store's."""
    try:
        signed = read_head(line)
    except ValueError:
        return None
    of_store = signed.head.store == store
    return signed.head if of_store and check(signed.signature, signed.head.message()) else None


def _walk(links: Iterable[Link], signed: dict[int, bytes]) -> int | Tampered:
    """The number of events, all of which follow from one another and agree with what is signed."""
    previous, sequence = GENESIS, 0
    for link in links:
        sequence += 1
        if link.sequence != sequence:
            return Tampered(Finding.GAP, sequence)
        previous = digest_after(previous, link)
        if link.digest != previous:
            return Tampered(Finding.BROKEN_CHAIN, sequence)
        if signed.get(sequence, previous) != previous:
            return Tampered(Finding.NOT_AS_SIGNED, sequence)
    return sequence


def _recovered(heads: list[Head]) -> int:
    found, last = 0, 0
    for head in heads:
        if head.kind is HeadKind.RECOVERED:
            found += head.sequence - last
        last = head.sequence
    return found
