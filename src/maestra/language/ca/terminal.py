"""Catalan: what the commands and the session in the terminal say."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

SENTENCES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "learned": "Demostracions vistes: {demonstrations}. Accions apreses: {actions}.",
        "written": "Desat a {file}.",
        "still-narrow": "Encara no és clar:",
        "sure": "N'estic segur al {percent} %.",
        "not-sure": "No n'estic segur: {percent} %.",
        "could-also-be": "No n'estic segur: {percent} %. També podria ser:",
        "no-simple-rule": "No n'estic segur: cap regla senzilla explica el que he vist. Mentre "
        "no em digui més, només permeto això:",
        "does-not-fit": "No n'estic segur: el que m'ha mostrat i el que m'ha dit no encaixen.",
        "told": "Vostè m'ho ha dit així.",
        "no-rule": "Tot val.",
        "show-next": "Per aclarir-ne el màxim, mostreu ara això:",
        "planned": "Planificat per {engine} en {seconds} s. Problemes: {problems}. "
        "Supressions supèrflues descartades: {superfluous}.",
        "not-understood": "No he entès: «{text}».",
        "could-say": "Podeu dir:",
        "several-meanings": "Això pot voler dir diverses coses. Quina?",
        "cannot-keep": "Cap fila d'aquestes fitxes compleix totes aquestes regles:",
        "before": "abans",
        "after": "després",
        "times-shown": "Vegades mostrada: {seen}.",
        "of-cells": "Sobre les dues caselles d'un moviment:",
        "of-tokens": "Sobre una fitxa:",
        "of-pairs": "Sobre dues fitxes:",
        "relation": "la primera és {name} de la segona, tal com ho declaren les demostracions",
        "welcome": "Maestra aprèn un exercici del que mostreu, i acompanya un pacient que el "
        "juga.",
        "which-exercise": "Quin exercici fem?",
        "odd-ascending": "Nombres senars, de petit a gran",
        "ascending": "Nombres, de petit a gran",
        "descending": "Nombres, de gran a petit",
        "first-row": "La primera fila de reserva, en línia recta cap amunt",
        "curie": "La paraula CURIE",
        "letters": "Lletres en l'ordre de l'alfabet",
        "own-numbers": "El vostre propi exercici, amb nombres",
        "own-letters": "El vostre propi exercici, amb lletres",
        "please-choose": "Escriviu un nombre de l'1 al {last}, si us plau.",
        "how-to-teach": "{number}  m'ho ensenyeu mostrant-ho, i ho proveu",
        "how-to-accompany": "{accompany} {number}  acompanyo un pacient que hi juga",
        "kept": "Deso aquesta sessió per a {patient}.",
        "not-kept": "No deso aquesta sessió; la desaria amb un nom per al pacient: "
        "{accompany} {patient}",
        "rest": "Ha acabat la partida {number} de {count}. "
        "Descanseu; després premeu Retorn o escriviu {quit}.",
        "teach": "Mostreu-me com es fa. {title}.",
        "how-to-move": "Escriviu una fitxa i una columna, per exemple: {token} 1",
        "how-to-show": "O deixeu que jo mostri una jugada correcta: {show}",
        "nth-demonstration": "Demostració {number}",
        "i-move": "{token} va a la columna {column}.",
        "understood": "El que entenc fins ara:",
        "and-more": "i {count} més",
        "all-clear": "Ara ho tinc tot clar.",
        "nothing-shown": "Mostreu-me abans almenys una jugada, si us plau.",
        "nothing-moved": "Moveu abans una fitxa, si us plau.",
        "nothing-to-undo": "No hi ha res per desfer.",
        "cannot-show": "Aquest exercici només el coneixeu vós. Mostreu-me'l, si us plau.",
        "next-step": "Mostreu una altra jugada, o proveu-ho: {play}. O que hi jugui un pacient: "
        "{accompany}",
        "your-turn": "És el vostre torn. Diré de cada moviment si és correcte.",
        "right": "Sí.",
        "put-back": "Tornem {token} al seu lloc i provem amb una altra fitxa.",
        "complete": "Molt bé, l'exercici és complet.",
        "not-yet": "Encara queda alguna cosa per moure.",
        "hint": "Podríeu moure {token} a la columna {column}.",
        "no-hint": "Aquí no conec cap moviment correcte. Ensenyeu-me'n més, si us plau: {teach}",
        "unknown-command": "Això no ho conec. Escriviu {help} per veure què podeu fer.",
        "unknown-token": "No hi ha cap fitxa {token}.",
        "no-such-column": "Les columnes van de l'1 al {last}.",
        "taken": "Ja hi ha una fitxa a la columna {column}.",
        "already-there": "{token} ja és a la fila de destí.",
        "row-is-full": "La fila de destí és plena.",
        "help-teaching": "{token} 1  mou {token} a la columna 1 de la fila de destí\n"
        "{token}    la mou a la primera columna buida\n"
        "{undo}  desfà l'últim moviment\n"
        "{done}  acaba aquesta demostració\n"
        "{show}  jo mostro una jugada correcta; amb un nombre, tantes\n"
        "{play}  provar l'exercici\n"
        "{accompany}  acompanyo un pacient que hi juga\n"
        "{menu}  triar un altre exercici\n"
        "{quit}  acabar la sessió",
        "help-playing": "{token} 1  mou {token} a la columna 1 de la fila de destí\n"
        "{token}    la mou a la primera columna buida\n"
        "{hint}  dic què es podria moure\n"
        "{teach}  ensenyar-me més\n"
        "{play}  tornar a començar\n"
        "{accompany}  acompanyo un pacient que hi juga\n"
        "{menu}  triar un altre exercici\n"
        "{quit}  acabar la sessió",
        "help-session": "{token} 1  mou {token} a la columna 1 de la fila de destinació\n"
        "{token}    la mou a la primera columna lliure\n"
        "{undo}  torna el que és fora de lloc\n"
        "{hint}  demana ajuda\n"
        "{show}  fa que un altre faci aquest moviment\n"
        "{done}  diu que això és tot\n"
        "{quit}  acaba la sessió",
        "help-choosing": "{number}  m'ensenyeu aquest exercici mostrant-lo, i el proveu\n"
        "{accompany} {number}  acompanyo un pacient que hi juga\n"
        "{accompany} {number} {patient}  el mateix, i deso la sessió per a {patient}\n"
        "{quit}  acabar la sessió",
        "goodbye": "A reveure.",
        "goal": "destí",
        "type-undo": "desfés",
        "type-done": "fet",
        "type-show": "mostra",
        "type-play": "jugar",
        "type-teach": "ensenyar",
        "type-menu": "menú",
        "type-hint": "pista",
        "type-accompany": "acompanyar",
        "type-help": "ajuda",
        "type-quit": "surt",
    }
)

FEATURES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "cells": "només origen i destinació, res de les fitxes",
        "origin": "la casella d'on ve la fitxa",
        "destination": "la casella on va",
        "origin-row": "la fila d'on ve",
        "origin-column": "la columna d'on ve",
        "destination-column": "la columna on va",
        "same-column": "no canvia de columna",
        "from-storage": "ve d'una fila de reserva (sempre compta)",
        "to-goal-row": "va a la fila de destí (sempre compta)",
        "odd": "és senar",
        "even": "és parell",
        "prime": "és un nombre primer",
        "vowel": "és una vocal",
        "consonant": "és una consonant",
        "multiple-of-K": "és múltiple de K, per exemple multiple-of-5",
        "digits-K": "té K xifres, per exemple digits-2",
        "above-K": "és més gran que K, per exemple above-30",
        "below-K": "és més petit que K, per exemple below-30",
        "is-K": "és justament K, per exemple is-red",
        "less-than": "la primera és més petita que la segona",
        "greater-than": "el mateix que less-than, vist des de l'altra",
        "before": "la primera va abans que la segona a l'alfabet o en l'ordre declarat",
        "after": "el mateix que before, vist des de l'altra",
        "successor": "la segona és la que segueix immediatament la primera",
        "predecessor": "el mateix que successor, vist des de l'altra",
        "twice": "la segona és el doble de la primera",
        "half": "el mateix que twice, vist des de l'altra",
        "same": "totes dues mostren el mateix",
        "different": "mostren coses diferents",
    }
)
