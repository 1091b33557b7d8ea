"""A program teaches."""

from collections.abc import Callable
from typing import Any

import pytest
from fastapi.testclient import TestClient

from maestra.web.access.visitor import Role

Login = Callable[[Role], TestClient]
ASCENDING = ("19", "32", "46", "57", "68")


@pytest.fixture
def program(somebody: Login) -> TestClient:
    return somebody(Role.CAREGIVER)


def row(*tokens: str, goal_row: int = 1) -> dict[str, Any]:
    return {
        "moves": [
            {"token": token, "destination": [goal_row, column]}
            for column, token in enumerate(tokens, start=1)
        ]
    }


def begun(program: TestClient, **more: object) -> dict[str, Any]:
    answer = program.post("/api/drafts", json={"ready": "numbers", "seed": 3, **more})
    assert answer.status_code == 201, answer.text
    said: dict[str, Any] = answer.json()
    return said


def shown(program: TestClient, draft: str, *tokens: str) -> dict[str, Any]:
    answer = program.post(f"/api/drafts/{draft}/demonstrations", json=row(*tokens))
    assert answer.status_code == 200, answer.text
    said: dict[str, Any] = answer.json()
    return said


def test_a_program_teaches_ascending_and_saves_it(program: TestClient) -> None:
    new = begun(program)
    assert (new["demonstrations"], new["rules"], new["asked"]) == (0, [], None)
    said = shown(program, new["id"], *ASCENDING)
    assert said["status"] == "ambiguous"
    assert said["asked"]["kind"] in {"row", "move"}
    path = f"/api/drafts/{new['id']}"
    said = program.post(f"{path}/answers", json={"answer": "yes", "mark": said["mark"]}).json()
    assert (said["status"], said["asked"]) == ("learned", None)
    assert [one["id"] for one in said["rules"]] == ["full-row", "increasing-value"]
    assert program.get(path).json() == said
    saved = program.post(f"{path}/save", json={"name": "Up"})
    assert saved.json() == {"name": "Up", "version": 1}
    assert program.post(f"{path}/save", json={"name": "Up"}).json()["version"] == 1


def test_an_answer_to_what_is_no_longer_asked_is_refused(program: TestClient) -> None:
    new = begun(program)
    said = shown(program, new["id"], *ASCENDING)
    path = f"/api/drafts/{new['id']}/answers"
    first = {"answer": "no", "mark": said["mark"]}
    assert program.post(path, json=first).status_code == 200
    again = program.post(path, json=first)
    assert (again.status_code, again.json()["title"]) == (409, "the draft has changed since")
    assert program.post(path, json={"answer": "confirmed"}).status_code == 409


def test_a_demonstration_counts_no_more_and_again(program: TestClient) -> None:
    new = begun(program)
    shown(program, new["id"], *ASCENDING)
    path = f"/api/drafts/{new['id']}/demonstrations/1"
    gone = program.delete(path).json()
    assert (gone["demonstrations"], gone["counting"], gone["rules"]) == (1, [], [])
    assert program.delete(path).status_code == 409
    back = program.put(path).json()
    assert back["counting"] == [1]
    assert back["rules"]


def test_undo_takes_the_last_demonstration_away(program: TestClient) -> None:
    new = begun(program)
    shown(program, new["id"], *ASCENDING)
    after = program.post(f"/api/drafts/{new['id']}/undo").json()
    assert (after["demonstrations"], after["start"]) == (0, new["start"])
    assert program.post(f"/api/drafts/{new['id']}/undo").status_code == 409


def test_tokens_and_board_may_be_ones_own(program: TestClient) -> None:
    deck = {"tokens": {"a": {"size": 1.5}, "b": {"size": 2}, "c": {"size": 3}}}
    board = {"rows": 2, "columns": 3, "goal_row": 2}
    answer = program.post("/api/drafts", json={"deck": deck, "board": board, "name": "Sizes"})
    new = answer.json()
    assert new["tokens"]["a"] == {"size": 1.5}
    start = {"a": [1, 3], "b": [1, 2], "c": [1, 1]}
    sent = {**row("a", "b", "c", goal_row=2), "start": start}
    said = program.post(f"/api/drafts/{new['id']}/demonstrations", json=sent).json()
    assert said["demonstrations"] == 1
    assert said["start"] == start


