"""The web app put together: routes, static files, headers."""

from __future__ import annotations

from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager
from typing import Final

from fastapi import FastAPI

from maestra import __version__
from maestra.robots.phrases import Phrases
from maestra.web import help as help_pages
from maestra.web import home, language_choice, problems, teach
from maestra.web.access import routers as access
from maestra.web.access.gate import Gate
from maestra.web.assets import assets
from maestra.web.context import Context
from maestra.web.headers import SecurityHeaders
from maestra.web.library import api as library_api
from maestra.web.library import routes as library_pages
from maestra.web.patients import routers as patients
from maestra.web.progress import routers as progress
from maestra.web.rooms import patient_page, stream
from maestra.web.rooms import routes as room_routes
from maestra.web.rooms.rooms import Rooms
from maestra.web.sessions import routers as sessions

ROUTERS: Final = (
    home.router,
    language_choice.router,
    *access.ROUTERS,
    help_pages.router,
    library_pages.router,
    library_api.router,
    *patients.ROUTERS,
    *progress.ROUTERS,
    *sessions.ROUTERS,
    *teach.ROUTERS,
    room_routes.router,
    patient_page.router,
    stream.router,
)


def create_app(context: Context) -> FastAPI:
    """The application; it uses what `context` holds until the server stops."""
    phrases = Phrases(context.folder / "speech")
    rooms = Rooms(context.store, context.clock, can_speak=phrases.can_speak)

    @asynccontextmanager
    async def living(_app: FastAPI) -> AsyncGenerator[None]:
        async with rooms.ticking():
            yield

    app = FastAPI(
        lifespan=living,
        title="Maestra",
        version=__version__,
        # Their pages come from elsewhere; the document itself is ours.
        docs_url=None,
        redoc_url=None,
        openapi_url="/api/openapi.json",
        responses=problems.problems(400, 401, 403, 404, 413, 422, 429),
    )
    app.state.context = context
    app.state.rooms = rooms
    app.state.phrases = phrases
    for router in ROUTERS:
        app.include_router(router)
    app.mount("/static", assets(), "static")
    problems.install(app)
    app.add_middleware(Gate, with_files=library_api.WITH_PICTURES)
    app.add_middleware(SecurityHeaders, over_tls=context.over_tls)
    return app
