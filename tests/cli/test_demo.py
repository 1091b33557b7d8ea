"""The guided session, typed and read as a person would."""

from pathlib import Path

import pytest

from maestra.app import record_at, record_to_read
from maestra.cli.demo_session import begin, come_back, end, step
from maestra.cli.demo_stages import (
    SUBJECTS,
    Accompanying,
    Choosing,
    Ended,
    Playing,
    Stage,
    Teaching,
)
from maestra.cli.demo_words import (
    Accompany,
    Command,
    Typed,
    Unclear,
    Wish,
    Word,
    accompany_typed,
    understand,
)
from maestra.cli.drawing import ASCII, UNICODE, draw, label, strokes_for
from maestra.cli.lesson import Speech
from maestra.cli.outputs import Drawn, Output, Said
from maestra.cli.own_language import own_language
from maestra.core.board import Board, Cell, Column, Row
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import NO_LEXICON, Language
from maestra.language.terminal import TerminalKey
from maestra.rules.exercise import LearnStatus
from maestra.rules.paper_rules import paper_exercise
from maestra.rules.position import Position
from tests.cli.running import maestra
from tests.learning.scripts import AMBIGUOUS, LEARNED, scripted, slip

ENGLISH = Speech(Language.EN, NO_LEXICON)
LETTERS = "8"


class Session:
    """A session, typed line by line; chance is the number of the line."""

    def __init__(self, *lines: str, speech: Speech = ENGLISH, by_few: bool = False) -> None:
        """Type `lines`."""
        self.speech = speech
        self.stage: Stage
        self.outputs: tuple[Output, ...]
        self.stage, self.outputs = begin(speech, by_few=by_few)
        self.typed = 0
        self.type(*lines)

    def type(self, *lines: str) -> "Session":
        for line in lines:
            self.typed += 1
            self.stage, self.outputs = step(self.stage, line, self.typed, self.speech)
        return self

    @property
    def said(self) -> list[str]:
        return [output.text for output in self.outputs if isinstance(output, Said)]

    @property
    def drawn(self) -> list[Drawn]:
        return [output for output in self.outputs if isinstance(output, Drawn)]


def in_goal_row(state: State) -> list[str]:
    return [state.tokens[cell] for cell in state.board.goal_cells if cell in state.tokens]


@pytest.mark.parametrize("number", range(1, len(SUBJECTS) + 1))
def test_each_exercise_can_be_chosen(number: int) -> None:
    session = Session(str(number))
    assert isinstance(session.stage, Teaching)
    assert session.said[-1] == "Demonstration 1"
    assert len(session.drawn) == 1


@pytest.mark.parametrize("line", ["0", "9", "first", "19 1", "²"])
def test_what_is_no_exercise_is_asked_for_again(line: str) -> None:
    session = Session(line)
    assert isinstance(session.stage, Choosing)
    assert session.said == ["Please type a number from 1 to 8."]


def test_an_empty_line_changes_nothing() -> None:
    session = Session("2", "19 1", "  ")
    assert isinstance(session.stage, Teaching)
    assert len(session.stage.moves) == 1
    assert session.outputs == ()


def test_a_token_is_moved_and_moved_back() -> None:
    session = Session("2", "34 3")
    assert in_goal_row(session.drawn[0].state) == ["34"]
    session.type("undo")
    assert in_goal_row(session.drawn[0].state) == []
    assert session.type("undo").said == ["There is nothing to undo."]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("35", "There is no token 35."),
        ("34 6", "The columns go from 1 to 5."),
        ("34 0", "The columns go from 1 to 5."),
        ("34 1", "There is already a token in column 1."),
        ("19 2", "19 is already in the goal row."),
        ("put it there", "I do not know that. Type help to see what you can do."),
        ("hint", "I do not know that. Type help to see what you can do."),
        ("play", "Please show me at least one play first."),
    ],
)
def test_what_cannot_be_done_while_teaching_is_said(line: str, said: str) -> None:
    session = Session("2", "19 1")
    before = session.stage
    assert session.type(line).said == [said]
    assert session.stage == before


def test_a_demonstration_needs_a_move() -> None:
    assert Session("2", "done").said == ["Please move a token first."]


def test_a_full_row_ends_the_demonstration_and_the_rules_are_said() -> None:
    session = Session("2", "19", "23", "32", "34", "36")
    assert "What I understand so far:" in session.said
    assert "+ Put the tokens in the top row from left to right." in session.said
    assert "  - and 5 more" in session.said
    assert session.said[-1] == "Demonstration 2"


