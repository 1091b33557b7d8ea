"""One's own account: language, password, second factor, other browsers."""

import re
from dataclasses import replace

import pytest
from fastapi import FastAPI
from pyotp.totp import TOTP

from maestra.coaching.fields import Milliseconds
from maestra.web.access.accounts import TEMPORARY_MS
from maestra.web.access.passwords import Passwords, is_weak
from maestra.web.access.visitor import Role
from maestra.web.application import create_app
from maestra.web.context import Context
from tests.web.conftest import StillClock
from tests.web.people import (
    PASSWORD,
    WRONG,
    Person,
    log_in,
    logged_in,
    new_browser,
    quick_doors,
)

OTHER = "a distant lighthouse"


@pytest.fixture
def context(context: Context) -> Context:
    return Context(context.store, context.folder, context.clock, doors=quick_doors())


@pytest.fixture
def ada(app: FastAPI, context: Context) -> Person:
    return logged_in(app, context, "Ada")


def acts(context: Context) -> list[str]:
    return [one.act for one in reversed(context.store.custody.audit())]


@pytest.mark.parametrize("role", list(Role))
def test_the_page_leads_to_what_the_role_may_do(
    app: FastAPI, context: Context, role: Role
) -> None:
    page = logged_in(app, context, "Ada", role).browser.get("/account").text
    led = {path for path in ("/devices", "/accounts", "/audit") if f'href="{path}"' in page}
    assert (
        led
        == {
            Role.CAREGIVER: {"/devices"},
            Role.RESEARCHER: set[str](),
            Role.ADMINISTRATOR: {"/devices", "/accounts", "/audit"},
        }[role]
    )


def test_the_language_goes_with_the_account(app: FastAPI, ada: Person) -> None:
    assert ada.browser.post("/account/language", data={"language": "ca"}).status_code == 303
    assert '<html lang="ca">' in ada.browser.get("/account").text
    elsewhere = new_browser(app)
    log_in(elsewhere, "Ada")
    assert '<html lang="ca">' in elsewhere.get("/account").text
    assert ada.browser.post("/account/language", data={"language": "fr"}).status_code == 422


# ---------------------------------------------------------------- the password


def test_a_new_password_counts_at_once_and_ends_every_other_login(
    app: FastAPI, context: Context, ada: Person
) -> None:
    elsewhere = new_browser(app)
    log_in(elsewhere, "Ada")
    typed = {"current": PASSWORD, "password": OTHER}
    answer = ada.browser.post("/account/password", data=typed)
    assert answer.headers["location"] == "/account?saved=password"
    assert "password is changed" in ada.browser.get("/account?saved=password").text
    assert elsewhere.get("/").headers["location"] == "/login"
    assert log_in(elsewhere, "Ada").status_code == 422
    assert log_in(elsewhere, "Ada", OTHER).status_code == 303
    assert "password-changed" in acts(context)


@pytest.mark.parametrize(
    ("current", "password", "line"),
    [
        (WRONG, OTHER, "This is not your password"),
        ("", OTHER, "This is not your password"),
        (PASSWORD, "short", "at least 10 letters"),
        (PASSWORD, "x" * 201, "at least 10 letters"),
    ],
)
def test_a_password_is_only_changed_for_a_good_one_by_who_knows_it(
    app: FastAPI, ada: Person, current: str, password: str, line: str
) -> None:
    typed = {"current": current, "password": password}
    answer = ada.browser.post("/account/password", data=typed)
    assert answer.status_code == 422
    assert line in answer.text
    assert log_in(new_browser(app), "Ada").status_code == 303


def test_a_borrowed_browser_cannot_guess_the_password(ada: Person) -> None:
    typed = {"current": WRONG, "password": OTHER}
    answers = [ada.browser.post("/account/password", data=typed) for _ in range(11)]
    assert "Too many tries" in answers[-1].text


@pytest.mark.parametrize(
    ("password", "name", "expected"),
    [
        ("a quiet harbour", "Ada", False),
        ("123456789", "Ada", True),
        ("1234567890", "Ada", False),
        ("x" * 201, "Ada", True),
        ("abababababab", "Ada", True),
        ("ADA LOVELACE!", "ada", True),
        ("joyful harbour", "Jo", False),
    ],
)
def test_what_a_weak_password_is(password: str, name: str, *, expected: bool) -> None:
    assert is_weak(password, name) == expected


def test_a_password_is_the_same_however_a_keyboard_composes_it() -> None:
    passwords = quick_doors().passwords
    assert passwords.matches(passwords.hashed("ma\u00f1ana tranquila"), "man\u0303ana tranquila")


def test_a_hash_of_other_parameters_is_made_anew_at_the_next_log_in(
    app: FastAPI, context: Context, ada: Person
) -> None:
    before = context.store.access.account(ada.visitor.account).password
    stronger = replace(quick_doors(), passwords=Passwords(memory_kib=16, passes=2))
    again = create_app(Context(context.store, context.folder, context.clock, doors=stronger))
    assert log_in(new_browser(again), "Ada").status_code == 303
    after = context.store.access.account(ada.visitor.account).password
    assert ("m=8,t=1" in before, "m=16,t=2" in after) == (True, True)
    assert log_in(new_browser(app), "Ada").status_code == 303


