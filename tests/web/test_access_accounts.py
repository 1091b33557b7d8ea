"""What administrators do with accounts, and the audit."""

import re

import pytest
from fastapi import FastAPI
from httpx2 import Response

from maestra.coaching.ports import PatientId
from maestra.web.access.audit import Act
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from tests.web.people import (
    PASSWORD,
    Person,
    add_account,
    log_in,
    logged_in,
    new_browser,
    quick_doors,
)

HERON, PLOVER = PatientId("heron"), PatientId("plover")


@pytest.fixture
def context(context: Context) -> Context:
    return Context(context.store, context.folder, context.clock, doors=quick_doors())


@pytest.fixture
def chief(app: FastAPI, context: Context) -> Person:
    return logged_in(app, context, "Chief", Role.ADMINISTRATOR)


def password_in(answer: Response) -> str:
    found = re.search(r"<code>([A-Z2-9-]+)</code>", answer.text)
    assert found is not None
    return found[1]


def test_an_account_is_made_with_a_password_that_is_replaced_at_once(
    app: FastAPI, context: Context, chief: Person
) -> None:
    answer = chief.browser.post("/accounts", data={"name": " Eva ", "role": "caregiver"})
    assert answer.status_code == 200
    given = password_in(answer)
    (eva,) = [one for one in context.store.access.accounts() if one.name == "Eva"]
    assert given not in repr(eva)
    assert "has not chosen a password yet" in chief.browser.get("/accounts").text
    browser = new_browser(app)
    assert log_in(browser, "Eva", given).status_code == 303
    assert browser.get("/").headers["location"] == "/account/new-password"
    browser.post("/account/new-password", data={"password": PASSWORD})
    assert browser.get("/").status_code == 200
    assert context.store.access.account(eva.account).temporary_until_ms is None


@pytest.mark.parametrize(
    ("typed", "line"),
    [
        ({"name": " ", "role": "caregiver"}, "write a name"),
        ({"name": "CHIEF", "role": "caregiver"}, "Somebody else has this name"),
        ({"name": "Eva", "role": "king"}, "not filled in as expected"),
        ({"name": "Eva"}, "not filled in as expected"),
    ],
)
def test_an_account_that_cannot_be_is_not_made(
    context: Context, chief: Person, typed: dict[str, str], line: str
) -> None:
    answer = chief.browser.post("/accounts", data=typed)
    assert answer.status_code == 422
    assert line in answer.text
    assert len(context.store.access.accounts()) == 1


def test_a_disabled_account_is_out_at_once_and_can_come_back(
    app: FastAPI, context: Context, chief: Person
) -> None:
    eva = logged_in(app, context, "Eva")
    path = f"/accounts/{eva.visitor.account}"
    assert chief.browser.post(f"{path}/disable").headers["location"] == path
    assert eva.browser.get("/").headers["location"] == "/login"
    assert log_in(eva.browser, "Eva").status_code == 422
    assert "Nobody can log in" in chief.browser.get(path).text
    assert "cannot log in" in chief.browser.get("/accounts").text
    chief.browser.post(f"{path}/enable")
    assert log_in(eva.browser, "Eva").status_code == 303


def test_an_account_that_was_disabled_meanwhile_is_out_whatever_it_holds(
    app: FastAPI, context: Context, chief: Person
) -> None:
    eva = logged_in(app, context, "Eva")
    held = eva.browser.cookies["maestra"]
    login = context.store.access.logins(eva.visitor.account)[0]
    chief.browser.post(f"/accounts/{eva.visitor.account}/disable")
    context.store.access.add_login(login)
    eva.browser.cookies.set("maestra", held)
    assert eva.browser.get("/").status_code == 303


def test_another_role_counts_from_the_next_page_on(
    app: FastAPI, context: Context, chief: Person
) -> None:
    eva = logged_in(app, context, "Eva")
    assert eva.browser.get("/accounts").status_code == 403
    path = f"/accounts/{eva.visitor.account}/role"
    chief.browser.post(path, data={"role": "administrator"})
    assert eva.browser.get("/accounts").status_code == 200
    chief.browser.post(path, data={"role": "researcher"})
    assert eva.browser.get("/devices").status_code == 403


