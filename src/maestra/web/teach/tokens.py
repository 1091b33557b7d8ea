"""The pages where tokens and the board are made, before anything is shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Final, TypeAlias, assert_never

from fastapi import APIRouter, Form, UploadFile
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import Deck, Token
from maestra.language import Language
from maestra.language.languages import words_of
from maestra.storage.drafts import Digest, Drafts
from maestra.web.board_press import CellText, TokenText
from maestra.web.teach import decks, pictures
from maestra.web.teach.actions import (
    CannotError,
    Deal,
    Equip,
    LayOut,
    new_draft,
)
from maestra.web.teach.bench import AtBench, Bench, WhyNot, path_of, pressed
from maestra.web.teach.decks import Unfit, UnfitError
from maestra.web.teach.desk import Kept, new_seed
from maestra.web.teach.draft import Draft
from maestra.web.teach.routes import all_drafts

PLACE: Final = "tokens"
MOST_TYPED: Final = 4_000
"""Letters of a list of words."""
MOST_FIELDS: Final = 1_000
"""Of the table: as many as the most tokens with the most properties, and one more of each."""

router: Final = APIRouter(include_in_schema=False)

Lines = Annotated[str, Form(max_length=MOST_TYPED)]
Fields = Annotated[list[str], Form(max_length=MOST_FIELDS)]
Perhaps = Annotated[list[str] | None, Form(max_length=MOST_FIELDS)]
"""Of check boxes: none if none is checked."""
Shown: TypeAlias = Mapping[str, Digest]


@router.get("/teach/{draft}/tokens")
def tokens(bench: AtBench, draft: str, why: WhyNot = "") -> HTMLResponse:
    """What is on the tokens, where they lie, how large the board is."""
    return _page(bench, bench.desk.find(draft), why)


@router.post("/teach/pictures")
def begin_with_pictures(bench: AtBench, files: list[UploadFile]) -> Response:
    """A new exercise with somebody's own pictures."""
    try:
        deck, shown = _pictured(bench, files, (), {})
        draft = new_draft(deck, decks.board_for(deck), new_seed())
        draft = Draft(deck, draft.showing, draft.seed, pictures=shown)
        kept = bench.desk.add(draft)
    except InvalidError as error:
        return all_drafts(bench, fault=_line(bench, error))
    except CannotError as error:
        return RedirectResponse(f"/teach?why={error.why.value}", 303)
    return RedirectResponse(path_of(kept.id), 303)


@router.post("/teach/{draft}/tokens/numbers")
def numbers(
    bench: AtBench,
    draft: str,
    first: Annotated[int, Form()],
    last: Annotated[int, Form()],
    step: Annotated[int, Form()] = 1,
) -> Response:
    """Numbers from one to another."""
    return _equip(bench, draft, "numbers", lambda: decks.numbers_deck(first, last, step))


@router.post("/teach/{draft}/tokens/list")
def listed(bench: AtBench, draft: str, numbers: Lines = "") -> Response:
    """Just these numbers."""
    return _equip(bench, draft, "list", lambda: decks.listed_deck(numbers))


@router.post("/teach/{draft}/tokens/letters")
def letters(bench: AtBench, draft: str, letters: Lines = "") -> Response:
    """Just these letters."""
    return _equip(bench, draft, "letters", lambda: decks.letters_deck(letters))


@router.post("/teach/{draft}/tokens/words")
def words(bench: AtBench, draft: str, words: Lines = "") -> Response:
    """Words, perhaps with what kind of thing each is."""
    return _equip(bench, draft, "words", lambda: decks.words_deck(words))


@router.post("/teach/{draft}/tokens/shapes")
def shapes(bench: AtBench, draft: str, colour: Perhaps = None, shape: Perhaps = None) -> Response:
    """Each of the colours in each of the shapes."""
    return _equip(bench, draft, "shapes", lambda: decks.shapes_deck(colour or [], shape or []))


@router.post("/teach/{draft}/tokens/pictures")
def more_pictures(bench: AtBench, draft: str, files: list[UploadFile]) -> Response:
    """Pictures of one's own, besides those that are there."""
    kept = bench.desk.find(draft)
    try:
        deck, shown = _pictured(bench, files, kept.draft.deck.tokens, kept.draft.pictures)
    except InvalidError as error:
        return _page(bench, kept, fault=("pictures", _line(bench, error)))
    return _equip(bench, draft, "pictures", lambda: deck, shown)


