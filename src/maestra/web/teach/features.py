"""The page where a caregiver says beforehand what counts: the interface of the paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Annotated, Final

from fastapi import APIRouter, Form
from fastapi.responses import HTMLResponse, Response

from maestra.core.board import Board
from maestra.core.tokens import Deck
from maestra.language import Language
from maestra.language.terminal import feature_words
from maestra.rules.features import (
    FRAME,
    CellFeature,
    Feature,
    PairFeature,
    TokenFeature,
    UnknownFeatureError,
    pair_feature_holds,
    select_features,
    token_feature_holds,
)
from maestra.rules.registry import CELL_FEATURES, PAIR_FEATURES, TOKEN_FEATURES
from maestra.web.board_view import tokens_by_id
from maestra.web.teach.actions import Choose
from maestra.web.teach.bench import AtBench, Bench, WhyNot
from maestra.web.teach.desk import Kept

PLACE: Final = "features"
MOST_CHOSEN: Final = 40
_BOARD: Final = Board()
EXAMPLES: Final = 3
"""Tokens, or pairs of them, that show what a feature means."""

router: Final = APIRouter(include_in_schema=False)


@dataclass(frozen=True, slots=True)
class FeatureView:
    """A box to check."""

    name: str
    text: str
    examples: str
    chosen: bool


@router.get("/teach/{draft}/features")
def features(bench: AtBench, draft: str, why: WhyNot = "") -> HTMLResponse:
    """What may count, each with examples from the tokens that are there."""
    return _page(bench, bench.desk.find(draft), why)


@router.post("/teach/{draft}/features")
def choose(
    bench: AtBench,
    draft: str,
    feature: Annotated[list[str] | None, Form(max_length=MOST_CHOSEN)] = None,
) -> Response:
    """Only these count."""
    kept = bench.desk.find(draft)
    try:
        select_features(kept.draft.deck, feature or [])
    except UnknownFeatureError:
        line = bench.pages.say("That cannot count with these tokens. Please choose again.")
        return _page(bench, kept, fault=line)
    return bench.change(draft, lambda _: Choose(tuple(feature or ())), PLACE)


@router.post("/teach/{draft}/features/none")
def leave_open(bench: AtBench, draft: str) -> Response:
    """Maestra finds out by itself what counts."""
    return bench.change(draft, lambda _: Choose(None), PLACE)


def _page(bench: Bench, kept: Kept, why: str = "", fault: str = "") -> HTMLResponse:
    draft, language = kept.draft, bench.pages.language
    chosen = draft.features
    names = _chosen(draft.deck, chosen)
    views = list(_offered(draft.deck, language, names))
    return bench.page(
        "teach/features.html",
        kept,
        why,
        422 if fault else 200,
        of_tokens=[one for kind, one in views if kind is TokenFeature],
        of_pairs=[one for kind, one in views if kind is PairFeature],
        of_cells=[one for kind, one in views if kind is CellFeature],
        is_chosen=chosen is not None,
        understood=bench.views(kept).understanding() if chosen is not None else None,
        fault=fault,
    )


def _chosen(deck: Deck, names: tuple[str, ...] | None) -> frozenset[str]:
    """The labels of the features that count, or would if nobody said anything."""
    return frozenset(one.label for one in select_features(deck, names))


def _offered(
    deck: Deck, language: Language, chosen: frozenset[str]
) -> Iterator[tuple[type[Feature], FeatureView]]:
    """All features of these tokens, without those that always count."""
    for name in (*TOKEN_FEATURES, *PAIR_FEATURES, *deck.relations):
        yield from _of_tokens(name, deck, language, chosen)
    always = {one.name for one in FRAME}
    for name in CELL_FEATURES:
        if name not in always:
            text = feature_words(name, language)
            yield CellFeature, FeatureView(name, text, "", name in chosen)


def _of_tokens(
    name: str, deck: Deck, language: Language, chosen: frozenset[str]
) -> Iterator[tuple[type[Feature], FeatureView]]:
    """A feature over each attribute that it applies to."""
    try:
        found = select_features(deck, [name])
    except UnknownFeatureError:
        return
    own = [one for one in found if not isinstance(one, CellFeature)]
    for feature in own:
        about = f" ({feature.attribute})" if len(own) > 1 else ""
        text = f"{feature_words(name, language)}{about}"
        examples = _examples(feature, deck, language)
        yield type(feature), FeatureView(feature.label, text, examples, feature.label in chosen)


def _examples(feature: TokenFeature | PairFeature, deck: Deck, language: Language) -> str:
    """A few tokens that have it, or pairs."""
    from_deck = tokens_by_id(deck, _BOARD, language)
    names = {token.id: from_deck[token.id].name for token in deck.tokens}
    if isinstance(feature, TokenFeature):
        having = (t for t in deck.tokens if token_feature_holds(feature, t.attributes))
        return ", ".join(names[one.id] for one in islice(having, EXAMPLES))
    pairs = (
        f"{names[one.id]} – {names[other.id]}"
        for one in deck.tokens
        for other in deck.tokens
        if one.id != other.id
        and pair_feature_holds(feature, deck, one.attributes, other.attributes)
    )
    return ", ".join(islice(pairs, EXAMPLES))
