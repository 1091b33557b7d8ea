"""What is refused before any route sees it."""

from collections.abc import Callable, Iterator

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from starlette.testclient import WebSocketDenialResponse
from starlette.websockets import WebSocket, WebSocketDisconnect

from maestra.coaching.fields import Milliseconds
from maestra.core.faults import Fault, InvalidError
from maestra.web.access.doors import LOOPBACK_HOSTS, Doors, Limits
from maestra.web.access.gate import MOST_BYTES, MOST_BYTES_WITH_FILES
from maestra.web.access.guard import Anybody
from maestra.web.access.throttle import Limit
from maestra.web.access.visitor import Role
from maestra.web.application import create_app
from maestra.web.context import Context
from tests.web.conftest import StillClock
from tests.web.people import logged_in, new_browser, quick_doors

OURS = {"origin": "http://localhost", "sec-fetch-site": "same-origin"}


@pytest.fixture
def context(context: Context) -> Context:
    return Context(context.store, context.folder, context.clock, doors=quick_doors())


@pytest.fixture
def browser(app: FastAPI) -> TestClient:
    return new_browser(app)


# ---------------------------------------------------------------- other sites


@pytest.mark.parametrize(
    ("headers", "is_let_in"),
    [
        (OURS, True),
        ({}, True),  # a program
        ({"sec-fetch-site": "none"}, True),  # typed by the user
        ({"origin": "http://localhost"}, True),
        ({"origin": "HTTP://LOCALHOST"}, True),
        ({"sec-fetch-site": "cross-site"}, False),
        ({"sec-fetch-site": "same-site"}, False),
        (OURS | {"sec-fetch-site": "cross-site"}, False),
        (OURS | {"origin": "null"}, False),
        (OURS | {"origin": "https://localhost"}, False),
        (OURS | {"origin": "http://localhost:8000"}, False),
        (OURS | {"origin": "http://evil.example"}, False),
        ({"origin": "http://evil.example"}, False),
        ({"origin": ""}, False),
    ],
)
def test_only_pages_of_ours_may_change_anything(
    browser: TestClient, headers: dict[str, str], *, is_let_in: bool
) -> None:
    for method in ("POST", "PUT", "PATCH", "DELETE"):
        answer = browser.request(method, "/login", headers=headers)
        assert (answer.status_code != 403) == is_let_in


@pytest.mark.parametrize("method", ["GET", "HEAD"])
def test_links_from_elsewhere_may_be_followed(browser: TestClient, method: str) -> None:
    headers = {"sec-fetch-site": "cross-site", "origin": "http://evil.example"}
    assert browser.request(method, "/help", headers=headers).status_code != 403


def test_the_same_holds_over_tls(context: Context) -> None:
    secure = Context(
        context.store, context.folder, context.clock, doors=quick_doors(), over_tls=True
    )
    browser = TestClient(create_app(secure), base_url="https://maestra.example")
    for origin, is_let_in in (
        ("https://maestra.example", True),
        ("http://maestra.example", False),
        ("https://other.example", False),
    ):
        answer = browser.post("/login", headers={"origin": origin})
        assert (answer.status_code != 403) == is_let_in


@pytest.fixture
def app(app: FastAPI) -> FastAPI:
    """With routes that do what the tests ask for."""

    @app.websocket("/test/stream")
    async def stream(socket: WebSocket) -> None:
        await socket.accept()
        await socket.send_text("welcome")
        await socket.close()

    @app.websocket("/test/guarded")
    async def guarded(socket: WebSocket, visitor: Anybody) -> None:
        await socket.accept()
        await socket.send_text(visitor.name)
        await socket.close()

    @app.post("/api/test/fails/{how}")
    def fails(how: str) -> None:
        raise {
            "invalid": InvalidError([Fault("deck", "nothing", "tokens")]),
            "disk": OSError("no space left"),
            "fault": RuntimeError("oh"),
        }[how]

    @app.post("/test/fails/{how}")
    def fails_on_a_page(how: str) -> None:
        fails(how)

    @app.post("/api/test/number/{number}")
    def number(number: int) -> int:
        return number

    return app