def given_a_password(context: Context, person: Person) -> None:
    until = int(context.clock.utc().timestamp() * 1000) + TEMPORARY_MS
    context.store.access.change_account(
        person.visitor.account, lambda now: replace(now, temporary_until_ms=until)
    )


def test_a_password_from_somebody_else_opens_only_the_way_to_ones_own(
    context: Context, ada: Person
) -> None:
    given_a_password(context, ada)
    for path in ("/", "/account", "/teach"):
        assert ada.browser.get(path).headers["location"] == "/account/new-password"
    assert ada.browser.post("/account/language", data={"language": "es"}).status_code == 303
    assert ada.browser.get("/help").status_code == 200
    assert "Choose a password" in ada.browser.get("/account/new-password").text
    for wrong, line in ((PASSWORD, "another one than you were given"), ("x", "at least 10")):
        answer = ada.browser.post("/account/new-password", data={"password": wrong})
        assert answer.status_code == 422
        assert line in answer.text
    answer = ada.browser.post("/account/new-password", data={"password": OTHER})
    assert answer.headers["location"] == "/"
    assert ada.browser.get("/").status_code == 200


def test_ones_own_password_is_not_replaced_without_it(app: FastAPI, ada: Person) -> None:
    answer = ada.browser.post("/account/new-password", data={"password": OTHER})
    assert answer.headers["location"] == "/account"
    assert log_in(new_browser(app), "Ada", OTHER).status_code == 422


def test_a_password_from_somebody_else_counts_for_a_week(
    app: FastAPI, context: Context, ada: Person, clock: StillClock
) -> None:
    given_a_password(context, ada)
    clock.now = Milliseconds(TEMPORARY_MS)
    assert log_in(new_browser(app), "Ada").status_code == 303
    clock.now = Milliseconds(TEMPORARY_MS + 1000)
    assert log_in(new_browser(app), "Ada").status_code == 422


# ---------------------------------------------------------------- the second factor


def test_a_telephone_is_connected_and_then_asked_for(
    app: FastAPI, context: Context, ada: Person, clock: StillClock
) -> None:
    browser = ada.browser
    assert browser.get("/account/second-factor").headers["location"] == "/account"
    led = browser.post("/account/second-factor/offer", data={"current": PASSWORD})
    assert led.headers["location"] == "/account/second-factor"
    page = browser.get("/account/second-factor").text
    assert "<svg" in page
    assert "style=" not in page
    found = re.search(r"<code>([A-Z2-7 ]+)</code>", page)
    assert found is not None
    telephone = TOTP(found[1].replace(" ", ""))
    assert log_in(new_browser(app), "Ada").headers["location"] == "/"
    wrong = browser.post("/account/second-factor", data={"code": "12"})
    assert wrong.status_code == 422
    assert "This code is not right" in wrong.text
    code = telephone.at(clock.utc())
    right = browser.post("/account/second-factor", data={"code": f"{code[:3]} {code[3:]}"})
    assert right.headers["location"] == "/account?saved=second-factor"
    assert "telephone is asked for" in browser.get("/account").text
    elsewhere = new_browser(app)
    assert log_in(elsewhere, "Ada").headers["location"].startswith("/login/code")
    # The code that connected it is used up.
    assert elsewhere.post("/login/code", data={"code": code}).status_code == 422
    clock.now = Milliseconds(30_000)
    later = {"code": telephone.at(clock.utc())}
    assert elsewhere.post("/login/code", data=later).status_code == 303
    assert "second-factor-on" in acts(context)


@pytest.mark.parametrize("act", ["offer", "off"])
def test_the_second_factor_is_changed_only_with_the_password(
    context: Context, ada: Person, act: str
) -> None:
    context.store.access.change_account(
        ada.visitor.account, lambda now: replace(now, secret="KRSXG5CTMVRXEZLU")
    )
    answer = ada.browser.post(f"/account/second-factor/{act}", data={"current": WRONG})
    assert answer.status_code == 422
    assert "This is not your password" in answer.text
    account = context.store.access.account(ada.visitor.account)
    assert (account.secret, account.offered_secret) == ("KRSXG5CTMVRXEZLU", None)


def test_the_telephone_is_disconnected(app: FastAPI, context: Context, ada: Person) -> None:
    context.store.access.change_account(
        ada.visitor.account, lambda now: replace(now, secret="KRSXG5CTMVRXEZLU")
    )
    ada.browser.post("/account/second-factor/off", data={"current": PASSWORD})
    assert log_in(new_browser(app), "Ada").headers["location"] == "/"
    assert acts(context)[-2:] == ["second-factor-off", "logged-in"]


def test_no_secret_that_was_not_offered_is_confirmed(ada: Person) -> None:
    answer = ada.browser.post("/account/second-factor", data={"code": "123456"})
    assert answer.headers["location"] == "/account"


# ---------------------------------------------------------------- other browsers


def test_other_browsers_are_seen_and_logged_out(app: FastAPI, ada: Person) -> None:
    assert "Nowhere else" in ada.browser.get("/account").text
    elsewhere = new_browser(app)
    log_in(elsewhere, "Ada")
    assert "May 4, 2026" in ada.browser.get("/account").text
    ada.browser.post("/account/logins/end")
    assert elsewhere.get("/").status_code == 303
    assert ada.browser.get("/").status_code == 200
