"""A rule as a drawing: the strokes of `rules.pictures` on a small board, for who likes pictures.

What lies between goal cells is an arc over the goal row with a sign on it, what happens in time
stands on a line of circles below the board, and sets of tokens have a mark each: the same mark
is on the tokens where they lie and wherever the rule speaks of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, assert_never

from markupsafe import Markup

from maestra.core.board import Cell
from maestra.core.tokens import TokenId
from maestra.language import NO_LEXICON, Language, Lexicon
from maestra.language.languages import speaker_for
from maestra.language.speaker import Speaker
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.pictures import (
    Arrow,
    Badge,
    Balance,
    Choice,
    Implication,
    Place,
    Selection,
    Sign,
    Stroke,
    Succession,
    Tally,
    Turn,
    picture,
)
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.web.board_drawing import (
    ACCENT,
    CELL,
    INK,
    MARGIN,
    MOST_COLUMNS,
    PITCH,
    Plan,
    Point,
    arrow,
    draw_token,
    element,
    picture_of,
    text,
)
from maestra.web.drawing_lines import below, draw_line, width_of
from maestra.web.drawing_marks import (
    CORNERS,
    Marks,
    mark,
    medal,
)
from maestra.web.token_view import TokenView, token_view

ARC: Final = 15.0
"""How much higher an arc is for each cell further that it reaches."""
ARC_SPACE: Final = 30.0
"""Over the highest arc, for its sign."""
TURN: Final = 19.0
"""Radius of a circle on the line of time."""
CHIP: Final = 34.0
"""Height of a line below the board."""
MOST_MARKS: Final = 4
"""On one token: one in each corner."""
SIGN: Final = 26.0
"""Size of a sign on an arrow."""
SHORT: Final = 46.0
"""An arrow shorter than this has its sign in the cell that it leads to."""


def draw_rule(
    rule: Rule,
    setting: Setting,
    sentence: str = "",
    *,
    description: str = "",
    language: Language = Language.EN,
    lexicon: Lexicon = NO_LEXICON,
) -> Markup:
    """The drawing of one rule.

    Args:
        rule: what to draw.
        setting: the board and the tokens on it.
        sentence: the rule in words; without it the drawing is decoration.
        description: more words for who cannot see it.
        language: of what stands on tokens.
        lexicon: a caregiver's own words.
    """
    speaker = speaker_for(language, setting.start.board, setting.deck, lexicon)
    panels = [_Panel(setting, strokes, speaker) for strokes in _panels(picture(rule, setting))]
    parts: list[Markup] = []
    width = max(panel.width for panel in panels)
    height = 0.0
    for number, panel in enumerate(panels):
        if number:
            middle = width / 2
            parts.append(arrow([Point(middle, height + 2), Point(middle, height + 30)]))
            height += 36
        shift = f"translate(0 {height:.1f})"
        parts.append(element("g", *panel.draw(), transform=shift))
        height += panel.height
    return picture_of(parts, width, height, sentence, description)


def draw_exercise(
    rules: Sequence[Rule],
    setting: Setting,
    title: str = "",
    *,
    language: Language = Language.EN,
    lexicon: Lexicon = NO_LEXICON,
) -> Markup:
    """A thumbnail of an exercise: its board with the rule that says most about it."""
    telling = [rule for rule in rules if not isinstance(rule, FullRow | FillOrder)] or rules
    if telling:
        return draw_rule(telling[0], setting, title, language=language, lexicon=lexicon)
    speaker = speaker_for(language, setting.start.board, setting.deck, lexicon)
    panel = _Panel(setting, (), speaker)
    return picture_of(panel.draw(), panel.width, panel.height, title, "")


def _panels(strokes: tuple[Stroke, ...]) -> Sequence[tuple[Stroke, ...]]:
    """Boards one below the other: what follows from what has one each."""
    match strokes:
        case (Implication(condition, consequence),):
            return (condition, consequence)
        case _:
            return (strokes,)


class _Panel:
    """One board with strokes on it."""

    def __init__(self, setting: Setting, strokes: Sequence[Stroke], speaker: Speaker) -> None:
        self._setting = setting
        self._strokes = strokes
        self._speaker = speaker
        self._marks = Marks()
        self._views: Mapping[TokenId, TokenView] = {
            token.id: token_view(token, speaker) for token in setting.deck.tokens
        }
        arcs = [s for s in strokes if isinstance(s, Arrow)]
        goals = [a for a in arcs if self._is_goal(a.start) and self._is_goal(a.end)]
        self._plan = Plan(setting.start.board, _height(goals) if goals else 0.0)
        turns = [a for a in arcs if isinstance(a.start, Turn)]
        self._turns = self._last_turn()
        self._time = self._plan.bottom + (_height(turns) if turns else 0.0) + TURN + 14
        """How far down the line of time is."""
        marked = {s.place for s in strokes if isinstance(s, Choice | Badge)}
        under = any(isinstance(place, Turn) for place in marked)
        end = self._time + TURN + (CELL if under else 0.0)
        self._chips_at = end if self._turns else self._plan.bottom
        self._lines = below(strokes, setting, speaker, self._marks)

    @property
    def width(self) -> float:
        """Of the panel."""
        slots = len(self._turns) * PITCH
        chips = max((width_of(line) for line in self._lines), default=0.0)
        return max(self._plan.width, slots, chips) + 2 * MARGIN

    @property
    def height(self) -> float:
        """Of the panel."""
        return self._chips_at + len(self._lines) * CHIP + MARGIN

    def draw(self) -> Iterator[Markup]:
        """The board, what is drawn on it, and what stands below it."""
        lying = {cell: self._views[token] for token, cell in self._setting.start.cells.items()}
        drawn = [part for stroke in self._strokes for part in self._stroke(stroke)]
        across = [s for s in self._strokes if isinstance(s, Arrow) and not self._is_arc(s)]
        lines = [part for stroke in across for part in self._line_across(stroke)]
        yield from self._plan.draw(lying, lines)
        yield from self._time_line()
        yield from drawn
        yield from self._marked()
        for number, line in enumerate(self._lines):
            yield from draw_line(line, Point(MARGIN, self._chips_at + (number + 0.7) * CHIP))

    # ------------------------------------------------------------ places

    def _is_goal(self, place: Place) -> bool:
        return isinstance(place, Cell) and place.row == self._setting.start.board.goal_row

    def _last_turn(self) -> tuple[int, ...]:
        """The turns on the line of time; -1 is the last one, whichever that is."""
        named = {
            place.number
            for stroke in self._strokes
            for place in _places(stroke)
            if isinstance(place, Turn)
        }
        if not named:
            return ()
        most = min(max(self._setting.length, *named), MOST_COLUMNS)
        return (*range(1, most + 1), *(number for number in named if number < 0))

    def _has(self, place: Place) -> bool:
        return place.number in self._turns if isinstance(place, Turn) else self._plan.has(place)

    def _at(self, place: Place) -> Point:
        if isinstance(place, Turn):
            slot = self._turns.index(place.number)
            return Point(MARGIN + slot * PITCH + CELL / 2, self._time)
        return self._plan.middle(place)

    # ------------------------------------------------------------ strokes

    def _stroke(self, stroke: Stroke) -> Iterator[Markup]:
        match stroke:
            case Arrow():
                yield from self._arrow(stroke)
            case Choice(place, tokens):
                yield from self._choice(place, tokens)
            case Badge(place, words):
                yield from self._badge(place, words)
            case Selection(tokens):
                self._marks.texts |= dict.fromkeys(tokens, "✓")
            case Succession(sets):
                for turn, tokens in enumerate(sets, start=1):
                    self._marks.texts |= dict.fromkeys(tokens, str(turn))
            case Tally() | Balance() | Implication():
                return
            case _:
                assert_never(stroke)

    def _arrow(self, stroke: Arrow) -> Iterator[Markup]:
        if not self._is_drawn(stroke):
            return
        if self._is_arc(stroke):
            yield from self._arc(stroke)
        elif stroke.sign is not Sign.MOVES:
            yield self._sign_across(stroke)

    def _is_drawn(self, stroke: Arrow) -> bool:
        return self._has(stroke.start) and self._has(stroke.end)

    def _is_arc(self, stroke: Arrow) -> bool:
        """Whether both ends are on one line: the goal row, or that of time."""
        in_time = isinstance(stroke.start, Turn)
        return in_time or (self._is_goal(stroke.start) and self._is_goal(stroke.end))

    def _arc(self, stroke: Arrow) -> Iterator[Markup]:
        start, end = self._at(stroke.start), self._at(stroke.end)
        # Beside the middle, so that arcs that meet at a cell are told apart.
        aside = 7.0 if end.x >= start.x else -7.0
        edge = start.y - (TURN if isinstance(stroke.start, Turn) else CELL / 2) - 3
        high = ARC * max(_reach(stroke), 1)
        middle = Point((start.x + end.x) / 2, edge - 2 * high)
        ends = Point(start.x + aside, edge), Point(end.x - aside, edge)
        yield arrow([ends[0], middle, ends[1]], bent=True)
        at = Point(middle.x, edge - high - 13)
        yield text(self._sign(stroke), at, SIGN, halo=True, within=PITCH - 6)

    def _line_across(self, stroke: Arrow) -> Iterator[Markup]:
        """From row to row; tokens that lie between hide it."""
        if self._is_drawn(stroke):
            yield arrow(self._ends(stroke))

    def _ends(self, stroke: Arrow) -> tuple[Point, Point]:
        start, end = self._at(stroke.start), self._at(stroke.end)
        down = 1.0 if end.y > start.y else -1.0
        half = CELL / 2 - 8
        return Point(start.x, start.y + down * half), Point(end.x, end.y - down * half)

    def _sign_across(self, stroke: Arrow) -> Markup:
        first, last = self._ends(stroke)
        if abs(last.y - first.y) < SHORT:
            return text(self._sign(stroke), self._at(stroke.end), SIGN)
        middle = Point((first.x + last.x) / 2, (first.y + last.y) / 2)
        return text(self._sign(stroke), middle, SIGN, halo=True)

    def _sign(self, stroke: Arrow) -> str:
        numeral = self._speaker.grammar.numeral
        amount = "" if stroke.amount is None else numeral(stroke.amount)
        if stroke.sign is Sign.PLUS and amount.startswith(("-", "−")):
            return f"−{amount[1:]}"
        if stroke.sign is Sign.ADD_UP:
            return f"Σ={amount}"
        return f"{stroke.sign.value}{amount}"

    def _choice(self, place: Place, tokens: tuple[TokenId, ...]) -> Iterator[Markup]:
        if not self._has(place):
            return
        at = self._under(place)
        if not tokens:
            yield text("∅", at, 30)
        elif len(tokens) == 1:
            yield draw_token(self._views[tokens[0]], at, ghost=True)
        else:
            yield element(
                "circle", cx=at.x, cy=at.y, r=19, fill="#fff", stroke=ACCENT, stroke_width=2
            )
            yield mark(self._marks.of(tokens), at)

    def _badge(self, place: Place, words: str) -> Iterator[Markup]:
        if not self._has(place):
            return
        at = self._under(place)
        lies = isinstance(place, Cell) and place in self._setting.start.tokens
        if lies:
            yield medal(words, Point(at.x, at.y + CELL / 2 - 4))
        else:
            yield text(words, at, 30 if len(words) == 1 else 24, ACCENT)

    def _under(self, place: Place) -> Point:
        """In a cell, or below a circle of the line of time."""
        at = self._at(place)
        return Point(at.x, at.y + TURN + CELL / 2) if isinstance(place, Turn) else at

    def _marked(self) -> Iterator[Markup]:
        """Marks on the tokens, where they lie."""
        for token, cell in self._setting.start.cells.items():
            if not self._plan.has(cell):
                continue
            at = self._plan.middle(cell)
            away = CELL / 2 - 3
            corners = [Point(at.x + x * away, at.y + y * away) for x, y in CORNERS]
            if token in self._marks.texts:
                yield medal(self._marks.texts[token], corners.pop(0))
            for number, corner in zip(self._marks.on(token)[:MOST_MARKS], corners, strict=False):
                yield mark(number, corner)

    def _time_line(self) -> Iterator[Markup]:
        """Circles in the order of placing; the last one has two rings."""
        for number in self._turns:
            at = self._at(Turn(number))
            style = {"fill": "#fff", "stroke": INK, "stroke_width": 2}
            yield element("circle", cx=at.x, cy=at.y, r=TURN, **style)
            if number < 0:
                yield element("circle", cx=at.x, cy=at.y, r=TURN - 5, **style)
            else:
                yield text(str(number), at)


def _places(stroke: Stroke) -> tuple[Place, ...]:
    match stroke:
        case Arrow(start, end):
            return (start, end)
        case Choice(place) | Badge(place):
            return (place,)
        case _:
            return ()


def _reach(stroke: Arrow) -> int:
    """How many cells or turns further an arc leads."""
    match stroke.start, stroke.end:
        case Cell() as start, Cell() as end:
            return abs(end.column - start.column)
        case Turn(start), Turn(end):
            return abs(end - start)
        case _:
            return 0


def _height(arcs: Sequence[Arrow]) -> float:
    return ARC * max(1, *(min(_reach(one), MOST_COLUMNS) for one in arcs)) + ARC_SPACE