@pytest.mark.parametrize(
    ("headers", "is_let_in"),
    [
        (OURS, True),
        ({}, True),
        ({"origin": "http://evil.example"}, False),
        ({"sec-fetch-site": "cross-site"}, False),
    ],
)
def test_only_pages_of_ours_may_open_a_stream(
    browser: TestClient, headers: dict[str, str], *, is_let_in: bool
) -> None:
    if is_let_in:
        with browser.websocket_connect("ws://localhost/test/stream", headers=headers) as stream:
            assert stream.receive_text() == "welcome"
        return
    with (
        pytest.raises(WebSocketDisconnect) as refused,
        browser.websocket_connect("ws://localhost/test/stream", headers=headers),
    ):
        pass
    assert refused.value.code == 1008


def test_a_stream_asks_who_is_there_as_pages_do(
    app: FastAPI, browser: TestClient, context: Context
) -> None:
    with (
        pytest.raises((WebSocketDisconnect, WebSocketDenialResponse)) as refused,
        browser.websocket_connect("ws://localhost/test/guarded"),
    ):
        pass
    assert isinstance(refused.value, WebSocketDisconnect)
    assert refused.value.code == 1008
    ada = logged_in(app, context, "Ada")
    with ada.browser.websocket_connect("ws://localhost/test/guarded") as stream:
        assert stream.receive_text() == "Ada"


def test_on_the_same_computer_other_names_lead_nowhere(context: Context) -> None:
    doors = Doors(hosts=LOOPBACK_HOSTS)
    app = create_app(Context(context.store, context.folder, context.clock, doors=doors))
    for base, status in (
        ("http://localhost:8000", 200),
        ("http://127.0.0.1:8000", 200),
        ("http://[::1]:8000", 200),
        ("http://rebound.example:8000", 421),
    ):
        assert TestClient(app, base_url=base).get("/login").status_code == status


# ---------------------------------------------------------------- too large, too many


def test_what_says_that_it_is_too_large_is_not_read(browser: TestClient) -> None:
    headers = {"content-type": "application/x-www-form-urlencoded"}
    answer = browser.post("/login", content=b"x" * (MOST_BYTES + 1), headers=headers)
    assert answer.status_code == 413
    assert "too large" in answer.text


@pytest.mark.parametrize("length", ["-1", "a lot", "1e3"])
def test_a_length_that_is_none_is_refused(browser: TestClient, length: str) -> None:
    answer = browser.post("/login", content=b"x", headers={"content-length": length})
    assert answer.status_code == 413


