"""Summaries: rules that refuse nothing that was learned, and an exact account of the rest."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations, product

import pytest
from hypothesis import assume, given

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.learning.grounded import GroundedLearner, learn_grounded
from maestra.rules.exercise import GroundedExercise, Provenance
from maestra.rules.features import select_features
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import given_row
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.ground_truth import ground_truth
from maestra.rules.pairs import Named, Times, different, same
from maestra.rules.pairs import Step as StepBy
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.rule import Rule
from maestra.rules.setting import play_of
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Literal
from maestra.rules.strips.vocabulary import Level, Vocabulary
from maestra.rules.summaries.summary import Check, Narrow, Summary, Unseen, summarise
from maestra.rules.token_tests import Not, has
from tests.rules.lessons import Lesson, lessons

LEFT_TO_RIGHT = FillOrder(Filling.LEFT_TO_RIGHT)


def learned(name: str, level: Level = Level.A) -> GroundedExercise:
    """One of the paper's exercises, learned to the end."""
    paper = PAPER_EXERCISES[name]
    model = ground_truth(paper.plays(), paper.vocabulary(level))
    provenance = {action: Provenance(1, ()) for action in model.preconditions}
    return GroundedExercise(model, provenance, frozenset({5}), 12)


def play(
    deck: Deck, row: Sequence[Value], origins: Sequence[Cell], board: Board | None = None
) -> Demonstration:
    """A row filled from the left; the other tokens lie wherever there is room."""
    board = board or Board()
    by_value = {value: token.id for token in deck.tokens for _, value in token.attributes}
    start = {by_value[value]: origin for value, origin in zip(row, origins, strict=True)}
    free = (cell for cell in board.storage_cells if cell not in start.values())
    for token in deck.tokens:
        if token.id not in start:
            start[token.id] = next(free)
    moves = tuple(
        Move(by_value[value], origin, goal)
        for value, origin, goal in zip(row, origins, board.goal_cells, strict=False)
    )
    return Demonstration(deck, State(board, start), moves)


def shuffled(board: Board, seed: int, count: int) -> list[Cell]:
    """Different storage cells."""
    return random.Random(seed).sample(board.storage_cells, count)  # noqa: S311 - seeded, for a test


def numbers(*values: int) -> Deck:
    """A deck of tokens that show a value."""
    return Deck(tuple(Token(TokenId(f"t{v:03}"), (("value", v),)) for v in values))


RULES: dict[str, tuple[Rule, ...]] = {
    "odd-ascending": (EveryToken(has("odd", "value")), Ordered("value")),
    "ascending": (Ordered("value"),),
    "descending": (Ordered("value", Direction.FALLING),),
    "first-row": (from_row(1), StraightUp()),
    "curie": (given_row("letter", tuple("CURIE")),),
    "letters": (Ordered("letter"),),
}


@pytest.mark.parametrize("name", PAPER_EXERCISES)
@pytest.mark.parametrize("level", Level)
def test_what_is_learned_to_the_end_is_said_exactly(name: str, level: Level) -> None:
    summary = summarise(learned(name, level))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow(), *RULES[name])
    assert (summary.steps, summary.gaps, summary.check) == ((), (), Check.SAME)


@given(lessons())
def test_rules_refuse_nothing_learned_and_accept_more_only_where_gaps_say_so(
    lesson: Lesson,
) -> None:
    learner = GroundedLearner(lesson.vocabulary)
    for shown in lesson.demonstrations:
        learner.show(shown)
    exercise = learner.exercise()
    summary = summarise(exercise)
    board, deck = exercise.board, lesson.deck
    assert (summary.check is Check.WIDER) == bool(summary.gaps)
    assume(summary.places and len(deck.tokens) <= len(board.storage_cells))
    accepted: set[Demonstration] = set()
    right: set[Demonstration] = set()
    for one in every_play(board, deck, summary.lengths):
        if accepts(exercise, one):
            accepted.add(one)
        if is_right(summary, one):
            right.add(one)
    assert accepted <= right
    if summary.check is not Check.NOT_COMPARED:
        assert (accepted == right) == (summary.check is Check.SAME)
        for gap in summary.gaps:
            assert any(shows_gap(gap, exercise, one) for one in right - accepted)