def test_a_rule_is_new_only_once() -> None:
    session = Session("2", "show me", "show me")
    assert "  Put the tokens in the top row from left to right." in session.said


def test_an_own_exercise_may_end_before_the_row_is_full() -> None:
    session = Session(LETTERS, "c 1", "done")
    assert "+ Put one token in the top row from left to right." in session.said


def test_maestra_shows_each_move_of_a_right_play() -> None:
    session = Session("5", "show me")
    moves = [said for said in session.said if " goes to column " in said]
    assert moves == [f"{letter} goes to column {k}." for k, letter in enumerate("CURIE", start=1)]


def test_maestra_shows_several_right_plays_until_all_is_clear() -> None:
    session = Session("2", "show me 15")
    assert "Demonstration 15" in session.said
    assert "All of it is clear to me now." in session.said
    assert session.type("show me 2").said[0].count("  ") == 4


def test_maestra_shows_at_most_thirty_plays_at_once() -> None:
    session = Session("5", "show me 9999")
    assert session.said[-1] == "Demonstration 31"


def test_maestra_cannot_show_what_only_the_user_knows() -> None:
    assert Session("7", "show me").said == ["Only you know this exercise. Please show it to me."]


def taught() -> Session:
    return Session("5", "show me 2", "play")


def test_right_moves_are_confirmed_to_the_end_and_it_begins_anew() -> None:
    session = taught().type("C", "U", "R", "I")
    assert session.said == ["Yes."]
    assert session.type("E 5").said[:2] == ["Yes.", "Well done, the exercise is complete."]
    assert isinstance(session.stage, Playing)
    assert session.stage.position.moves == ()


def test_a_wrong_move_is_explained_and_put_back() -> None:
    session = taught().type("C", "R 2")
    assert session.said[-1] == "Let us put R back and try another one."
    assert in_goal_row(session.drawn[-1].state) == ["C"]
    assert isinstance(session.stage, Playing)
    assert len(session.stage.position.moves) == 1


def test_a_hint_is_a_right_move() -> None:
    session = taught().type("hint")
    assert session.said == ["You could move C to column 1."]
    assert session.type("c 1").said == ["Yes."]


def test_there_is_no_hint_where_nothing_is_known_to_be_right() -> None:
    session = Session(LETTERS, "C 1", "done", "play")
    said = session.type("c 1", "hint").said[-1]
    assert said.startswith(("You could move C", "I know no right move here."))


def test_no_start_with_a_right_move_may_be_found() -> None:
    # From one demonstration C is known to be right from one cell only, and chance hides it.
    for chance in range(50):
        stage: Stage = Session(LETTERS, "C 1", "done").stage
        stage, _ = step(stage, "play", chance, ENGLISH)
        _, outputs = step(stage, "hint", chance, ENGLISH)
        (output,) = outputs
        assert isinstance(output, Said)
        if output.text == "I know no right move here. Please show me more: teach":
            return
    pytest.fail("every deal had a right move")


def test_a_play_that_may_not_end_yet_goes_on() -> None:
    assert taught().type("C", "done").said == ["There is still something to move."]


def test_a_play_may_end_early_where_that_was_shown() -> None:
    session = Session(LETTERS, "C 1", "done", "C 1", "U 2", "done", "play")
    assert isinstance(session.stage, Playing)
    move = next(session.stage.taught.judge.allowed_moves(session.stage.position))
    session.stage = Playing(session.stage.taught, session.stage.position.after(move))
    assert session.type("done").said[0] == "Well done, the exercise is complete."


def test_the_row_may_be_full() -> None:
    session = taught()
    assert isinstance(session.stage, Playing)
    letters = "CURIE"
    cells = session.stage.state.board.goal_cells
    lying = dict(session.stage.state.cells)
    lying |= {TokenId(letter): cell for letter, cell in zip(letters, cells, strict=True)}
    full = State(session.stage.state.board, lying)
    session.stage = Playing(session.stage.taught, Position.begin(full))
    assert session.type("A").said == ["The goal row is full."]


@pytest.mark.parametrize("line", ["undo", "show me", "what now please?"])
def test_what_cannot_be_done_while_playing_is_said(line: str) -> None:
    said = taught().type(line).said
    assert said == ["I do not know that. Type help to see what you can do."]


def test_from_playing_one_can_go_anywhere() -> None:
    assert isinstance(taught().type("play").stage, Playing)
    assert isinstance(taught().type("teach").stage, Teaching)
    assert isinstance(taught().type("menu").stage, Choosing)
    assert isinstance(taught().type("quit").stage, Ended)
    assert taught().type("unknown").said == ["There is no token unknown."]


