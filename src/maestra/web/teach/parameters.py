"""Which features with a parameter a deck's tokens can be told apart by: the boxes of a page.

There are as many as there are numbers; a few of each kind are offered, at values that divide the
tokens into those that have the feature and those that have not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import ROUND_HALF_UP, Decimal
from types import MappingProxyType
from typing import Final

from maestra.core.tokens import Deck, Value
from maestra.rules.features import TokenFeature, token_feature_holds
from maestra.rules.registry import IS, MAX_DIGITS, PARAMETER_FEATURES

DIVISORS: Final = (3, 5, 10)
"""What people count in; of 2 the feature is ``even``."""
MOST_LIMITS: Final = 3
"""Numbers to be above or below, of one attribute: the deck in quarters."""
MOST_VALUES: Final = 12
"""Values that a token may just have, of one attribute: of more each says too little."""


def offered(deck: Deck, chosen: Iterable[TokenFeature]) -> Mapping[str, tuple[TokenFeature, ...]]:
    """The features to offer, by their kind; kinds of which there is none are left out.

    Args:
        deck: the tokens.
        chosen: what counts already; it is offered at any value.
    """
    kinds = {kind: tuple(_of_kind(kind, deck, tuple(chosen))) for kind in PARAMETER_FEATURES}
    return MappingProxyType({kind: found for kind, found in kinds.items() if found})


def _of_kind(kind: str, deck: Deck, chosen: Sequence[TokenFeature]) -> Iterator[TokenFeature]:
    """Those of one kind over each attribute, then what was chosen besides."""
    definition = PARAMETER_FEATURES[kind]
    found: list[TokenFeature] = []
    for attribute, scale in deck.scales.items():
        if scale in definition.scales:
            shown = [token.value(attribute) for token in deck.tokens]
            values = [value for value in shown if value is not None]
            fitting = filter(definition.accepts, PARAMETERS[kind](values))
            found += (TokenFeature(f"{kind}-{parameter}", attribute) for parameter in fitting)
    yield from (one for one in found if _divides(one, deck))
    yield from (one for one in chosen if one.name.startswith(f"{kind}-") and one not in found)


def _divides(feature: TokenFeature, deck: Deck) -> bool:
    """Whether some tokens have it and some have not."""
    having = {token_feature_holds(feature, token.attributes) for token in deck.tokens}
    return len(having) > 1


# ---------------------------------------------------------------- values


def _divisors(_values: Sequence[Value]) -> Sequence[str]:
    return [str(number) for number in DIVISORS]


def _lengths(values: Sequence[Value]) -> Sequence[str]:
    """As many digits as whole numbers have."""
    lengths = {len(str(abs(value))) for value in values if isinstance(value, int)}
    return [str(length) for length in sorted(lengths)]


def _limits(values: Sequence[Value]) -> Sequence[str]:
    """Round numbers near those that divide the tokens into quarters."""
    ordered = sorted({Decimal(value) for value in values})
    parts, count = MOST_LIMITS + 1, len(ordered)
    near = count // (2 * parts)
    ends = [end for part in range(1, parts) if (end := count * part // parts) > 0]
    limits = (roundest(ordered[end - 1 - near], ordered[end + near]) for end in ends)
    return [_written(limit) for limit in dict.fromkeys(limits)]


def _values(values: Sequence[Value]) -> Sequence[str]:
    """All that are shown, if they are few: of numbers the least first."""
    apart = dict.fromkeys(values)
    if len(apart) > MOST_VALUES:
        return []
    numbers = sorted(value for value in apart if not isinstance(value, str))
    return [str(value) for value in (numbers if len(numbers) == len(apart) else apart)]


PARAMETERS: Final[Mapping[str, Callable[[Sequence[Value]], Sequence[str]]]] = MappingProxyType(
    {
        "multiple-of": _divisors,
        "digits": _lengths,
        "above": _limits,
        "below": _limits,
        IS: _values,
    }
)
"""What makes sense after the name of each kind, by what an attribute's tokens show."""


def roundest(low: Decimal, high: Decimal) -> Decimal:
    """A number from `low` to `high`, about the middle, that ends in as many zeros as any there."""
    middle = (low + high) / 2
    steps = (Decimal(1).scaleb(exponent) for exponent in range(MAX_DIGITS, -MAX_DIGITS, -1))
    rounded = ((middle / step).to_integral_value(ROUND_HALF_UP) * step for step in steps)
    return next((number for number in rounded if low <= number <= high), low)


def _written(number: Decimal) -> str:
    """Without an exponent, and zero without a sign."""
    return format((number + 0).normalize(), "f")
