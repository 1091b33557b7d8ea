"""Set-up, logging in, logging out, and what is left of it."""

from dataclasses import replace
from datetime import timedelta

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from httpx2 import Response
from pyotp.totp import TOTP

from maestra.coaching.fields import Milliseconds
from maestra.web.access import logins
from maestra.web.access.second_factor import new_secret
from maestra.web.access.visitor import Role
from maestra.web.application import create_app
from maestra.web.context import Context
from tests.web.conftest import StillClock
from tests.web.people import (
    PASSWORD,
    WRONG,
    add_account,
    log_in,
    logged_in,
    new_browser,
    quick_doors,
)


@pytest.fixture
def context(context: Context) -> Context:
    return Context(context.store, context.folder, context.clock, doors=quick_doors())


@pytest.fixture
def browser(app: FastAPI) -> TestClient:
    return new_browser(app)


def cookies_set(answer: Response) -> str:
    return "\n".join(answer.headers.get_list("set-cookie"))


# ---------------------------------------------------------------- the first start


def test_the_first_start_leads_to_setting_up(browser: TestClient, context: Context) -> None:
    context.doors.open_set_up()
    assert browser.get("/").headers["location"] == "/login"
    assert browser.get("/login").headers["location"] == "/set-up"
    assert "Welcome" in browser.get("/set-up").text


def test_the_printed_code_makes_one_administrator_and_no_second(
    browser: TestClient, context: Context
) -> None:
    code = context.doors.open_set_up()
    typed = {"code": code.lower().replace("-", " "), "name": " Ada ", "password": PASSWORD}
    assert browser.post("/set-up", data=typed).headers["location"] == "/"
    assert "Ada" in browser.get("/").text
    (account,) = context.store.access.accounts()
    assert (account.name, account.role) == ("Ada", "administrator")
    assert account.password.startswith("$argon2id$")
    assert browser.get("/set-up").headers["location"] == "/login"
    again = browser.post("/set-up", data=typed | {"name": "Eve"})
    assert again.status_code == 422
    assert len(context.store.access.accounts()) == 1


@pytest.mark.parametrize(
    ("changed", "line"),
    [
        ({"code": "AAAA-BBBB-CCCC-DDDD"}, "not the code"),
        ({"code": ""}, "not the code"),
        ({"name": " "}, "write a name"),
        ({"name": "x" * 61}, "write a name"),
        ({"password": "short"}, "at least 10 letters"),
        ({"password": "aaaaaaaaaaaa"}, "at least 10 letters"),
        ({"password": "ada lovelace"}, "at least 10 letters"),
    ],
)
def test_setting_up_says_what_is_wrong_at_its_field(
    browser: TestClient, context: Context, changed: dict[str, str], line: str
) -> None:
    typed = {"code": context.doors.open_set_up(), "name": "Ada", "password": PASSWORD} | changed
    answer = browser.post("/set-up", data=typed)
    assert answer.status_code == 422
    assert line in answer.text
    assert PASSWORD not in answer.text
    assert context.store.access.accounts() == ()


def test_without_a_printed_code_nothing_typed_is_one(browser: TestClient) -> None:
    for code in ("", "None", "AAAA-BBBB-CCCC-DDDD"):
        typed = {"code": code, "name": "Ada", "password": PASSWORD}
        assert browser.post("/set-up", data=typed).status_code == 422


def test_a_code_for_recovery_makes_another_administrator_with_another_name(
    browser: TestClient, context: Context
) -> None:
    add_account(context, "Ada")
    typed = {"code": context.doors.open_set_up(), "name": "ADA", "password": PASSWORD}
    assert "Somebody else has this name" in browser.post("/set-up", data=typed).text
    assert browser.post("/set-up", data=typed | {"name": "Eve"}).status_code == 303


