"""The page where a caregiver says beforehand what counts: the interface of the paper."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Annotated, Final, assert_never

from fastapi import APIRouter, Form
from fastapi.responses import HTMLResponse, Response

from maestra.core.board import Board
from maestra.core.tokens import Deck, TokenId
from maestra.language import Language, feature_of_token
from maestra.language.languages import speaker_for
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
from maestra.rules.registry import CELL_FEATURES, IS, PAIR_FEATURES, TOKEN_FEATURES
from maestra.web.board_view import tokens_by_id
from maestra.web.pages import Pages
from maestra.web.teach.actions import Choose
from maestra.web.teach.bench import AtBench, Bench, WhyNot
from maestra.web.teach.desk import Kept
from maestra.web.teach.parameters import offered

PLACE: Final = "features"
MOST_CHOSEN: Final = 500
"""More than there are boxes for six attributes; learning by 240 features takes 0.15 s."""
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
    other: str = ""
    """A token that has it not."""


@dataclass(frozen=True, slots=True)
class KindView:
    """Boxes for one kind of features that have a parameter."""

    text: str
    features: tuple[FeatureView, ...]


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
    # What counts, or would if nobody said anything.
    chosen = select_features(draft.deck, draft.features)
    boxes = _Boxes.of(bench.pages, draft.deck, chosen)
    kinds = tuple(boxes.with_parameters())
    return bench.page(
        "teach/features.html",
        kept,
        why,
        422 if fault else 200,
        of_tokens=tuple(boxes.named(TOKEN_FEATURES)),
        of_kinds=kinds,
        some_kind_chosen=any(one.chosen for kind in kinds for one in kind.features),
        of_pairs=tuple(boxes.named((*PAIR_FEATURES, *draft.deck.relations))),
        of_cells=tuple(_of_cells(language, boxes.chosen)),
        is_chosen=draft.features is not None,
        understood=bench.views(kept).understanding() if draft.features is not None else None,
        fault=fault,
    )


def _of_cells(language: Language, chosen: frozenset[Feature]) -> Iterator[FeatureView]:
    """Those of a move's cells, without those that always count."""
    for one in map(CellFeature, CELL_FEATURES):
        if one not in FRAME:
            text = feature_words(one.name, language)
            yield FeatureView(one.label, text, "", one in chosen)


@dataclass(frozen=True, slots=True)
class _Boxes:
    """Makes the boxes for the features of one deck's tokens."""

    pages: Pages
    deck: Deck
    names: Mapping[TokenId, str]
    chosen: frozenset[Feature]

    @classmethod
    def of(cls, pages: Pages, deck: Deck, chosen: Iterable[Feature]) -> _Boxes:
        """For a deck, of whose features some are chosen."""
        views = tokens_by_id(deck, _BOARD, pages.language)
        names = {token: view.name for token, view in views.items()}
        return cls(pages, deck, names, frozenset(chosen))

    def named(self, names: Iterable[str]) -> Iterator[FeatureView]:
        """Those without a parameter, over each attribute that they apply to."""
        for name in names:
            try:
                found = select_features(self.deck, [name])
            except UnknownFeatureError:
                continue
            of_tokens = [one for one in found if not isinstance(one, CellFeature)]
            for feature in of_tokens:
                yield self._box(feature, is_one_of_many=len(of_tokens) > 1)

    def with_parameters(self) -> Iterator[KindView]:
        """Those with one, by their kind."""
        chosen = sorted(one for one in self.chosen if isinstance(one, TokenFeature))
        for kind, features in offered(self.deck, chosen).items():
            boxes = tuple(self._box(feature) for feature in features)
            yield KindView(_kind_words(kind, self.pages), boxes)

    def _box(
        self, feature: TokenFeature | PairFeature, *, is_one_of_many: bool = False
    ) -> FeatureView:
        language = self.pages.language
        is_chosen = feature in self.chosen
        match feature:
            case TokenFeature():
                says = feature_of_token(feature, _BOARD, self.deck, language)
                text = self.pages.say("it {says}", says=says)
                examples, other = self._tokens(feature)
                return FeatureView(feature.label, text, examples, is_chosen, other)
            case PairFeature(name, attribute):
                words = speaker_for(language, _BOARD, self.deck).attribute(attribute)
                about = f" ({words.noun})" if is_one_of_many else ""
                text = f"{feature_words(name, language)}{about}"
                return FeatureView(feature.label, text, self._pairs(feature), is_chosen)
            case _:
                assert_never(feature)

    def _tokens(self, feature: TokenFeature) -> tuple[str, str]:
        """A few tokens that have it, and one that has not; one of each where there are many boxes.

        Nothing where the one token that has it is named by the feature itself.
        """
        having: list[str] = []
        lacking: list[str] = []
        for token in self.deck.tokens:
            holds = token_feature_holds(feature, token.attributes)
            (having if holds else lacking).append(self.names[token.id])
        if feature.name.startswith(f"{IS}-") and len(having) == 1:
            return "", ""
        most = EXAMPLES if feature.name in TOKEN_FEATURES else 1
        return ", ".join(having[:most]), next(iter(lacking), "")

    def _pairs(self, feature: PairFeature) -> str:
        """A few pairs of which it is true."""
        pairs = (
            f"{self.names[one.id]} – {self.names[other.id]}"
            for one in self.deck.tokens
            for other in self.deck.tokens
            if one.id != other.id
            and pair_feature_holds(feature, self.deck, one.attributes, other.attributes)
        )
        return ", ".join(islice(pairs, EXAMPLES))


def _kind_words(kind: str, pages: Pages) -> str:
    words = {
        "multiple-of": pages.say("The multiples of a number"),
        "digits": pages.say("How many digits it has"),
        "above": pages.say("Above a number"),
        "below": pages.say("Below a number"),
        IS: pages.say("Just one value"),
    }
    return words[kind]
