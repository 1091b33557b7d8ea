"""Bringing a database's tables to the version that this Maestra reads."""

from typing import Final, cast

from sqlalchemy import Connection, inspect, text

from maestra.core.faults import Fault, InvalidError

VERSION: Final = "0005"
"""The newest module in migrations/versions; a test compares."""


def version_of(connection: Connection) -> str | None:
    """The version of the tables in this database; None where there are none."""
    if not inspect(connection).has_table("alembic_version"):
        return None
    query = text("SELECT version_num FROM alembic_version")
    return cast("str | None", connection.scalar(query))


def demand_version(connection: Connection, name: str) -> None:
    """Refuse tables that this Maestra cannot read.

    Raises:
        InvalidError: there are none, or those of another version.
    """
    found = version_of(connection)
    if found == VERSION:
        return
    if found is None:
        raise InvalidError([Fault(name, "no record", "one that Maestra has begun")])
    raise InvalidError(
        [Fault(name, f"a record of version {found}", f"version {VERSION}, of this Maestra")]
    )


def upgrade(connection: Connection, name: str) -> None:
    """Make or change the tables, all or nothing with the transaction around it.

    Raises:
        InvalidError: the tables are of a newer Maestra.
    """
    found = version_of(connection)
    if found == VERSION:
        return
    if found is not None and found > VERSION:
        demand_version(connection, name)
    # A quarter of a second to import, and needed once for each version.
    from alembic import command  # noqa: PLC0415
    from alembic.config import Config  # noqa: PLC0415

    config = Config()
    config.set_main_option("script_location", "maestra.storage:migrations")
    config.attributes["connection"] = connection
    command.upgrade(config, "head")
