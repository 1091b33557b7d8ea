"""How patients get on: curves and tables, sessions step by step, exports."""

from maestra.web.progress import api, routes

ROUTERS = (routes.router, api.router)
