"""A robot in a program: it prints what a robot would say and do.

    python examples/programs/robot.py http://localhost:8000 ROOM TOKEN_OF_THE_ROBOT

It has no hand, and says so: then the coach asks somebody else to move the token. A robot with a
hand moves it first, and tells `robot-done` with the number of the command.
"""

import json
import sys
import time
from typing import Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

AGAIN_S = 1.0
"""Between attempts to connect."""


def carry_out(command: dict[str, Any]) -> None:
    """Do what the coach asks for; what is not known here is passed over."""
    match command:
        case {"command": "say", "text": text}:
            print("says:", text, flush=True)
        case {"command": "express", "expression": expression}:
            print("looks", expression, flush=True)
        case {"command": "gesture", "gesture": gesture}:
            print("makes a gesture:", gesture, flush=True)
        case {"command": "point-at", "cells": cells}:
            print("points at", cells, flush=True)
        case _:
            pass


def answer(socket: ClientConnection, message: dict[str, Any]) -> None:
    """Carry out what is new, and tell how it went with tokens that are to be moved."""
    for command in message.get("commands", []):
        carry_out(command)
    # All that still waits, also what was asked for while the connection was broken.
    for command in message.get("awaiting", []):
        number = command["number"]
        event = {"event": "robot-failed", "command": number, "why": "it has no hand"}
        # The same id for the same command: told twice, it happens once.
        told = {"id": f"{message['session'][-16:]}-{number}", "event": event}
        socket.send(json.dumps(told))


def main() -> None:
    """Follow the room for ever; connect again whenever that breaks off."""
    address, room, token = sys.argv[1:4]
    url = f"{address.replace('http', 'ws', 1)}/api/rooms/{room}/stream"
    while True:
        try:
            with connect(url, additional_headers={"Authorization": f"Bearer {token}"}) as socket:
                for text in socket:
                    message = json.loads(text)
                    if message["type"] == "state":
                        answer(socket, message)
        except (ConnectionClosed, OSError):
            time.sleep(AGAIN_S)


if __name__ == "__main__":
    main()