def test_the_code_cannot_be_guessed(browser: TestClient, context: Context) -> None:
    code = context.doors.open_set_up()
    typed = {"code": "AAAA-BBBB-CCCC-DDDD", "name": "Eve", "password": PASSWORD}
    answers = [browser.post("/set-up", data=typed).text for _ in range(11)]
    assert "not the code" in answers[9]
    assert "Please wait 2 minutes" in answers[10]
    assert "Please wait" in browser.post("/set-up", data=typed | {"code": code}).text


# ---------------------------------------------------------------- logging in


def test_whoever_logs_in_comes_back_to_the_page(browser: TestClient, context: Context) -> None:
    add_account(context, "Ada")
    led = browser.get("/account?saved=logins").headers["location"]
    assert led == "/login?next=%2Faccount%3Fsaved%3Dlogins"
    assert 'value="/account?saved=logins"' in browser.get(led).text
    typed = {"name": "ada", "password": PASSWORD, "next": "/account?saved=logins"}
    assert browser.post("/login", data=typed).headers["location"] == "/account?saved=logins"
    assert browser.get(led).headers["location"] == "/account?saved=logins"


@pytest.mark.parametrize(
    "elsewhere", ["//evil.example", "https://evil.example", "/\\evil.example", "/\t/evil", "evil"]
)
def test_logging_in_never_leads_elsewhere(
    browser: TestClient, context: Context, elsewhere: str
) -> None:
    add_account(context, "Ada")
    typed = {"name": "Ada", "password": PASSWORD, "next": elsewhere}
    assert "evil" not in browser.get("/login", params={"next": elsewhere}).text
    assert browser.post("/login", data=typed).headers["location"] == "/"


