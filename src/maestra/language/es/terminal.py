"""Spanish: what the commands and the session in the terminal say."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

SENTENCES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "learned": "Demostraciones vistas: {demonstrations}. Acciones aprendidas: {actions}.",
        "written": "Guardado en {file}.",
        "still-narrow": "Aún no está claro:",
        "sure": "Estoy seguro de esto al {percent} %.",
        "not-sure": "No estoy seguro de esto: {percent} %.",
        "could-also-be": "No estoy seguro: {percent} %. También podría ser:",
        "no-simple-rule": "No estoy seguro: ninguna regla sencilla explica lo que vi. Mientras "
        "no me diga más, solo permito esto:",
        "does-not-fit": "No estoy seguro: lo que me mostró y lo que me dijo no encajan.",
        "told": "Usted me lo dijo así.",
        "no-rule": "Todo vale.",
        "show-next": "Para aclarar lo más posible, muestre ahora esto:",
        "planned": "Planificado por {engine} en {seconds} s. Problemas: {problems}. "
        "Supresiones superfluas descartadas: {superfluous}.",
        "not-understood": "No he entendido: «{text}».",
        "could-say": "Puede decir:",
        "several-meanings": "Eso puede querer decir varias cosas. ¿Cuál de ellas?",
        "cannot-keep": "Ninguna fila de estas fichas cumple todas estas reglas:",
        "before": "antes",
        "after": "después",
        "times-shown": "Veces mostrada: {seen}.",
        "of-cells": "Sobre las dos casillas de un movimiento:",
        "of-tokens": "Sobre una ficha:",
        "of-pairs": "Sobre dos fichas:",
        "relation": "la primera es {name} de la segunda, como lo declaran las demostraciones",
        "welcome": "Maestra aprende un ejercicio de lo que usted muestra, y acompaña a un "
        "paciente que lo juega.",
        "which-exercise": "¿Qué ejercicio hacemos?",
        "odd-ascending": "Números impares, de menor a mayor",
        "ascending": "Números, de menor a mayor",
        "descending": "Números, de mayor a menor",
        "first-row": "La primera fila de reserva, en línea recta hacia arriba",
        "curie": "La palabra CURIE",
        "letters": "Letras en el orden del alfabeto",
        "own-numbers": "Su propio ejercicio, con números",
        "own-letters": "Su propio ejercicio, con letras",
        "please-choose": "Escriba un número del 1 al {last}, por favor.",
        "how-to-teach": "{number}  usted me lo enseña mostrándolo, y lo prueba",
        "how-to-accompany": "{accompany} {number}  acompaño a un paciente que lo juega",
        "kept": "Guardo esta sesión para {patient}.",
        "not-kept": "No guardo esta sesión; la guardaría con un nombre para el paciente: "
        "{accompany} {patient}",
        "rest": "Ha terminado la partida {number} de {count}. "
        "Descanse; luego pulse Intro o escriba {quit}.",
        "teach": "Muéstreme cómo se hace. {title}.",
        "how-to-move": "Escriba una ficha y una columna, por ejemplo: {token} 1",
        "how-to-show": "O deje que yo muestre una jugada correcta: {show}",
        "nth-demonstration": "Demostración {number}",
        "i-move": "{token} va a la columna {column}.",
        "understood": "Lo que entiendo hasta ahora:",
        "and-more": "y {count} más",
        "all-clear": "Ahora lo tengo todo claro.",
        "nothing-shown": "Muéstreme antes al menos una jugada, por favor.",
        "nothing-moved": "Mueva antes una ficha, por favor.",
        "nothing-to-undo": "No hay nada que deshacer.",
        "cannot-show": "Este ejercicio solo lo conoce usted. Muéstremelo, por favor.",
        "next-step": "Muestre otra jugada, o pruébelo: {play}. O que lo juegue un paciente: "
        "{accompany}",
        "your-turn": "Le toca a usted. Diré de cada movimiento si es correcto.",
        "right": "Sí.",
        "put-back": "Devolvamos {token} a su sitio y probemos con otra ficha.",
        "complete": "Muy bien, el ejercicio está completo.",
        "not-yet": "Todavía queda algo por mover.",
        "hint": "Podría mover {token} a la columna {column}.",
        "no-hint": "Aquí no conozco ningún movimiento correcto. Enséñeme más, por favor: {teach}",
        "unknown-command": "Eso no lo conozco. Escriba {help} para ver qué puede hacer.",
        "unknown-token": "No hay ninguna ficha {token}.",
        "no-such-column": "Las columnas van de la 1 a la {last}.",
        "taken": "Ya hay una ficha en la columna {column}.",
        "already-there": "{token} ya está en la fila de destino.",
        "row-is-full": "La fila de destino está llena.",
        "help-teaching": "{token} 1  mueve {token} a la columna 1 de la fila de destino\n"
        "{token}    la mueve a la primera columna vacía\n"
        "{undo}  deshace el último movimiento\n"
        "{done}  termina esta demostración\n"
        "{show}  yo muestro una jugada correcta; con un número, tantas\n"
        "{play}  probar el ejercicio\n"
        "{accompany}  acompaño a un paciente que lo juega\n"
        "{menu}  elegir otro ejercicio\n"
        "{quit}  terminar la sesión",
        "help-playing": "{token} 1  mueve {token} a la columna 1 de la fila de destino\n"
        "{token}    la mueve a la primera columna vacía\n"
        "{hint}  digo qué se podría mover\n"
        "{teach}  enseñarme más\n"
        "{play}  empezar de nuevo\n"
        "{accompany}  acompaño a un paciente que lo juega\n"
        "{menu}  elegir otro ejercicio\n"
        "{quit}  terminar la sesión",
        "help-session": "{token} 1  mueve {token} a la columna 1 de la fila de destino\n"
        "{token}    la mueve a la primera columna libre\n"
        "{undo}  devuelve lo que está fuera de su sitio\n"
        "{hint}  pide ayuda\n"
        "{show}  hace que otro haga este movimiento\n"
        "{done}  dice que esto es todo\n"
        "{quit}  termina la sesión",
        "help-choosing": "{number}  usted me enseña este ejercicio mostrándolo, y lo prueba\n"
        "{accompany} {number}  acompaño a un paciente que lo juega\n"
        "{accompany} {number} {patient}  lo mismo, y guardo la sesión para {patient}\n"
        "{quit}  terminar la sesión",
        "goodbye": "Hasta pronto.",
        "goal": "destino",
        "type-undo": "deshacer",
        "type-done": "listo",
        "type-show": "muestra",
        "type-play": "jugar",
        "type-teach": "enseñar",
        "type-menu": "menú",
        "type-hint": "pista",
        "type-accompany": "acompañar",
        "type-help": "ayuda",
        "type-quit": "salir",
    }
)

FEATURES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "cells": "solo origen y destino, nada de las fichas",
        "origin": "la casilla de la que viene la ficha",
        "destination": "la casilla a la que va",
        "origin-row": "la fila de la que viene",
        "origin-column": "la columna de la que viene",
        "destination-column": "la columna a la que va",
        "same-column": "no cambia de columna",
        "from-storage": "viene de una fila de reserva (siempre cuenta)",
        "to-goal-row": "va a la fila de destino (siempre cuenta)",
        "odd": "es impar",
        "even": "es par",
        "prime": "es un número primo",
        "vowel": "es una vocal",
        "consonant": "es una consonante",
        "multiple-of-K": "es múltiplo de K, por ejemplo multiple-of-5",
        "digits-K": "tiene K cifras, por ejemplo digits-2",
        "above-K": "es mayor que K, por ejemplo above-30",
        "below-K": "es menor que K, por ejemplo below-30",
        "is-K": "es justamente K, por ejemplo is-red",
        "less-than": "la primera es menor que la segunda",
        "greater-than": "lo mismo que less-than, visto desde la otra",
        "before": "la primera va antes que la segunda en el alfabeto o en el orden declarado",
        "after": "lo mismo que before, visto desde la otra",
        "successor": "la segunda es la que sigue inmediatamente a la primera",
        "predecessor": "lo mismo que successor, visto desde la otra",
        "twice": "la segunda es el doble de la primera",
        "half": "lo mismo que twice, visto desde la otra",
        "same": "las dos muestran lo mismo",
        "different": "muestran cosas diferentes",
    }
)
