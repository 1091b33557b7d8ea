"""English: what is said while a caregiver teaches."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

TEACHING: Final[Mapping[str, str]] = MappingProxyType(
    {
        "is-row-right": "Is this row right: {tokens}?",
        "is-row-right-in-time": "Is this row right: {tokens}, placed in this order: {order}?",
        "is-empty-row-right": "Is it right to put nothing in {row}?",
        "is-move-right": "Is it right to put {token} in column {column} after {tokens}?",
        "is-first-move-right": "Is it right to put {token} in column {column} first?",
        "is-rule-meant": "Do you mean this? {rule}",
        "which-is-wrong": "Which token is wrong in this row?",
        "meant-to-come-before": (
            "In the {nth} demonstration, was {first} meant to come before {second}?"
        ),
        "meant-in-row": "In the {nth} demonstration, was {token} meant to be in the row?",
        "meant-there": "In the {nth} demonstration, was {token} meant to go to column {column}?",
        "disagree": "These two do not go together:",
        "shown-row": "In the {nth} demonstration you made this row: {tokens}.",
        "shown-before": "In the {nth} demonstration you put {first} before {second}.",
        "understood-rules": "From all the rest I understood: {rules}",
        "said-row-right": "You said that this row is right: {tokens}.",
        "said-row-wrong": "You said that this row is wrong: {tokens}.",
        "said-move-right": "You said that {token} may go to column {column} here.",
        "said-move-wrong": "You said that {token} may not go to column {column} here.",
        "said-rule-meant": "You said that this is meant: {rule}",
        "said-rule-not-meant": "You said that this is not meant: {rule}",
        "which-counts": "Which of the two counts?",
        "ask-again": "{earlier} {later} So I ask once more. {question}",
        "so-far": "What I understand so far:",
        "no-rule-yet": "Nothing yet: any row may be right.",
        "nothing-left": "Nothing is left to learn from. Please show me again.",
        "saved": "Saved in {file}.",
        "how-to-reply": "({yes}, {no}, {unsure}: it does not matter, {enough}: no more questions)",
        "how-to-name": "(Type the token, or {unsure}.)",
        "how-to-mend": (
            "({yes}: it was meant, {no}: forget this demonstration, {again}: I play it again)"
        ),
        "how-to-pick": "(1: the first, 2: the second, {neither}: neither of them, {enough})",
        "how-to-show-again": "Type the tokens of the row from left to right, such as: {tokens}",
        "not-understood": "Sorry, I did not understand that.",
        "no-token": "There is no token {token} here.",
        "type-yes": "yes",
        "type-no": "no",
        "type-unsure": "unsure",
        "type-enough": "enough",
        "type-again": "again",
        "type-neither": "neither",
        "exam": "I play by my rules, right rows and wrong ones. Please say which are right.",
        "nth-play": "Row {number} of {count}",
        "agreed": "You agreed with {agreed} of {plays} plays.",
        "bound": "With 95 % confidence fewer than {percent} % of my plays would be wrong.",
        "near-misses": "Of {plays} rows that I hold for wrong you called {agreed} wrong too.",
        "nothing-examined": "You judged none of my plays, so I know no more than before.",
        "now": "What I understand now:",
        "changed": "I have learned from that. What changed:",
        "unchanged": "I have learned from that, but my rules stay the same.",
        "only-told": "These rules were told to me in words. Please change the words.",
        "examine-again": "Please examine me again: this exam was about my old rules.",
    }
)
