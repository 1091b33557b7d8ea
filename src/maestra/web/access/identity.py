"""Finding out that somebody is who they say: name and password, then perhaps a code."""

from __future__ import annotations

from dataclasses import replace

from maestra.storage.access import Account
from maestra.web.access.audit import Act, note
from maestra.web.access.logins import now_ms
from maestra.web.access.passwords import digest
from maestra.web.access.second_factor import step_of
from maestra.web.access.throttle import NO_WAIT
from maestra.web.context import Context
from maestra.web.problems import TooManyError


def account_with(context: Context, name: str, password: str, address: str) -> Account | None:
    """Whose name and password these are; takes as long for names that nobody has.

    Raises:
        TooManyError: too many have failed, of this name or from this address.
    """
    key = digest(name.strip().casefold())
    count_try(context, key, address)
    account = context.store.access.account_named(name)
    usable = None if account is None or account.is_disabled else account.password
    if not context.doors.passwords.matches(usable, password) or _is_expired(context, account):
        # Not the name that was typed: it may be a password in the wrong field.
        note(context, None if account is None else account.account, Act.LOG_IN_REFUSED)
        return None
    uncount_try(context, key, address)
    return account if account is None else _up_to_date(context, account, password)


def has_code(context: Context, account: Account, code: str, address: str) -> bool:
    """Whether `code` is the second factor's now; it will not be a second time.

    Raises:
        TooManyError: too many have failed, of this account or from this address.
    """
    count_try(context, account.account, address)
    if account.secret is None:
        return False
    utc = context.clock.utc()
    is_right = False

    def use(now: Account) -> Account:
        nonlocal is_right
        step = None if now.secret is None else step_of(now.secret, code, utc, now.last_step)
        is_right = step is not None
        return now if step is None else replace(now, last_step=step)

    context.store.access.change_account(account.account, use)
    if is_right:
        uncount_try(context, account.account, address)
    else:
        note(context, account.account, Act.LOG_IN_REFUSED, detail="second factor")
    return is_right


def count_try(context: Context, key: str, address: str) -> None:
    """Count a try of this name or account, from this address.

    Raises:
        TooManyError: there have been too many.
    """
    doors, now = context.doors, context.clock.monotonic()
    for kind, who, limit in (
        ("try from", address, doors.limits.address),
        ("try of", key, doors.limits.account),
    ):
        wait = doors.throttle.take(kind, who, limit, now)
        if wait != NO_WAIT:
            note(context, None, Act.DENIED, detail="too many tries")
            raise TooManyError(wait)


def uncount_try(context: Context, key: str, address: str) -> None:
    """It was no failure."""
    doors, now = context.doors, context.clock.monotonic()
    doors.throttle.give_back("try from", address, doors.limits.address, now)
    doors.throttle.give_back("try of", key, doors.limits.account, now)


def _is_expired(context: Context, account: Account | None) -> bool:
    until = None if account is None else account.temporary_until_ms
    return until is not None and now_ms(context) > until


def _up_to_date(context: Context, account: Account, password: str) -> Account:
    """The same, its password hashed as new ones are."""
    passwords = context.doors.passwords
    if not passwords.is_outdated(account.password):
        return account
    hashed = passwords.hashed(password)

    def keep(now: Account) -> Account:
        return replace(now, password=hashed) if now.password == account.password else now

    return context.store.access.change_account(account.account, keep)