def every_play(board: Board, deck: Deck, lengths: frozenset[int]) -> Iterator[Demonstration]:
    """Every play of storage tokens onto an empty goal row, from every arrangement."""
    ids = [token.id for token in deck.tokens]
    for cells in permutations(board.storage_cells, len(ids)):
        start = State(board, dict(zip(ids, cells, strict=True)))
        for length in lengths:
            for tokens, goals in product(
                permutations(ids, length), permutations(board.goal_cells, length)
            ):
                moves = tuple(
                    Move(token, start.cells[token], goal)
                    for token, goal in zip(tokens, goals, strict=True)
                )
                yield Demonstration(deck, start, moves)


def failures(
    exercise: GroundedExercise, one: Demonstration
) -> Iterator[tuple[Action, tuple[Literal, ...] | None]]:
    """Each move that the preconditions refuse, with what is false; None if it was never shown."""
    vocabulary = exercise.model.vocabulary
    indices = vocabulary.indices(one.deck)
    for step, (state, move) in enumerate(zip(one.states(), one.moves, strict=False), start=1):
        action = Action(one.deck.by_id[move.token].attributes, step)
        if action not in exercise.model.preconditions:
            yield action, None
            continue
        contents = {cell: indices[token] for cell, token in state.tokens.items()}
        broken = exercise.model.broken(action, contents, move.origin, move.destination)
        if broken:
            yield action, broken


def accepts(exercise: GroundedExercise, one: Demonstration) -> bool:
    """Whether every precondition holds in its turn."""
    return next(failures(exercise, one), None) is None


def shows_gap(gap: Unseen | Narrow, exercise: GroundedExercise, one: Demonstration) -> bool:
    """Whether a play is refused for what the gap says."""
    for action, broken in failures(exercise, one):
        if action.step == gap.step:
            if isinstance(gap, Unseen) and broken is None and action.shown in gap.missing:
                return True
            if isinstance(gap, Narrow) and broken is not None and action.shown in gap.shown:
                return not set(broken).isdisjoint(gap.literals)
    return False


def is_right(summary: Summary, one: Demonstration) -> bool:
    """Whether all rules hold, and every step is as the single steps say."""
    steps = {step.step: step for step in summary.steps}
    for number, move in enumerate(one.moves, start=1):
        step = steps.get(number)
        shown = one.deck.by_id[move.token].attributes
        if step is not None and step.shown and shown not in step.shown:
            return False
        if step is not None and step.cell not in {None, move.destination}:
            return False
    whole = play_of(one)
    return all(rule.holds(whole) for rule in summary.rules)


def test_one_demonstration_gives_rules_and_says_how_little_was_seen() -> None:
    deck = numbers(1, 2, 3, 4, 5, 6, 7)
    board = Board()
    summary = summarise(learn_grounded([play(deck, (1, 2, 4, 6, 7), shuffled(board, 1, 5))]))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow(), Ordered("value"))
    assert summary.check is Check.WIDER
    first = summary.gaps[0]
    assert isinstance(first, Unseen)
    assert (first.step, first.seen) == (1, ((("value", 1),),))
    assert summary.gap_names[:2] == ("unseen-1", "unseen-2")


def test_the_same_row_from_elsewhere_is_a_given_row() -> None:
    deck = numbers(1, 2, 3, 4, 5, 6, 7)
    board = Board()
    row = (4, 1, 7, 2, 6)
    plays = [play(deck, row, shuffled(board, seed, 5)) for seed in range(6)]
    summary = summarise(learn_grounded(plays))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow(), given_row("value", row))
    assert summary.check is Check.SAME


def test_a_row_seen_once_straight_up_is_no_given_row_but_seen_twice_it_is() -> None:
    deck = numbers(1, 2, 3, 4, 5, 6, 7)
    row = (4, 1, 7, 2, 6)
    below = [Cell(Row(2), Column(column)) for column in range(1, 6)]
    once = summarise(learn_grounded([play(deck, row, below)]))
    assert once.rules == (LEFT_TO_RIGHT, FullRow(), from_row(1), StraightUp())
    twice = summarise(learn_grounded([play(deck, row, below)] * 2))
    assert twice.rules[-1] == given_row("value", row)
    assert twice.check is Check.SAME


