import io
import re
import zipfile
from collections.abc import Callable
from dataclasses import replace
from html import unescape
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.formats import read_demonstrations
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language
from maestra.learning.grounded import learn_grounded
from maestra.rules.completability import Completable, Conjunction
from maestra.rules.exercise import Evidence
from maestra.rules.exercise_format import decode_exercise, encode_exercise
from maestra.rules.forms.counting import Total
from maestra.rules.forms.length import FullRow
from maestra.rules.paper import NUMBER_DECK
from maestra.rules.paper_rules import paper_exercise
from maestra.rules.setting import Play, Setting
from maestra.rules.telling import dealt, told_exercise
from maestra.rules.token_tests import Comparison
from maestra.storage.shelf import Shelf, Source
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.library.collection import exercise_id, titles
from maestra.web.library.files import MOST_BYTES, fresh, title_of, zipped_pddl
from maestra.web.library.included import INCLUDED, Included, first_start

Login = Callable[[Role], TestClient]
UTC = "2026-05-04T12:00:00+00:00"
CURIE = encode_exercise(paper_exercise("curie"))
TEN = encode_exercise(
    told_exercise(
        (FullRow(), Total("value", Comparison.EQUAL, 10)),
        Board(3, 2),
        Deck(tuple(Token(TokenId(str(one)), (("value", one),)) for one in (3, 4, 6, 7))),
    )
)
"""A sum, which no precondition can say."""


@pytest.fixture
def browser(context: Context, somebody: Login) -> TestClient:
    """A caregiver's, just after the first start."""
    first_start(context.store, UTC)
    return somebody(Role.CAREGIVER)


def bring_in(browser: TestClient, content: bytes, name: str = "Spelling.exercise.json") -> str:
    """The page that shows what came of it."""
    return browser.post("/library/files", files={"file": (name, io.BytesIO(content))}).text


# ---------------------------------------------------------------- what comes with Maestra


@pytest.mark.parametrize("included", INCLUDED, ids=lambda one: one.name)
def test_every_included_exercise_can_be_played_to_its_end(included: Included) -> None:
    exercise = included.exercise
    setting = Setting(exercise.deck, dealt(exercise.deck, exercise.board))
    outlook = Conjunction(exercise.conjunction, setting).outlook(Play.begin(setting))
    assert isinstance(outlook, Completable)


def test_the_first_start_fills_the_library_once(context: Context) -> None:
    first_start(context.store, UTC)
    Shelf(context.store).remove("Spell CURIE", UTC)
    context.store.save_exercise("Count in twos", "changed")
    first_start(context.store, UTC)
    assert len(context.store.exercises()) == len(INCLUDED) - 1
    assert context.store.exercise("Count in twos").exercise == "changed"


@pytest.mark.parametrize("language", Language)
def test_included_exercises_have_a_name_in_each_language(
    context: Context, language: Language
) -> None:
    first_start(context.store, UTC)
    said = titles(context.store, language)
    assert len(set(said.values())) == len(INCLUDED)
    assert (said["Count in twos"] == "Count in twos") is (language is Language.EN)


# ---------------------------------------------------------------- the list


def test_the_list_says_each_exercise_in_the_visitors_language(browser: TestClient) -> None:
    browser.headers["accept-language"] = "es"
    page = browser.get("/library").text
    assert "Cada ficha debe sumar 10 con la de su izquierda." in page
    assert "Los vecinos suman 10" in page


@pytest.mark.parametrize(
    ("search", "found"),
    [
        ("", len(INCLUDED)),
        ("CURIE", 1),
        ("ODD numbers", 1),
        ("exactly 100", 1),
        ("nothing of the kind", 0),
    ],
)
def test_a_search_finds_what_says_all_of_its_words(
    browser: TestClient, search: str, found: int
) -> None:
    page = browser.get("/library", params={"search": search}).text
    assert len(re.findall(r'href="/library/[0-9a-f]{16}"', page)) == found


def test_a_search_without_accents_finds_words_with_them(browser: TestClient) -> None:
    browser.headers["accept-language"] = "es"
    assert "Cinco números impares" in browser.get("/library?search=numeros+impares").text


