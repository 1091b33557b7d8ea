"""People with accounts, who really log in."""

from dataclasses import dataclass
from typing import Final

from fastapi import FastAPI
from fastapi.testclient import TestClient
from httpx2 import Response

from maestra.language import Language
from maestra.storage.access import Account
from maestra.web.access.doors import Doors, Limits
from maestra.web.access.passwords import Passwords
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.context import Context

PASSWORD: Final = "a quiet harbour"
WRONG: Final = "a loud harbour"

ADA: Final = Account("", "Ada", Role.CAREGIVER.value, "en", "no hash, so no password")


def quick_doors(limits: Limits | None = None) -> Doors:
    """Doors whose hashes take no time: the tests make hundreds."""
    return Doors(passwords=Passwords(memory_kib=8, passes=1), limits=limits or Limits())


def add_account(
    context: Context, name: str, role: Role = Role.CAREGIVER, password: str = PASSWORD
) -> Visitor:
    """An account, as its owner is seen by routes."""
    account = context.store.access.add_account(
        Account(
            account="",
            name=name,
            role=role.value,
            language="en",
            password=context.doors.passwords.hashed(password),
        )
    )
    return Visitor(AccountId(account.account), name, role, Language.EN)


@dataclass(frozen=True)
class Person:
    """Somebody and their browser."""

    visitor: Visitor
    browser: TestClient


def new_browser(app: FastAPI) -> TestClient:
    """A browser that holds nothing yet, and goes nowhere by itself."""
    return TestClient(app, base_url="http://localhost", follow_redirects=False)


def log_in(browser: TestClient, name: str, password: str = PASSWORD) -> Response:
    """The answer to name and password."""
    return browser.post("/login", data={"name": name, "password": password})


def logged_in(app: FastAPI, context: Context, name: str, role: Role = Role.CAREGIVER) -> Person:
    """Somebody with a new account, logged in."""
    visitor = add_account(context, name, role)
    browser = new_browser(app)
    assert log_in(browser, name).headers["location"] == "/"
    return Person(visitor, browser)
