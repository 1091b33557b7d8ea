"""Catalan: what a caregiver can set, in plain words."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

SETTINGS: Final[Mapping[str, tuple[str, str]]] = MappingProxyType(
    {
        "mental": (
            "Pensar i recordar",
            (
                "Fins a quin punt costa pensar i recordar. Els altres ajustos se'n "
                "dedueixen fins que els canvieu."
            ),
        ),
        "physical": (
            "Moure's",
            "Fins a quin punt costa moure's. Una mà més lenta rep més temps.",
        ),
        "hand": (
            "Mà",
            (
                "Quina mà mou les fitxes. Si costa arribar-hi, les pistes prefereixen "
                "les fitxes del seu costat."
            ),
        ),
        "reach": (
            "Abast",
            "Fins on arriba la mà. Amb poc abast, les pistes prefereixen les files properes.",
        ),
        "language": (
            "Llengua",
            "La llengua en què el robot parla i escriu.",
        ),
        "speech_wpm": (
            "Velocitat de la parla",
            "Paraules per minut. Més a poc a poc se segueix millor.",
        ),
        "volume": (
            "Volum",
            "Com de fort parla el robot, en tant per cent.",
        ),
        "modalities": (
            "Maneres de comunicar-se",
            "Si el robot parla, escriu, fa gestos o diverses coses alhora.",
        ),
        "behaviour": (
            "Comportament inicial",
            "Quanta confiança té el robot en la persona abans de conèixer-la.",
        ),
        "persona": (
            "Manera de ser",
            "Si el robot espera i anima, o manté el ritme de l'exercici.",
        ),
        "put_back": (
            "Tornar fitxes",
            "Qui torna una fitxa que no és al seu lloc. Si no passa res, es demana al següent.",
        ),
        "robot_moves": (
            "El robot mou fitxes",
            "Si el robot pot moure fitxes ell mateix.",
        ),
        "errorless": (
            "Sense errors",
            "El robot ensenya la fitxa abans que hi pugui haver un error.",
        ),
        "attempts": (
            "Intents",
            "Després de tants intents, el robot ensenya la fitxa.",
        ),
        "patience_s": (
            "Paciència",
            "Quants segons de silenci passen abans que el robot parli. No obliga mai ningú.",
        ),
        "policy": (
            "Decidir l'ajuda",
            "Si l'ajuda és sempre igual, puja i baixa pas a pas, o s'aprèn de la persona.",
        ),
        "level": (
            "Ajuda per començar",
            "Quant ajuda el robot al principi, de 0, us toca a vós, a 5, col·loca la fitxa.",
        ),
        "least_level": (
            "Ajuda mínima",
            "El robot no ajuda mai menys que això.",
        ),
        "most_level": (
            "Ajuda màxima",
            "El robot no ajuda mai més que això.",
        ),
        "rounds": (
            "Rondes",
            "Quantes vegades es juga l'exercici en una sessió.",
        ),
        "one_switch": (
            "Un sol polsador",
            (
                "En una pantalla n'hi ha prou amb una tecla o de tocar a qualsevol lloc. "
                "S'ofereixen les files una rere l'altra, i després les caselles d'una fila."
            ),
        ),
        "show_score": (
            "Mostra els encerts",
            "Si el pacient veu al final quants moviments ha encertat.",
        ),
        "difficulty": (
            "Dificultat",
            "Quantes xifres tenen els nombres i com de junts estan.",
        ),
        "easiest": (
            "Fitxes més fàcils",
            "La dificultat no baixa mai d'aquí.",
        ),
        "hardest": (
            "Fitxes més difícils",
            "La dificultat no puja mai d'aquí.",
        ),
    }
)
"""Each setting's name, and what it does."""

VALUES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "mental.none": "sense deteriorament",
        "mental.very-mild": "deteriorament molt lleu",
        "mental.mild": "deteriorament lleu",
        "mental.moderate": "deteriorament moderat",
        "mental.severe": "deteriorament greu",
        "physical.none": "sense dificultat",
        "physical.slight": "una mica de dificultat",
        "physical.marked": "molta dificultat",
        "hand.left": "mà esquerra",
        "hand.right": "mà dreta",
        "reach.whole-board": "tot el tauler",
        "reach.near-rows": "les files properes",
        "language.en": "English",
        "language.es": "español",
        "language.ca": "català",
        "modalities.speech": "veu",
        "modalities.text": "text",
        "modalities.gesture": "gestos",
        "behaviour.challenging": "exigent: al principi ajuda poc",
        "behaviour.neutral": "neutre",
        "behaviour.helping": "atent: al principi ajuda molt",
        "persona.human-centred": "la persona primer",
        "persona.exercise-centred": "l'exercici primer",
        "put_back.robot": "el robot",
        "put_back.patient": "la persona que juga",
        "put_back.caregiver": "qui acompanya",
        "policy.fixed": "sempre igual",
        "policy.ladder": "pas a pas",
        "policy.adaptive": "apresa de la persona",
    }
)
"""What can be chosen, by setting and value."""
