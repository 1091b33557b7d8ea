import ast
import re
from collections import Counter
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from string import Formatter

import pytest
from babel.messages.pofile import read_po
from jinja2 import Environment
from jinja2.ext import extract_from_ast

from maestra.language import Language
from maestra.web.library.included import INCLUDED_NAMES
from maestra.web.translations import CATALOGUES, UntranslatedError, texts, translate

WEB = Path(str(files("maestra.web")))
AREAS = {
    *("shared", "access", "board", "teach", "library"),
    *("patients", "sessions", "progress", "patient"),
}
SAYING = {"say", "translate", "_"}
"""What Python calls with a text of the catalogues."""
HELP = "help/"
"""The help is written whole in each language: a page each, not texts to be filled in."""
TEMPLATES = sorted(
    name
    for one in (WEB / "templates").rglob("*.html")
    if not (name := str(one.relative_to(WEB / "templates"))).startswith(HELP)
)


def of_templates() -> Iterator[str]:
    reader = Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True)
    for template in WEB.rglob("*.html"):
        parsed = reader.parse(template.read_text("utf-8"))
        for _, _, text in extract_from_ast(parsed, gettext_functions=("_",)):
            # With gaps a tuple whose first is the text; None where what is said comes from Python.
            first = text[0] if isinstance(text, tuple) else text
            if isinstance(first, str):
                yield first


def of_python() -> Iterator[str]:
    for node in nodes_of_python():
        if isinstance(node, ast.Call) and _name(node.func) in SAYING:
            texts_said = (one for one in node.args if isinstance(one, ast.Constant))
            yield from (one.value for one in texts_said if isinstance(one.value, str))


def nodes_of_python() -> Iterator[ast.AST]:
    for module in WEB.rglob("*.py"):
        yield from ast.walk(ast.parse(module.read_text("utf-8")))


def _name(called: ast.expr) -> str:
    match called:
        case ast.Name(name) | ast.Attribute(attr=name):
            return name
        case _:
            return ""


USED = frozenset(of_templates()) | frozenset(of_python())
# Tables in Python hold texts that are said later; the paper's titles stand with its rules.
MENTIONED = frozenset(INCLUDED_NAMES) | {
    one.value
    for one in nodes_of_python()
    if isinstance(one, ast.Constant) and isinstance(one.value, str)
}


def gaps(text: str) -> Counter[str]:
    return Counter(name for _, name, _, _ in Formatter().parse(text) if name is not None)


@pytest.mark.parametrize("language", Language)
def test_each_text_is_there_once_and_none_is_superfluous(language: Language) -> None:
    there = set(texts(language))
    assert sorted(USED - there) == []
    assert sorted(there - USED - MENTIONED) == []


@pytest.mark.parametrize("language", Language)
def test_each_text_has_the_gaps_of_its_english_sentence(language: Language) -> None:
    different = {
        key: text for key, text in texts(language).items() if set(gaps(key)) != set(gaps(text))
    }
    assert different == {}


@pytest.mark.parametrize("language", Language)
def test_no_text_is_empty_or_has_spaces_around_it(language: Language) -> None:
    assert [key for key, text in texts(language).items() if not text or text != text.strip()] == []


def test_the_english_text_is_its_own_key() -> None:
    assert {key: text for key, text in texts(Language.EN).items() if key != text} == {}


@pytest.mark.parametrize("language", [Language.ES, Language.CA])
def test_most_texts_are_translated(language: Language) -> None:
    """A few words are the same in two languages; whole sentences never are."""
    same = [key for key, text in texts(language).items() if key == text and len(key.split()) > 3]
    assert same == []


@pytest.mark.parametrize("language", Language)
def test_the_catalogues_of_each_language_are_of_the_same_areas(language: Language) -> None:
    names = {one.name for one in (CATALOGUES / language.value).iterdir()}
    assert names <= {f"{area}.po" for area in AREAS}
    assert names == {one.name for one in (CATALOGUES / "en").iterdir()}


@pytest.mark.parametrize("language", Language)
def test_each_area_has_the_same_texts_in_each_language(language: Language) -> None:
    assert {area: keys(language, area) for area in areas()} == {
        area: keys(Language.EN, area) for area in areas()
    }


def areas() -> list[str]:
    return sorted(one.name for one in (CATALOGUES / "en").iterdir())


def keys(language: Language, area: str) -> set[str]:
    with (CATALOGUES / language.value / area).open("rb") as file:
        return {str(one.id) for one in read_po(file) if one.id}


@pytest.mark.parametrize("template", TEMPLATES)
def test_no_template_has_text_that_is_not_in_the_catalogues(template: str) -> None:
    """What is left between the tags when all that Jinja fills in is away is no word."""
    bare = re.sub(
        r"\{#.*?#\}|\{%.*?%\}|\{\{.*?\}\}",
        " ",
        (WEB / "templates" / template).read_text("utf-8"),
        flags=re.DOTALL,
    )
    # Attributes may stand in a macro of their own; addresses and code are typed as they are.
    tags = re.sub(r'"[^"]*"|[\w-]+=|<code>.*?</code>|>/\w+<', " ", bare)
    words = re.findall(r"[^\W\d_]{2,}", re.sub(r"<[^>]*>", " ", tags))
    assert set(words) <= {"Maestra", "hidden"}  # an attribute that a macro of the patient's makes


def test_a_text_that_is_nowhere_is_refused() -> None:
    with pytest.raises(UntranslatedError, match="ca: Never written"):
        translate(Language.CA, "Never written")
