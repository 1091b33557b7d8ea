"""The exercises of the list that therapists gave, one by one."""

from __future__ import annotations

from typing import Final

from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import ModelRow, Reading
from maestra.rules.forms.counting import (
    Count,
    Equation,
    Total,
)
from maestra.rules.forms.order import (
    ExtremeAt,
    Ordered,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template, given_row
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme, from_row
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import (
    AddUp,
    Compare,
    Named,
    Step,
    Times,
    different,
    same,
)
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW
from maestra.rules.token_tests import (
    Among,
    Comparison,
    Either,
    Not,
    has,
)
from tests.rules.therapy_boards import (
    AT_LEAST,
    CAST,
    EQUAL,
    FULL,
    HIGHEST,
    LOWEST,
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
    kinds,
    laid_out,
    named,
    numbers,
    sized,
)

LISTED: Final = (
    TherapyExercise(
        "1 smallest to largest", TEN, (Ordered("value"), FULL), "19 23 34 36 77", "19 34 23 36 77"
    ),
    TherapyExercise(
        "2 largest to smallest",
        TEN,
        (Ordered("value", Direction.FALLING), FULL),
        "77 63 46 23 19",
        "77 63 23 46 19",
    ),
    TherapyExercise(
        "3 the odd ones in order",
        TEN,
        (EveryToken(has("odd", "value")), Ordered("value"), FULL),
        "19 23 51 57 63",
        "19 23 32 57 63",
    ),
    TherapyExercise("4 alphabetical", CAST, (Ordered("letter"), FULL), "A C D I U", "A C I D U"),
    TherapyExercise(
        "5 small to big",
        sized(),
        (Ordered("size"), FULL),
        "tiny small medium large huge",
        "tiny medium small large huge",
    ),
    TherapyExercise(
        "6 coins by value",
        laid_out(
            deck_of(
                {
                    "1a": {"money": 1},
                    "1b": {"money": 1},
                    "2a": {"money": 2},
                    "2b": {"money": 2},
                    "5a": {"money": 5},
                    "5b": {"money": 5},
                }
            )
        ),
        (Ordered("money", strict=False), FULL),
        "1a 1b 2a 5a 5b",
        "1a 2a 1b 5a 5b",
    ),
    TherapyExercise("7 only red", TOYS, (EveryToken(colour("red")),), "r3 r1 r2", "r3 r1 b2"),
    TherapyExercise("8 only fruit", THINGS, (EveryToken(kind("fruit")),), "f2 f1", "f2 a1"),
    TherapyExercise(
        "9 only above 30",
        TEN,
        (EveryToken(has("above-30", "value")), FULL),
        "77 32 34 51 36",
        "77 32 34 51 23",
    ),
    TherapyExercise(
        "10 anything but animals",
        THINGS,
        (EveryToken(Not(kind("animal"))), FULL),
        "f1 t1 p1 p2 f2",
        "f1 t1 a1 p2 f2",
    ),
    TherapyExercise(
        "11 red or round",
        TOYS,
        (EveryToken(Either(colour("red"), has("is-round", "shape"))), FULL),
        "r1 b2 g2 r3 b4",
        "r1 b2 g2 r3 b3",
    ),
    TherapyExercise(
        "12 the five smallest in order",
        TEN,
        (EveryToken(Among("value", LOWEST)), Ordered("value"), FULL),
        "19 23 32 34 36",
        "19 23 32 34 46",
    ),
    TherapyExercise(
        "13 all the odd ones",
        numbers(2, 3, 4, 7, 8, 9),
        (EveryToken(has("odd", "value")), AllOfThem(has("odd", "value"))),
        "9 3 7",
        "9 3",
    ),
    TherapyExercise(
        "14 the same kinds together",
        THINGS,
        (Blocks("category"), FULL),
        "a1 a3 p1 t1 t2",
        "a1 p1 a3 t1 t2",
    ),
    TherapyExercise(
        "15 odd one out goes last",
        kinds("a1 a2 a3 a4 p1 p2 t1"),
        (Template("category", "AAAAB"), FULL),
        "a1 a2 a4 a3 p1",
        "a1 a2 a4 p1 a3",
    ),
    TherapyExercise(
        "16 partners side by side",
        named(
            "cup saucer fork knife shoe sock",
            partner=frozenset({("cup", "saucer"), ("fork", "knife"), ("shoe", "sock")}),
        ),
        (EachPair(Pairs.TWO_BY_TWO, Named("partner")),),
        "cup saucer knife fork",
        "cup saucer fork sock",
    ),
    TherapyExercise(
        "17 never two of a colour together",
        TOYS,
        (EachPair(Pairs.NEIGHBOURS, different("colour")), FULL),
        "r1 b1 r2 g1 b2",
        "r1 b1 r2 r3 b2",
    ),
    TherapyExercise(
        "18 two animals and three plants",
        THINGS,
        (Count(kind("animal"), EQUAL, 2), Count(kind("plant"), EQUAL, 3)),
        "a1 p1 p2 a3 p3",
        "a1 p1 p2 a3 a2",
    ),
    TherapyExercise(
        "19 alternate two colours",
        TOYS,
        (Template("colour", "AB", repeat=True), FULL),
        "b1 r2 b3 r4 b2",
        "b1 r2 g1 r4 b2",
    ),
    TherapyExercise(
        "20 two and two",
        TOYS,
        (Template("colour", "AABBA"), FULL),
        "r1 r2 b1 b2 r3",
        "r1 r2 b1 r4 r3",
    ),
    TherapyExercise(
        "21 high, low, high, low",
        TEN,
        (
            Zigzag("value"),
            TwoPlaces(Position(1), Position(2), Compare("value", Comparison.MORE)),
            FULL,
        ),
        "34 19 77 23 36",
        "19 34 23 77 36",
    ),
    TherapyExercise(
        "22 biggest in the middle",
        TEN,
        (ExtremeAt("value", HIGHEST, MIDDLE), FULL),
        "34 19 77 23 36",
        "34 77 19 23 36",
    ),
    TherapyExercise(
        "23 mirrored colours",
        TOYS,
        (EachPair(Pairs.MIRRORED, same("colour")), FULL),
        "r1 b1 g1 b2 r2",
        "r1 b1 g1 r3 r2",
    ),
    TherapyExercise(
        "24 copy the model row",
        coloured("r1 b1 g1 b3 r3 r2 b2 g2 b4 r4 b6", columns=5),
        (ModelRow(1, Reading.COPIED, same("colour")), FULL),
        "r2 b4 g2 b2 r4",
        "r2 b4 b6 b2 r4",
    ),
    TherapyExercise(
        "25 count in twos",
        SMALL,
        (EachPair(Pairs.NEIGHBOURS, Step("value", 2)), FULL),
        "2 4 6 8 10",
        "2 4 6 8 9",
    ),
    TherapyExercise(
        "26 doubling",
        SMALL,
        (EachPair(Pairs.NEIGHBOURS, Times("value", 2)), FULL),
        "1 2 4 8 16",
        "1 2 4 8 12",
    ),
    TherapyExercise(
        "27 make exactly 100",
        numbers(10, 15, 20, 25, 30, 35),
        (Total("value", EQUAL, 100), FULL),
        "10 15 20 25 30",
        "10 15 20 25 35",
    ),
    TherapyExercise(
        "28 first plus second is third",
        SMALL,
        (Equation("value", (FIRST, Position(2)), (Position(3),)),),
        "3 4 7",
        "3 4 8",
    ),
    TherapyExercise(
        "29 neighbours add up to 10",
        laid_out(deck_of({f"{v}{c}": {"value": v} for v in (3, 7, 4, 6) for c in "ab"})),
        (EachPair(Pairs.NEIGHBOURS, AddUp("value", 10)),),
        "3a 7a 3b 7b",
        "3a 7a 4a 6a",
    ),
    TherapyExercise(
        "30 spell CURIE",
        CAST,
        (given_row("letter", tuple("CURIE")), FULL),
        "C U R I E",
        "C U R I A",
    ),
    TherapyExercise(
        "31 any real five-letter word", WORDS, (Word(), FULL), "B A C O N", "B A C O D"
    ),
    TherapyExercise(
        "32 days of the week in order",
        days(),
        (EachPair(Pairs.NEIGHBOURS, Step("day", 1)), At(FIRST, has("is-Mon", "day")), FULL),
        "Mon Tue Wed Thu Fri",
        "Tue Wed Thu Fri Sat",
    ),
    TherapyExercise(
        "33 days in order, starting anywhere",
        days(),
        (EachPair(Pairs.NEIGHBOURS, Step("day", 1)), FULL),
        "Sat Sun Mon Tue Wed",
        "Sat Sun Mon Wed Tue",
    ),
    TherapyExercise(
        "34 making tea",
        named("kettle cup milk spoon sugar"),
        (
            Before(has("is-kettle", "name"), has("is-cup", "name")),
            Before(has("is-cup", "name"), has("is-milk", "name")),
            FULL,
        ),
        "spoon kettle cup sugar milk",
        "spoon cup kettle sugar milk",
    ),
    TherapyExercise(
        "35 the first storage row", ROWS, (from_row(1), FULL), "5 1 4 2 3", "5 1 4 2 9"
    ),
    TherapyExercise("36 straight up", ROWS, (StraightUp(), FULL), "9 1 8 2 10", "1 9 8 2 10"),
    TherapyExercise(
        "37 rows by turns",
        ROWS,
        (
            Pattern((has("is-1", ORIGIN_ROW), has("is-2", ORIGIN_ROW)), repeat=True, line=TIME),
            FULL,
        ),
        "5 9 1 10 2",
        "5 9 1 3 2",
    ),
    TherapyExercise(
        "38 always the left-most one left",
        ROWS,
        (TakeExtreme(ORIGIN_COLUMN, LOWEST), FULL),
        "9 5 1 6 4",
        "9 1 5 6 4",
    ),
    TherapyExercise(
        "39 from right to left",
        TEN,
        (FillOrder(Filling.RIGHT_TO_LEFT), FULL),
        "77@5 19@4 23@3 34@2 36@1",
        "77@5 19@4 23@2 34@3 36@1",
    ),
    TherapyExercise(
        "40 small to large in any cell",
        TEN,
        (Ordered("value", line=TIME), FULL),
        "19@4 23@1 34@5 36@2 77@3",
        "19@4 34@1 23@5 36@2 77@3",
    ),
    TherapyExercise(
        "41 all reds before any blue",
        TOYS,
        (Before(colour("red"), colour("blue")), FULL),
        "r1@3 g1@1 r2@5 b1@2 b2@4",
        "r1@3 g1@1 b1@5 r2@2 b2@4",
    ),
    TherapyExercise(
        "42 after an animal a plant",
        THINGS,
        (Follows(kind("animal"), kind("plant")), FULL),
        "t1 a1 p1 a2 p2",
        "t1 a1 p1 p2 a2",
    ),
    TherapyExercise(
        "43 exactly two red, rising",
        coloured("r1 r3 r5 b2 b4 b6 b8"),
        (Count(colour("red"), EQUAL, 2), Ordered("number"), FULL),
        "r1 b2 r3 b4 b6",
        "r1 b2 r3 b4 r5",
    ),
    TherapyExercise(
        "44 at least one vowel",
        CAST,
        (Count(has("vowel", "letter"), AT_LEAST, 1), FULL),
        "C R G B A",
        "C R G B D",
    ),
    TherapyExercise(
        "45 animal first, plant last",
        THINGS,
        (IfThen(At(FIRST, kind("animal")), At(LAST, kind("plant"))), FULL),
        "a1 t1 t2 f1 p1",
        "a1 t1 p1 t2 f1",
    ),
)
"""One for each of the list."""