def test_what_no_rule_says_is_told_step_by_step() -> None:
    deck = numbers(*range(1, 8))
    rows = [(4, 1, 7, 2, 6), (3, 5, 1, 7, 2)]
    plays = [play(deck, row, shuffled(Board(), seed, 5)) for row in rows for seed in range(8)]
    summary = summarise(learn_grounded(plays))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow())
    assert summary.steps[0].shown == ((("value", 3),), (("value", 4),))
    assert summary.steps[0].name == "step-1"


def test_an_order_of_cells_without_a_name_is_told_step_by_step() -> None:
    deck = numbers(1, 2, 3, 4)
    board = Board(2, 4)
    cells = [Cell(Row(2), Column(column)) for column in (1, 2, 3, 4)]
    goals = tuple(board.goal_cells[k] for k in (1, 0, 2, 3))
    plays: list[Demonstration] = []
    for tokens in permutations(deck.tokens):
        start = State(board, {t.id: c for t, c in zip(tokens, cells, strict=True)})
        for chosen in permutations(deck.tokens):
            moves = tuple(
                Move(t.id, start.cells[t.id], g) for t, g in zip(chosen, goals, strict=True)
            )
            plays.append(Demonstration(deck, start, moves))
    summary = summarise(learn_grounded(plays, features=["cells"]))
    assert summary.rules == (FullRow(),)
    assert [step.cell for step in summary.steps] == list(goals)
    assert all(step.shown == () for step in summary.steps)
    assert (summary.placing_name, summary.check) == ("placing", Check.SAME)


def test_moves_that_rules_do_not_speak_of_are_not_compared() -> None:
    deck = numbers(1, 2)
    board = Board(2, 3)
    start = State(board, {TokenId("t001"): board.cells[0], TokenId("t002"): board.cells[3]})
    away = Demonstration(deck, start, (Move(TokenId("t001"), board.cells[0], board.cells[4]),))
    summary = summarise(learn_grounded([away]))
    assert (summary.places, summary.rules, summary.gaps) == (False, (), ())
    assert summary.check is Check.NOT_COMPARED
    assert [step.shown for step in summary.steps] == [((("value", 1),),)]


def test_a_kind_that_all_used_tokens_share_is_a_rule_and_so_is_one_that_none_has() -> None:
    board = Board(3, 2)
    colours = {1: "red", 2: "red", 3: "blue", 4: "green"}
    deck = Deck(
        tuple(
            Token(TokenId(f"t{v}"), (("value", v), ("colour", colour)))
            for v, colour in colours.items()
        )
    )

    def shown(row: Sequence[int], origins: Sequence[Cell]) -> Demonstration:
        free = [cell for cell in board.storage_cells if cell not in origins]
        cells = [*origins, *free]
        order = [*row, *(v for v in colours if v not in row)]
        start = {TokenId(f"t{v}"): cell for v, cell in zip(order, cells, strict=False)}
        moves = tuple(
            Move(TokenId(f"t{v}"), origin, goal)
            for v, origin, goal in zip(row, origins, board.goal_cells, strict=True)
        )
        return Demonstration(deck, State(board, start), moves)

    pairs = list(permutations(board.storage_cells, 2))
    reds = [shown((a, b), pair) for pair in pairs for a, b in ((1, 2), (2, 1))]
    summary = summarise(learn_grounded(reds, features=["cells"]))
    assert summary.rules[2:] == (EveryToken(has("is-red", "colour")),)
    assert summary.check is Check.SAME
    single = [shown(row, pair) for pair in pairs for row in permutations((1, 2, 3), 2)]
    # Only one token is green, so that green is no kind: which tokens come is said step by step.
    assert len(summarise(learn_grounded(single, features=["cells"])).steps) == 2


