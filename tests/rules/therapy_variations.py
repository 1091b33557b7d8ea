"""More exercises of the same families, over other attributes."""

from __future__ import annotations

from typing import Final

from maestra.rules.forms.base import FIRST, LAST, Direction, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import (
    CompareCounts,
    Count,
    Equation,
    Kinds,
    Operation,
    Total,
)
from maestra.rules.forms.length import UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Pattern, Template
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import (
    Apart,
    Compare,
    Named,
    Step,
    different,
    same,
)
from maestra.rules.setting import ORIGIN_COLUMN
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Not,
    has,
)
from tests.rules.therapy_boards import (
    AT_LEAST,
    AT_MOST,
    CAST,
    EQUAL,
    FULL,
    HIGHEST,
    LEFT_TO_RIGHT,
    LOWEST,
    ROW,
    ROWS,
    SMALL,
    TEN,
    THINGS,
    TIME,
    TOYS,
    WORDS,
    TherapyExercise,
    colour,
    coloured,
    days,
    deck_of,
    kind,
    laid_out,
    letters,
    named,
    numbers,
    sized,
)

MORE: Final = (
    TherapyExercise(
        "weights falling, ties allowed",
        THINGS,
        (Ordered("weight", Direction.FALLING, strict=False), FULL),
        "a3 p3 t2 f2 a1",
        "a3 t2 p3 f2 a1",
    ),
    TherapyExercise(
        "letters backwards",
        CAST,
        (Ordered("letter", Direction.FALLING), FULL),
        "U R O B A",
        "U O R B A",
    ),
    TherapyExercise(
        "days in order with gaps, once round",
        days(),
        (CyclicOrdered("day"), FULL),
        "Fri Sun Mon Wed Thu",
        "Fri Mon Sun Wed Thu",
    ),
    TherapyExercise(
        "once round backwards",
        days(),
        (CyclicOrdered("day", Direction.FALLING), FULL),
        "Tue Mon Sun Sat Thu",
        "Tue Sun Mon Sat Thu",
    ),
    TherapyExercise(
        "every second day",
        days(),
        (EachPair(Pairs.NEIGHBOURS, Step("day", 2)), FULL),
        "Mon Wed Fri Sun Tue",
        "Mon Wed Fri Sun Thu",
    ),
    TherapyExercise(
        "up and then down",
        SMALL,
        (
            RiseAndFall("value"),
            ExtremeAt("value", HIGHEST, FIRST, negated=True),
            ExtremeAt("value", HIGHEST, LAST, negated=True),
            FULL,
        ),
        "2 5 9 4 1",
        "1 2 4 5 9",
    ),
    TherapyExercise(
        "down and then up",
        SMALL,
        (RiseAndFall("value", Direction.FALLING), FULL),
        "9 5 2 4 8",
        "9 2 5 4 8",
    ),
    TherapyExercise("zigzag either way", SMALL, (Zigzag("value"), FULL), "3 9 2 8 1", "3 9 8 2 1"),
    TherapyExercise(
        "zigzag of weights in time",
        THINGS,
        (Zigzag("weight", TIME), FULL),
        "a1 p2 t1 a3 f2",
        "a1 p2 a3 t1 f2",
    ),
    TherapyExercise(
        "equal steps, whichever", SMALL, (EqualSteps("value"), FULL), "12 10 8 6 4", "12 10 8 6 5"
    ),
    TherapyExercise(
        "the same ratio each time",
        numbers(1, 2, 3, 4, 6, 8, 9, 12, 16, 27, 81),
        (EqualSteps("value", ratio=True), FULL),
        "1 3 9 27 81",
        "1 3 9 27 16",
    ),
    TherapyExercise(
        "the smallest at the left end",
        TEN,
        (ExtremeAt("value", LOWEST, FIRST), FULL),
        "19 77 23 36 34",
        "23 77 19 36 34",
    ),
    TherapyExercise(
        "the lightest last",
        THINGS,
        (ExtremeAt("weight", LOWEST, LAST), FULL),
        "a3 p2 t2 f2 a1",
        "a3 p2 t1 f2 a2",
    ),
    TherapyExercise(
        "only multiples of 3",
        SMALL,
        (EveryToken(has("multiple-of-3", "value")),),
        "3 6 12 9",
        "3 6 10 9",
    ),
    TherapyExercise(
        "only one-digit numbers",
        SMALL,
        (EveryToken(has("digits-1", "value")), FULL),
        "1 2 3 4 9",
        "1 2 3 4 10",
    ),
    TherapyExercise(
        "from 30 to 60",
        TEN,
        (EveryToken(Both(Compared("value", AT_LEAST, 30), Compared("value", AT_MOST, 60))), FULL),
        "32 34 36 46 57",
        "32 34 36 46 63",
    ),
    TherapyExercise(
        "no later than medium",
        sized(),
        (EveryToken(Compared("size", AT_MOST, "medium")),),
        "medium tiny",
        "medium large",
    ),
    TherapyExercise(
        "only consonants",
        CAST,
        (EveryToken(has("consonant", "letter")), FULL),
        "C R G B D",
        "C R G B A",
    ),
    TherapyExercise(
        "the three heaviest",
        THINGS,
        (EveryToken(Among("weight", HIGHEST, 2)), Count(Anything(), EQUAL, 2)),
        "a3 p3",
        "a3 p2",
    ),
    TherapyExercise(
        "all the plants, lightest first",
        THINGS,
        (EveryToken(kind("plant")), AllOfThem(kind("plant")), Ordered("weight")),
        "p1 p2 p3",
        "p1 p3 p2",
    ),
    TherapyExercise(
        "neither red nor round",
        TOYS,
        (EveryToken(Not(Either(colour("red"), has("is-round", "shape")))),),
        "b1 g1 b3",
        "b1 g2 b3",
    ),
    TherapyExercise(
        "all of one kind", THINGS, (EachPair(Pairs.ALL, same("category")),), "a1 a3 a2", "a1 a3 p2"
    ),
    TherapyExercise(
        "all of different kinds",
        THINGS,
        (EachPair(Pairs.ALL, different("category")),),
        "a1 f1 t1 p2",
        "a1 f1 t1 f2",
    ),
    TherapyExercise(
        "same colour at both ends",
        TOYS,
        (TwoPlaces(FIRST, LAST, same("colour")), FULL),
        "r1 b1 b2 g1 r2",
        "r1 b1 b2 r2 g1",
    ),
    TherapyExercise(
        "mirrored shapes",
        TOYS,
        (EachPair(Pairs.MIRRORED, same("shape")), FULL),
        "r1 b2 g1 r2 b3",
        "r1 b2 g1 b1 b3",
    ),
    TherapyExercise(
        "three shapes by turns",
        THINGS,
        (Template("category", "ABC", repeat=True), FULL),
        "a1 p1 t1 a2 p2",
        "a1 p1 t1 p2 a2",
    ),
    TherapyExercise(
        "red, blue, blue again and again",
        TOYS,
        (Pattern((colour("red"), colour("blue"), colour("blue")), repeat=True), FULL),
        "r1 b1 b2 r2 b3",
        "r1 b1 b2 b4 b3",
    ),
    TherapyExercise(
        "neighbours three apart",
        numbers(1, 4, 7, 8, 10, 11, 13),
        (EachPair(Pairs.NEIGHBOURS, Apart("value", 3)), FULL),
        "13 10 7 4 1",
        "10 13 8 11 7",
    ),
    TherapyExercise(
        "partners mirrored",
        named(
            "cup saucer fork knife shoe", partner=frozenset({("cup", "saucer"), ("fork", "knife")})
        ),
        (EachPair(Pairs.MIRRORED, Named("partner")), FULL),
        "cup fork shoe knife saucer",
        "cup fork shoe saucer knife",
    ),
    TherapyExercise(
        "more animals than plants",
        THINGS,
        (CompareCounts(kind("animal"), Comparison.MORE, kind("plant")), FULL),
        "a1 a2 p1 t1 f1",
        "a1 t2 p1 t1 f1",
    ),
    TherapyExercise(
        "exactly two colours",
        TOYS,
        (Kinds("colour", EQUAL, 2), FULL),
        "r1 b1 r2 r3 b2",
        "r1 b1 r2 g1 b2",
    ),
    TherapyExercise(
        "at most 15 together",
        SMALL,
        (Total("value", AT_MOST, 15), Count(Anything(), EQUAL, 4)),
        "1 2 3 9",
        "1 2 3 10",
    ),
    TherapyExercise(
        "weights make 10",
        THINGS,
        (Total("weight", EQUAL, 10), FULL),
        "a3 p3 t1 f1 a2",
        "a3 p3 t1 f2 a2",
    ),
    TherapyExercise(
        "first times second is third",
        SMALL,
        (Equation("value", (FIRST, Position(2)), (Position(3),), 1, Operation.PRODUCT),),
        "3 4 12",
        "3 4 10",
    ),
    TherapyExercise(
        "the last is two more than the first",
        SMALL,
        (Equation("value", (LAST,), (FIRST,), 2), FULL),
        "5 1 2 3 7",
        "5 1 2 3 8",
    ),
    TherapyExercise(
        "a word that is a bird",
        letters(
            "R O B I N C H A E",
            ("ROBIN", "CHAIN", "CRANE"),
            kind=frozenset({("ROBIN", "bird"), ("CRANE", "bird"), ("CHAIN", "thing")}),
        ),
        (Word(relation="kind", value="bird"), FULL),
        "C R A N E",
        "C H A I N",
    ),
    TherapyExercise(
        "a word with an I",
        WORDS,
        (Word(), Count(has("is-I", "letter"), AT_LEAST, 1), FULL),
        "C H A I R",
        "B R E A D",
    ),
    TherapyExercise(
        "any word, shorter too",
        letters("C A T S O", ("CAT", "CATS", "OAT")),
        (Word(),),
        "O A T",
        "O A S",
    ),
    TherapyExercise(
        "mirrored columns", ROWS, (StraightUp(mirrored=True), FULL), "3 2 4 1 5", "3 2 4 5 1"
    ),
    TherapyExercise(
        "all from the second column", ROWS, (EveryToken(has("is-2", ORIGIN_COLUMN)),), "6 1", "6 5"
    ),
    TherapyExercise(
        "one of each column",
        ROWS,
        (EachPair(Pairs.ALL, different(ORIGIN_COLUMN)), FULL),
        "10 7 4 1 9",
        "10 3 4 1 9",
    ),
    TherapyExercise(
        "the order of the columns is kept", ROWS, (Ordered(ORIGIN_COLUMN),), "9 1 4 2", "9 4 1 2"
    ),
    TherapyExercise(
        "always the smallest red one left",
        coloured("r1 r2 r3 r4 b1 b2"),
        (TakeExtreme("number", LOWEST, colour("red")), FULL),
        "b2 r1 r2 b1 r3",
        "b2 r2 r1 b1 r3",
    ),
    TherapyExercise(
        "ends first",
        TEN,
        (FillOrder(Filling.ENDS_FIRST), FULL),
        "19@5 23@1 32@2 34@4 36@3",
        "19@5 23@2 32@1 34@4 36@3",
    ),
    TherapyExercise(
        "the middle first",
        TEN,
        (FillOrder(Filling.MIDDLE_FIRST), FULL),
        "19@3 23@4 32@2 34@1 36@5",
        "19@3 23@4 32@5 34@1 36@2",
    ),
    TherapyExercise(
        "from left to right, heavy to light",
        THINGS,
        (LEFT_TO_RIGHT, Ordered("weight", Direction.FALLING), Count(Anything(), EQUAL, 3)),
        "a3 p2 t1",
        "a3@2 p2@1 t1@3",
    ),
    TherapyExercise(
        "all plants left of all animals",
        THINGS,
        (Before(kind("plant"), kind("animal"), ROW), FULL),
        "p1 t1 p2 a1 a2",
        "p1 a1 p2 t1 a2",
    ),
    TherapyExercise(
        "a blue right of each red",
        TOYS,
        (Follows(colour("red"), colour("blue"), line=ROW), FULL),
        "r1 b1 g1 r2 b2",
        "r1 g1 b1 r2 b2",
    ),
    TherapyExercise(
        "after a tool some day a fruit",
        THINGS,
        (Follows(kind("tool"), kind("fruit"), immediately=False), FULL),
        "t1 a1 t2 p1 f1",
        "t1 a1 f1 p1 t2",
    ),
    TherapyExercise(
        "the model row mirrored",
        coloured("r1 b1 g1 b3 g3 r2 b2 g2 b4 r4 g4"),
        (ModelRow(1, Reading.MIRRORED, same("colour")), FULL),
        "g2 b2 g4 b4 r2",
        "r2 b2 g4 b4 g2",
    ),
    TherapyExercise(
        "a short model row reversed",
        coloured("r1 b1 g1 r2 b2 g2 b4", order="r1 b1 g1 - - r2 b2 g2 b4"),
        (ModelRow(1, Reading.REVERSED, same("colour")), Count(Anything(), EQUAL, 3)),
        "g2 b2 r2",
        "r2 b2 g2",
    ),
    TherapyExercise(
        "one more than the model",
        coloured("r1 r3 r5 b2 b4 b6 g2 g4", order="r1 r3 r5 - - b2 b4 b6 g2 g4"),
        (ModelRow(1, Reading.COPIED, Step("number", 1)), Count(Anything(), EQUAL, 3)),
        "b2 g4 b6",
        "b2 b6 g4",
    ),
    TherapyExercise(
        "the first one names the class of the others",
        laid_out(
            deck_of(
                {
                    "fruit": {"name": "fruit", "class": "label"},
                    "tree": {"name": "tree", "class": "label"},
                    **{n: {"name": n, "class": "fruit"} for n in ("apple", "pear", "plum")},
                    **{n: {"name": n, "class": "tree"} for n in ("oak", "elm")},
                }
            )
        ),
        (
            At(FIRST, has("is-label", "class")),
            EachPair(Pairs.FIRST_WITH_REST, Compare("name", EQUAL, "class")),
        ),
        "fruit plum apple",
        "fruit plum oak",
    ),
    TherapyExercise(
        "all like the first one placed",
        TOYS,
        (EachPair(Pairs.FIRST_WITH_REST, same("colour"), TIME), Count(Anything(), EQUAL, 3)),
        "g1@3 g3@1 g2@2",
        "g1@3 r3@1 g2@2",
    ),
    TherapyExercise(
        "of the cue's colour",
        coloured("r1 b1 g1 r2 b2 g2"),
        (Cue(1, 2, same("colour")),),
        "b2",
        "b1",
    ),
    TherapyExercise("until 20 is reached", SMALL, (UntilTotal("value", 20),), "8 9 3", "8 12 3"),
    TherapyExercise(
        "if it starts red, exactly two blues",
        TOYS,
        (IfThen(At(FIRST, colour("red")), Count(colour("blue"), EQUAL, 2)), FULL),
        "r1 g1 b1 b2 r2",
        "r1 g1 b1 b2 b3",
    ),
    TherapyExercise(
        "if the first placed is a tool, the last placed is too",
        THINGS,
        (IfThen(At(FIRST, kind("tool"), TIME), At(LAST, kind("tool"), TIME)), FULL),
        "t1@2 a1@1 p1@3 p2@5 t2@4",
        "t1@2 a1@1 t2@3 p2@5 p1@4",
    ),
)
"""More of the same families, over other attributes."""
