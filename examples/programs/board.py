"""A board in a program: tokens lie in memory, and are moved by lines on standard input.

    python examples/programs/board.py http://localhost:8000 ROOM TOKEN_OF_THE_BOARD

A line such as `19 1,1` puts the token that shows 19 on row 1, column 1. A real board tells the
same events when somebody moves a token. Nothing is lost when the connection breaks: what was not
acknowledged is told again under the same id, which Maestra takes once.
"""

import json
import sys
import threading
import time
import uuid
from typing import Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

AGAIN_S = 1.0
"""Between attempts to connect."""


class Board:
    """What lies where, and what is still to be told."""

    def __init__(self, address: str, room: str, token: str) -> None:
        """Join a room of the server at `address` with the board's token."""
        self.url = f"{address.replace('http', 'ws', 1)}/api/rooms/{room}/stream"
        self.headers = {"Authorization": f"Bearer {token}"}
        self.cells: dict[str, list[int]] = {}
        """Of this board: a server that comes back is told of them."""
        self.labels: dict[str, str] = {}
        self.session = ""
        self.untold: dict[str, dict[str, Any]] = {}
        self.socket: ClientConnection | None = None
        self.lock = threading.Lock()

    def follow(self) -> None:
        """Connect, listen, and connect again whenever that breaks off.

        Raises:
            InvalidStatus: the server does not let this board in.
        """
        while True:
            try:
                with connect(self.url, additional_headers=self.headers) as socket:
                    self.begin(socket)
                    for message in socket:
                        self.hear(json.loads(message))
            except (ConnectionClosed, OSError):
                with self.lock:
                    self.socket = None
                time.sleep(AGAIN_S)

    def begin(self, socket: ClientConnection) -> None:
        """Tell what could not be told, then what lies where, in case that was seen otherwise."""
        self.hear(json.loads(socket.recv()))
        with self.lock:
            self.socket = socket
            for identity, event in self.untold.items():
                socket.send(json.dumps({"id": identity, "event": event}))
        if self.session:
            self.tell({"event": "board-back", "cells": self.cells})

    def hear(self, message: dict[str, Any]) -> None:
        """Take an answer, or the state after a change; pings need nothing."""
        if message["type"] in {"ack", "fault"} and not message.get("again"):
            self.untold.pop(message["id"], None)
        if message["type"] == "fault":
            print("refused:", message["faults"], flush=True)
        if message["type"] == "state" and message["session"] != self.session:
            # Somebody has laid the tokens out for another session.
            self.session, self.cells = message["session"], dict(message["cells"])
            self.labels = {view["label"]: one for one, view in message["tokens"].items()}
            print("ready:", " ".join(sorted(self.labels)), flush=True)

    def tell(self, event: dict[str, Any]) -> None:
        """Tell it now, or as soon as there is a connection."""
        identity = str(uuid.uuid4())
        with self.lock:
            self.untold[identity] = event
            if self.socket is not None:
                self.socket.send(json.dumps({"id": identity, "event": event}))

    def move(self, label: str, cell: list[int]) -> None:
        """Somebody lifts a token and puts it on a cell."""
        token = self.labels[label]
        self.tell({"event": "lifted", "token": token})
        self.cells[token] = cell
        self.tell({"event": "placed", "token": token, "cell": cell})

    def read_lines(self) -> None:
        """Move what the lines on standard input say."""
        for line in sys.stdin:
            label, _, cell = line.strip().partition(" ")
            if label in self.labels and cell:
                self.move(label, [int(part) for part in cell.split(",")])
            else:
                print("a line is a token and a cell, such as: 19 1,1", flush=True)


def main() -> None:
    """Follow the room for ever, and move what is typed."""
    board = Board(*sys.argv[1:4])
    threading.Thread(target=board.read_lines, daemon=True).start()
    board.follow()


if __name__ == "__main__":
    main()
