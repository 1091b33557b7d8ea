"""Catalan: what is said while a caregiver teaches."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

TEACHING: Final[Mapping[str, str]] = MappingProxyType(
    {
        "is-row-right": "És correcta aquesta fila: {tokens:bare}?",
        "is-row-right-in-time": (
            "És correcta aquesta fila: {tokens:bare}, posada en aquest ordre: {order:bare}?"
        ),
        "is-empty-row-right": "És correcte no posar res a {row}?",
        "is-move-right": "És correcte posar {token} a la columna {column} després {tokens:of}?",
        "is-first-move-right": "És correcte posar primer {token} a la columna {column}?",
        "is-rule-meant": "És això el que voleu dir? {rule}",
        "which-is-wrong": "Quina fitxa d'aquesta fila està malament?",
        "meant-to-come-before": (
            "A la {nth:feminine} demostració, volíeu posar {first} abans {second:of}?"
        ),
        "meant-in-row": "A la {nth:feminine} demostració, volíeu posar {token} a la fila?",
        "meant-there": (
            "A la {nth:feminine} demostració, volíeu posar {token} a la columna {column}?"
        ),
        "disagree": "Aquestes dues coses no concorden:",
        "shown-row": "A la {nth:feminine} demostració vau formar aquesta fila: {tokens:bare}.",
        "shown-before": "A la {nth:feminine} demostració vau posar {first} abans {second:of}.",
        "understood-rules": "De tota la resta vaig entendre: {rules}",
        "said-row-right": "Vau dir que aquesta fila és correcta: {tokens:bare}.",
        "said-row-wrong": "Vau dir que aquesta fila no és correcta: {tokens:bare}.",
        "said-move-right": "Vau dir que aquí {token} pot anar a la columna {column}.",
        "said-move-wrong": "Vau dir que aquí {token} no pot anar a la columna {column}.",
        "said-rule-meant": "Vau dir que això és el que voleu dir: {rule}",
        "said-rule-not-meant": "Vau dir que això no és el que voleu dir: {rule}",
        "which-counts": "Quina de les dues val?",
        "ask-again": "{earlier} {later} Per això ho pregunto un altre cop. {question}",
        "so-far": "El que entenc fins ara:",
        "no-rule-yet": "Encara res: qualsevol fila pot ser correcta.",
        "nothing-left": "No queda res de què aprendre. Mostreu-m'ho un altre cop, si us plau.",
        "saved": "Desat a {file}.",
        "how-to-reply": "({yes}, {no}, {unsure}: tant és, {enough}: prou preguntes)",
        "how-to-name": "(Escriviu la fitxa, o {unsure}.)",
        "how-to-mend": (
            "({yes}: era així, {no}: oblideu aquesta demostració, {again}: la jugo un altre cop)"
        ),
        "how-to-pick": "(1: la primera, 2: la segona, {neither}: cap de les dues, {enough})",
        "how-to-show-again": (
            "Escriviu les fitxes de la fila d'esquerra a dreta, per exemple: {tokens:bare}"
        ),
        "not-understood": "Perdoneu, no ho he entès.",
        "no-token": "Aquí no hi ha cap fitxa {token}.",
        "type-yes": "sí",
        "type-no": "no",
        "type-unsure": "igual",
        "type-enough": "prou",
        "type-again": "altra",
        "type-neither": "cap",
        "exam": "Jugo amb les meves regles, files correctes i d'altres que no. Quines ho són?",
        "nth-play": "Fila {number} de {count}",
        "agreed": "Esteu d'acord amb {agreed} de {plays} jugades.",
        "bound": (
            "Amb una confiança del 95 %, menys del {percent} % de les meves jugades "
            "serien errònies."
        ),
        "near-misses": "De {plays} files que crec errònies, també n'heu dit errònies {agreed}.",
        "nothing-examined": "No heu jutjat cap de les meves jugades: no sé més que abans.",
        "now": "El que entenc ara:",
        "changed": "N'he après. El que canvia:",
        "unchanged": "N'he après, però les meves regles segueixen igual.",
        "only-told": "Aquestes regles me les vau dir amb paraules. Canvieu-les, si us plau.",
        "examine-again": "Examineu-me un altre cop: aquest examen era de les regles d'abans.",
    }
)