def test_going_back_to_teach_keeps_what_was_shown() -> None:
    session = taught().type("teach")
    assert session.said[-1] == "Demonstration 3"


def test_the_menu_can_be_asked_for_anywhere() -> None:
    assert isinstance(Session("2", "menu").stage, Choosing)
    assert Session("menu").said[0] == "Which exercise shall it be?"


@pytest.mark.parametrize("lines", [(), ("2",), ("5", "show me 2", "play")])
def test_help_tells_what_can_be_typed(lines: tuple[str, ...]) -> None:
    session = Session(*lines)
    before = session.stage
    (said,) = session.type("help").said
    assert "quit" in said
    assert session.stage == before


@pytest.mark.parametrize("lines", [(), ("2",), ("5", "show me 2", "play")])
def test_quit_ends_the_session_anywhere(lines: tuple[str, ...]) -> None:
    session = Session(*lines, "quit")
    assert isinstance(session.stage, Ended)
    assert session.said == ["Goodbye."]
    assert session.type("2").outputs == ()


def test_the_same_chance_makes_the_same_session() -> None:
    assert Session("2", "show me", "19").outputs == Session("2", "show me", "19").outputs


@pytest.mark.parametrize(
    ("line", "language", "typed"),
    [
        ("undo", Language.EN, Command(Word.UNDO)),
        (" Show  ME ", Language.EN, Command(Word.SHOW)),
        ("show", Language.EN, Command(Word.SHOW)),
        ("show me 12", Language.EN, Command(Word.SHOW, 12)),
        ("show 3", Language.EN, Command(Word.SHOW, 3)),
        ("deshacer", Language.ES, Command(Word.UNDO)),
        ("undo", Language.ES, Command(Word.UNDO)),
        ("mostra 4", Language.CA, Command(Word.SHOW, 4)),
        ("desfés", Language.CA, Command(Word.UNDO)),
        ("34", Language.EN, Wish("34", None)),
        ("34 3", Language.EN, Wish("34", 3)),
        ("34,3", Language.EN, Wish("34", 3)),
        ("34 to 3", Language.EN, Wish("34", 3)),
        ("c 2", Language.EN, Wish("c", 2)),
        ("34 ³", Language.EN, Unclear()),
        ("34 12345", Language.EN, Unclear()),
        ("a b c d", Language.EN, Unclear()),
    ],
)
def test_what_is_typed_is_understood(line: str, language: Language, typed: Typed) -> None:
    assert understand(line, language) == typed


@pytest.mark.parametrize("language", Language)
def test_a_whole_session_can_be_piped_in_each_language(language: Language) -> None:
    lines = "5\nshow me 2\nplay\nc 1\nr 2\nu\nr\ni\ne\nquit\nnever read\n"
    options = ("--lang", language.value, "--seed", "1", "--learner", "grounded")
    ran = maestra("demo", *options, typed=lines.encode())
    assert (ran.code, ran.err) == (0, "")
    assert "┃ C  ┃ U  ┃ R  ┃ I  ┃ E  ┃" in ran.out
    assert "\x1b" not in ran.out
    (goodbye,) = end(Speech(language, NO_LEXICON))[1]
    assert isinstance(goodbye, Said)
    assert ran.out.splitlines()[-1] == goodbye.text


def test_the_session_ends_cleanly_where_the_input_does() -> None:
    ran = maestra("demo", "--seed", "1", typed=b"2\n19 1")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.endswith("> \nGoodbye.\n")


def test_noise_is_no_command() -> None:
    ran = maestra("demo", "--seed", "1", typed=b"\xff\xfe\n")
    assert (ran.code, ran.err) == (0, "")


@pytest.mark.parametrize(
    ("variables", "language"),
    [
        ({"LANG": "es_ES.UTF-8"}, Language.ES),
        ({"LANG": "es_ES.UTF-8", "LC_ALL": "ca_ES.UTF-8"}, Language.CA),
        ({"LANG": "de_DE.UTF-8"}, Language.EN),
        ({"LC_ALL": "C", "LANG": "es_ES"}, Language.EN),
        ({}, Language.EN),
    ],
)
def test_the_language_is_that_of_the_environment(
    monkeypatch: pytest.MonkeyPatch, variables: dict[str, str], language: Language
) -> None:
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert own_language() is language


def drawing(board: Board, encoding: str = "utf-8") -> list[str]:
    deck = Deck((Token(TokenId("t"), (("value", 7),)),))
    state = State(board, {TokenId("t"): Cell(Row(2), Column(2))})
    lines = draw(state, deck, "goal", strokes_for(encoding))
    return ["".join(text for text, _ in pieces) for pieces in lines]