def test_tokens_none_of_which_has_a_feature_are_said_by_its_absence() -> None:
    deck = numbers(2, 3, 5, 7, 11, 4, 9, 15)
    rows = list(permutations((4, 9, 15), 2))
    board = Board(5, 2)
    plays = [
        play(deck, row, origins, board)
        for row in rows
        for origins in permutations(board.storage_cells, 2)
    ]
    summary = summarise(learn_grounded(plays, features=["cells", "prime"]))
    assert summary.rules[2:] == (EveryToken(Not(has("prime", "value"))),)
    assert summary.check is Check.SAME


def test_neighbours_by_another_feature_are_a_rule() -> None:
    deck = numbers(1, 2, 3, 4, 5)
    board = Board(4, 3)
    rows = [(v, v + 1, v + 2) for v in (1, 2, 3)]
    plays = [play(deck, row, shuffled(board, seed, 3), board) for row in rows for seed in range(9)]
    summary = summarise(learn_grounded(plays, features=["successor"]))
    assert summary.rules[2:] == (EachPair(Pairs.NEIGHBOURS, StepBy("value", 1)),)
    assert summary.check is Check.SAME


@pytest.mark.parametrize("level", [Level.A, Level.C])
def test_a_board_of_20_x_20_with_100_tokens_is_compared(level: Level) -> None:
    board = Board(20, 20)
    deck = numbers(*range(1, 101))
    rng = random.Random(3)  # noqa: S311 - seeded, for a test
    plays = [
        play(deck, sorted(rng.sample(range(1, 101), 20)), shuffled(board, seed, 20), board)
        for seed in range(5)
    ]
    summary = summarise(learn_grounded(plays, level))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow(), Ordered("value"))
    assert summary.check is Check.WIDER


def test_too_many_rows_to_tell_apart_are_not_compared() -> None:
    board = Board(20, 20)
    deck = Deck(
        tuple(
            Token(TokenId(f"t{k:03}"), (("value", k), ("colour", "rb"[k % 2]))) for k in range(100)
        )
    )
    rng = random.Random(4)  # noqa: S311 - seeded, for a test

    def row() -> list[str]:
        reds, blues = rng.sample(range(0, 100, 2), 10), rng.sample(range(1, 100, 2), 10)
        return [f"t{k:03}" for pair in zip(reds, blues, strict=True) for k in pair]

    plays: list[Demonstration] = []
    for seed in range(2):
        ids = row()
        origins = shuffled(board, seed, 100)
        rest = [t.id for t in deck.tokens if t.id not in ids]
        start = State(board, dict(zip([*map(TokenId, ids), *rest], origins, strict=True)))
        moves = tuple(
            Move(TokenId(i), start.cells[TokenId(i)], goal)
            for i, goal in zip(ids, board.goal_cells, strict=True)
        )
        plays.append(Demonstration(deck, start, moves))
    summary = summarise(learn_grounded(plays, features=["different:colour"]))
    assert summary.check is Check.NOT_COMPARED
    assert summary.gaps == ()


def spread(
    board: Board, deck: Deck, chosen: Sequence[TokenId], goals: Sequence[Cell], seed: int
) -> Demonstration:
    """A play of these tokens onto these goal cells from a start arrangement."""
    origins = shuffled(board, seed, len(deck.tokens))
    start = State(board, {t.id: cell for t, cell in zip(deck.tokens, origins, strict=True)})
    moves = tuple(Move(t, start.cells[t], goal) for t, goal in zip(chosen, goals, strict=True))
    return Demonstration(deck, start, moves)


def test_from_right_to_left_the_right_neighbour_is_looked_at() -> None:
    deck = numbers(1, 2, 3, 4)
    board = Board(4, 3)
    goals = board.goal_cells[::-1]
    plays = [
        spread(board, deck, [TokenId(f"t{v:03}") for v in row], goals, seed)
        for row in ((4, 2, 1), (3, 2, 1), (4, 3, 2), (4, 3, 1))
        for seed in range(12)
    ]
    summary = summarise(learn_grounded(plays))
    assert summary.rules == (FillOrder(Filling.RIGHT_TO_LEFT), FullRow(), Ordered("value"))
    assert summary.check is Check.SAME


