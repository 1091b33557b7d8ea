"""Rules as JSON, as bits and as pictures: laws that every form keeps."""

from __future__ import annotations

import json
from collections.abc import Iterable
from decimal import Decimal
from math import isfinite
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from maestra.core.faults import InvalidError
from maestra.core.json_lines import FormatError
from maestra.core.tokens import TokenId
from maestra.rules.description import FORMS as BITS
from maestra.rules.description import description_length
from maestra.rules.fields import MEANINGS
from maestra.rules.forms.base import Form
from maestra.rules.pictures import (
    Arrow,
    Badge,
    Balance,
    Choice,
    Implication,
    Place,
    Selection,
    Stroke,
    Succession,
    Tally,
    Turn,
    picture,
)
from maestra.rules.rule_json import (
    RulesJson,
    decode_rule,
    decode_rules,
    encode_rule,
    encode_rules,
)
from maestra.rules.setting import Setting
from tests.rules.rule_strategies import FORMS, RULES, decks, rules_for, settings_with

SCHEMA: dict[str, Any] = RulesJson.model_json_schema()
VALIDATOR: Any = Draft202012Validator(SCHEMA)


@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.__name__)
@settings(max_examples=20)
@given(data=st.data())
def test_a_rule_survives_json_and_the_schema_takes_it(
    form: type[Form], data: st.DataObject
) -> None:
    setting = data.draw(settings_with(data.draw(decks())))
    rule = data.draw(RULES[form](setting.deck, setting.start.board))
    text = json.dumps(encode_rule(rule))
    assert text.startswith('{"form": ')
    assert decode_rule(json.loads(text, parse_float=Decimal)) == rule
    VALIDATOR.validate({"format": "maestra.rules/1", "rules": [json.loads(text)]})


@given(st.data())
def test_a_file_of_rules_survives(data: st.DataObject) -> None:
    setting = data.draw(settings_with(data.draw(decks())))
    rules = data.draw(st.lists(rules_for(setting.deck, setting.start.board), max_size=4))
    assert list(decode_rules(encode_rules(rules).encode())) == rules


@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.__name__)
@settings(max_examples=20)
@given(data=st.data())
def test_a_rule_costs_what_its_form_costs_and_more(form: type[Form], data: st.DataObject) -> None:
    setting = data.draw(settings_with(data.draw(decks())))
    rule = data.draw(RULES[form](setting.deck, setting.start.board))
    bits = description_length(rule, setting)
    assert isfinite(bits)
    assert bits >= BITS[form]


@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.__name__)
@settings(max_examples=20)
@given(data=st.data())
def test_a_picture_speaks_of_the_board_and_the_deck(form: type[Form], data: st.DataObject) -> None:
    setting = data.draw(settings_with(data.draw(decks())))
    rule = data.draw(RULES[form](setting.deck, setting.start.board))
    check_strokes(picture(rule, setting), setting)


def check_strokes(strokes: Iterable[Stroke], setting: Setting) -> None:
    places: list[Place] = []
    tokens: list[TokenId] = []
    for stroke in strokes:
        match stroke:
            case Arrow(start, end):
                places += [start, end]
            case Choice(place, ids):
                places.append(place)
                tokens += ids
            case Badge(place):
                places.append(place)
            case Selection(ids) | Tally(_, _, ids):
                tokens += ids
            case Succession(sets):
                tokens += [token for ids in sets for token in ids]
            case Balance(first, _, second):
                tokens += [*first, *second]
            case Implication(condition, consequence):
                check_strokes((*condition, *consequence), setting)
    assert set(tokens) <= set(setting.deck.by_id)
    assert all(is_on(place, setting) for place in places)


def is_on(place: Place, setting: Setting) -> bool:
    if isinstance(place, Turn):
        return place.number == -1 or 1 <= place.number <= setting.length
    return place in setting.start.board


def test_every_field_of_every_form_is_explained() -> None:
    for part in SCHEMA["$defs"].values():
        for name, field in part.get("properties", {}).items():
            assert field["description"] == MEANINGS[name]


FAULTS = {
    '{"form": "x"}': ["form"],
    "{}": ["form"],
    "5": [""],
    '{"form": "ordered"}': ["attribute"],
    '{"form": "ordered", "attribute": 3, "x": 1}': ["attribute", "x"],
    '{"form": "ordered", "attribute": "v", "strict": "yes", "line": 1}': ["strict", "line"],
    '{"form": "pattern", "tests": []}': ["tests"],
    '{"form": "template", "attribute": "v", "letters": ""}': ["letters"],
    '{"form": "equation", "attribute": "v", "left": []}': ["left"],
    '{"form": "equation", "attribute": "v", "left": [1, true]}': ["left[1]"],
    '{"form": "equation", "attribute": "v", "left": [1, 2, 3], "right": [4, 5]}': ["right"],
    '{"form": "at", "position": -2, "test": {"test": "anything"}, "line": "time"}': ["position"],
    '{"form": "count", "test": {"test": "anything"}, "comparison": "equal", "number": -1}': [
        "number"
    ],
    '{"form": "total", "attribute": "v", "comparison": "equal", "number": "3"}': ["number"],
    '{"form": "total", "attribute": "v", "comparison": "equal", "number": true}': ["number"],
    '{"form": "each-pair", "pairs": "mirrored", "line": "time", "relation": {"relation": '
    '"compare", "attribute": "v", "comparison": "equal"}}': ["pairs"],
    '{"form": "every-token", "test": {"test": "not", "of": {"test": "has"}}}': ["test.of.feature"],
    '{"form": "every-token", "test": {"test": "not", "of": {"test": "perhaps"}}}': [
        "test.of.test"
    ],
    '{"form": "take-extreme", "attribute": "v", "extreme": "lowest", "among": {"test": "not"}}': [
        "among.of"
    ],
    '{"form": "every-token", "test": {"test": "has", "feature": {"name": "odd"}}}': [
        "test.feature"
    ],
    '{"form": "every-token", "test": {"test": "has", "feature": 3}}': ["test.feature"],
    '{"form": "every-token", "test": {"test": "has", "feature": {"name": "oddly", '
    '"attribute": "v"}}}': ["test.feature"],
    '{"form": "pattern", "tests": [{"test": "anything"}, {"test": "not"}]}': ["tests[1].of"],
}


@pytest.mark.parametrize("written", FAULTS)
def test_a_wrong_rule_is_refused_with_its_place(written: str) -> None:
    with pytest.raises(InvalidError) as caught:
        decode_rule(json.loads(written))
    assert [fault.where for fault in caught.value.faults] == FAULTS[written]


@pytest.mark.parametrize("written", FAULTS)
def test_a_file_with_a_wrong_rule_is_refused_with_its_place(written: str) -> None:
    text = f'{{"format": "maestra.rules/1", "rules": [{written}]}}'
    with pytest.raises(FormatError) as caught:
        decode_rules(text.encode(), "rules.json")
    places = [f"rules[0].{place}" if place else "rules[0]" for place in FAULTS[written]]
    assert [fault.where for fault in caught.value.faults] == places
