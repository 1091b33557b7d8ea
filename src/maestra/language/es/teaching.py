"""Spanish: what is said while a caregiver teaches."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

TEACHING: Final[Mapping[str, str]] = MappingProxyType(
    {
        "is-row-right": "¿Es correcta esta fila: {tokens:bare}?",
        "is-row-right-in-time": (
            "¿Es correcta esta fila: {tokens:bare}, puesta en este orden: {order:bare}?"
        ),
        "is-empty-row-right": "¿Es correcto no poner nada en {row}?",
        "is-move-right": "¿Es correcto poner {token} en la columna {column} después {tokens:of}?",
        "is-first-move-right": "¿Es correcto poner primero {token} en la columna {column}?",
        "is-rule-meant": "¿Es esto lo que quiere decir? {rule}",
        "which-is-wrong": "¿Qué ficha de esta fila está mal?",
        "meant-to-come-before": (
            "En la {nth:feminine} demostración, ¿quería poner {first} antes {second:of}?"
        ),
        "meant-in-row": "En la {nth:feminine} demostración, ¿quería poner {token} en la fila?",
        "meant-there": (
            "En la {nth:feminine} demostración, ¿quería poner {token} en la columna {column}?"
        ),
        "disagree": "Estas dos cosas no concuerdan:",
        "shown-row": "En la {nth:feminine} demostración formó esta fila: {tokens:bare}.",
        "shown-before": "En la {nth:feminine} demostración puso {first} antes {second:of}.",
        "understood-rules": "De todo lo demás entendí: {rules}",
        "said-row-right": "Dijo que esta fila es correcta: {tokens:bare}.",
        "said-row-wrong": "Dijo que esta fila no es correcta: {tokens:bare}.",
        "said-move-right": "Dijo que aquí {token} puede ir en la columna {column}.",
        "said-move-wrong": "Dijo que aquí {token} no puede ir en la columna {column}.",
        "said-rule-meant": "Dijo que esto es lo que quiere decir: {rule}",
        "said-rule-not-meant": "Dijo que esto no es lo que quiere decir: {rule}",
        "which-counts": "¿Cuál de las dos vale?",
        "ask-again": "{earlier} {later} Por eso pregunto otra vez. {question}",
        "so-far": "Lo que entiendo hasta ahora:",
        "no-rule-yet": "Todavía nada: cualquier fila puede ser correcta.",
        "nothing-left": "No queda nada de que aprender. Muéstremelo otra vez, por favor.",
        "saved": "Guardado en {file}.",
        "how-to-reply": "({yes}, {no}, {unsure}: da igual, {enough}: no más preguntas)",
        "how-to-name": "(Escriba la ficha, o {unsure}.)",
        "how-to-mend": (
            "({yes}: era así, {no}: olvide esta demostración, {again}: la juego otra vez)"
        ),
        "how-to-pick": "(1: la primera, 2: la segunda, {neither}: ninguna de las dos, {enough})",
        "how-to-show-again": (
            "Escriba las fichas de la fila de izquierda a derecha, por ejemplo: {tokens:bare}"
        ),
        "not-understood": "Perdone, no lo he entendido.",
        "no-token": "Aquí no hay ninguna ficha {token}.",
        "type-yes": "sí",
        "type-no": "no",
        "type-unsure": "igual",
        "type-enough": "basta",
        "type-again": "otra",
        "type-neither": "ninguna",
        "exam": "Juego con mis reglas, filas correctas y otras que no. ¿Cuáles lo son?",
        "nth-play": "Fila {number} de {count}",
        "agreed": "Está de acuerdo con {agreed} de {plays} jugadas.",
        "bound": (
            "Con una confianza del 95 %, menos del {percent} % de mis jugadas serían erróneas."
        ),
        "near-misses": "De {plays} filas que creo erróneas, también llamó erróneas a {agreed}.",
        "nothing-examined": "No juzgó ninguna de mis jugadas: no sé más que antes.",
        "now": "Lo que entiendo ahora:",
        "changed": "He aprendido de ello. Lo que cambia:",
        "unchanged": "He aprendido de ello, pero mis reglas siguen igual.",
        "only-told": "Estas reglas me las dijeron con palabras. Cambie las palabras, por favor.",
        "examine-again": "Examíneme otra vez, por favor: este examen era de mis reglas de antes.",
    }
)
