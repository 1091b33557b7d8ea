"""Teaching an exercise on the screen: played on a board, understood beside it, kept as it goes."""

from __future__ import annotations

from typing import Final

from maestra.web.teach import pictures, routes

ROUTERS: Final = (routes.router, pictures.router)
