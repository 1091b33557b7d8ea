"""All routes of this area."""

from maestra.web.progress import api, routes

ROUTERS = (routes.router, api.router)
