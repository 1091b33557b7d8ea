"""Who is logged in in a browser, whatever may be asked of them."""

from __future__ import annotations

from starlette.requests import HTTPConnection

from maestra.language import Language
from maestra.storage.access import Account
from maestra.web.access.logins import LoginKind, current
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.context import Context, context_of


def account_of(context: Context, connection: HTTPConnection) -> Account | None:
    """Whose account this browser is logged in with."""
    login = current(context, connection, LoginKind.ACCOUNT)
    account = None if login is None else context.store.access.account(login.holder)
    return None if account is None or account.is_disabled else account


def as_visitor(account: Account) -> Visitor:
    """The account's owner, as routes know them."""
    return Visitor(
        AccountId(account.account),
        account.name,
        Role(account.role),
        Language(account.language),
    )


def perhaps(connection: HTTPConnection) -> Visitor | None:
    """Who is logged in, for pages that are everybody's; None also while a password is due."""
    account = account_of(context_of(connection), connection)
    if account is None or account.temporary_until_ms is not None:
        return None
    return as_visitor(account)
