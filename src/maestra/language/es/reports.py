"""Spanish: what a report on progress says."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

REPORT: Final[Mapping[str, str]] = MappingProxyType(
    {
        "title": "Progreso de {patient}",
        "nothing-yet": "Todavía no se ha jugado ninguna sesión.",
        "exercise": "Ejercicio",
        "session": "Sesión",
        "sessions": "Sesiones",
        "begun": "Inicio",
        "completion": "Hecho",
        "completed": "sí",
        "broken-off": "no",
        "steps": "Pasos",
        "first-attempts": "Bien a la primera",
        "reaction": "Reacción",
        "assistance": "Ayuda",
        "lasted": "Duración",
        "trend": "Tendencia",
        "rising": "sube",
        "falling": "baja",
        "steady": "sin tendencia clara",
        "too-few": "pocas sesiones",
        "percent": "{number} %",
        "seconds": "{number} s",
        "minutes": "{number} min",
        "level": "{number} de 5",
        "how-to-read": (
            "Bien a la primera: pasos que la persona hizo sin ningún intento rechazado "
            "antes. Reacción: mediana del tiempo desde que le toca hasta que levanta una "
            "ficha. Ayuda: nivel medio, de 0 (ninguna) a 5 (el robot coloca la ficha), "
            "la mayor de cada paso."
        ),
    }
)
