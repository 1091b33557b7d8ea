"""A way to the server that can be cut: closed at once, or silent as when a cable is pulled."""

import contextlib
import socket
import threading
from collections.abc import Generator
from contextlib import contextmanager
from urllib.parse import urlsplit

_CHUNK = 65_536
_PATIENCE_S = 0.05


class Cable:
    """Passes bytes on between browsers and a server, until it is cut."""

    def __init__(self, server: str) -> None:
        """Lead to the server of this address."""
        self._port = urlsplit(server).port or 80
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._listener.settimeout(_PATIENCE_S)
        self._whole = threading.Event()
        self._whole.set()
        self._is_silent = False
        self._closed = threading.Event()
        self._open: list[socket.socket] = []
        self._lock = threading.Lock()
        self._thread = threading.Thread(target=self._accept, daemon=True)
        self._thread.start()

    @property
    def url(self) -> str:
        """The address of this end."""
        return f"http://localhost:{self._listener.getsockname()[1]}"

    def cut(self, *, silently: bool = False) -> None:
        """From now on nothing comes through; `silently`: and nobody is told."""
        self._is_silent = silently
        self._whole.clear()
        if not silently:
            self._drop_all()

    def mend(self) -> None:
        """What comes new gets through again; what was open is lost."""
        self._drop_all()
        self._whole.set()

    def close(self) -> None:
        """Stop."""
        self._closed.set()
        self._drop_all()
        self._thread.join()
        self._listener.close()

    def _drop_all(self) -> None:
        with self._lock:
            dropped, self._open = self._open, []
        for one in dropped:
            with contextlib.suppress(OSError):
                one.shutdown(socket.SHUT_RDWR)
            one.close()

    def _accept(self) -> None:
        while not self._closed.is_set():
            try:
                browser, _ = self._listener.accept()
            except TimeoutError:
                continue
            if not self._whole.is_set() and not self._is_silent:
                browser.close()
                continue
            with self._lock:
                self._open.append(browser)
            threading.Thread(target=self._lead, args=(browser,), daemon=True).start()

    def _lead(self, browser: socket.socket) -> None:
        if not self._whole.is_set():
            return  # silence: taken, and never answered
        server = socket.create_connection(("127.0.0.1", self._port))
        with self._lock:
            self._open.append(server)
        back = threading.Thread(target=self._pass_on, args=(server, browser), daemon=True)
        back.start()
        self._pass_on(browser, server)
        back.join()

    def _pass_on(self, one: socket.socket, other: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while chunk := one.recv(_CHUNK):
                if self._whole.is_set():
                    other.sendall(chunk)
            other.shutdown(socket.SHUT_RDWR)


@contextmanager
def cable_to(server: str) -> Generator[Cable]:
    """A cable to a server."""
    cable = Cable(server)
    try:
        yield cable
    finally:
        cable.close()
