"""English: what the coach says."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

PHRASES: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "welcome": (
            "Hello. Let us play together.",
            "Good to see you. Let us begin.",
            "Welcome. The board is ready.",
            "Hello again. Here is our exercise.",
        ),
        "your-turn": (
            "It is your turn.",
            "You can begin whenever you like.",
            "Please take a token.",
            "The next one is yours.",
        ),
        "complete": (
            "The exercise is complete. Well done!",
            "That was the last one. Bravo!",
            "The row is finished. What a good game!",
            "Everything is in place. Congratulations!",
        ),
        "goodbye": (
            "That is all for today. Thank you for playing.",
            "Let us stop here. It was good to play with you.",
            "We end here. See you soon.",
            "Thank you for your time. Until next time.",
        ),
        "paused": (
            "Let us rest for a while.",
            "We take a short break.",
            "A little pause now.",
            "We stop for a moment.",
        ),
        "resumed": (
            "Let us go on where we were.",
            "Here we go again.",
            "The break is over. Let us continue.",
            "We carry on now.",
        ),
        "board-lost": (
            "One moment, please.",
            "Please wait a little.",
            "I need a short moment.",
            "Let us wait a moment.",
        ),
        "board-back": (
            "Thank you for waiting.",
            "I am ready again.",
            "Here I am again.",
            "I can see the board again.",
        ),
        "may-stop": (
            "The row can stay like this. You may also go on.",
            "This could be the end. More would fit too.",
            "You may stop here. You may place another one.",
            "It is fine as it is. You can also add more.",
        ),
        "not-yet": (
            "There is still something to move.",
            "A little is missing.",
            "We are nearly there.",
            "Something still belongs in the row.",
        ),
        "let-us-go-on": (
            "Let us go on with the next one.",
            "On to the next one.",
            "We continue with another token.",
            "Let us look at the next one.",
        ),
        "accepted": (
            "That is fine too.",
            "We leave it like that.",
            "Good, it stays there.",
            "All right, it may stay.",
        ),
        "praise": (
            "Very good!",
            "Yes, that fits.",
            "Well done!",
            "That is right.",
            "Great, it belongs there.",
            "Lovely, go on like that.",
        ),
        "praise-own-correction": (
            "Now it fits. Well done!",
            "You found it. Very good!",
            "That is it. Good thinking!",
            "There it belongs. Great!",
        ),
        "thanks-for-putting-back": (
            "Thank you. Let us try another one.",
            "Good. Now let us look again.",
            "Thanks. Which one could it be?",
            "Fine. Let us have another look.",
        ),
        "refused": (
            "Good try. {reason}",
            "Let us look again. {reason}",
            "Nearly. {reason}",
            "We take another look. {reason}",
            "Let us think together. {reason}",
        ),
        "refused-by-caregiver": (
            "Let us try another one here.",
            "Another one fits better here.",
            "Let us look for another one.",
            "We try a different one.",
        ),
        "please-put-back": (
            "Please put {token} back to {place}.",
            "{token} goes back to {place}.",
            "Could you return {token} to {place}?",
            "Let us bring {token} back to {place}.",
        ),
        "i-put-back": (
            "I will put {token} back.",
            "Let me put {token} back.",
            "I bring {token} back for you.",
            "I take {token} back to its cell.",
        ),
        "help-comes": (
            "Somebody will help us with it.",
            "Let us wait for a helping hand.",
            "I have asked for a little help.",
            "Help is on its way.",
        ),
        "one-at-a-time": (
            "Let us take one token at a time.",
            "One after another, please.",
            "Just one token at once, please.",
            "Let us move a single token.",
        ),
        "unknown-token": (
            "I do not know this token. Let us leave it aside.",
            "This token is new to me. Please put it aside.",
            "This one is from another game.",
            "We do not need this token.",
        ),
        "encourage": (
            "Take your time.",
            "You are doing well.",
            "No hurry at all.",
            "I am sure there is one.",
            "Let us have a calm look.",
        ),
        "remind": (
            "Remember: {rule}",
            "This is the idea: {rule}",
            "Here is what we do: {rule}",
            "Let me say it again: {rule}",
        ),
        "look-at-row": (
            "Have a look at {row}.",
            "There is one that fits in {row}.",
            "Let us look at {row}.",
            "You could find it in {row}.",
        ),
        "one-of-these": (
            "It could be {tokens}.",
            "One of these fits: {tokens}.",
            "Is it {tokens}?",
            "Which one is it: {tokens}?",
        ),
        "this-one": (
            "{token} fits in {place}.",
            "Let us put {token} in {place}.",
            "You could place {token} in {place}.",
            "{token} can go to {place}.",
        ),
        "together": (
            "Shall we place {token} in {place} together?",
            "Together we put {token} in {place}.",
            "Let us bring {token} to {place} together.",
            "We move {token} to {place} side by side.",
        ),
        "i-place": (
            "I will place {token} in {place}.",
            "Let me put {token} in {place}.",
            "I bring {token} to {place}.",
            "I do this one: {token} in {place}.",
        ),
        "i-cannot": (
            "I cannot reach it.",
            "My arm does not get there.",
            "This move is hard for me.",
            "I cannot do this one.",
        ),
        "i-am-here": (
            "I am here with you.",
            "I am watching with you.",
            "We have all the time we need.",
            "I stay beside you.",
        ),
        "show-me": (
            "Show me how it goes.",
            "Please play it once for me.",
            "I am watching. Please begin.",
            "Please show me a right play.",
        ),
        "seen": (
            "I have seen it.",
            "Thank you, I watched closely.",
            "Good, I have this one.",
            "I will remember that.",
        ),
        "show-another": (
            "Please show me another one.",
            "One more would help me.",
            "Could you play it differently once?",
            "Please play it with other tokens.",
        ),
        "clear-the-row": (
            "Please clear the row for the next one.",
            "Put the tokens back anywhere in storage.",
            "We need an empty row now.",
            "Please empty the goal row.",
        ),
        "taken-back": (
            "All right, that one does not count.",
            "I forget this move.",
            "Good, we take it back.",
            "Fine, as if nothing had happened.",
        ),
        "nothing-shown": (
            "Please move a token first.",
            "I have seen no move yet.",
            "There is nothing to learn from so far.",
            "I still need to see a move.",
        ),
        "forgotten": (
            "All right, I forget this play.",
            "This play does not count.",
            "We leave this one out.",
            "I drop what was shown just now.",
        ),
        "understood": (
            "This is what I understand: {rules}",
            "So far I understand this: {rules}",
            "I see it like this: {rules}",
            "As I understand it: {rules}",
        ),
        "not-clear": (
            "It is not quite clear to me yet.",
            "I am not sure of it yet.",
            "I still have doubts.",
            "There is more than one way to see it.",
        ),
        "learned": (
            "Thank you, I have learned the exercise.",
            "Now I know how it goes.",
            "I can play it with others now.",
            "The exercise is clear to me.",
        ),
        "thanks": (
            "Thank you.",
            "Thanks, that helps.",
            "Good to know.",
            "I see, thank you.",
        ),
    }
)

ASKED: Final[Mapping[str, str]] = MappingProxyType(
    {
        "put-back": "Please put back, or have put back: {tokens}.",
        "check-board": "Please check the board: the tokens do not lie as they should.",
        "place": "Please place {token} in {place}.",
        "no-way-on": "No move is right any more. Please end the session, or judge the last move "
        "otherwise.",
        "long-silence": "Nobody has moved for a long while. Would you like to pause?",
        "demonstration": "I could not learn from this play. Please show it again.",
    }
)
