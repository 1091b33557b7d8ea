"""The app on a real server, in this process, so that tests see what it holds."""

import socket
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import uvicorn
from fastapi import FastAPI

from maestra.storage.opening import open_store, place
from maestra.web.application import create_app
from maestra.web.clock import Clock, SystemClock
from maestra.web.context import Context
from maestra.web.library.included import first_start
from tests.web.people import quick_doors

STARTED_WITHIN_S = 30.0


@dataclass(frozen=True, slots=True)
class Served:
    """A server that answers, and its insides."""

    url: str
    app: FastAPI
    context: Context


@contextmanager
def serving(folder: Path, clock: Clock | None = None) -> Generator[Served]:
    """The app on a free port of this computer, with a record of its own in `folder`.

    What comes with Maestra is in its library; nobody has an account.
    """
    store = open_store(place(str(folder / "data"), str(folder / "keys")))
    context = Context(store, folder / "cache", clock or SystemClock(), quick_doors())
    first_start(store, context.clock.utc().isoformat(timespec="seconds"))
    app = create_app(context)
    try:
        with listening(app) as url:
            yield Served(url, app, context)
    finally:
        store.close()


@contextmanager
def listening(app: FastAPI) -> Generator[str]:
    """Any app on a free port of this computer, and its address."""
    # Bound here, so that nobody else takes the port before the server does.
    listener = socket.create_server(("127.0.0.1", 0))
    port = int(listener.getsockname()[1])
    config = uvicorn.Config(app, log_config=None, access_log=False, timeout_graceful_shutdown=2)
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, args=([listener],), name="server", daemon=True)
    thread.start()
    try:
        _wait_until(lambda: server.started or not thread.is_alive())
        yield f"http://localhost:{port}"
    finally:
        server.should_exit = True
        thread.join(STARTED_WITHIN_S)
        listener.close()


def _wait_until(done: Callable[[], bool]) -> None:
    patience = time.monotonic() + STARTED_WITHIN_S
    while not done():
        if time.monotonic() > patience:
            raise TimeoutError("the server does not start")
        time.sleep(0.01)
