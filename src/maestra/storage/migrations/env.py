"""What Alembic runs for each upgrade: on the connection that `schema.upgrade` hands over."""

from alembic import context

from maestra.storage.tables import METADATA

context.configure(connection=context.config.attributes["connection"], target_metadata=METADATA)
context.run_migrations()
