"""Which exercises stand in the library under which title, and where each version comes from."""

from typing import Final

import sqlalchemy as sa
from alembic import op

revision: Final = "0005"
down_revision: Final = "0004"


def upgrade() -> None:
    """Make the tables."""
    op.create_table(
        "shelf",
        sa.Column("name", sa.String(200), primary_key=True),
        sa.Column("title", sa.String(200)),
        sa.Column("removed_utc", sa.String(40)),
    )
    op.create_table(
        "sources",
        sa.Column("name", sa.String(200), primary_key=True),
        sa.Column("version", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("origin", sa.String(20), nullable=False),
        sa.Column("account", sa.String(32)),
        sa.Column("utc", sa.String(40), nullable=False),
    )
