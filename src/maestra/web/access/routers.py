"""All routes of access, to be joined to the app."""

from __future__ import annotations

from typing import Final

from maestra.web.access import (
    accounts,
    audit_page,
    devices_page,
    entrance,
    own_account,
    screen_page,
)

ROUTERS: Final = (
    entrance.router,
    own_account.router,
    accounts.router,
    devices_page.router,
    screen_page.router,
    audit_page.router,
)