def test_a_forgotten_password_is_replaced_and_the_telephone_let_go(
    app: FastAPI, context: Context, chief: Person
) -> None:
    eva = logged_in(app, context, "Eva")
    answer = chief.browser.post(f"/accounts/{eva.visitor.account}/reset")
    given = password_in(answer)
    assert eva.browser.get("/").headers["location"] == "/login"
    assert log_in(eva.browser, "Eva").status_code == 422
    assert log_in(eva.browser, "Eva", given).status_code == 303
    assert eva.browser.get("/").headers["location"] == "/account/new-password"


@pytest.mark.parametrize("act", ["role", "disable", "enable", "reset"])
def test_nobody_takes_their_own_rights_so_an_administrator_stays(
    context: Context, chief: Person, act: str
) -> None:
    path = f"/accounts/{chief.visitor.account}"
    assert chief.browser.post(f"{path}/{act}", data={"role": "caregiver"}).status_code == 403
    assert "your own account" in chief.browser.get(path).text
    assert context.store.access.account(chief.visitor.account).role == "administrator"


def test_accounts_that_are_not_there_are_not_found(chief: Person) -> None:
    assert chief.browser.get("/accounts/nobody").status_code == 404
    for act in ("role", "disable", "enable", "reset", "patients"):
        answer = chief.browser.post(f"/accounts/nobody/{act}", data={"role": "caregiver"})
        assert answer.status_code == 404


def test_patients_are_entrusted_by_ticking_them(context: Context, chief: Person) -> None:
    eva = add_account(context, "Eva")
    context.store.save_settings(HERON, "{}")
    context.store.save_settings(PLOVER, "{}")
    path = f"/accounts/{eva.account}"
    answer = chief.browser.post(f"{path}/patients", data={"patient": ["heron", "nobody"]})
    assert answer.headers["location"] == path
    assert context.store.custody.patients_of(eva.account) == (HERON,)
    assert re.search(r'value="heron" checked', chief.browser.get(path).text)
    chief.browser.post(f"{path}/patients", data={"patient": ["plover"]})
    assert context.store.custody.patients_of(eva.account) == (PLOVER,)
    chief.browser.post(f"{path}/patients")
    assert context.store.custody.patients_of(eva.account) == ()
    lines = [(one.act, one.patient) for one in reversed(context.store.custody.audit())]
    assert lines[1:] == [
        ("entrusted", HERON),
        ("entrusted", PLOVER),
        ("released", HERON),
        ("released", PLOVER),
    ]


# ---------------------------------------------------------------- the audit


def test_the_audit_is_shown_page_by_page_in_words(context: Context, chief: Person) -> None:
    context.store.save_settings(HERON, "{}")
    for k in range(150):
        context.store.custody.note(
            "2026-05-04T12:00:00+00:00", chief.visitor.account, "read", HERON, f"line-{k}-"
        )
    page = chief.browser.get("/audit").text
    assert "line-149-" in page
    assert "line-49-" not in page
    assert "looked at a patient" in page
    led = re.search(r'href="(/audit\?before=\d+)"', page)
    assert led is not None
    older = chief.browser.get(led[1]).text
    assert "line-49-" in older
    assert "logged in" in older
    assert "Newest" in older
    assert "before=" not in older


@pytest.mark.parametrize("before", ["0", "-1", "x", "9007199254740993"])
def test_a_page_of_the_audit_that_cannot_be_is_refused(chief: Person, before: str) -> None:
    assert chief.browser.get("/audit", params={"before": before}).status_code == 422


def test_every_act_has_its_words(context: Context, chief: Person) -> None:
    for act in Act:
        context.store.custody.note("2026-05-04T12:00:00+00:00", None, act.value, None, "")
    for language in ("en", "es", "ca"):
        chief.browser.post("/language", data={"language": language})
        assert chief.browser.get("/audit").status_code == 200
