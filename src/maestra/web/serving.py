"""Starting the server: where it listens, who may reach it, what it says, how it stops."""

from __future__ import annotations

import errno
import os
import signal
import socket
import ssl
import sys
import webbrowser
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from types import FrameType
from typing import Final

import uvicorn

from maestra.core.faults import Fault, InvalidError
from maestra.storage.opening import open_store, place
from maestra.storage.store import SqlStore
from maestra.web.access.doors import LOOPBACK_HOSTS, Doors
from maestra.web.application import create_app
from maestra.web.context import Context
from maestra.web.library.included import first_start

USUAL_PORT: Final = 8000
ANY_PORT: Final = 0
"""Has the operating system choose one."""
LOOPBACK: Final = "127.0.0.1"
STOP_S: Final = 5
"""For answers that are under way; a stream is told to come back later."""
MOST_CONNECTIONS: Final = 2_000
"""At the same time: a thousand screens and their pages; more is refused with 503."""
MOST_MESSAGE_BYTES: Final = 64 * 1024
"""Of a stream's message; an event has a few hundred."""

Tell = Callable[[str], None]
"""Prints a line."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """How to serve."""

    data: str | None = None
    """The record; None: where it usually is."""
    keys: str | None = None
    host: str = LOOPBACK
    port: int | None = None
    """None: the usual one, or another if it is taken."""
    certificate: str | None = None
    key: str | None = None
    behind_proxy: bool = False
    """A proxy on this computer speaks TLS to the browsers."""
    without_tls: bool = False
    """Whoever asked knows what plain HTTP beyond this computer means."""
    recover: bool = False
    """Make a set-up code although there are accounts."""
    opens_browser: bool = False

    @property
    def over_tls(self) -> bool:
        """Whether browsers reach the server by https."""
        return self.certificate is not None or self.behind_proxy

    @property
    def is_local(self) -> bool:
        """Whether only this computer can reach the server."""
        return is_loopback(self.host)


def serve(wanted: Wanted, tell: Tell) -> None:
    """Serve until it is stopped by Ctrl-C or by the system.

    Raises:
        InvalidError: others would reach it in plain HTTP, the certificate is none, or the record
            is in use.
        OSError: the address is taken or not this computer's, or the record cannot be reached.
    """
    demand_safe(wanted)
    with _listening(wanted) as listener:
        store = open_store(place(wanted.data, wanted.keys))
        try:
            context = _context(store, wanted)
            first_start(store, context.clock.utc().isoformat(timespec="seconds"))
            address = address_to_open(wanted, int(listener.getsockname()[1]))
            _announce(context, wanted, address, tell)
            if wanted.opens_browser and has_display():
                # The listener already waits for it.
                webbrowser.open(address)
            _run(uvicorn.Server(_config(context, wanted)), listener)
        finally:
            store.close()
    tell("Stopped; everything is saved.")


def demand_safe(wanted: Wanted) -> None:
    """Refuse to be reached by others without encryption, and a certificate that is none.

    Raises:
        InvalidError: so it would be.
    """
    if (wanted.certificate is None) != (wanted.key is None):
        missing = "--key" if wanted.key is None else "--certificate"
        raise InvalidError([Fault(missing, "missing", "certificate and key, both or neither")])
    if wanted.certificate is not None and wanted.key is not None:
        _demand_certificate(wanted.certificate, wanted.key)
    if not (wanted.is_local or wanted.certificate is not None or wanted.without_tls):
        raise InvalidError(
            [
                Fault(
                    "--host",
                    f"{wanted.host}, which others can reach without encryption",
                    "--certificate and --key, or a proxy on this computer with --behind-proxy and "
                    f"--host {LOOPBACK}, or --without-tls-beyond-loopback",
                )
            ]
        )


def _demand_certificate(certificate: str, key: str) -> None:
    for file in (certificate, key):
        Path(file).read_bytes()  # so that a file that is missing is named
    try:
        ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER).load_cert_chain(certificate, key)
    except ssl.SSLError:
        fault = Fault(
            "--certificate", f"{certificate} and {key}", "a certificate and its key, PEM"
        )
        raise InvalidError([fault]) from None


def is_loopback(host: str) -> bool:
    """Whether an address is this computer's alone; a name is, if it is localhost."""
    if host == "localhost":
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