@pytest.mark.parametrize("level", Level)
def test_from_the_ends_inwards_is_a_rule(level: Level) -> None:
    deck = numbers(1, 2, 3, 4, 5)
    board = Board(3, 4)
    ids = [token.id for token in deck.tokens]
    plays = [
        spread(board, deck, [ids[k] for k in order], [board.goal_cells[k] for k in order], seed)
        for order in ((0, 3, 1, 2), (3, 0, 2, 1), (0, 3, 2, 1), (3, 0, 1, 2))
        for seed in range(20)
    ]
    summary = summarise(learn_grounded(plays, level))
    row = given_row("value", (1, 2, 3, 4))
    assert summary.rules == (FillOrder(Filling.ENDS_FIRST), FullRow(), row)
    assert (summary.gaps, summary.check) == ((), Check.SAME)


def test_any_order_of_cells_needs_no_rule() -> None:
    deck = numbers(1, 2, 3)
    board = Board(3, 2)
    ids = [token.id for token in deck.tokens]
    shown = [
        spread(board, deck, row, goals, seed)
        for row in permutations(ids, 2)
        for goals in permutations(board.goal_cells)
        for seed in range(12)
    ]
    summary = summarise(learn_grounded(shown, Level.B))
    assert (summary.rules, summary.steps, summary.check) == ((FullRow(),), (), Check.SAME)
    for level in Level:
        few = summarise(learn_grounded([shown[0], shown[20], shown[50]], level))
        assert (few.rules, few.check) == ((FullRow(),), Check.WIDER)
    short = [replace(one, moves=one.moves[:1]) for one in shown]
    begun = summarise(learn_grounded([short[0], short[12]], Level.C, ["cells"]))
    assert begun.check is Check.WIDER
    both = summarise(learn_grounded([*shown, *short], Level.B))
    assert (both.rules, both.lengths, both.check) == ((), frozenset({1, 2}), Check.SAME)


def test_a_given_row_in_any_order_is_compared_if_it_is_full() -> None:
    deck = numbers(1, 2, 3, 4)
    board = Board(3, 2)
    ids = [TokenId("t002"), TokenId("t001")]
    goals = board.goal_cells
    shown = [
        spread(board, deck, tokens, cells, seed)
        for tokens, cells in ((ids, goals), (ids[::-1], goals[::-1]))
        for seed in range(12)
    ]
    summary = summarise(learn_grounded(shown))
    assert summary.rules == (FullRow(), given_row("value", (2, 1)))
    assert summary.check is Check.SAME
    short = [replace(one, moves=one.moves[:1]) for one in shown]
    part = summarise(learn_grounded(short))
    assert part.rules == (given_row("value", (2, 1)),)
    assert part.check is Check.NOT_COMPARED


def test_steps_in_any_order_of_cells_are_compared_too() -> None:
    deck = numbers(1, 2, 3, 4)
    board = Board(3, 2)
    shown = [
        spread(board, deck, [TokenId("t003"), TokenId(f"t00{last}")], cells, seed)
        for last in (1, 4)
        for cells in permutations(board.goal_cells)
        for seed in range(3)
    ]
    summary = summarise(learn_grounded(shown, features=["cells"]))
    assert summary.steps[0].shown == ((("value", 3),),)
    assert summary.check is Check.SAME


def test_on_a_full_board_storage_is_not_compared() -> None:
    deck = numbers(1, 2, 3, 4)
    board = Board(3, 2)
    ids = [token.id for token in deck.tokens]
    shown = [spread(board, deck, ids[:2], board.goal_cells, seed) for seed in range(2)]
    assert summarise(learn_grounded(shown, Level.C)).check is Check.NOT_COMPARED


