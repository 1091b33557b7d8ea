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
        "completion": "Completades",
        "completed": "sí",
        "broken-off": "no",
        "steps": "Passos",
        "first-attempts": "Bé al primer intent",
        "reaction": "Temps de reacció (mediana)",
        "assistance": "Ajuda (nivell mitjà)",
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
            "Bé al primer intent: passos que la persona ha fet sense cap intent rebutjat "
            "abans. Temps de reacció: des que li toca fins que aixeca una fitxa. Ajuda: "
            "de 0 (cap) a 5 (el robot col·loca la fitxa), la més alta de cada pas."
        ),
    }
)
