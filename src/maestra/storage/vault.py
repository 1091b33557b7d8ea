"""What must not lie beside the record: its keys and its signed heads, in a folder of their own.

```
KEYS/STORE/           0700; STORE is the id of the database that it opens
  tags.key            HMAC-SHA256: tags for pseudonyms, sessions and keys
  signing.key         Ed25519, private: signs heads
  signing.pub         its public half, to give away
  heads.jsonl         one signed head for each commit, appended
  subjects/ID.key     AES-256-GCM, one for each patient; erasing a patient destroys it
```
Every file is written and flushed to the disk before anything depends on it.
"""

import hmac
import json
import os
import secrets
from hashlib import sha256
from pathlib import Path
from typing import Final, NewType

from cryptography.exceptions import InvalidSignature, InvalidTag
from cryptography.hazmat.primitives.asymmetric.ed25519 import (
    Ed25519PrivateKey,
    Ed25519PublicKey,
)
from cryptography.hazmat.primitives.ciphers.aead import AESGCM

from maestra.core.faults import Fault, InvalidError
from maestra.storage.chain import Head, SignedHead
from maestra.storage.formats import KEYS_FORMAT, KeysJson

SubjectId = NewType("SubjectId", str)
"""A patient within the database: random, known only together with the key."""
StoreId = NewType("StoreId", str)

KEY_BYTES: Final = 32
NONCE_BYTES: Final = 12
"""As AES-GCM wants them; random, which is safe for 2^32 messages under one key."""
_ID_BYTES: Final = 16


class KeyDestroyedError(Exception):
    """The key is no more: whoever it belonged to has been erased."""


def new_store_id() -> StoreId:
    """An id that no other store has."""
    return StoreId(secrets.token_hex(_ID_BYTES))


