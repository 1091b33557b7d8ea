"""Teaching an exercise on the screen: played on a board, understood beside it, kept as it goes."""

from __future__ import annotations

from typing import Final

from maestra.web.teach import api, features, pictures, routes, tokens, trying, words

ROUTERS: Final = (
    # The pages with a fixed name come before those that are named by a draft.
    tokens.router,
    routes.router,
    words.router,
    trying.router,
    features.router,
    pictures.router,
    api.router,
)
