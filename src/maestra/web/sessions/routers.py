"""All routes of this area."""

from maestra.web.sessions import routes

ROUTERS = (routes.router,)