def test_a_wrong_password_and_an_unknown_name_read_and_cost_the_same(
    browser: TestClient, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    add_account(context, "Ada")
    tried: list[str | None] = []
    really = context.doors.passwords.matches

    def counted(kept: str | None, password: str) -> bool:
        tried.append(kept)
        return really(kept, password)

    monkeypatch.setattr(context.doors.passwords, "matches", counted)
    answers = [log_in(browser, name, WRONG) for name in ("Ada", "Eva")]
    assert [one.status_code for one in answers] == [422, 422]
    assert answers[0].text.replace("Ada", "Eva") == answers[1].text
    # One hash is verified for each: where there is none, one of nobody's.
    assert len(tried) == 2
    assert tried[1] is None


def test_nobodys_password_is_compared_at_the_same_cost() -> None:
    passwords = quick_doors().passwords
    assert not passwords.matches(None, WRONG)
    ours, nobodys = passwords.hashed(WRONG), passwords.nobodys
    assert ours.split("$")[:4] == nobodys.split("$")[:4]


def test_after_ten_failures_even_the_right_password_waits(
    browser: TestClient, context: Context, clock: StillClock
) -> None:
    add_account(context, "Ada")
    for _ in range(10):
        assert log_in(browser, "Ada", WRONG).status_code == 422
    answer = log_in(browser, "ada ")
    assert answer.status_code == 429
    assert "Please wait 2 minutes" in answer.text
    clock.now = Milliseconds(90_000)
    assert log_in(browser, "Ada").status_code == 303


def test_one_address_fails_thirty_times_whatever_the_name(
    browser: TestClient, context: Context
) -> None:
    add_account(context, "Ada")
    for number in range(30):
        assert log_in(browser, f"name {number}", WRONG).status_code == 422
    assert log_in(browser, "Ada").status_code == 429


def test_log_ins_that_succeed_are_not_counted(browser: TestClient, context: Context) -> None:
    add_account(context, "Ada")
    assert {log_in(browser, "Ada").status_code for _ in range(40)} == {303}


def test_the_cookie_of_the_same_computer_is_strict_and_for_no_script(
    browser: TestClient, context: Context
) -> None:
    add_account(context, "Ada")
    found = cookies_set(log_in(browser, "Ada"))
    assert "maestra=" in found
    assert "__Host-" not in found
    assert "HttpOnly; Path=/; SameSite=strict" in found


def test_over_tls_the_cookie_is_the_hosts_alone(context: Context) -> None:
    secure = Context(
        context.store, context.folder, context.clock, doors=quick_doors(), over_tls=True
    )
    add_account(secure, "Ada")
    browser = TestClient(
        create_app(secure), base_url="https://maestra.example", follow_redirects=False
    )
    answer = log_in(browser, "Ada")
    assert "__Host-maestra=" in cookies_set(answer)
    assert "HttpOnly; Path=/; SameSite=strict; Secure" in cookies_set(answer)
    assert "max-age" in answer.headers["strict-transport-security"]
    assert browser.get("/").status_code == 200
    # A cookie without the prefix, which plain HTTP could have set, is none.
    token = browser.cookies["__Host-maestra"]
    browser.cookies.clear()
    browser.cookies.set("maestra", token)
    assert browser.get("/").status_code == 303


def test_the_store_holds_the_digest_and_not_the_token(app: FastAPI, context: Context) -> None:
    ada = logged_in(app, context, "Ada")
    token = ada.browser.cookies["maestra"]
    (login,) = context.store.access.logins(ada.visitor.account)
    assert token not in repr(login)
    assert context.store.access.login(token) is None


def test_logging_in_again_ends_what_the_browser_held(app: FastAPI, context: Context) -> None:
    ada = logged_in(app, context, "Ada")
    before = ada.browser.cookies["maestra"]
    log_in(ada.browser, "Ada")
    assert ada.browser.cookies["maestra"] != before
    assert len(context.store.access.logins(ada.visitor.account)) == 1


def test_logging_out_ends_the_token_wherever_it_is(app: FastAPI, context: Context) -> None:
    ada = logged_in(app, context, "Ada")
    stolen = new_browser(app)
    stolen.cookies.set("maestra", ada.browser.cookies["maestra"])
    assert stolen.get("/").status_code == 200
    assert ada.browser.post("/logout").headers["location"] == "/login"
    assert "maestra" not in ada.browser.cookies
    assert stolen.get("/").headers["location"] == "/login"
    assert stolen.post("/logout").status_code == 303


@pytest.mark.parametrize(
    ("steps", "is_in"),
    [
        ([logins.IDLE_MS - 1_000], True),
        ([logins.IDLE_MS + 1_000], False),
        ([logins.IDLE_MS - 1_000] * 5, True),
        ([logins.IDLE_MS - 1_000] * 7, False),
    ],
)
def test_a_login_ends_when_unused_and_at_the_latest_after_a_day_of_work(
    app: FastAPI, context: Context, clock: StillClock, steps: list[int], *, is_in: bool
) -> None:
    ada = logged_in(app, context, "Ada")
    answers: list[int] = []
    for step in steps:
        clock.now = Milliseconds(clock.now + step)
        answers.append(ada.browser.get("/").status_code)
    assert answers[-1] == (200 if is_in else 303)
    assert len(context.store.access.logins(ada.visitor.account)) == int(is_in)


def test_logins_that_are_over_are_removed_when_somebody_logs_in(
    app: FastAPI, context: Context, clock: StillClock
) -> None:
    ada = logged_in(app, context, "Ada")
    clock.now = Milliseconds(logins.LONGEST_MS + 1)
    logged_in(app, context, "Eva")
    assert context.store.access.logins(ada.visitor.account) == ()


def test_a_login_outlives_a_restart_of_the_server(app: FastAPI, context: Context) -> None:
    ada = logged_in(app, context, "Ada")
    again = new_browser(create_app(Context(context.store, context.folder, context.clock)))
    again.cookies.set("maestra", ada.browser.cookies["maestra"])
    assert again.get("/").status_code == 200


def test_programs_are_told_and_not_led(browser: TestClient) -> None:
    answer = browser.get("/api/nowhere")
    assert answer.status_code == 404
    assert answer.json()["status"] == 404
    assert answer.headers["content-type"] == "application/problem+json"


# ---------------------------------------------------------------- the second factor


def with_factor(context: Context, name: str) -> tuple[str, str]:
    """Somebody whose telephone is asked for: account and secret."""
    visitor = add_account(context, name)
    secret = new_secret()
    context.store.access.change_account(visitor.account, lambda now: replace(now, secret=secret))
    return visitor.account, secret


def test_the_password_alone_opens_nothing_where_there_is_a_second_factor(
    browser: TestClient, context: Context, clock: StillClock
) -> None:
    _, secret = with_factor(context, "Ada")
    assert log_in(browser, "Ada").headers["location"] == "/login/code?next=%2F"
    assert browser.get("/").headers["location"] == "/login"
    assert browser.get("/login/code").status_code == 200
    assert browser.post("/login/code", data={"code": "000000"}).status_code == 422
    right = TOTP(secret).at(clock.utc())
    assert browser.post("/login/code", data={"code": right}).headers["location"] == "/"
    assert browser.get("/").status_code == 200


def test_a_code_counts_once_and_for_a_minute_and_a_half(
    app: FastAPI, context: Context, clock: StillClock
) -> None:
    _, secret = with_factor(context, "Ada")
    codes = {
        seconds: TOTP(secret).at(clock.utc() + timedelta(seconds=seconds))
        for seconds in (-60, -30, 0, 30, 60)
    }
    accepted: list[int] = []
    for seconds in (-60, 60, -30, -30, 0, 30, 0):
        browser = new_browser(app)
        log_in(browser, "Ada")
        if browser.post("/login/code", data={"code": codes[seconds]}).status_code == 303:
            accepted.append(seconds)
    assert accepted == [-30, 0, 30]


def test_half_a_login_ends_after_five_minutes(
    browser: TestClient, context: Context, clock: StillClock
) -> None:
    _, secret = with_factor(context, "Ada")
    log_in(browser, "Ada")
    clock.now = Milliseconds(5 * 60_000 + 1)
    code = TOTP(secret).at(clock.utc())
    assert browser.post("/login/code", data={"code": code}).headers["location"] == "/login"
    assert browser.get("/login/code").headers["location"] == "/login"


def test_codes_cannot_be_guessed(browser: TestClient, context: Context) -> None:
    with_factor(context, "Ada")
    log_in(browser, "Ada")
    answers = [browser.post("/login/code", data={"code": "1"}).status_code for _ in range(11)]
    assert answers == [422] * 10 + [429]


def test_half_a_login_can_be_given_up(browser: TestClient, context: Context) -> None:
    account, _ = with_factor(context, "Ada")
    log_in(browser, "Ada")
    assert browser.post("/logout").headers["location"] == "/login"
    assert context.store.access.logins(account) == ()


def test_the_first_language_after_logging_in_is_the_accounts(
    app: FastAPI, context: Context
) -> None:
    visitor = add_account(context, "Ada", Role.RESEARCHER)
    context.store.access.change_account(visitor.account, lambda one: replace(one, language="ca"))
    browser = new_browser(app)
    log_in(browser, "Ada")
    assert '<html lang="ca">' in browser.get("/").text


def test_the_audit_tells_of_log_ins_and_keeps_no_name_that_was_mistyped(
    app: FastAPI, context: Context
) -> None:
    ada = logged_in(app, context, "Ada")
    log_in(new_browser(app), "Ada", WRONG)
    log_in(new_browser(app), "my secret password", WRONG)
    ada.browser.post("/logout")
    lines = context.store.custody.audit()
    assert [one.act for one in reversed(lines)] == [
        "logged-in",
        "log-in-refused",
        "log-in-refused",
        "logged-out",
    ]
    assert [one.account for one in reversed(lines)] == [
        ada.visitor.account,
        ada.visitor.account,
        None,
        ada.visitor.account,
    ]
    assert "secret" not in repr(lines)
    assert WRONG not in repr(lines)