def test_what_does_not_say_is_cut_off(browser: TestClient) -> None:
    def endless() -> Iterator[bytes]:
        for _ in range(MOST_BYTES // 1000 + 2):
            yield b"name=" + b"x" * 995

    headers = {"content-type": "application/x-www-form-urlencoded"}
    assert browser.post("/login", content=endless(), headers=headers).status_code == 413


def test_forms_with_files_may_be_larger(browser: TestClient) -> None:
    picture = b"x" * (MOST_BYTES + 1)
    assert browser.post("/login", files={"picture": picture}).status_code == 422
    picture = b"x" * (MOST_BYTES_WITH_FILES + 1)
    assert browser.post("/login", files={"picture": picture}).status_code == 413


def test_exercises_with_pictures_may_be_larger_too(somebody: Callable[[Role], TestClient]) -> None:
    browser = somebody(Role.CAREGIVER)
    spaces = b" " * (MOST_BYTES + 1)
    assert browser.post("/api/exercises", content=spaces).status_code == 422
    spaces = b" " * (MOST_BYTES_WITH_FILES + 1)
    assert browser.post("/api/exercises", content=spaces).status_code == 413
    assert browser.post("/api/drafts", content=b" " * (MOST_BYTES + 1)).status_code == 413


def flooded(context: Context, clock: StillClock) -> FastAPI:
    doors = Doors(passwords=quick_doors().passwords, limits=Limits(requests=Limit(3, 1000)))
    return create_app(Context(context.store, context.folder, clock, doors=doors))


def test_an_address_changes_no_more_than_its_share(context: Context, clock: StillClock) -> None:
    browser = new_browser(flooded(context, clock))
    statuses = [browser.post("/language", data={"language": "es"}).status_code for _ in range(4)]
    assert statuses == [303, 303, 303, 429]
    answer = browser.post("/language", data={"language": "es"})
    assert answer.headers["retry-after"] == "1"
    assert "Demasiados intentos" in answer.text
    assert browser.get("/login").status_code == 200
    clock.now = Milliseconds(1000)
    assert browser.post("/language", data={"language": "es"}).status_code == 303


def test_an_account_changes_no_more_than_its_share_from_anywhere(
    context: Context, clock: StillClock
) -> None:
    app = flooded(context, clock)
    ada = logged_in(app, context, "Ada")
    statuses: list[int] = []
    for number in range(4):
        browser = TestClient(
            app,
            base_url="http://localhost",
            client=(f"10.0.0.{number}", 1),
            cookies=dict(ada.browser.cookies),
            follow_redirects=False,
        )
        statuses.append(browser.post("/account/language", data={"language": "es"}).status_code)
    assert statuses == [303, 303, 303, 429]


# ---------------------------------------------------------------- what is said


def test_faults_are_told_to_programs_as_json(app: FastAPI) -> None:
    browser = TestClient(app, base_url="http://localhost", raise_server_exceptions=False)
    found = browser.post("/api/test/number/x")
    assert found.status_code == 422
    (fault,) = found.json()["faults"]
    assert (fault["where"], fault["found"]) == ("number", "'x'")
    found = browser.post("/api/test/fails/invalid")
    assert found.status_code == 422
    assert found.json()["faults"] == [{"where": "deck", "found": "nothing", "expected": "tokens"}]
    for how, status in (("disk", 503), ("fault", 500)):
        found = browser.post(f"/api/test/fails/{how}")
        assert found.status_code == status
        assert found.json()["faults"] == []
        assert found.headers["content-type"] == "application/problem+json"
        assert "script" not in found.headers["content-security-policy"]
    assert browser.post("/api/nowhere").status_code == 404
    assert browser.get("/api/test/number/1").json()["status"] == 405


@pytest.mark.parametrize(("how", "status"), [("invalid", 422), ("disk", 503), ("fault", 500)])
@pytest.mark.parametrize("language", ["en", "es", "ca"])
def test_faults_are_told_to_people_in_their_language(
    app: FastAPI, how: str, status: int, language: str
) -> None:
    browser = TestClient(app, base_url="http://localhost", raise_server_exceptions=False)
    answer = browser.post(f"/test/fails/{how}", headers={"accept-language": language})
    assert answer.status_code == status
    assert f'<html lang="{language}">' in answer.text
    assert answer.text.count("<h1>") == 1
    assert answer.headers["x-frame-options"] == "DENY"


def test_a_page_that_is_not_there_keeps_the_way_on(app: FastAPI, context: Context) -> None:
    ada = logged_in(app, context, "Ada", Role.RESEARCHER)
    answer = ada.browser.get("/nowhere")
    assert answer.status_code == 404
    assert 'href="/library"' in answer.text
    answer = ada.browser.get("/accounts")
    assert answer.status_code == 403
    assert "You may not open this page" in answer.text
    assert "Ada" in answer.text
    lines = context.store.custody.audit(most=1)
    assert [(one.act, one.account, one.detail) for one in lines] == [
        ("denied", ada.visitor.account, "/accounts")
    ]


@pytest.mark.parametrize(
    ("path", "page"),
    [("/language", "/"), ("/screen/close", "/screen"), ("/devices/x/remove", "/devices/x")],
)
def test_what_a_form_was_sent_to_leads_back_to_its_page(
    browser: TestClient, path: str, page: str
) -> None:
    answer = browser.get(path)
    assert (answer.status_code, answer.headers["location"]) == (303, page)
    assert browser.put(path).status_code == 405
