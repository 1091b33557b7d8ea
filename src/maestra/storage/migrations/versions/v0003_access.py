"""Accounts, who is logged in, devices, who cares for whom, and the audit."""

from typing import Final

import sqlalchemy as sa
from alembic import op

revision: Final = "0003"
down_revision: Final = "0002"


def upgrade() -> None:
    """Make the tables."""
    op.create_table(
        "accounts",
        sa.Column("account", sa.String(32), primary_key=True),
        sa.Column("tag", sa.String(32), nullable=False, unique=True),
        sa.Column("sealed", sa.LargeBinary, nullable=False),
    )
    op.create_table(
        "logins",
        sa.Column("digest", sa.String(64), primary_key=True),
        sa.Column("kind", sa.String(20), nullable=False),
        sa.Column("holder", sa.String(32), nullable=False),
        sa.Column("begun_ms", sa.BigInteger, nullable=False),
        sa.Column("used_ms", sa.BigInteger, nullable=False),
    )
    op.create_table(
        "devices",
        sa.Column("device", sa.String(32), primary_key=True),
        sa.Column("digest", sa.String(64), nullable=False, unique=True),
        sa.Column("kind", sa.String(20), nullable=False),
        sa.Column("label", sa.String(200), nullable=False),
        sa.Column("room", sa.String(200)),
        sa.Column("subject", sa.String(32)),
        sa.Column("pin", sa.String(200)),
        sa.Column("account", sa.String(32), nullable=False),
        sa.Column("made_ms", sa.BigInteger, nullable=False),
    )
    op.create_table(
        "caregivers",
        sa.Column("subject", sa.String(32), primary_key=True),
        sa.Column("account", sa.String(32), primary_key=True),
    )
    op.create_table(
        "audit",
        sa.Column("number", sa.BigInteger, primary_key=True, autoincrement=False),
        sa.Column("utc", sa.String(40), nullable=False),
        sa.Column("account", sa.String(32)),
        sa.Column("act", sa.String(40), nullable=False),
        sa.Column("subject", sa.String(32)),
        sa.Column("detail", sa.String(300), nullable=False),
    )
