"""The words of English."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from maestra.language.keys import Key, Predicate
from maestra.language.tongue import AttributeWords, Naming, VerbForms, Words
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW

_SENTENCES: Final = {
    Key.PLACE: "Put {tokens} in {row} {order}.",
    Key.LEFT_TO_RIGHT: "from left to right",
    Key.RIGHT_TO_LEFT: "from right to left",
    Key.ENDS_FIRST: "from the ends inwards",
    Key.MIDDLE_FIRST: "from the middle outwards",
    Key.ANY_ORDER: "in any order",
    Key.IN_THIS_ORDER: "in this order",
    Key.THE_TOKENS: "the tokens",
    Key.SO_MANY_TOKENS: "{count} [count#token|tokens]",
    Key.FILL_ROW: "Fill the whole of {row}.",
    Key.UNTIL_TOTAL: "Stop as soon as the {attribute:plural} make {k} or more together.",
    Key.NTH_IS: "{nth:capital}: {tokens}.",
    Key.NTH_IS_THERE: "{nth:capital}: {tokens}, in {place}.",
    Key.NTH_THERE: "{nth:capital}: {place}.",
    Key.ONLY: "Use only {kind}.",
    Key.NONE: "Use no {kind}.",
    Key.ONLY_THAT: "Use only tokens that {does:do}.",
    Key.USE_ALL: "Use all {kind}.",
    Key.USE_ALL_TOKENS: "Use all the tokens.",
    Key.USE_ALL_THAT: "Use all tokens that {does:do}.",
    Key.HAS_ONE_THAT: "The row must have {amount} token that {does:that}.",
    Key.HAS_MANY_THAT: "The row must have {amount} tokens that {does:do}.",
    Key.ROW_HAS_ONE_THAT: "the row has {amount} token that {does:that}",
    Key.ROW_HAS_MANY_THAT: "the row has {amount} tokens that {does:do}",
    Key.PLACE_SO_MANY: "Place {amount} [count#token|tokens].",
    Key.HAS_MORE_THAN: (
        "The row must have more tokens that {first:do} than tokens that {second:do}."
    ),
    Key.HAS_FEWER_THAN: (
        "The row must have fewer tokens that {first:do} than tokens that {second:do}."
    ),
    Key.HAS_AS_MANY_AS: (
        "The row must have as many tokens that {first:do} as tokens that {second:do}."
    ),
    Key.HAS_AT_LEAST_AS_MANY_AS: (
        "The row must have at least as many tokens that {first:do} as tokens that {second:do}."
    ),
    Key.HAS_AT_MOST_AS_MANY_AS: (
        "The row must have at most as many tokens that {first:do} as tokens that {second:do}."
    ),
    Key.HAS_NOT_AS_MANY_AS: (
        "The row must not have as many tokens that {first:do} as tokens that {second:do}."
    ),
    Key.KINDS: "The number of different {attribute:plural} in the row must be {amount}.",
    Key.TOTAL: "The {attribute:plural} of the row must make {amount} together.",
    Key.EQUATION: "By {attribute}, {left} must make {right}.",
    Key.WORD: "The letters must make a word of the list.",
    Key.WORD_WITH: "The letters must make a word of the list, with {relation} “{value}”.",
    Key.EXACTLY: "exactly {k}",
    Key.AT_LEAST: "at least {k}",
    Key.AT_MOST: "at most {k}",
    Key.MORE_THAN: "more than {k}",
    Key.FEWER_THAN: "less than {k}",
    Key.NOT_EXACTLY: "more or less than {k}",
    Key.FROM_ROW: "Take the tokens only from {row}.",
    Key.NOT_FROM_ROW: "Take no tokens from {row}.",
    Key.FROM_COLUMN: "Take the tokens only from column {column}.",
    Key.NOT_FROM_COLUMN: "Take no tokens from column {column}.",
    Key.SAME_COLUMN: "Keep each token in its column.",
    Key.MIRRORED_COLUMN: "Move each token to the opposite column, as in a mirror.",
    Key.TAKE: "{does:clause}.",
    Key.THE_ONE_TO_TAKE: "the token you take",
    Key.TAKE_OF_THOSE: "Of the tokens that {among:do}, {does:clause}.",
    Key.EACH_TOKEN: "Each token {does:must}.",
    Key.IN_EACH_PAIR: "Two by two: each second token {does:must}.",
    Key.IN_RIGHT_HALF: "Each token in the right half {does:must}.",
    Key.SUBJECT_MUST: "{subject} {does:must}.",
    Key.CYCLE_RISING: "{along}, the {attribute:plural} go up; after the last comes the first.",
    Key.CYCLE_FALLING: "{along}, the {attribute:plural} go down; after the first comes the last.",
    Key.RISE_AND_FALL: "{along}, the {attribute:plural} first go up, then down.",
    Key.FALL_AND_RISE: "{along}, the {attribute:plural} first go down, then up.",
    Key.ZIGZAG: "{along}, the {attribute:plural} go up and down by turns.",
    Key.EQUAL_STEPS: "{along}, the {attribute:plural} change by the same amount each time.",
    Key.EQUAL_RATIOS: "{along}, the {attribute:plural} are multiplied by the same each time.",
    Key.ALONG_THE_ROW: "from left to right",
    Key.IN_TIME: "in the order you place them",
    Key.THIS_ROW: "Make this row: {tokens}.",
    Key.PATTERN: "{along}: {steps}.",
    Key.PATTERN_REPEATED: "{along}: {steps}, and again from the start.",
    Key.NTH_DOES: "the {nth} {does}",
    Key.NTH_FREE: "the {nth} is any",
    Key.TEMPLATE: "{along}, the {attribute:plural} follow the pattern {pattern}.",
    Key.TEMPLATE_REPEATED: (
        "{along}, the {attribute:plural} follow the pattern {pattern} again and again."
    ),
    Key.BLOCKS: "{along}, tokens with the same {attribute} stay together.",
    Key.IF_THEN: "If {condition}, then {consequence}.",
    Key.SUBJECT_DOES: "{does:clause}",
    Key.ALL_BEFORE: "Place all tokens that {first:do} before any that {second:do}.",
    Key.ALL_LEFT_OF: "All tokens that {first:do} must be left of all that {second:do}.",
    Key.NEXT_AFTER: "After a token that {first:that}, place next one that {second:that}.",
    Key.LATER_AFTER: "After a token that {first:that}, place later one that {second:that}.",
    Key.NEXT_RIGHT_OF: "Right beside a token that {first:that}, put one that {second:that}.",
    Key.LATER_RIGHT_OF: "To the right of a token that {first:that}, put one that {second:that}.",
    Key.MODEL_COPIED: (
        "{row:capital} is the model and stays: each token {does:must}, column by column."
    ),
    Key.MODEL_MIRRORED: (
        "{row:capital} is the model and stays: each token {does:must}, as in a mirror."
    ),
    Key.MODEL_REVERSED: (
        "{row:capital} is the model and stays: each token {does:must}, read from right to left."
    ),
    Key.CUE: "The token in {place} stays: each token {does:must}.",
    Key.THE_ONE_ON_ITS_LEFT: "the one on its left",
    Key.THE_ONE_BEFORE_IT: "the one placed before it",
    Key.EVERY_ONE_ON_ITS_LEFT: "every one on its left",
    Key.EVERY_ONE_BEFORE_IT: "every one placed before it",
    Key.THE_OPPOSITE_ONE: "the opposite one",
    Key.ITS_MODEL: "its model",
    Key.THIS_ONE: "this one",
    Key.NTH_FROM_LEFT: "the {nth} token from the left",
    Key.NTH_FROM_RIGHT: "the {nth} token from the right",
    Key.LAST_OF_ROW: "the last token of the row",
    Key.MIDDLE_OF_ROW: "the token in the middle",
    Key.NTH_PLACED: "the {nth} token placed",
    Key.LAST_PLACED: "the last token placed",
    Key.TOKEN_ON_ITS_LEFT: "{token} on its left",
    Key.TOKEN_ON_ITS_RIGHT: "{token} on its right",
    Key.TOKEN_IN_PLACE: "{token} in {place}",
    Key.IT: "it",
    Key.TOKEN_IN_COLUMN: "{token} in column {column}",
    Key.WHAT_LIES_IN_COLUMNS: "the tokens in {row}, columns {columns}",
    Key.WHAT_LIES_THERE: "the token in {place}",
    Key.SEEN_GO: "So far I have only seen {tokens} go {nth}.",
    Key.SEEN_COME: "So far I have only seen {tokens} go {nth} from {place}.",
    Key.SEEN_GO_TO: "So far I have only seen {tokens} go {nth} to {place}.",
    Key.SEEN_ONLY_IF: "So far {tokens} may go {nth} only if {conditions}.",
    Key.SEEN_TOO_SELDOM: "I have not seen {tokens} go {nth} in enough different plays.",
    Key.MAY_GO: "{token} may go {nth}.",
    Key.MAY_GO_IF: "{token} may go {nth} if {conditions}.",
    Key.EXACT: "I have compared these sentences with what I learned: they say the same.",
    Key.NOT_COMPARED: "I could not compare these sentences with all that I learned.",
    Key.GOES_TO: "it goes to {place}",
    Key.COMES_FROM: "it comes from {place}",
    Key.COMES_FROM_ROW: "it comes from {row}",
    Key.COMES_FROM_COLUMN: "it comes from column {column}",
    Key.GOES_TO_COLUMN: "it goes to column {column}",
    Key.KEEPS_COLUMN: "it stays in its column",
    Key.COMES_FROM_STORAGE: "it comes from a storage row",
    Key.GOES_TO_GOAL_ROW: "it goes to the goal row",
    Key.IT_DOES: "it {does}",
    Key.TOKEN_THERE_DOES: "the token in {place} {does}",
    Key.LIES_THERE: "{token} is in {place}",
    Key.NOT_SO: "{does:clause}.",
    Key.WRONG_PLACE: "{token} goes to {place}.",
    Key.NEXT_PLACE: "The next token goes to {place}.",
    Key.WRONG_COLUMN: "{token} goes to column {column}.",
    Key.WRONG_ORIGIN: "So far {token} has come from {place}.",
    Key.WRONG_ORIGIN_ROW: "The tokens come from {row}.",
    Key.WRONG_ORIGIN_COLUMN: "So far {token} has come from column {column}.",
    Key.OTHER_COLUMN: "{token} stays in its own column.",
    Key.NOT_FROM_STORAGE: "{token} is already in {row}.",
    Key.NOT_TO_GOAL_ROW: "The tokens go to {row}.",
    Key.NOTHING_THERE: "There is still no token in {place}.",
    Key.BELONGS_THERE: "So far {token} has been in {place} first.",
    Key.NOT_SHOWN: "I have not yet seen {tokens} go {nth}.",
    Key.DEAD_END: "Then the row can no longer be filled.",
    Key.NOT_NOW: "This token does not go here now.",
    Key.AFTER_THE_END: "The row is finished.",
}

_PREDICATES: Final = {
    Predicate.ODD: ("be", "odd"),
    Predicate.EVEN: ("be", "even"),
    Predicate.PRIME: ("be", "prime"),
    Predicate.VOWEL: ("be", "a vowel"),
    Predicate.CONSONANT: ("be", "a consonant"),
    Predicate.MULTIPLE_OF: ("be", "a multiple of {k}"),
    Predicate.DIGITS: ("have", "{k} [k#digit|digits]"),
    Predicate.ABOVE: ("be", "above {k}"),
    Predicate.BELOW: ("be", "below {k}"),
    Predicate.IS: ("be", "{value}"),
    Predicate.SHOWS: ("have", "the {attribute} {value}"),
    Predicate.HAS_ABOVE: ("have", "a {attribute} above {k}"),
    Predicate.HAS_BELOW: ("have", "a {attribute} below {k}"),
    Predicate.FROM_ROW: ("come", "from {row}"),
    Predicate.FROM_COLUMN: ("come", "from column {column}"),
    Predicate.AMONG_MOST: ("be", "among the {count} {adjective}"),
    Predicate.AMONG_LEAST: ("be", "among the {count} {adjective}"),
    Predicate.AMONG_HIGHEST: ("be", "among the {count} with the highest {attribute}"),
    Predicate.AMONG_LOWEST: ("be", "among the {count} with the lowest {attribute}"),
    Predicate.MOST: ("be", "the {adjective} of the row"),
    Predicate.LEAST: ("be", "the {adjective} of the row"),
    Predicate.HIGHEST: ("have", "the highest {attribute} of the row"),
    Predicate.LOWEST: ("have", "the lowest {attribute} of the row"),
    Predicate.MOST_LEFT: ("be", "always the {adjective} one still in storage"),
    Predicate.LEAST_LEFT: ("be", "always the {adjective} one still in storage"),
    Predicate.HIGHEST_LEFT: ("be", "always the one in storage with the highest {attribute}"),
    Predicate.LOWEST_LEFT: ("be", "always the one in storage with the lowest {attribute}"),
    Predicate.LEFTMOST: ("be", "always the left-most one still in storage"),
    Predicate.RIGHTMOST: ("be", "always the right-most one still in storage"),
    Predicate.TOPMOST: ("be", "always from the upper-most storage row with tokens"),
    Predicate.BOTTOMMOST: ("be", "always from the lower-most storage row with tokens"),
    Predicate.ANYTHING: ("be", "any token"),
    Predicate.NOTHING: ("be", "no token"),
    Predicate.MORE: ("be", "{adjective} than {other}"),
    Predicate.LESS: ("be", "{adjective} than {other}"),
    Predicate.HAS_MORE: ("have", "a higher {attribute} than {other}"),
    Predicate.HAS_LESS: ("have", "a lower {attribute} than {other}"),
    Predicate.AFTER: ("come", "after {other}"),
    Predicate.BEFORE: ("come", "before {other}"),
    Predicate.AFTER_IN_ALPHABET: ("come", "after {other} in the alphabet"),
    Predicate.BEFORE_IN_ALPHABET: ("come", "before {other} in the alphabet"),
    Predicate.MORE_BY: ("be", "{k} more than {other}"),
    Predicate.LESS_BY: ("be", "{k} less than {other}"),
    Predicate.NEXT: ("come", "right after {other}"),
    Predicate.PREVIOUS: ("come", "right before {other}"),
    Predicate.NEXT_IN_ALPHABET: ("come", "right after {other} in the alphabet"),
    Predicate.PREVIOUS_IN_ALPHABET: ("come", "right before {other} in the alphabet"),
    Predicate.AFTER_BY: ("come", "{k} places after {other}"),
    Predicate.BEFORE_BY: ("come", "{k} places before {other}"),
    Predicate.APART_BY: ("be", "{k} away from {other}"),
    Predicate.TWICE: ("be", "twice {other}"),
    Predicate.HALF: ("be", "half of {other}"),
    Predicate.TIMES: ("be", "{k} times {other}"),
    Predicate.TOGETHER: ("make", "{k} together with {other}"),
    Predicate.SAME: ("have", "the same {attribute} as {other}"),
    Predicate.DIFFERENT: ("have", "another {attribute} than {other}"),
    Predicate.SAME_ACROSS: ("have", "as {attribute} the {theirs} of {other}"),
    Predicate.MORE_ACROSS: ("have", "a higher {attribute} than the {theirs} of {other}"),
    Predicate.LESS_ACROSS: ("have", "a lower {attribute} than the {theirs} of {other}"),
    Predicate.RELATED: ("be", "the {relation} of {other}"),
    Predicate.RELATED_BACK: ("have", "{other} as {relation}"),
}

_KINDS: Final = {
    Predicate.ODD: "odd {things}",
    Predicate.EVEN: "even {things}",
    Predicate.PRIME: "prime {things}",
    Predicate.VOWEL: "vowels",
    Predicate.CONSONANT: "consonants",
    Predicate.MULTIPLE_OF: "multiples of {k}",
    Predicate.DIGITS: "{things} with {k} [k#digit|digits]",
    Predicate.ABOVE: "{things} above {k}",
    Predicate.BELOW: "{things} below {k}",
    Predicate.IS: "{value:bare} tokens",
    Predicate.HAS_ABOVE: "tokens with a {attribute} above {k}",
    Predicate.HAS_BELOW: "tokens with a {attribute} below {k}",
    Predicate.SHOWS: "tokens with the {attribute} {value}",
}


def _verb(base: str, third: str) -> VerbForms:
    return VerbForms(
        must=f"must {base}",
        must_not=f"must not {base}",
        does=third,
        does_not=f"does not {base}",
        that=third,
        that_not=f"does not {base}",
        do=base,
        do_not=f"do not {base}",
    )


_VERBS: Final = {
    "be": VerbForms(
        must="must be",
        must_not="must not be",
        does="is",
        does_not="is not",
        that="is",
        that_not="is not",
        do="are",
        do_not="are not",
    ),
    "have": _verb("have", "has"),
    "come": _verb("come", "comes"),
    "make": _verb("make", "makes"),
}

_NUMBER: Final = AttributeWords(
    "number",
    plural="numbers",
    things="numbers",
    more="larger",
    less="smaller",
    most="largest",
    least="smallest",
    naming=Naming.PLAIN,
)


def _word(noun: str, plural: str, naming: Naming | None = Naming.WORD) -> AttributeWords:
    return AttributeWords(noun, plural=plural, naming=naming)


def _measure(noun: str, plural: str, more: str, less: str) -> AttributeWords:
    most, least = (f"{word[:-2]}est" if word.endswith("er") else word for word in (more, less))
    return AttributeWords(noun, plural=plural, more=more, less=less, most=most, least=least)


_ATTRIBUTES: Final = {
    "value": _NUMBER,
    "number": _NUMBER,
    "letter": AttributeWords("letter", plural="letters", things="letters", naming=Naming.PLAIN),
    "colour": _word("colour", "colours", Naming.QUALITY),
    "color": _word("colour", "colours", Naming.QUALITY),
    "shape": _word("shape", "shapes", None),
    "category": _word("category", "categories", None),
    "size": _measure("size", "sizes", "bigger", "smaller"),
    "length": _measure("length", "lengths", "longer", "shorter"),
    "height": _measure("height", "heights", "taller", "shorter"),
    "weight": _measure("weight", "weights", "heavier", "lighter"),
    "price": _measure("price", "prices", "dearer", "cheaper"),
    "age": _measure("age", "ages", "older", "younger"),
    "name": _word("name", "names"),
    "picture": _word("picture", "pictures"),
    "word": _word("word", "words"),
    "day": _word("day", "days"),
    "month": _word("month", "months"),
    ORIGIN_ROW: _word("starting row", "starting rows", None),
    ORIGIN_COLUMN: _word("starting column", "starting columns", None),
}

WORDS: Final = Words(
    sentences=MappingProxyType(_SENTENCES),
    predicates=MappingProxyType(_PREDICATES),
    kinds=MappingProxyType(_KINDS),
    verbs=MappingProxyType(_VERBS),
    attributes=MappingProxyType(_ATTRIBUTES),
)
