"""The record on a disk: adapters of coaching's Store port, with what keeps it private and whole.

`opening.open_store` is the way in. SQLite in a folder and PostgreSQL by URL share everything but
`sqlite.py` and `postgres.py`; tests/storage/test_contract.py runs on both.
"""