class Vault:
    """The keys of one store."""

    def __init__(self, root: Path, store: StoreId) -> None:
        """Open the keys of `store` under `root`.

        Raises:
            InvalidError: they are not there.
        """
        self.store: StoreId = store
        self.folder: Path = root / store
        self._subjects: Path = self.folder / "subjects"
        self._heads: Path = self.folder / "heads.jsonl"
        try:
            self._tags = (self.folder / "tags.key").read_bytes()
            signing = (self.folder / "signing.key").read_bytes()
        except FileNotFoundError:
            expected = "those of this record; without them it cannot be read"
            raise InvalidError([Fault(str(self.folder), "no keys", expected)]) from None
        self._signing = Ed25519PrivateKey.from_private_bytes(signing)
        self._public = self._signing.public_key()

    @classmethod
    def create(cls, root: Path, store: StoreId) -> "Vault":
        """Make the keys of a new store."""
        folder = root / store
        (folder / "subjects").mkdir(parents=True, mode=0o700)
        folder.chmod(0o700)
        signing = Ed25519PrivateKey.generate()
        write_durably(folder / "tags.key", secrets.token_bytes(KEY_BYTES))
        write_durably(folder / "signing.pub", signing.public_key().public_bytes_raw())
        write_durably(folder / "signing.key", signing.private_bytes_raw())
        flush_folder(root)
        return cls(root, store)

    # ------------------------------------------------------------ patients

    def tag(self, *parts: str) -> str:
        """The same for the same parts, and nobody without the key can tell of which."""
        message = "\0".join(f"{len(part)}:{part}" for part in parts).encode()
        return hmac.new(self._tags, message, sha256).hexdigest()[: 2 * _ID_BYTES]

    def new_subject(self) -> SubjectId:
        """Somebody to keep things of, with a key of their own."""
        subject = SubjectId(secrets.token_hex(_ID_BYTES))
        write_durably(self._key_file(subject), secrets.token_bytes(KEY_BYTES))
        return subject

    def has(self, subject: SubjectId) -> bool:
        """Whether what is sealed for `subject` can still be read."""
        return self._key_file(subject).exists()

    def seal(self, subject: SubjectId | None, plain: bytes, about: str) -> bytes:
        """`plain`, readable only with the subject's key, and only as being `about` the same thing.

        What belongs to nobody is left as it is.

        Raises:
            KeyDestroyedError: the subject has been erased.
        """
        if subject is None:
            return plain
        nonce = secrets.token_bytes(NONCE_BYTES)
        return nonce + self._cipher(subject).encrypt(nonce, plain, self._bound(about))

    def unseal(self, subject: SubjectId | None, sealed: bytes, about: str) -> bytes:
        """What was sealed.

        Raises:
            KeyDestroyedError: the subject has been erased.
            InvalidError: this is not what was sealed.
        """
        if subject is None:
            return sealed
        nonce, rest = sealed[:NONCE_BYTES], sealed[NONCE_BYTES:]
        try:
            return self._cipher(subject).decrypt(nonce, rest, self._bound(about))
        except (InvalidTag, ValueError):
            raise InvalidError(
                [Fault("the record", "something that was changed", "what was sealed")]
            ) from None

    def destroy(self, subject: SubjectId) -> None:
        """Make everything that is sealed for `subject` unreadable for ever."""
        path = self._key_file(subject)
        if path.exists():
            with path.open("r+b") as file:
                file.write(secrets.token_bytes(KEY_BYTES))
                file.flush()
                os.fsync(file.fileno())
            path.unlink()
        flush_folder(self._subjects)

    # ------------------------------------------------------------ heads

    def public_key(self) -> bytes:
        """What checks signatures."""
        return self._public.public_bytes_raw()

    def sign(self, head: Head) -> SignedHead:
        """The head with this store's signature."""
        return SignedHead(head, self._signing.sign(head.message()))

    def add(self, head: SignedHead) -> None:
        """Add a head to the file; it is on the disk when this returns."""
        line = head.line().encode()
        with self._heads.open("ab") as file:
            end = file.tell()
            try:
                file.write(line)
                file.flush()
                os.fsync(file.fileno())
            except OSError:
                os.ftruncate(file.fileno(), end)
                raise
        if end == 0:
            flush_folder(self.folder)

    def heads(self) -> list[str]:
        """The lines of all heads, the oldest first; whether they are right is for `chain.verify`.

        A last line without an end was being written when the power went, and is left out.
        """
        if not self._heads.exists():
            return []
        return self._heads.read_bytes().decode(errors="replace").split("\n")[:-1]

    def drop_torn_head(self) -> None:
        """Remove a last line that was being written when the power went."""
        if not self._heads.exists():
            return
        with self._heads.open("r+b") as file:
            content = file.read()
            whole = content.rfind(b"\n") + 1
            if whole != len(content):
                file.truncate(whole)
                file.flush()
                os.fsync(file.fileno())

    def check(self, signature: bytes, message: bytes) -> bool:
        """Whether a signature is this store's."""
        return is_signature(self._public, signature, message)

    # ------------------------------------------------------------ a copy of all keys

    def packed(self) -> str:
        """All keys and heads as the text of one file."""
        return json.dumps(
            {
                "format": KEYS_FORMAT,
                "store": self.store,
                "tags": self._tags.hex(),
                "signing": self._signing.private_bytes_raw().hex(),
                "heads": self.heads(),
                "subjects": {
                    path.stem: path.read_bytes().hex()
                    for path in sorted(self._subjects.glob("*.key"))
                },
            }
        )

    @classmethod
    def unpack(cls, root: Path, text: str, file: str) -> None:
        """Lay out under `root` the keys that `packed` wrote.

        Raises:
            InvalidError: the text holds none.
        """
        try:
            keys = KeysJson.model_validate_json(text)
            contents = {
                "tags.key": bytes.fromhex(keys.tags),
                "signing.key": bytes.fromhex(keys.signing),
                "heads.jsonl": "".join(f"{line}\n" for line in keys.heads).encode(),
            }
            public = Ed25519PrivateKey.from_private_bytes(contents["signing.key"]).public_key()
        except ValueError:
            fault = Fault(file, "something else", f"keys, {KEYS_FORMAT}")
            raise InvalidError([fault]) from None
        folder = root / keys.store
        (folder / "subjects").mkdir(parents=True, mode=0o700)
        folder.chmod(0o700)
        for subject, key in keys.subjects.items():
            write_durably(folder / "subjects" / f"{subject}.key", bytes.fromhex(key))
        write_durably(folder / "signing.pub", public.public_bytes_raw())
        for name, content in contents.items():
            write_durably(folder / name, content)
        flush_folder(root)

    def _key_file(self, subject: SubjectId) -> Path:
        return self._subjects / f"{subject}.key"

    def _cipher(self, subject: SubjectId) -> AESGCM:
        try:
            return AESGCM(self._key_file(subject).read_bytes())
        except FileNotFoundError:
            raise KeyDestroyedError(subject) from None

    def _bound(self, about: str) -> bytes:
        return f"{self.store}\0{about}".encode()


def is_signature(key: Ed25519PublicKey, signature: bytes, message: bytes) -> bool:
    """Whether `signature` is that of `key` on `message`."""
    try:
        key.verify(signature, message)
    except InvalidSignature:
        return False
    return True


def write_durably(path: Path, content: bytes) -> None:
    """Write a file for its owner alone; it is on the disk, with its name, when this returns."""
    number = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(number, "wb") as file:
        file.write(content)
        file.flush()
        os.fsync(number)
    flush_folder(path.parent)


def flush_folder(folder: Path) -> None:
    """Have the names in a folder on the disk."""
    number = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(number)
    finally:
        os.close(number)