@pytest.mark.parametrize(
    ("goal_row", "lines"),
    [
        (
            1,
            [
                "          1    2",
                "       ┏━━━━┳━━━━┓",
                "  goal ┃    ┃    ┃",
                "       ┡━━━━╇━━━━┩",
                "     2 │    │ 7  │",
                "       ├────┼────┤",
                "     3 │    │    │",
                "       └────┴────┘",
            ],
        ),
        (
            2,
            [
                "          1    2",
                "       ┌────┬────┐",
                "     1 │    │    │",
                "       ┢━━━━╈━━━━┪",
                "  goal ┃    ┃ 7  ┃",
                "       ┡━━━━╇━━━━┩",
                "     3 │    │    │",
                "       └────┴────┘",
            ],
        ),
        (
            3,
            [
                "          1    2",
                "       ┌────┬────┐",
                "     1 │    │    │",
                "       ├────┼────┤",
                "     2 │    │ 7  │",
                "       ┢━━━━╈━━━━┪",
                "  goal ┃    ┃    ┃",
                "       ┗━━━━┻━━━━┛",
            ],
        ),
    ],
)
def test_the_goal_row_is_seen_without_colour(goal_row: int, lines: list[str]) -> None:
    assert drawing(Board(3, 2, Row(goal_row))) == lines


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "nonsense", None])
def test_a_board_is_drawn_with_what_the_terminal_can_show(encoding: str | None) -> None:
    assert strokes_for(encoding) is ASCII
    assert strokes_for("utf-8") is UNICODE
    assert all(line.isascii() for line in drawing(Board(3, 2), "ascii"))


@pytest.mark.parametrize(
    ("attributes", "text"),
    [
        ((("value", 19),), "19"),
        ((("colour", "red"), ("value", 19)), "19"),
        ((("colour", "red"), ("name", "cup")), "cup"),
        ((("colour", "red"),), "red"),
        ((), "t1"),
        ((("name", "a very long name"),), "a very lo…"),
    ],
)
def test_a_token_is_labelled_with_what_people_look_for(
    attributes: tuple[tuple[str, int | str], ...], text: str
) -> None:
    assert label(Token(TokenId("t1"), attributes)) == text


def test_control_c_ends_the_session_on_a_line_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(_prompt: str) -> str:
        raise KeyboardInterrupt

    monkeypatch.setattr("builtins.input", interrupted)
    ran = maestra("demo", "--seed", "1")
    assert (ran.code, ran.err) == (130, "")
    assert ran.out.endswith("\n\n")


def by_few(*lines: str) -> Session:
    return Session(*lines, by_few=True)


def test_who_learns_by_few_says_how_sure_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    scripted(monkeypatch, LEARNED)
    said = by_few("2", "show me").said
    assert "+ Each token must be larger than the one on its left." in said
    assert "I am 98 % sure of this." in said


def test_who_learns_by_few_asks_before_the_user_plays(monkeypatch: pytest.MonkeyPatch) -> None:
    scripted(monkeypatch, AMBIGUOUS, LEARNED)
    session = by_few("2", "show me", "play")
    assert "Is this row right: 1, 2, 9?" in session.said
    assert session.type("perhaps").said == ["Sorry, I did not understand that."]
    session.type("yes")
    assert isinstance(session.stage, Playing)
    assert session.said[-1] == "Your turn. I say of each move whether it is right."
    assert len(session.stage.taught.answers) == 1
    assert session.type("85", "hint").said


def test_who_is_sure_asks_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    scripted(monkeypatch, LEARNED)
    session = by_few("2", "show me 2", "play")
    assert isinstance(session.stage, Playing)


def test_a_user_who_takes_everything_back_begins_again(monkeypatch: pytest.MonkeyPatch) -> None:
    scripted(monkeypatch, (LearnStatus.LEARNED, (slip(0),)))
    session = by_few("2", "show me", "play", "no")
    assert isinstance(session.stage, Teaching)
    assert session.stage.taught.shown == ()
    assert session.said[0] == "Nothing is left to learn from. Please show me again."


@pytest.mark.parametrize(("line", "stage"), [("quit", Ended), ("menu", Choosing)])
def test_questions_can_be_left(
    line: str, stage: type[Stage], monkeypatch: pytest.MonkeyPatch
) -> None:
    scripted(monkeypatch, AMBIGUOUS)
    session = by_few("2", "show me", "play", line)
    assert isinstance(session.stage, stage)
    if isinstance(session.stage, Choosing):
        assert session.stage.by_few