@pytest.mark.parametrize(
    "body",
    [
        {},
        {"ready": "numbers", "deck": {"tokens": {"a": {"value": 1}}}},
        {"deck": {"tokens": {}}},
        {"deck": {"tokens": {"a": {"value": True}}}},
        {"deck": {"tokens": {"a": 3}}},
        {"deck": {"tokens": 3}},
        {"ready": "numbers", "board": {"rows": 20, "columns": 5}},
        {"ready": "numbers", "seed": -1},
        {"deck": {"tokens": {str(k): {"value": k} for k in range(80)}}},
        {"ready": "numbers", "unknown": 1},
    ],
)
def test_what_makes_no_draft_is_refused_with_its_faults(
    program: TestClient, body: dict[str, Any]
) -> None:
    answer = program.post("/api/drafts", json=body)
    assert answer.status_code == 422
    assert answer.json()["title"]


def test_a_board_without_room_is_refused(program: TestClient) -> None:
    board = {"rows": 2, "columns": 5}
    answer = program.post("/api/drafts", json={"ready": "numbers", "board": board})
    assert (answer.status_code, answer.json()["title"]) == (409, "no-room")


@pytest.mark.parametrize(
    "body",
    [
        {"moves": []},
        {"moves": [{"token": "19", "destination": [2, 1]}]},
        {"moves": [{"token": "nobody", "destination": [1, 1]}]},
        {"moves": [{"token": "19", "destination": [1, 9]}]},
        {"moves": [{"token": "19", "destination": [1, 1]}], "start": {"19": [2, 1]}},
    ],
)
def test_what_is_no_demonstration_is_refused(program: TestClient, body: dict[str, Any]) -> None:
    new = begun(program)
    answer = program.post(f"/api/drafts/{new['id']}/demonstrations", json=body)
    assert answer.status_code == 422


@pytest.mark.parametrize(
    "body", [{"answer": "wrong-cell"}, {"answer": "yes", "column": 1}, {"answer": "perhaps"}]
)
def test_what_is_no_answer_is_refused(program: TestClient, body: dict[str, Any]) -> None:
    new = begun(program)
    assert program.post(f"/api/drafts/{new['id']}/answers", json=body).status_code == 422


OTHERWISE = {"slip": "confirmed", "contradiction": "later", "cell": "unknown-cell"}


def test_whatever_is_asked_can_be_answered_until_nothing_is(program: TestClient) -> None:
    new = begun(program)
    path = f"/api/drafts/{new['id']}"
    kinds: set[str] = set()
    for tokens in (ASCENDING, ("68", "57", "46", "32", "19")):
        said = shown(program, new["id"], *tokens)
        while said["asked"] is not None:
            kinds.add(said["asked"]["kind"])
            reply: dict[str, Any] = {"answer": OTHERWISE.get(said["asked"]["kind"], "no")}
            if said["asked"]["kind"] == "cell":
                reply = {"answer": "wrong-cell", "column": 1}
            answer = program.post(f"{path}/answers", json=reply)
            assert answer.status_code == 200, answer.text
            said = answer.json()
    assert kinds & {"row", "move"}
    assert program.post(f"{path}/answers", json={"answer": "yes"}).status_code == 409


def test_drafts_are_their_owners_alone(somebody: Login) -> None:
    new = begun(somebody(Role.CAREGIVER))
    other = somebody(Role.ADMINISTRATOR)
    path = f"/api/drafts/{new['id']}"
    assert other.get("/api/drafts").json() == {"drafts": []}
    assert other.get(path).status_code == 404
    assert other.delete(path).status_code == 404
    assert other.post(f"{path}/undo").status_code == 404
    mine = somebody(Role.CAREGIVER)
    assert [one["id"] for one in mine.get("/api/drafts").json()["drafts"]] == [new["id"]]
    assert mine.delete(path).status_code == 204
    assert mine.get(path).status_code == 404
