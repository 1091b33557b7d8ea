"""English: what a caregiver can set, in plain words."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

SETTINGS: Final[Mapping[str, tuple[str, str]]] = MappingProxyType(
    {
        "mental": (
            "Thinking and remembering",
            (
                "How far thinking and remembering are impaired. The other settings "
                "follow from it until you change them."
            ),
        ),
        "physical": (
            "Moving",
            "How far moving is impaired. A slower hand is given more time.",
        ),
        "hand": (
            "Hand",
            (
                "Which hand moves the tokens. Where reaching is hard, tokens on its "
                "side are preferred in hints."
            ),
        ),
        "reach": (
            "Reach",
            "How far the hand gets. With a short reach, hints prefer tokens in the near rows.",
        ),
        "language": (
            "Language",
            "The language that the robot speaks and writes.",
        ),
        "speech_wpm": (
            "Speed of speech",
            "Words a minute. Slower is easier to follow.",
        ),
        "volume": (
            "Loudness",
            "How loud the robot speaks, in percent.",
        ),
        "modalities": (
            "Ways to communicate",
            "Whether the robot speaks, writes, gestures, or any of these together.",
        ),
        "behaviour": (
            "Behaviour at first",
            "How much the robot trusts the patient before it knows them.",
        ),
        "persona": (
            "Manner",
            "Whether the robot waits and encourages, or keeps the exercise going.",
        ),
        "put_back": (
            "Putting back",
            "Who puts a wrong token back. If nothing happens, the next one is asked.",
        ),
        "robot_moves": (
            "Robot moves tokens",
            "Whether the robot may move tokens itself.",
        ),
        "errorless": (
            "Without errors",
            "The robot shows the token before an error can happen.",
        ),
        "attempts": (
            "Attempts",
            "After so many attempts the robot shows the token itself.",
        ),
        "patience_s": (
            "Patience",
            "How many seconds of silence pass before the robot speaks. It never forces anybody.",
        ),
        "policy": (
            "Deciding on help",
            (
                "Whether help stays the same, rises and falls step by step, or is "
                "learned from the patient."
            ),
        ),
        "level": (
            "Help to begin with",
            "How much the robot helps at first, from 0, your turn, to 5, it places the token.",
        ),
        "least_level": (
            "Least help",
            "The robot never helps less than this.",
        ),
        "most_level": (
            "Most help",
            "The robot never helps more than this.",
        ),
        "rounds": (
            "Rounds",
            "How many times the exercise is played in one sitting.",
        ),
        "one_switch": (
            "One switch",
            (
                "On a screen, one key or a touch anywhere is enough. Rows are offered "
                "one after another, then the cells of one row."
            ),
        ),
        "show_score": (
            "Show the score",
            "Whether the patient sees at the end how many moves were right.",
        ),
        "difficulty": (
            "Difficulty",
            "How many digits the numbers have, and how close together they lie.",
        ),
        "easiest": (
            "Easiest tokens",
            "The difficulty never falls below this.",
        ),
        "hardest": (
            "Hardest tokens",
            "The difficulty never rises above this.",
        ),
    }
)
"""Each setting's name, and what it does."""

VALUES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "mental.none": "not impaired",
        "mental.very-mild": "very mildly impaired",
        "mental.mild": "mildly impaired",
        "mental.moderate": "moderately impaired",
        "mental.severe": "severely impaired",
        "physical.none": "not impaired",
        "physical.slight": "slightly impaired",
        "physical.marked": "markedly impaired",
        "hand.left": "left hand",
        "hand.right": "right hand",
        "reach.whole-board": "the whole board",
        "reach.near-rows": "the near rows",
        "language.en": "English",
        "language.es": "español",
        "language.ca": "català",
        "modalities.speech": "speech",
        "modalities.text": "text",
        "modalities.gesture": "gestures",
        "behaviour.challenging": "challenging: it helps little at first",
        "behaviour.neutral": "neutral",
        "behaviour.helping": "helping: it helps much at first",
        "persona.human-centred": "puts the person first",
        "persona.exercise-centred": "puts the exercise first",
        "put_back.robot": "the robot",
        "put_back.patient": "the patient",
        "put_back.caregiver": "the caregiver",
        "policy.fixed": "always the same",
        "policy.ladder": "step by step",
        "policy.adaptive": "learned from the patient",
    }
)
"""What can be chosen, by setting and value."""
