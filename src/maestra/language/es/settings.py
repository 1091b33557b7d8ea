"""Spanish: what a caregiver can set, in plain words."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

SETTINGS: Final[Mapping[str, tuple[str, str]]] = MappingProxyType(
    {
        "mental": (
            "Pensar y recordar",
            (
                "Hasta qué punto cuesta pensar y recordar. Los demás ajustes se "
                "deducen de esto hasta que usted los cambie."
            ),
        ),
        "physical": (
            "Moverse",
            "Hasta qué punto cuesta moverse. Una mano más lenta recibe más tiempo.",
        ),
        "hand": (
            "Mano",
            (
                "Qué mano mueve las fichas. Si cuesta alcanzar, las pistas prefieren "
                "las fichas de su lado."
            ),
        ),
        "reach": (
            "Alcance",
            (
                "Hasta dónde llega la mano. Con poco alcance, las pistas prefieren las "
                "filas cercanas."
            ),
        ),
        "language": (
            "Idioma",
            "El idioma en que el robot habla y escribe.",
        ),
        "speech_wpm": (
            "Velocidad del habla",
            "Palabras por minuto. Más despacio se sigue mejor.",
        ),
        "volume": (
            "Volumen",
            "Lo alto que habla el robot, en tanto por ciento.",
        ),
        "modalities": (
            "Maneras de comunicarse",
            "Si el robot habla, escribe, hace gestos o varias cosas a la vez.",
        ),
        "behaviour": (
            "Comportamiento inicial",
            "Cuánto confía el robot en la persona antes de conocerla.",
        ),
        "persona": (
            "Manera de ser",
            "Si el robot espera y anima, o mantiene el ritmo del ejercicio.",
        ),
        "put_back": (
            "Devolver fichas",
            "Quién devuelve una ficha equivocada de sitio. Si no pasa nada, se pide al siguiente.",
        ),
        "robot_moves": (
            "El robot mueve fichas",
            "Si el robot puede mover fichas por sí mismo.",
        ),
        "errorless": (
            "Sin errores",
            "El robot enseña la ficha antes de que pueda haber un error.",
        ),
        "attempts": (
            "Intentos",
            "Después de tantos intentos, el robot enseña la ficha.",
        ),
        "patience_s": (
            "Paciencia",
            (
                "Cuántos segundos de silencio pasan antes de que el robot hable. Nunca "
                "obliga a nadie."
            ),
        ),
        "policy": (
            "Decidir la ayuda",
            "Si la ayuda es siempre igual, sube y baja paso a paso, o se aprende de la persona.",
        ),
        "level": (
            "Ayuda al empezar",
            "Cuánto ayuda el robot al principio, de 0, le toca a usted, a 5, coloca la ficha.",
        ),
        "least_level": (
            "Ayuda mínima",
            "El robot nunca ayuda menos que esto.",
        ),
        "most_level": (
            "Ayuda máxima",
            "El robot nunca ayuda más que esto.",
        ),
        "rounds": (
            "Rondas",
            "Cuántas veces se juega el ejercicio en una sesión.",
        ),
        "one_switch": (
            "Un solo pulsador",
            (
                "En una pantalla basta una tecla o tocar en cualquier sitio. Se ofrecen las "
                "filas una tras otra, y después las casillas de una fila."
            ),
        ),
        "show_score": (
            "Mostrar los aciertos",
            "Si el paciente ve al final cuántos movimientos ha acertado.",
        ),
        "difficulty": (
            "Dificultad",
            "Cuántas cifras tienen los números y lo cerca que están unos de otros.",
        ),
        "easiest": (
            "Fichas más fáciles",
            "La dificultad nunca baja de aquí.",
        ),
        "hardest": (
            "Fichas más difíciles",
            "La dificultad nunca sube de aquí.",
        ),
    }
)
"""Each setting's name, and what it does."""

VALUES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "mental.none": "sin deterioro",
        "mental.very-mild": "deterioro muy leve",
        "mental.mild": "deterioro leve",
        "mental.moderate": "deterioro moderado",
        "mental.severe": "deterioro grave",
        "physical.none": "sin dificultad",
        "physical.slight": "algo de dificultad",
        "physical.marked": "mucha dificultad",
        "hand.left": "mano izquierda",
        "hand.right": "mano derecha",
        "reach.whole-board": "todo el tablero",
        "reach.near-rows": "las filas cercanas",
        "language.en": "English",
        "language.es": "español",
        "language.ca": "català",
        "modalities.speech": "voz",
        "modalities.text": "texto",
        "modalities.gesture": "gestos",
        "behaviour.challenging": "exigente: al principio ayuda poco",
        "behaviour.neutral": "neutro",
        "behaviour.helping": "atento: al principio ayuda mucho",
        "persona.human-centred": "la persona primero",
        "persona.exercise-centred": "el ejercicio primero",
        "put_back.robot": "el robot",
        "put_back.patient": "la persona que juega",
        "put_back.caregiver": "quien acompaña",
        "policy.fixed": "siempre igual",
        "policy.ladder": "paso a paso",
        "policy.adaptive": "aprendida de la persona",
    }
)
"""What can be chosen, by setting and value."""
