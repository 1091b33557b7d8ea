"""Patients: who they are, how the robot treats them, what they play, and erasing them."""

from maestra.web.patients import api, routes, settings_routes

ROUTERS = (routes.router, settings_routes.router, api.router)
