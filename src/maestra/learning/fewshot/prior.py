"""What the few-shot learner believes before it sees anything: all of its numbers in one place.

A hypothesis is a conjunction of proposals, each one rule or a few that are meant together. Its
prior is 2^-bits: `FAMILY_BITS` for the family of exercises a proposal belongs to, the bits of its
`Kind` for how usual it is within the family, the logarithm of how many proposals of the kind this
deck and board leave room for, and what `and_bits` says for more than one. Where the parameters of
a kind are not all as usual, its generator in `families` says so beside it. The families are those
of therapists' exercises, each as likely as any other; the bits of the kinds are our judgement, in
steps: 1 the usual thing, 2 or 3 one of several, 4 seldom, 5 and more hardly ever.

The likelihood of a demonstration is its habit-weighted share of all plays that the hypothesis
allows; see `posterior` and `weighing`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum
from fractions import Fraction
from math import log2
from types import MappingProxyType
from typing import Final

from maestra.rules.forms.timing import Filling

FAMILY_BITS: Final = 3.5
"""One of eleven families."""
CROWD_BITS: Final = (0.0, 0.4, 0.0, 3.0, 6.0)
"""For how many proposals there are, none to four: most exercises have one or two."""
UNUSUAL_BITS: Final = 4.5
"""For a further proposal that is not `USUALLY_ADDED`."""
SELDOM_BITS: Final = 2.0
"""For a feature that few people think of: prime, a multiple of three, two digits."""
FREE_BITS: Final = 6.0
"""That any play is right, as long as the row is filled."""


class Kind(Enum):
    """Kinds of proposals; `KIND_BITS` says how usual each is within its family."""

    # A. Ordering
    ORDER = "order"
    ORDER_LOOSE = "order-loose"
    """Ties allowed though there are none to see, or forbidden though there are."""
    # B. Selection
    ONLY = "only"
    ONLY_BEYOND = "only-beyond"
    ONLY_EXTREME = "only-extreme"
    ONLY_NOT = "only-not"
    ONLY_EITHER = "only-either"
    ALL_OF_THEM = "all-of-them"
    ALL_BEYOND = "all-beyond"
    AT_LEAST_ALL = "at-least-all"
    """All of these, and others too."""
    # C. Grouping
    BLOCKS = "blocks"
    NEIGHBOURS_DIFFER = "neighbours-differ"
    ALL_ALIKE = "all-alike"
    ALL_DIFFERENT = "all-different"
    PARTNERS = "partners"
    NEIGHBOURS_RELATED = "neighbours-related"
    SO_MANY_OF_EACH = "so-many-of-each"
    KINDS = "kinds"
    PAIRED_ALIKE = "paired-alike"
    # D. Shape
    ALTERNATING = "alternating"
    REPEATED = "repeated"
    TEMPLATE = "template"
    TEMPLATE_NAMED = "template-named"
    SHAPE = "shape"
    EXTREME_AT = "extreme-at"
    MIRRORED = "mirrored"
    TWO_PLACES = "two-places"
    TWO_PLACES_FAR = "two-places-far"
    # E. Arithmetic
    STEP = "step"
    RATIO = "ratio"
    EQUAL_STEPS = "equal-steps"
    EQUAL_RATIO = "equal-ratio"
    APART = "apart"
    ADD_UP = "add-up"
    TOTAL = "total"
    TOTAL_BEYOND = "total-beyond"
    EQUATION = "equation"
    EQUATION_ANYWHERE = "equation-anywhere"
    # F. Words
    GIVEN_ROW = "given-row"
    WORD = "word"
    WORD_OF = "word-of"
    # G. Routines
    SUCCESSORS = "successors"
    CYCLIC = "cyclic"
    CHAIN = "chain"
    # H. Source
    FROM_ROW = "from-row"
    ROW_UP = "row-up"
    """A storage row, straight up."""
    FROM_COLUMN = "from-column"
    STRAIGHT_UP = "straight-up"
    ROWS_IN_TURN = "rows-in-turn"
    TAKE_FIRST = "take-first"
    ORIGIN_ORDER = "origin-order"
    ORIGIN_PAIRS = "origin-pairs"
    # I. Timing
    ORDER_IN_TIME = "order-in-time"
    BEFORE = "before"
    FOLLOWS = "follows"
    TAKE_EXTREME = "take-extreme"
    # J. Counting
    COUNT = "count"
    COUNT_BEYOND = "count-beyond"
    CONTAINS = "contains"
    """One named token, whatever else."""
    MORE_OF = "more-of"
    IF_THEN = "if-then"
    AT_END = "at-end"
    AT_PLACE = "at-place"
    # K. Memory
    MODEL_ROW = "model-row"
    CUE = "cue"
    # Length
    UNTIL_TOTAL = "until-total"
    SO_LONG = "so-long"


KIND_BITS: Final[Mapping[Kind, float]] = MappingProxyType(
    {
        # A. Ordering
        Kind.ORDER: 0.3,
        Kind.ORDER_LOOSE: 1.5,
        # B. Selection
        Kind.ONLY: 0.6,
        Kind.ONLY_BEYOND: 2.0,
        Kind.ONLY_EXTREME: 2.5,
        Kind.ONLY_NOT: 2.6,
        Kind.ONLY_EITHER: 3.0,
        Kind.ALL_OF_THEM: 1.0,
        Kind.ALL_BEYOND: 4.0,
        Kind.AT_LEAST_ALL: 4.5,
        # C. Grouping
        Kind.BLOCKS: 2.9,
        Kind.NEIGHBOURS_DIFFER: 2.4,
        Kind.ALL_ALIKE: 2.4,
        Kind.ALL_DIFFERENT: 3.2,
        Kind.PARTNERS: 2.0,
        Kind.NEIGHBOURS_RELATED: 3.5,
        Kind.SO_MANY_OF_EACH: 1.5,
        Kind.KINDS: 2.8,
        Kind.PAIRED_ALIKE: 5.0,
        # D. Shape
        Kind.ALTERNATING: 2.7,
        Kind.REPEATED: 3.3,
        Kind.TEMPLATE: 2.1,
        Kind.TEMPLATE_NAMED: 3.6,
        Kind.SHAPE: 3.5,
        Kind.EXTREME_AT: 3.2,
        Kind.MIRRORED: 2.3,
        Kind.TWO_PLACES: 3.0,
        Kind.TWO_PLACES_FAR: 6.0,
        # E. Arithmetic
        Kind.STEP: 2.4,
        Kind.RATIO: 2.7,
        Kind.EQUAL_STEPS: 2.8,
        Kind.EQUAL_RATIO: 4.5,
        Kind.APART: 2.8,
        Kind.ADD_UP: 2.8,
        Kind.TOTAL: 2.0,
        Kind.TOTAL_BEYOND: 2.8,
        Kind.EQUATION: 2.4,
        Kind.EQUATION_ANYWHERE: 5.0,
        # F. Words
        Kind.GIVEN_ROW: 1.0,
        Kind.WORD: 1.0,
        Kind.WORD_OF: 2.0,
        # G. Routines
        Kind.SUCCESSORS: 1.0,
        Kind.CYCLIC: 2.0,
        Kind.CHAIN: 0.5,
        # H. Source
        Kind.FROM_ROW: 2.5,
        Kind.ROW_UP: 2.5,
        Kind.FROM_COLUMN: 4.0,
        Kind.STRAIGHT_UP: 2.5,
        Kind.ROWS_IN_TURN: 2.8,
        Kind.TAKE_FIRST: 2.5,
        Kind.ORIGIN_ORDER: 3.3,
        Kind.ORIGIN_PAIRS: 2.8,
        # I. Timing
        Kind.ORDER_IN_TIME: 1.6,
        Kind.BEFORE: 2.0,
        Kind.FOLLOWS: 2.0,
        Kind.TAKE_EXTREME: 2.0,
        # J. Counting
        Kind.COUNT: 1.0,
        Kind.COUNT_BEYOND: 2.8,
        Kind.CONTAINS: 3.3,
        Kind.MORE_OF: 2.8,
        Kind.IF_THEN: 3.0,
        Kind.AT_END: 2.1,
        Kind.AT_PLACE: 3.6,
        # K. Memory
        Kind.MODEL_ROW: 0.5,
        Kind.CUE: 4.0,
        # Length
        Kind.UNTIL_TOTAL: 3.0,
        Kind.SO_LONG: 2.1,
    }
)

USUALLY_ADDED: Final[Mapping[Kind, float]] = MappingProxyType(
    {
        Kind.ORDER: 1.0,
        Kind.ORDER_LOOSE: 1.0,
        Kind.ONLY: -0.5,
        Kind.ONLY_BEYOND: -0.5,
        Kind.ONLY_EXTREME: -0.5,
        Kind.ONLY_NOT: -0.5,
        Kind.ONLY_EITHER: -0.5,
        Kind.ALL_OF_THEM: -0.5,
        Kind.COUNT: 2.0,
    }
)
"""What people like to add to another proposal: which tokens, in which order, how many. It may
cost less than nothing, because it is then one of few families and not of eleven."""

ALONG_TIME_BITS: Final = 2.0
"""For what is as a rule meant along the row, if it is meant in time."""

OUTSIDE_BITS: Final = 4.5
"""That the exercise is about something that cannot be said: one in twenty or so."""
SLIP: Final = 0.03
"""How often a demonstration holds a mistake."""
TRUST: Final = 0.97
"""How often a caregiver's answer is meant; between the 95 and 98 % that others report."""
LEARNED_AT: Final = 0.95
"""Confidence from which a lesson counts as learned."""
LAZY: Final = 0.15
"""How many caregivers show the same row again and again."""
REPEATS: Final = 0.6
"""How often those do."""
OUTSIDE_YES: Final = 0.15
"""How often an answer is yes if the exercise is about something that cannot be said."""