def test_what_was_removed_can_be_put_back_at_once(browser: TestClient) -> None:
    wanted = exercise_id("Spell CURIE")
    page = browser.post(f"/library/{wanted}/removal").text
    assert "“Spell CURIE” is no longer in the library." in page
    assert len(re.findall(r'<h2><a href="/library/', page)) == len(INCLUDED) - 1
    assert "Put it back" in browser.get(f"/library/{wanted}").text
    browser.post(f"/library/{wanted}/return")
    page = browser.get("/library").text
    assert len(re.findall(r'<h2><a href="/library/', page)) == len(INCLUDED)
    assert "Put it back" not in page


# ---------------------------------------------------------------- one exercise


def test_an_exercise_says_who_taught_it_when_and_how(
    context: Context, browser: TestClient
) -> None:
    source = Source("taught", "somebody who has gone", UTC)
    Shelf(context.store).keep("Mine", CURIE, "", source)
    page = browser.get(f"/library/{exercise_id('Mine')}").text
    assert "Taught by somebody who has left on May 4, 2026" in page
    assert "Make this row: C, U, R, I, E." in page


def test_what_was_taught_elsewhere_has_no_known_source(
    context: Context, browser: TestClient
) -> None:
    context.store.save_exercise("By hand", CURIE)
    page = browser.get(f"/library/{exercise_id('By hand')}").text
    assert "Taught before the library noted by whom" in page


def test_an_exercise_that_cannot_be_read_is_shown_all_the_same(
    context: Context, browser: TestClient
) -> None:
    context.store.save_exercise("Broken", '{"format": "maestra.exercise/9"}')
    assert "It cannot be read here." in browser.get("/library").text
    assert "It cannot be read here." in browser.get(f"/library/{exercise_id('Broken')}").text
    assert browser.get("/api/exercises").json()["exercises"][0]["rules"] == []


def test_an_exercise_gets_another_name_and_keeps_its_versions(
    context: Context, browser: TestClient
) -> None:
    wanted = exercise_id("Spell CURIE")
    page = browser.post(f"/library/{wanted}/title", data={"title": " Madame Curie "}).text
    assert "<h1>Madame Curie</h1>" in page
    assert context.store.exercise("Spell CURIE").version == 1


@pytest.mark.parametrize(
    ("title", "fault"),
    [
        ("", "Please write a name, of at most 100 letters."),
        ("x" * 101, "Please write a name, of at most 100 letters."),
        ("Count in twos", "Another exercise has this name."),
    ],
)
def test_a_name_that_cannot_be_one_is_said_at_its_field(
    browser: TestClient, title: str, fault: str
) -> None:
    answer = browser.post(f"/library/{exercise_id('Spell CURIE')}/title", data={"title": title})
    assert answer.status_code == 422
    assert fault in answer.text


def test_a_duplicate_is_an_exercise_of_its_own(browser: TestClient) -> None:
    page = browser.post(f"/library/{exercise_id('Count in twos')}/copy").text
    assert "<h1>Count in twos (2)</h1>" in page
    assert "Copied by" in page


def test_an_earlier_version_becomes_the_newest(context: Context, browser: TestClient) -> None:
    context.store.save_exercise("Spell CURIE", encode_exercise(paper_exercise("letters")))
    wanted = exercise_id("Spell CURIE")
    assert "There is a newer one." in browser.get(f"/library/{wanted}?version=1").text
    browser.post(f"/library/{wanted}/again", data={"version": 1})
    assert context.store.exercise("Spell CURIE").version == 3
    assert context.store.exercise("Spell CURIE").exercise == CURIE


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("GET", ""),
        ("GET", "/file"),
        ("GET", "/pddl"),
        ("POST", "/copy"),
        ("POST", "/removal"),
        ("POST", "/return"),
    ],
)
def test_an_exercise_that_is_not_there_is_not_found(
    browser: TestClient, method: str, path: str
) -> None:
    assert browser.request(method, f"/library/0123456789abcdef{path}").status_code == 404


def test_a_version_that_is_not_there_is_not_found(browser: TestClient) -> None:
    wanted = exercise_id("Spell CURIE")
    assert browser.get(f"/library/{wanted}?version=9").status_code == 404
    assert browser.post(f"/library/{wanted}/again", data={"version": 9}).status_code == 404