@router.post("/teach/{draft}/tokens/table")
def table(
    bench: AtBench,
    draft: str,
    property: Fields,  # noqa: A002 - as the form calls it
    value: Fields,
    ordered: Perhaps = None,
    words: Lines = "",
) -> Response:
    """What each token shows, as it stands in the table."""
    wide = len(property)
    rows = tuple(
        ("", tuple(value[k : k + wide])) for k in range(0, len(value) - wide + 1, wide or 1)
    )
    called = _called(bench.pages.language)
    names = tuple(called.get(name.strip().casefold(), name.strip()) for name in property)
    marked = frozenset(name for k, name in enumerate(names) if str(k) in (ordered or ()))
    typed = decks.Table(names, marked, rows, tuple(words.split()))
    now = bench.desk.find(draft).draft
    shown = _renamed(now.pictures, decks.table_of(now.deck), typed)
    return _equip(bench, draft, "table", lambda: decks.deck_of(typed), shown)


@router.post("/teach/{draft}/tokens/board")
def board(
    bench: AtBench,
    draft: str,
    rows: Annotated[int, Form()],
    columns: Annotated[int, Form()],
    goal: Annotated[str, Form(max_length=10)] = "first",
) -> Response:
    """How large the board is, and on which side its goal row."""
    kept = bench.desk.find(draft)
    now = kept.draft
    try:
        wanted = decks.sized(rows, columns, goal_at_the_end=goal == "last")
    except InvalidError:
        line = bench.pages.say(
            "Please take 2 to {rows} rows and 1 to {columns} columns.",
            rows=decks.MOST_ROWS,
            columns=decks.MOST_COLUMNS,
        )
        return _page(bench, kept, fault=("board", line))
    return bench.change(draft, lambda _: Equip(now.deck, wanted, now.pictures), PLACE)


@router.post("/teach/{draft}/tokens/move")
def lay_out(bench: AtBench, draft: str, cell: CellText, token: TokenText = "") -> Response:
    """A token begins elsewhere."""
    return bench.change(
        draft, lambda now: pressed(now, now.showing.now, cell, token, LayOut), PLACE
    )


@router.post("/teach/{draft}/tokens/deal")
def deal(bench: AtBench, draft: str) -> Response:
    """All tokens begin elsewhere in storage."""
    return bench.change(draft, lambda _: Deal(), PLACE)


@router.post("/teach/{draft}/tokens/again")
def again(bench: AtBench, draft: str) -> Response:
    """A new exercise with these tokens, of which nothing was shown."""
    now = bench.desk.find(draft).draft
    try:
        fresh = new_draft(now.deck, now.board, new_seed())
        kept = bench.desk.add(Draft(fresh.deck, fresh.showing, fresh.seed, pictures=now.pictures))
    except CannotError as error:
        return RedirectResponse(f"{path_of(draft, PLACE)}?why={error.why.value}", 303)
    return RedirectResponse(path_of(kept.id, PLACE), 303)


def _equip(
    bench: Bench,
    draft: str,
    field: str,
    made: Callable[[], Deck],
    shown: Shown | None = None,
) -> Response:
    """Take the deck that was made; what is wrong with it is said where it was written."""
    kept = bench.desk.find(draft)
    try:
        deck = made()
        board = decks.board_for(deck, kept.draft.board)
    except InvalidError as error:
        return _page(bench, kept, fault=(field, _line(bench, error)))
    return bench.change(draft, lambda _: Equip(deck, board, shown or {}), PLACE)


