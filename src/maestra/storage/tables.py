"""The tables, as they are after all migrations.

Whatever belongs to a patient is sealed with that patient's key before it comes here (`vault`):
a tag stands for each pseudonym, session and key, a random number for each person. So it is with
accounts, too: each has a key of its own.
"""

from typing import Final

from sqlalchemy import (
    BigInteger,
    Column,
    Index,
    Integer,
    LargeBinary,
    MetaData,
    String,
    Table,
    Text,
)

METADATA: Final = MetaData()

STORE: Final = Table(
    "store",
    METADATA,
    Column("id", String(32), primary_key=True),
)
"""One row: which store this is, and so which keys open it."""

EVENTS: Final = Table(
    "events",
    METADATA,
    Column("sequence", BigInteger, primary_key=True, autoincrement=False),
    Column("session_tag", String(32), nullable=False),
    Column("key_tag", String(32), nullable=False, unique=True),
    Column("subject", String(32)),
    Column("at_ms", BigInteger, nullable=False),
    Column("utc", String(40), nullable=False),
    Column("sealed", LargeBinary, nullable=False),
    Column("digest", LargeBinary, nullable=False),
    Index("events_by_session", "session_tag", "sequence"),
)
"""Append-only, by triggers too. `sealed` holds session, key, kind and payload."""

EXERCISES: Final = Table(
    "exercises",
    METADATA,
    Column("name", String(200), primary_key=True),
    Column("version", Integer, primary_key=True, autoincrement=False),
    Column("exercise", Text, nullable=False),
    Column("demonstrations", Text, nullable=False),
)

SHELF: Final = Table(
    "shelf",
    METADATA,
    Column("name", String(200), primary_key=True),
    Column("title", String(200)),
    Column("removed_utc", String(40)),
)
"""What differs from how an exercise was kept: another title, or taken from the library.

The name stays, for sessions and patients know the exercise by it.
"""

SOURCES: Final = Table(
    "sources",
    METADATA,
    Column("name", String(200), primary_key=True),
    Column("version", Integer, primary_key=True, autoincrement=False),
    Column("origin", String(20), nullable=False),
    Column("account", String(32)),
    Column("utc", String(40), nullable=False),
)
"""Where a version of an exercise comes from: how, from whose account, when."""

PATIENTS: Final = Table(
    "patients",
    METADATA,
    Column("subject", String(32), primary_key=True),
    Column("tag", String(32), nullable=False, unique=True),
    Column("sealed", LargeBinary, nullable=False),
)
"""`sealed` holds the pseudonym."""

NAMES: Final = Table(
    "names",
    METADATA,
    Column("subject", String(32), primary_key=True),
    Column("sealed", LargeBinary, nullable=False),
)
"""Who a pseudonym is; only for those who were given a name."""

SETTINGS: Final = Table(
    "settings",
    METADATA,
    Column("subject", String(32), primary_key=True),
    Column("sealed", LargeBinary, nullable=False),
)

PLANS: Final = Table(
    "plans",
    METADATA,
    Column("subject", String(32), primary_key=True),
    Column("sealed", LargeBinary, nullable=False),
)
"""What caregivers intend with a patient: exercises, settings that are being changed."""

SESSIONS: Final = Table(
    "sessions",
    METADATA,
    Column("tag", String(32), primary_key=True),
    Column("subject", String(32)),
    Column("sealed", LargeBinary, nullable=False),
)

ACCOUNTS: Final = Table(
    "accounts",
    METADATA,
    Column("account", String(32), primary_key=True),
    Column("tag", String(32), nullable=False, unique=True),
    Column("sealed", LargeBinary, nullable=False),
)
"""Who may log in. The tag stands for the name; all else is sealed with the account's own key."""

LOGINS: Final = Table(
    "logins",
    METADATA,
    Column("digest", String(64), primary_key=True),
    Column("kind", String(20), nullable=False),
    Column("holder", String(32), nullable=False),
    Column("begun_ms", BigInteger, nullable=False),
    Column("used_ms", BigInteger, nullable=False),
)
"""Who is logged in: the SHA-256 of what their browser holds, and whose it is."""

DEVICES: Final = Table(
    "devices",
    METADATA,
    Column("device", String(32), primary_key=True),
    Column("digest", String(64), nullable=False, unique=True),
    Column("kind", String(20), nullable=False),
    Column("label", String(200), nullable=False),
    Column("room", String(200)),
    Column("subject", String(32)),
    Column("pin", String(200)),
    Column("account", String(32), nullable=False),
    Column("made_ms", BigInteger, nullable=False),
)
"""Boards, robots and patients' screens: the SHA-256 of each one's token, and what it opens."""

CAREGIVERS: Final = Table(
    "caregivers",
    METADATA,
    Column("subject", String(32), primary_key=True),
    Column("account", String(32), primary_key=True),
)
"""Which accounts care for which patients."""

AUDIT: Final = Table(
    "audit",
    METADATA,
    Column("number", BigInteger, primary_key=True, autoincrement=False),
    Column("utc", String(40), nullable=False),
    Column("account", String(32)),
    Column("act", String(40), nullable=False),
    Column("subject", String(32)),
    Column("detail", String(300), nullable=False),
)
"""Who did what, to whom, when. A patient who is erased becomes a number that means nobody."""

DRAFTS: Final = Table(
    "drafts",
    METADATA,
    Column("draft", String(32), primary_key=True),
    Column("account", String(32), nullable=False),
    Column("version", Integer, nullable=False),
    Column("changed_utc", String(40), nullable=False),
    Column("content", Text, nullable=False),
    Index("drafts_by_account", "account"),
)
"""Exercises that are being taught, as they were left; each belongs to an account."""

PICTURES: Final = Table(
    "pictures",
    METADATA,
    Column("digest", String(64), primary_key=True),
    Column("media_type", String(40), nullable=False),
    Column("content", LargeBinary, nullable=False),
)
"""Photographs and drawings on tokens, by the SHA-256 of their bytes."""

SHOWN_PICTURES: Final = Table(
    "shown_pictures",
    METADATA,
    Column("exercise", String(200), primary_key=True),
    Column("version", Integer, primary_key=True, autoincrement=False),
    Column("value", String(1000), primary_key=True),
    Column("digest", String(64), nullable=False),
)
"""What tokens of an exercise show under `picture`, each with the picture."""

PASSING: Final = (LOGINS,)
"""Not in backups: nobody is logged in after one is restored."""

OF_A_PATIENT: Final = (PATIENTS, NAMES, SETTINGS, PLANS, SESSIONS, DEVICES, CAREGIVERS)
"""What erasing a patient empties of them; events keep their rows, which nobody can read then."""