@pytest.mark.parametrize(
    ("line", "language", "meant"),
    [
        ("accompany", Language.EN, Accompany(None, None)),
        (" Accompany  2", Language.CA, Accompany(2, None)),
        ("acompañar Anna", Language.ES, Accompany(None, "Anna")),
        ("acompanyar 2 Anna", Language.CA, Accompany(2, "Anna")),
        ("accompany Anna 2", Language.EN, None),
        ("accompany 2 Anna B", Language.EN, None),
        ("acompañar", Language.EN, None),
        ("play", Language.EN, None),
        ("", Language.EN, None),
    ],
)
def test_who_is_to_be_accompanied_is_understood(
    line: str, language: Language, meant: Accompany | None
) -> None:
    assert accompany_typed(line, language) == meant


@pytest.mark.parametrize("number", range(1, 7))
def test_each_of_the_papers_exercises_can_be_played_by_a_patient(number: int) -> None:
    session = Session(f"accompany {number}")
    assert isinstance(session.stage, Accompanying)
    assert session.stage.exercise == paper_exercise(session.stage.name)
    how = f"accompany {number} anna"
    assert session.said == [
        f"I do not keep this session; I would, with a name for the patient: {how}"
    ]


def test_what_was_taught_can_be_played_by_a_patient() -> None:
    session = Session("8", "C", "U", "done", "accompany anna")
    assert isinstance(session.stage, Accompanying)
    assert (session.stage.name, session.stage.patient) == ("own-letters", "anna")
    assert session.said == ["I keep this session for anna."]
    assert session.type("2").outputs == ()
    back, outputs = come_back(session.stage, ENGLISH)
    assert isinstance(back, Teaching)
    assert len(back.taught.shown) == 1
    assert len(outputs) == 1
    played = taught().type("accompany")
    assert isinstance(played.stage, Accompanying)
    assert isinstance(come_back(played.stage, ENGLISH)[0], Playing)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (("accompany",), "Please type a number from 1 to 6."),
        (("accompany 0",), "Please type a number from 1 to 6."),
        (("accompany 9",), "Please type a number from 1 to 6."),
        (("accompany 7",), "Only you know this exercise. Please show it to me."),
        (("7", "accompany"), "Please show me at least one play first."),
    ],
)
def test_what_no_patient_can_play_is_said(lines: tuple[str, ...], said: str) -> None:
    session = Session(*lines)
    assert session.said == [said]
    assert not isinstance(session.stage, Accompanying)


@pytest.fixture(name="record")
def a_record(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("MAESTRA_DATA", str(tmp_path / "data"))
    monkeypatch.setenv("MAESTRA_KEYS", str(tmp_path / "keys"))
    return tmp_path / "data"


SPELLED = "accompany 5{who}\nc\nr\nundo\nu\nr\ni\ne\nquit\nnever read\n"


@pytest.mark.parametrize("language", Language)
def test_a_patient_plays_and_the_menu_comes_back(language: Language, record: Path) -> None:
    typed = SPELLED.format(who="").encode()
    ran = maestra("demo", "--lang", language.value, "--seed", "1", typed=typed)
    assert (ran.code, ran.err) == (0, "")
    speech = Speech(language, NO_LEXICON)
    assert ran.out.count(speech.say(TerminalKey.WHICH_EXERCISE)) == 2
    assert ran.out.splitlines()[-1] == speech.say(TerminalKey.GOODBYE)
    assert "never read" not in ran.out
    assert not record.exists()


def test_what_a_named_patient_plays_is_kept(record: Path) -> None:
    typed = SPELLED.format(who=" Anna").encode()
    ran = maestra("demo", "--lang", "en", "--seed", "1", typed=typed)
    assert (ran.code, ran.err) == (0, "")
    assert record.exists()
    store = record_to_read()
    try:
        (session,) = store.sessions()
    finally:
        store.close()
    assert (session.patient, session.exercise) == ("Anna", "curie")
    assert session.ended_utc is not None


def test_a_record_that_somebody_else_writes_to_ends_no_session(record: Path) -> None:
    store = record_at(str(record))
    try:
        ran = maestra("demo", "--lang", "en", typed=b"accompany 5 anna\nquit\n")
    finally:
        store.close()
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.count("Which exercise shall it be?") == 2


def test_planning_takes_too_long_for_a_session() -> None:
    ran = maestra("demo", "--learner", "compiled")
    assert (ran.code, ran.out) == (2, "")
    assert "grounded or fewshot" in ran.err