def _pictured(
    bench: Bench, files: Sequence[UploadFile], tokens: Sequence[Token], shown: Shown
) -> tuple[Deck, Shown]:
    """The tokens with pictures that were there, and one for each file.

    Raises:
        InvalidError: a file that is no picture or too large; too many files or tokens.
    """
    chosen = [file for file in files if file.filename]
    if not 0 < len(chosen) <= pictures.MOST_AT_ONCE:
        expected = f"1 to {pictures.MOST_AT_ONCE} pictures"
        raise UnfitError(Unfit.TOO_MANY_FILES, Fault("files", f"{len(chosen)} files", expected))
    # All are looked at before one is kept; a byte more than is allowed tells that it is too large.
    found = [
        (
            file.filename or "",
            pictures.stored(file.file.read(pictures.MOST_BYTES + 1), file.filename or ""),
        )
        for file in chosen
    ]
    taken, names = dict(shown), list[str]()
    store = Drafts(bench.context.store)
    for file, picture in found:
        name = _free(pictures.name_of(file), taken)
        taken[name] = store.keep_picture(picture)
        names.append(name)
    return decks.pictures_deck(names, tokens), taken


def _free(name: str, taken: Shown) -> str:
    """The name, with a number if another picture has it."""
    if name not in taken:
        return name
    number = 2
    while f"{name} {number}" in taken:
        number += 1
    return f"{name} {number}"


def _renamed(shown: Shown, before: decks.Table, after: decks.Table) -> Shown:
    """The pictures by what they are called now, line by line."""
    if decks.PICTURE not in before.properties or decks.PICTURE not in after.properties:
        return shown
    old, new = (one.properties.index(decks.PICTURE) for one in (before, after))
    lines = zip(before.rows, after.rows, strict=False)
    names = ((was[old], now[new].strip()) for (_, was), (_, now) in lines)
    return {name: shown[was] for was, name in names if was in shown and name}


def _called(language: Language) -> Mapping[str, str]:
    """What known properties are called in a language, to their names."""
    words = words_of(language).attributes
    return {one.noun.casefold(): name for name, one in reversed(list(words.items()))}


def _line(bench: Bench, error: InvalidError) -> str:
    """What is wrong, in one sentence."""
    say, fault = bench.pages.say, error.faults[0]
    match error.why if isinstance(error, UnfitError) else None:
        case None:
            return say("Please write at least one token, and each property once.")
        case Unfit.NO_NUMBER:
            return say("“{found}” is no number.", found=fault.found)
        case Unfit.TOO_LONG:
            return say("“{found}” is too long.", found=fault.found)
        case Unfit.TOO_MANY_TOKENS:
            return say("That is too much: at most {count} tokens.", count=decks.MOST_TOKENS)
        case Unfit.TOO_MANY_PROPERTIES:
            most = decks.MOST_PROPERTIES
            return say("That is too much: at most {count} properties.", count=most)
        case Unfit.TOO_MANY_FILES:
            most = pictures.MOST_AT_ONCE
            return say("Please choose 1 to {count} pictures at a time.", count=most)
        case Unfit.LARGE_FILE:
            size = pictures.MOST_BYTES // 2**20
            return say("{file} is larger than {size} MB.", file=fault.where, size=size)
        case Unfit.NO_PICTURE:
            return say("{file} is no PNG, JPEG, WebP or GIF.", file=fault.where)
        case Unfit.LARGE_PICTURE:
            return say("{file} has more dots than a page can show.", file=fault.where)
        case _ as never:
            assert_never(never)


def _page(
    bench: Bench, kept: Kept, why: str = "", *, fault: tuple[str, str] = ("", "")
) -> HTMLResponse:
    draft = kept.draft
    say = bench.pages.say
    return bench.page(
        "teach/tokens.html",
        kept,
        why,
        422 if fault[0] else 200,
        board_view=bench.views(kept).board(draft.showing.now, held=True),
        in_use=bool(draft.steps or draft.showing.moves),
        table=decks.table_of(draft.deck),
        nouns={name: one.noun for name, one in words_of(bench.pages.language).attributes.items()},
        colours=decks.COLOURS,
        colour_names={
            "red": say("red"),
            "blue": say("blue"),
            "green": say("green"),
            "yellow": say("yellow"),
        },
        shapes=decks.shapes(say),
        rows=draft.board.rows,
        columns=draft.board.columns,
        goal_last=draft.board.goal_row > 1,
        megabytes=pictures.MOST_BYTES // 2**20,
        spare=decks.SPARE_ROWS,
        fault_at=fault[0],
        fault=fault[1],
    )