@pytest.mark.parametrize("any_order", [False, True], ids=["left-to-right", "any-order"])
def test_a_storage_row_that_is_used_up_is_known_to_be_full_at_first(any_order: bool) -> None:  # noqa: FBT001 - a parameter of the test
    board = Board(4, 2)
    deck = numbers(1, 3, 5, 2)
    lower = [cell for cell in board.storage_cells if cell.row > 2]
    upper = [cell for cell in board.storage_cells if cell.row == 2]
    names = ["destination", "origin-row", "less-than", "odd"]
    vocabulary = Vocabulary(board, deck, Level.C, select_features(deck, names))
    learner = GroundedLearner(vocabulary)
    odd = [TokenId("t001"), TokenId("t003"), TokenId("t005")]
    orders = list(permutations(board.goal_cells)) if any_order else [board.goal_cells]
    for row, goals, origins in product(permutations(odd, 2), orders, permutations(upper)):
        rest = [token.id for token in deck.tokens if token.id not in row]
        for others in permutations(lower, 2):
            start = dict(zip([*row, *rest], [*origins, *others], strict=True))
            moves = tuple(Move(t, start[t], goal) for t, goal in zip(row, goals, strict=True))
            learner.show(Demonstration(deck, State(board, start), moves))
            assert summarise(learner.exercise()).check is not Check.NOT_COMPARED
    summary = summarise(learner.exercise())
    order = () if any_order else (LEFT_TO_RIGHT,)
    odd_only = EveryToken(has("odd", "value"))
    assert summary.rules == (*order, FullRow(), from_row(1), odd_only)
    assert summary.check is Check.SAME


@pytest.mark.parametrize(
    ("feature", "colours", "rule"),
    [
        ("same:colour", "rrrbbb", EachPair(Pairs.NEIGHBOURS, same("colour"))),
        ("different:colour", "rbrbrb", EachPair(Pairs.NEIGHBOURS, different("colour"))),
    ],
)
def test_colours_of_neighbours_are_a_rule(feature: str, colours: str, rule: Rule) -> None:
    board = Board(4, 2)
    deck = Deck(
        tuple(
            Token(TokenId(f"t{k}"), (("value", k), ("colour", colour)))
            for k, colour in enumerate(colours)
        )
    )
    wanted = feature.startswith("same")
    rows = [
        (one.id, two.id)
        for one, two in permutations(deck.tokens, 2)
        if (one.value("colour") == two.value("colour")) == wanted
    ]
    shown = [
        spread(board, deck, row, board.goal_cells, seed) for row in rows for seed in range(15)
    ]
    summary = summarise(learn_grounded(shown, features=[feature]))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow(), rule)
    assert summary.check is Check.SAME


def test_doubles_partners_and_several_relations_are_rules() -> None:
    board = Board(4, 2)
    names = ("cup", "saucer", "knife", "fork")
    deck = Deck(
        tuple(
            Token(TokenId(f"t{k}"), (("value", 2**k), ("name", name)))
            for k, name in enumerate(names)
        ),
        relations={"partner": frozenset({("cup", "saucer"), ("knife", "fork")})},
    )
    pairs = [(TokenId("t0"), TokenId("t1")), (TokenId("t2"), TokenId("t3"))]
    shown = [
        spread(board, deck, pair, board.goal_cells, seed) for pair in pairs for seed in range(9)
    ]
    partner = EachPair(Pairs.NEIGHBOURS, Named("partner", directed=True))
    double = EachPair(Pairs.NEIGHBOURS, Times("value", 2))
    one = summarise(learn_grounded(shown, features=["partner"]))
    assert (one.rules[2:], one.check) == ((partner,), Check.SAME)
    both = summarise(learn_grounded(shown, features=["twice", "partner"]))
    assert (both.rules[2:], both.check) == ((double, partner), Check.SAME)
    # A double is larger anyway: the order adds nothing.
    order = summarise(learn_grounded(shown, features=["twice", "less-than"]))
    assert order.rules[2:] == (double,)


def test_a_row_of_tokens_that_features_cannot_tell_apart_is_no_given_row() -> None:
    board = Board(3, 2)
    shown = ((("value", 1),), (("colour", "red"), ("value", 1)), (("value", 2),))
    deck = Deck(tuple(Token(TokenId(f"t{k}"), each) for k, each in enumerate(shown)))
    ids = [TokenId("t0"), TokenId("t2")]
    plays = [spread(board, deck, ids, board.goal_cells, seed) for seed in range(9)]
    summary = summarise(learn_grounded(plays, features=["cells"]))
    assert summary.rules == (LEFT_TO_RIGHT, FullRow())
    assert [step.shown for step in summary.steps] == [(shown[0],), (shown[2],)]