NEAREST: Final[Mapping[float, float]] = MappingProxyType({0.0: 0.8, 1.0: 0.2})
"""How strongly people take what is near, to how many do: each cell of distance makes a token
less likely by the factor 2^-strength."""

FILLING: Final[Mapping[Filling | None, float]] = MappingProxyType(
    {
        None: 0.97,
        Filling.LEFT_TO_RIGHT: 0.001,
        Filling.RIGHT_TO_LEFT: 0.012,
        Filling.ENDS_FIRST: 0.009,
        Filling.MIDDLE_FIRST: 0.008,
    }
)
"""How often an exercise asks for an order of placement; nobody has to be told the usual one."""
ALONE: Final = 0.5
"""How many of those ask for nothing else: any row will do, filled in that order."""

HABITS: Final[Mapping[Filling | None, float]] = MappingProxyType(
    {
        None: 0.3,
        Filling.LEFT_TO_RIGHT: 0.6,
        Filling.RIGHT_TO_LEFT: 0.096,
        Filling.ENDS_FIRST: 0.002,
        Filling.MIDDLE_FIRST: 0.002,
    }
)
"""How people fill a row when they may fill it anyhow; None: now so, now so."""


def one_of(choices: float) -> float:
    """What it costs to name one of so many."""
    return log2(max(1.0, choices))


def amount_bits(amount: object) -> float:
    """What a step or a factor costs that was read off a play: small whole ones are usual."""
    exact = Fraction(str(amount))
    return 2 * log2(1 + abs(exact)) + (0.0 if exact.denominator == 1 else 4.0)


def round_bits(amount: object, span: float) -> float:
    """What a sum costs that was read off a play, of about `span` possible: round ones less."""
    exact = Fraction(str(amount))
    cheaper = 2.0 if exact % 10 == 0 else 0.0
    return max(0.0, one_of(span) - cheaper)


def and_bits(added: Sequence[float]) -> float:
    """What it costs that so many proposals are meant together.

    Args:
        added: for each of them what `USUALLY_ADDED` says, or `UNUSUAL_BITS`. One that is not
            usually added is the main thing, to which the others are.
    """
    together = sum(added) - max(0.0, *added) if len(added) > 1 else 0.0
    return CROWD_BITS[len(added)] + together
