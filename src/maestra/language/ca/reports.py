"""Catalan: what a report on progress says."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

REPORT: Final[Mapping[str, str]] = MappingProxyType(
    {
        "title": "Progrés de {patient}",
        "nothing-yet": "Encara no s'ha jugat cap sessió.",
        "exercise": "Exercici",
        "session": "Sessió",
        "sessions": "Sessions",
        "begun": "Inici",
        "completion": "Fet",
        "completed": "sí",
        "broken-off": "no",
        "steps": "Passos",
        "first-attempts": "Bé a la primera",
        "reaction": "Reacció",
        "assistance": "Ajuda",
        "lasted": "Durada",
        "trend": "Tendència",
        "rising": "puja",
        "falling": "baixa",
        "steady": "sense tendència clara",
        "too-few": "poques sessions",
        "percent": "{number} %",
        "seconds": "{number} s",
        "minutes": "{number} min",
        "level": "{number} de 5",
        "how-to-read": (
            "Bé a la primera: passos que la persona ha fet sense cap intent rebutjat "
            "abans. Reacció: mediana del temps des que li toca fins que aixeca una "
            "fitxa. Ajuda: nivell mitjà, de 0 (cap) a 5 (el robot col·loca la fitxa), la "
            "més alta de cada pas."
        ),
    }
)
