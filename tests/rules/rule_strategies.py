"""Random decks, starts, plays and rules of every form; any test may use them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from math import perm
from typing import Any, Final, TypeAlias, get_args

from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Row
from maestra.core.state import State
from maestra.core.tokens import LETTER, NAME, Deck, Scale, Token, TokenId, Value
from maestra.rules.features import TokenFeature
from maestra.rules.forms.base import Direction, Form, Position
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
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Apart, Compare, Named, Relation, Step, Times
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Play, Setting, bits
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Extreme,
    Has,
    Not,
    TokenTest,
    has,
)

SIZES: Final = ("small", "medium", "large")
DAYS: Final = ("Mon", "Tue", "Wed", "Thu")
COLOURS: Final = ("red", "blue", "green")
WORDS: Final = ("a", "ab", "ba", "cab", "abc", "bac", "Baca", "aabb")
NAMES: Final = ("cup", "saucer", "red", "blue", "spoon")

FORMS: Final[tuple[type[Form], ...]] = get_args(get_args(Rule)[0])
"""Every form of the language."""


@st.composite
def decks(draw: st.DrawFn, largest: int = 6) -> Deck:
    """A deck whose tokens show some of many attributes, not always all of them."""
    kinds: dict[str, st.SearchStrategy[Value]] = {
        "value": st.integers(-3, 6),
        "weight": st.integers(1, 8).map(lambda k: k if k % 2 == 0 else Decimal(k) / 2),
        "colour": st.sampled_from(COLOURS),
        LETTER: st.sampled_from("abcA"),
        "size": st.sampled_from(SIZES),
        "day": st.sampled_from(DAYS),
        NAME: st.sampled_from(NAMES),
    }
    chosen = draw(st.lists(st.sampled_from(sorted(kinds)), min_size=1, max_size=4, unique=True))
    whole = draw(st.sampled_from((True, True, True, False)))
    tokens: list[Token] = []
    for number in range(draw(st.integers(1, largest))):
        shown = {name: draw(kinds[name]) for name in chosen if whole or draw(st.booleans())}
        tokens.append(Token(TokenId(f"t{number}"), tuple(shown.items())))
    relations = {
        "partner": frozenset({("cup", "saucer"), ("red", "blue")}),
        "kind": frozenset({("ab", "short"), ("abc", "long"), ("CAB", "long")}),
    }
    return Deck(tuple(tokens), {"size": SIZES}, {"day": DAYS}, relations, WORDS)


@st.composite
def settings_with(draw: st.DrawFn, deck: Deck, columns: int | None = None) -> Setting:
    """A start on a small board with room for the deck, some tokens perhaps in the goal row."""
    wide = columns or draw(st.integers(1, 5))
    rows = 1 + -(-len(deck.tokens) // wide) + draw(st.integers(0, 1))
    board = Board(rows, wide, Row(draw(st.integers(1, rows))))
    given = draw(st.integers(0, 3)) == 0
    cells: Sequence[Cell] = board.cells if given else board.storage_cells
    places = draw(st.permutations(cells))
    ids = [token.id for token in deck.tokens]
    return Setting(deck, State(board, dict(zip(ids, places, strict=False))))


def ways_on(play: Play) -> int:
    """How many plays `every_way_on` lists."""
    free, left = len(play.free), play.left.bit_count()
    return sum(perm(free, k) * perm(left, k) for k in range(play.room + 1))


@st.composite
def plays_from(draw: st.DrawFn, setting: Setting, ways: int = 300) -> Play:
    """A play of any length that can go on in at most `ways` ways, ending at once included."""
    play = Play.begin(setting)
    wanted = draw(st.integers(0, play.room))
    while len(play.placed) < wanted or ways_on(play) > ways:
        token = draw(st.sampled_from(list(bits(play.left))))
        play = play.after(token, draw(st.sampled_from(play.free)))
    return play


def attributes_of(deck: Deck) -> st.SearchStrategy[str]:
    """What tokens of the deck show, and where they come from."""
    return st.sampled_from((*deck.scales, ORIGIN_ROW, ORIGIN_COLUMN))


def ordinals_of(deck: Deck) -> st.SearchStrategy[str]:
    """Attributes that have an order, seldom one that has none."""
    ordered = [name for name, scale in deck.scales.items() if scale is not Scale.NOMINAL]
    return st.sampled_from((*ordered * 3, ORIGIN_ROW, ORIGIN_COLUMN)) | attributes_of(deck)


def values_of(deck: Deck, attribute: str) -> st.SearchStrategy[Value]:
    """What some token shows, or for numbers something near."""
    shown = [value for token in deck.tokens if (value := token.value(attribute)) is not None]
    return st.sampled_from(shown) if shown else st.integers(0, 4)


def features_of(deck: Deck) -> st.SearchStrategy[Has]:
    """Features of one token that apply to the deck."""
    simple = [
        has(name, attribute)
        for attribute, scale in (*deck.scales.items(), (ORIGIN_COLUMN, Scale.NUMBER))
        for name in {
            Scale.NUMBER: ("odd", "even", "multiple-of-3", "above-2", "below-1.5", "digits-1"),
            Scale.LETTER: ("vowel", "consonant"),
        }.get(scale, ())
    ]
    shown = attributes_of(deck).flatmap(
        lambda attribute: values_of(deck, attribute).map(
            lambda value: Has(TokenFeature(f"is-{value}", attribute))
        )
    )
    return st.sampled_from(simple) | shown


def token_tests_of(deck: Deck, deep: int = 2) -> st.SearchStrategy[TokenTest]:
    """Tests of one token."""
    comparisons, extremes = st.sampled_from(Comparison), st.sampled_from(Extreme)
    compared = ordinals_of(deck).flatmap(
        lambda attribute: st.builds(
            Compared, st.just(attribute), comparisons, values_of(deck, attribute)
        )
    )
    among = st.builds(Among, ordinals_of(deck), extremes, st.none() | st.integers(1, 4))
    plain = features_of(deck) | features_of(deck) | compared | among | st.just(Anything())
    if not deep:
        return plain
    inner = token_tests_of(deck, deep - 1)
    return (
        plain
        | st.builds(Not, inner)
        | st.builds(Either, inner, inner)
        | st.builds(Both, inner, inner)
    )


def relations_of(deck: Deck) -> st.SearchStrategy[Relation]:
    """Relations of two tokens."""
    ordinal, amounts = ordinals_of(deck), st.integers(-2, 4) | st.just(Decimal("1.5"))
    compare = st.builds(
        Compare, attributes_of(deck), st.sampled_from(Comparison), st.none() | attributes_of(deck)
    )
    return st.one_of(
        compare,
        st.builds(Compare, attributes_of(deck), st.sampled_from(Comparison)),
        st.builds(Step, ordinal, amounts),
        st.builds(Apart, ordinal, amounts),
        st.builds(Times, ordinal, amounts),
        st.builds(AddUp, ordinal, amounts),
        st.builds(Named, st.sampled_from((*deck.relations, "unknown")), st.booleans()),
    )


Build: TypeAlias = Callable[[Deck, Board], st.SearchStrategy[Any]]

_LINES: Final = st.sampled_from(Line)
_DIRECTIONS: Final = st.sampled_from(Direction)
_COMPARISONS: Final = st.sampled_from(Comparison)
_EXTREMES: Final = st.sampled_from(Extreme)


def _positions(board: Board) -> st.SearchStrategy[Position]:
    return st.integers(-board.columns, board.columns + 1).map(Position)


def _numbers() -> st.SearchStrategy[int | Decimal]:
    return st.integers(-4, 12) | st.integers(0, 16).map(lambda k: Decimal(k) / 2)


def _each_pairs(deck: Deck) -> st.SearchStrategy[EachPair]:
    rows = st.builds(EachPair, st.sampled_from(Pairs), relations_of(deck))
    in_time = [pairs for pairs in Pairs if pairs is not Pairs.MIRRORED]
    return rows | st.builds(
        EachPair, st.sampled_from(in_time), relations_of(deck), st.just(Line.TIME)
    )


def _ats(deck: Deck, board: Board) -> st.SearchStrategy[At]:
    in_time = st.sampled_from([Position(k) for k in (-1, *range(1, board.columns + 1))])
    return st.builds(At, _positions(board), token_tests_of(deck)) | st.builds(
        At, in_time, token_tests_of(deck), st.just(Line.TIME)
    )


def _counts(deck: Deck) -> st.SearchStrategy[Count]:
    return st.builds(Count, token_tests_of(deck), _COMPARISONS, st.integers(0, 4))


def _equations(deck: Deck, board: Board) -> st.SearchStrategy[Equation]:
    places = st.integers(1, 4).flatmap(
        lambda left: st.tuples(
            st.tuples(*[_positions(board)] * left),
            st.lists(_positions(board), max_size=4 - left).map(tuple),
        )
    )
    return places.flatmap(
        lambda sides: st.builds(
            Equation,
            ordinals_of(deck),
            st.just(sides[0]),
            st.just(sides[1]),
            _numbers(),
            st.sampled_from(Operation),
        )
    )


def _conditions(deck: Deck, board: Board) -> st.SearchStrategy[At | Count]:
    return _ats(deck, board) | _counts(deck)


RULES: Final[dict[type[Form], Build]] = {
    EveryToken: lambda deck, _: st.builds(EveryToken, token_tests_of(deck)),
    AllOfThem: lambda deck, _: st.builds(AllOfThem, token_tests_of(deck)),
    Ordered: lambda deck, _: st.builds(
        Ordered, ordinals_of(deck), _DIRECTIONS, st.booleans(), _LINES
    ),
    CyclicOrdered: lambda deck, _: st.builds(
        CyclicOrdered, ordinals_of(deck), _DIRECTIONS, _LINES
    ),
    RiseAndFall: lambda deck, _: st.builds(RiseAndFall, ordinals_of(deck), _DIRECTIONS, _LINES),
    Zigzag: lambda deck, _: st.builds(Zigzag, ordinals_of(deck), _LINES),
    EqualSteps: lambda deck, _: st.builds(EqualSteps, ordinals_of(deck), st.booleans(), _LINES),
    ExtremeAt: lambda deck, board: st.builds(
        ExtremeAt, ordinals_of(deck), _EXTREMES, _positions(board), st.booleans()
    ),
    EachPair: lambda deck, _: _each_pairs(deck),
    TwoPlaces: lambda deck, board: st.builds(
        TwoPlaces, _positions(board), _positions(board), relations_of(deck)
    ),
    Pattern: lambda deck, _: st.builds(
        Pattern,
        st.lists(token_tests_of(deck), min_size=1, max_size=3).map(tuple),
        st.booleans(),
        _LINES,
    ),
    Template: lambda deck, _: st.builds(
        Template,
        attributes_of(deck),
        st.text("ABC", min_size=1, max_size=4),
        st.booleans(),
        _LINES,
    ),
    Blocks: lambda deck, _: st.builds(Blocks, attributes_of(deck), _LINES),
    Count: lambda deck, _: _counts(deck),
    CompareCounts: lambda deck, _: st.builds(
        CompareCounts, token_tests_of(deck), _COMPARISONS, token_tests_of(deck)
    ),
    Kinds: lambda deck, _: st.builds(Kinds, attributes_of(deck), _COMPARISONS, st.integers(0, 3)),
    Total: lambda deck, _: st.builds(Total, ordinals_of(deck), _COMPARISONS, _numbers()),
    Equation: _equations,
    At: _ats,
    IfThen: lambda deck, board: st.builds(
        IfThen, _conditions(deck, board), _conditions(deck, board)
    ),
    Word: lambda _, __: (
        st.builds(Word)
        | st.builds(Word, st.just(LETTER), st.just("kind"), st.sampled_from(("short", "long")))
    ),
    StraightUp: lambda _, __: st.builds(StraightUp, st.booleans()),
    TakeExtreme: lambda deck, _: st.builds(
        TakeExtreme, ordinals_of(deck), _EXTREMES, token_tests_of(deck)
    ),
    FillOrder: lambda _, __: st.builds(FillOrder, st.sampled_from(Filling)),
    Before: lambda deck, _: st.builds(Before, token_tests_of(deck), token_tests_of(deck), _LINES),
    Follows: lambda deck, _: st.builds(
        Follows, token_tests_of(deck), token_tests_of(deck), st.booleans(), _LINES
    ),
    ModelRow: lambda deck, _: st.builds(
        ModelRow, st.integers(1, 3), st.sampled_from(Reading), relations_of(deck)
    ),
    Cue: lambda deck, _: st.builds(Cue, st.integers(1, 3), st.integers(1, 4), relations_of(deck)),
    FullRow: lambda _, __: st.just(FullRow()),
    UntilTotal: lambda deck, _: st.builds(UntilTotal, ordinals_of(deck), _numbers()),
}
"""A strategy for each form."""


def rules_for(deck: Deck, board: Board) -> st.SearchStrategy[Rule]:
    """Rules of any form that make sense of this deck on this board."""
    return st.one_of([build(deck, board) for build in RULES.values()])


def every_way_on(play: Play) -> list[Play]:
    """The play and all that continue it: the slow and obvious list."""
    found: list[Play] = []
    todo = [play]
    while todo:
        now = todo.pop()
        found.append(now)
        todo.extend(now.extensions())
    return found
