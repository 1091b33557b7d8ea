"""How the tables came to be, one module a version; Alembic runs them."""
