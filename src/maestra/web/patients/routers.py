"""All routes of this area."""

from maestra.web.patients import api, routes, settings_routes

ROUTERS = (routes.router, settings_routes.router, api.router)