# ---------------------------------------------------------------- drawings


def test_an_exercise_and_each_of_its_rules_is_drawn(browser: TestClient) -> None:
    wanted = exercise_id("Five odd numbers, ascending")
    page = browser.get(f"/library/{wanted}").text
    pictures = [unescape(one) for one in re.findall(r'<img src="([^"]+)"', page)]
    assert len(pictures) == 4
    for picture in (f"/library/{wanted}/picture", *pictures):
        answer = browser.get(picture)
        assert answer.headers["content-type"] == "image/svg+xml"
        assert answer.text.startswith("<svg")


def test_actions_are_drawn_by_the_rules_that_sum_them_up(
    context: Context, browser: TestClient
) -> None:
    actions = encode_exercise(learn_grounded(shown_in("odd-ascending")))
    context.store.save_exercise("Actions", actions)
    wanted = exercise_id("Actions")
    assert '<img src="' in browser.get(f"/library/{wanted}").text
    assert browser.get(f"/library/{wanted}/picture").status_code == 200


def moved_up(board: Board, deck: Deck) -> Demonstration:
    """The deck's one token goes from the last storage cell to the first goal cell."""
    (token,) = deck.by_id
    origin, goal = Cell(Row(4), Column(5)), Cell(Row(1), Column(1))
    return Demonstration(deck, State(board, {token: origin}), (Move(token, origin, goal),))


def test_what_was_shown_is_drawn_as_it_was_shown(context: Context, browser: TestClient) -> None:
    exercise = paper_exercise("curie")
    only_c = Deck((exercise.deck.by_id[TokenId("C")],))
    only_19 = Deck((NUMBER_DECK.by_id[TokenId("19")],))
    evidence = Evidence(
        (
            moved_up(exercise.board, only_19),
            moved_up(exercise.board, only_c),
        )
    )
    context.store.save_exercise("Shown", encode_exercise(replace(exercise, evidence=evidence)))
    drawing = browser.get(f"/library/{exercise_id('Shown')}/picture").text
    assert ">G<" not in drawing


def test_what_cannot_be_drawn_is_not_found(context: Context, browser: TestClient) -> None:
    crowd = told_exercise((), Board(2, 2), NUMBER_DECK)
    context.store.save_exercise("Crowd", encode_exercise(crowd))
    context.store.save_exercise("Broken", "{}")
    for name in ("Crowd", "Broken"):
        assert browser.get(f"/library/{exercise_id(name)}/picture").status_code == 404
    wanted = exercise_id("Spell CURIE")
    assert browser.get(f"/library/{wanted}/picture?rule=none").status_code == 404


# ---------------------------------------------------------------- files


def test_what_is_saved_as_a_file_can_be_brought_in_again(
    context: Context, browser: TestClient
) -> None:
    file = browser.get(f"/library/{exercise_id('Spell CURIE')}/file")
    assert "Spell-CURIE.exercise.json" in file.headers["content-disposition"]
    page = bring_in(browser, file.content)
    assert "<h1>Spelling</h1>" in page
    assert "Brought in by" in page
    assert decode_exercise(context.store.exercise("Spelling").exercise.encode()) == (
        paper_exercise("curie")
    )


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (b"", "expected"),
        (b"{}", "maestra.exercise/1"),
        (CURIE.replace('"confidence": 1.0', '"confidence": 7', 1).encode(), "confidence: 7"),
        (b" " * (MOST_BYTES + 1), "at most 15360 kB"),
    ],
    ids=["nothing", "no exercise", "a wrong number", "too large"],
)
def test_each_fault_of_a_file_is_said_in_a_line(
    browser: TestClient, content: bytes, line: str
) -> None:
    answer = browser.post("/library/files", files={"file": ("Mine.json", content)})
    assert answer.status_code == 422
    assert "The file “Mine” cannot be used:" in answer.text
    assert line in answer.text.replace("&#34;", '"')


def test_a_form_without_a_file_is_refused(browser: TestClient) -> None:
    assert browser.post("/library/files").status_code == 422


