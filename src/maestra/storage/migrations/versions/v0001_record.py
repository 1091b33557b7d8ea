"""The record, exercises, patients, names, settings and sessions."""

from typing import Final

import sqlalchemy as sa
from alembic import op

revision: Final = "0001"
down_revision: Final = None

_ONLY_APPENDED: Final = "the record is append-only"


def upgrade() -> None:
    """Make the tables, and keep the record from being changed by mistake."""
    op.create_table("store", sa.Column("id", sa.String(32), primary_key=True))
    op.create_table(
        "events",
        sa.Column("sequence", sa.BigInteger, primary_key=True, autoincrement=False),
        sa.Column("session_tag", sa.String(32), nullable=False),
        sa.Column("key_tag", sa.String(32), nullable=False, unique=True),
        sa.Column("subject", sa.String(32)),
        sa.Column("at_ms", sa.BigInteger, nullable=False),
        sa.Column("utc", sa.String(40), nullable=False),
        sa.Column("sealed", sa.LargeBinary, nullable=False),
        sa.Column("digest", sa.LargeBinary, nullable=False),
    )
    op.create_index("events_by_session", "events", ["session_tag", "sequence"])
    op.create_table(
        "exercises",
        sa.Column("name", sa.String(200), primary_key=True),
        sa.Column("version", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("exercise", sa.Text, nullable=False),
        sa.Column("demonstrations", sa.Text, nullable=False),
    )
    op.create_table(
        "patients",
        sa.Column("subject", sa.String(32), primary_key=True),
        sa.Column("tag", sa.String(32), nullable=False, unique=True),
        sa.Column("sealed", sa.LargeBinary, nullable=False),
    )
    for name in ("names", "settings"):
        op.create_table(
            name,
            sa.Column("subject", sa.String(32), primary_key=True),
            sa.Column("sealed", sa.LargeBinary, nullable=False),
        )
    op.create_table(
        "sessions",
        sa.Column("tag", sa.String(32), primary_key=True),
        sa.Column("subject", sa.String(32)),
        sa.Column("sealed", sa.LargeBinary, nullable=False),
    )
    _forbid_changes(op.get_bind().dialect.name)


def _forbid_changes(dialect: str) -> None:
    if dialect == "sqlite":
        for act in ("UPDATE", "DELETE"):
            op.execute(
                f"CREATE TRIGGER events_no_{act.lower()} BEFORE {act} ON events "
                f"BEGIN SELECT RAISE(ABORT, '{_ONLY_APPENDED}'); END"
            )
        return
    op.execute(
        "CREATE FUNCTION events_only_appended() RETURNS trigger LANGUAGE plpgsql AS "
        f"$$ BEGIN RAISE EXCEPTION '{_ONLY_APPENDED}'; END $$"
    )
    op.execute(
        "CREATE TRIGGER events_no_change BEFORE UPDATE OR DELETE OR TRUNCATE ON events "
        "FOR EACH STATEMENT EXECUTE FUNCTION events_only_appended()"
    )