@contextmanager
def _listening(wanted: Wanted) -> Generator[socket.socket]:
    """A socket that takes connections; they wait until the server runs."""
    port = USUAL_PORT if wanted.port is None else wanted.port
    try:
        listener = _bound(wanted.host, port)
    except OSError as error:
        if error.errno != errno.EADDRINUSE or wanted.port is not None:
            number = error.errno or 0
            raise OSError(number, os.strerror(number), f"{wanted.host}, port {port}") from error
        listener = _bound(wanted.host, ANY_PORT)
    try:
        yield listener
    finally:
        listener.close()


def _bound(host: str, port: int) -> socket.socket:
    try:
        family, _, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    except socket.gaierror:
        fault = Fault("--host", host, "an address or name of this computer")
        raise InvalidError([fault]) from None
    return socket.create_server(address[:2], family=family)


def address_to_open(wanted: Wanted, port: int) -> str:
    """What to type in a browser."""
    scheme = "https" if wanted.certificate is not None else "http"
    host = wanted.host
    if wanted.is_local:
        # Browsers trust this name as they trust TLS, for it never leaves the computer.
        host = "localhost" if host == LOOPBACK else host
    elif host in {"0.0.0.0", "::"}:  # noqa: S104 - recognised, not used to bind
        host = socket.gethostname()
    return f"{scheme}://{f'[{host}]' if ':' in host else host}:{port}"


def has_display() -> bool:
    """Whether a browser's window could be seen here."""
    return sys.platform == "darwin" or any(
        os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY")
    )


def _context(store: SqlStore, wanted: Wanted) -> Context:
    guarded = wanted.is_local and not wanted.behind_proxy
    return Context(
        store,
        _cache_folder(),
        doors=Doors(hosts=LOOPBACK_HOSTS if guarded else None),
        over_tls=wanted.over_tls,
    )


def _cache_folder() -> Path:
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    # The specification has relative paths ignored.
    return (named if named.is_absolute() else Path.home() / ".cache") / "maestra"


def _announce(context: Context, wanted: Wanted, address: str, tell: Tell) -> None:
    tell(f"Maestra is at {address}")
    if wanted.behind_proxy:
        tell("Others reach it through your proxy, by its address.")
    if not wanted.is_local and not wanted.over_tls:
        tell("Without encryption: whoever is on the network can read along and take over.")
    is_first = not context.store.access.has_accounts()
    if is_first or wanted.recover:
        code = context.doors.open_set_up()
        first = f"To begin, open {address}/set-up" if is_first else f"Open {address}/set-up"
        tell(f"{first} and type this code, which counts once: {code}")
    tell("Ctrl-C stops it.")


def _config(context: Context, wanted: Wanted) -> uvicorn.Config:
    return uvicorn.Config(
        create_app(context),
        log_level="warning",
        # Addresses hold pseudonyms, which no log may have.
        access_log=False,
        server_header=False,
        proxy_headers=wanted.behind_proxy,
        # A proxy elsewhere is believed only by who said that others may reach us anyway.
        forwarded_allow_ips=["127.0.0.1", "::1"] if wanted.is_local else "*",
        limit_concurrency=MOST_CONNECTIONS,
        timeout_graceful_shutdown=STOP_S,
        ws_max_size=MOST_MESSAGE_BYTES,
        ssl_certfile=wanted.certificate,
        ssl_keyfile=wanted.key,
    )


def _run(server: uvicorn.Server, listener: socket.socket) -> None:
    def stop(_number: int, _frame: FrameType | None) -> None:
        server.should_exit = True

    # Those of uvicorn only hold while it runs, and end the process afterwards: before and after,
    # a signal shall let the record be closed.
    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        server.run([listener])
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
