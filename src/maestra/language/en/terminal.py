"""English: what the commands and the session in the terminal say."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

SENTENCES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "learned": "Demonstrations seen: {demonstrations}. Actions learned: {actions}.",
        "written": "Saved in {file}.",
        "still-narrow": "Not clear yet:",
        "sure": "I am {percent} % sure of this.",
        "not-sure": "I am not sure of this: {percent} %.",
        "could-also-be": "I am not sure: {percent} %. It could also be:",
        "no-simple-rule": "I am not sure: no simple rule explains what I saw. Until you say more "
        "I only allow this:",
        "does-not-fit": "I am not sure: what I was shown and told does not fit together.",
        "told": "You told me so.",
        "no-rule": "Anything is right.",
        "show-next": "To settle most of it, show this next:",
        "planned": "Planned by {engine} in {seconds} s. Problems: {problems}. "
        "Superfluous deletions dropped: {superfluous}.",
        "not-understood": "I did not understand: “{text}”.",
        "could-say": "You could say:",
        "several-meanings": "That can mean several things. Which one?",
        "cannot-keep": "No row of these tokens keeps all of these rules:",
        "before": "before",
        "after": "after",
        "times-shown": "Times shown: {seen}.",
        "of-cells": "About the two cells of a move:",
        "of-tokens": "About one token:",
        "of-pairs": "About two tokens:",
        "relation": "the first is {name} of the second, as the demonstrations declare it",
        "welcome": "Maestra learns an exercise from what you show, and accompanies a patient "
        "who plays it.",
        "which-exercise": "Which exercise shall it be?",
        "odd-ascending": "Odd numbers, from small to large",
        "ascending": "Numbers, from small to large",
        "descending": "Numbers, from large to small",
        "first-row": "The first storage row, straight up",
        "curie": "The word CURIE",
        "letters": "Letters in the order of the alphabet",
        "own-numbers": "Your own exercise, with numbers",
        "own-letters": "Your own exercise, with letters",
        "please-choose": "Please type a number from 1 to {last}.",
        "how-to-teach": "{number}  you teach it to me by showing it, and try it",
        "how-to-accompany": "{accompany} {number}  I accompany a patient who plays it",
        "kept": "I keep this session for {patient}.",
        "not-kept": "I do not keep this session; I would, with a name for the patient: "
        "{accompany} {patient}",
        "rest": "Play {number} of {count} is done. Rest; then press Enter, or type {quit}.",
        "teach": "Show me how it goes. {title}.",
        "how-to-move": "Type a token and a column, such as: {token} 1",
        "how-to-show": "Or let me show a right play: {show}",
        "nth-demonstration": "Demonstration {number}",
        "i-move": "{token} goes to column {column}.",
        "understood": "What I understand so far:",
        "and-more": "and {count} more",
        "all-clear": "All of it is clear to me now.",
        "nothing-shown": "Please show me at least one play first.",
        "nothing-moved": "Please move a token first.",
        "nothing-to-undo": "There is nothing to undo.",
        "cannot-show": "Only you know this exercise. Please show it to me.",
        "next-step": "Show another play, or try it: {play}. Or let a patient play it: {accompany}",
        "your-turn": "Your turn. I say of each move whether it is right.",
        "right": "Yes.",
        "put-back": "Let us put {token} back and try another one.",
        "complete": "Well done, the exercise is complete.",
        "not-yet": "There is still something to move.",
        "hint": "You could move {token} to column {column}.",
        "no-hint": "I know no right move here. Please show me more: {teach}",
        "unknown-command": "I do not know that. Type {help} to see what you can do.",
        "unknown-token": "There is no token {token}.",
        "no-such-column": "The columns go from 1 to {last}.",
        "taken": "There is already a token in column {column}.",
        "already-there": "{token} is already in the goal row.",
        "row-is-full": "The goal row is full.",
        "help-teaching": "{token} 1  moves {token} to column 1 of the goal row\n"
        "{token}    moves it to the first empty column\n"
        "{undo}  takes the last move back\n"
        "{done}  ends this demonstration\n"
        "{show}  I show a right play; with a number, so many\n"
        "{play}  try the exercise yourself\n"
        "{accompany}  I accompany a patient who plays it\n"
        "{menu}  choose another exercise\n"
        "{quit}  end the session",
        "help-playing": "{token} 1  moves {token} to column 1 of the goal row\n"
        "{token}    moves it to the first empty column\n"
        "{hint}  I say what you could move\n"
        "{teach}  show me more\n"
        "{play}  start again\n"
        "{accompany}  I accompany a patient who plays it\n"
        "{menu}  choose another exercise\n"
        "{quit}  end the session",
        "help-session": "{token} 1  moves {token} to column 1 of the goal row\n"
        "{token}    moves it to the first empty column\n"
        "{undo}  puts back what lies wrong\n"
        "{hint}  asks for help\n"
        "{show}  has this move made\n"
        "{done}  says that this is all\n"
        "{quit}  ends the session",
        "help-choosing": "{number}  you teach this exercise to me by showing it, and try it\n"
        "{accompany} {number}  I accompany a patient who plays it\n"
        "{accompany} {number} {patient}  the same, and I keep the session for {patient}\n"
        "{quit}  end the session",
        "goodbye": "Goodbye.",
        "goal": "goal",
        "type-undo": "undo",
        "type-done": "done",
        "type-show": "show me",
        "type-play": "play",
        "type-teach": "teach",
        "type-menu": "menu",
        "type-hint": "hint",
        "type-accompany": "accompany",
        "type-help": "help",
        "type-quit": "quit",
    }
)

FEATURES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "cells": "origin and destination alone, nothing of tokens",
        "origin": "the cell the token comes from",
        "destination": "the cell it goes to",
        "origin-row": "the row it comes from",
        "origin-column": "the column it comes from",
        "destination-column": "the column it goes to",
        "same-column": "it stays in its column",
        "from-storage": "it comes from a storage row (always counts)",
        "to-goal-row": "it goes to the goal row (always counts)",
        "odd": "it is odd",
        "even": "it is even",
        "prime": "it is a prime number",
        "vowel": "it is a vowel",
        "consonant": "it is a consonant",
        "multiple-of-K": "it is a multiple of K, such as multiple-of-5",
        "digits-K": "it has K digits, such as digits-2",
        "above-K": "it is greater than K, such as above-30",
        "below-K": "it is less than K, such as below-30",
        "is-K": "it is just K, such as is-red",
        "less-than": "the first is less than the second",
        "greater-than": "the same as less-than, from the other end",
        "before": "the first comes before the second in the alphabet or the declared order",
        "after": "the same as before, from the other end",
        "successor": "the second is the one right after the first",
        "predecessor": "the same as successor, from the other end",
        "twice": "the second is twice the first",
        "half": "the same as twice, from the other end",
        "same": "both show the same",
        "different": "they show different things",
    }
)
