"""Sessions: begun, watched, steered, ended."""

from maestra.web.sessions import routes

ROUTERS = (routes.router,)