def test_an_exercise_is_saved_as_pddl(browser: TestClient) -> None:
    answer = browser.get(f"/library/{exercise_id('Spell CURIE')}/pddl")
    archive = zipfile.ZipFile(io.BytesIO(answer.content))
    assert set(archive.namelist()) == {"domain.pddl", "problem.pddl", "exercise.json"}
    assert archive.read("domain.pddl").startswith(b"(define (domain")


def test_what_preconditions_cannot_say_is_no_pddl(context: Context, browser: TestClient) -> None:
    context.store.save_exercise("Ten", TEN)
    answer = browser.get(f"/library/{exercise_id('Ten')}/pddl")
    assert answer.status_code == 422
    assert "This exercise cannot be said in PDDL:" in answer.text


def test_actions_and_rules_are_both_zipped() -> None:
    actions = encode_exercise(learn_grounded(shown_in("curie")))
    for text in (CURIE, actions):
        archive = zipfile.ZipFile(io.BytesIO(zipped_pddl(text)))
        assert archive.read("exercise.json").decode() == text
        assert b"(:goal (now t6))" in archive.read("problem.pddl")


def shown_in(example: str) -> list[Demonstration]:
    """The demonstrations of one of the files in examples/."""
    file = Path(__file__).parents[3] / "examples" / f"{example}.jsonl"
    return list(read_demonstrations([file.read_bytes()], file.name))


def test_what_cannot_be_zipped_names_its_faults() -> None:
    with pytest.raises(InvalidError):
        zipped_pddl("{}")


def test_a_title_that_is_taken_gets_a_number() -> None:
    assert fresh("One", frozenset()) == "One"
    assert fresh("One", frozenset({"One", "One (2)"})) == "One (3)"
    assert len(fresh("x" * 100, frozenset({"x" * 100}))) == 100


def test_a_files_name_becomes_a_title() -> None:
    assert title_of("Monday\n.exercise.json") == "Monday"


# ---------------------------------------------------------------- for programs


def test_programs_list_and_read_exercises(browser: TestClient) -> None:
    listed = browser.get("/api/exercises", params={"search": "curie", "language": "ca"}).json()
    (found,) = listed["exercises"]
    assert found["title"] == "Escriure CURIE"
    assert (found["origin"], found["status"], found["version"]) == ("paper", "told", 1)
    one = browser.get(f"/api/exercises/{found['id']}").json()
    assert one["earlier"] == []
    file = browser.get(f"/api/exercises/{found['id']}/file")
    assert file.text == CURIE


def test_programs_bring_in_and_take_away(browser: TestClient) -> None:
    answer = browser.post("/api/exercises", params={"title": "Sent"}, content=CURIE)
    assert answer.status_code == 201
    made = answer.json()
    assert (made["name"], made["version"]) == ("Sent", 1)
    path = f"/api/exercises/{made['id']}"
    assert browser.delete(path).status_code == 204
    assert "Sent" not in browser.get("/api/exercises").text
    assert browser.post(f"{path}/return").status_code == 204
    assert "Sent" in browser.get("/api/exercises").text


def test_programs_are_told_each_fault(browser: TestClient) -> None:
    answer = browser.post("/api/exercises", content=b'{"format": "maestra.exercise/1"}')
    assert answer.status_code == 422
    assert answer.json()["faults"][0] == {
        "where": "kind",
        "found": "missing",
        "expected": '"grounded" or "ruled"',
    }


def test_programs_get_pddl_or_a_conflict(context: Context, browser: TestClient) -> None:
    context.store.save_exercise("Ten", TEN)
    for name, status in (("Spell CURIE", 200), ("Ten", 409)):
        answer = browser.get(f"/api/exercises/{exercise_id(name)}/pddl")
        assert answer.status_code == status


def test_to_programs_what_is_not_there_is_not_found(browser: TestClient) -> None:
    for path in ("", "/file", "/pddl"):
        assert browser.get(f"/api/exercises/0123456789abcdef{path}").status_code == 404
    assert browser.delete("/api/exercises/0123456789abcdef").status_code == 404
    assert browser.post("/api/exercises/0123456789abcdef/return").status_code == 404
