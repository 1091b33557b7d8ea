from dataclasses import replace

from maestra.experiments.demonstrators import Mistake
from maestra.experiments.fewshot import Outcome
from maestra.experiments.fewshot_findings import Finding, findings
from maestra.experiments.fewshot_runs import Part, Run
from maestra.experiments.fewshot_tables import tables
from maestra.experiments.pages import PageTable, in_words
from maestra.rules.exercise import LearnStatus

RIGHT = Finding(
    Part.LANGUAGE,
    1000,
    "ordering",
    "lazy",
    1,
    0,
    0,
    LearnStatus.LEARNED,
    0.98,
    exact=True,
    exact_on_new_decks=True,
    slipped=False,
    found=False,
    located=False,
    false_alarms=0,
)
WRONG = replace(RIGHT, seed=1001, exact=False, family="spelling")
UNSURE = replace(RIGHT, seed=1002, status=LearnStatus.AMBIGUOUS, confidence=0.5)


def table(found: list[Finding], name: str) -> PageTable:
    (one,) = (one for one in tables(found) if one.name == name)
    return one


def words(found: list[Finding], name: str) -> list[list[str]]:
    return [[in_words(cell) for cell in row] for row in table(found, name).rows]


def test_nothing_found_makes_no_table() -> None:
    assert tables([]) == ()


def test_what_is_exact_is_held_against_what_was_wanted() -> None:
    (row,) = words([RIGHT, WRONG, UNSURE], "exact")
    assert row == ["1", "0", "0.0", "66.7 (20.8-93.8)", "100.0 (43.9-100.0)", "60 %", "reached"]
    (row,) = words([RIGHT, WRONG], "exact")
    assert row[-1] == "10.0"
    assert "2 exercises, seeds 1000 to 1001" in table([RIGHT, WRONG], "exact").title


def test_of_what_was_called_learned_it_is_said_how_much_is_exact() -> None:
    (row,) = words([RIGHT, WRONG, UNSURE], "learned")
    assert [cell.split()[0] for cell in row] == ["1", "0", "66.7", "50.0", "95", "45.0", "33.3"]
    (row,) = words([UNSURE], "learned")
    assert row[3] == row[5] == "-"


def test_families_and_persons_have_a_row_each() -> None:
    assert [row[:2] for row in words([RIGHT, WRONG, UNSURE], "families")] == [
        ["ordering", "2"],
        ["spelling", "1"],
    ]
    assert [row[:2] for row in words([RIGHT, WRONG], "persons")] == [["lazy", "2"]]


def test_confidence_is_calibrated_by_intervals_that_hold_their_lower_end() -> None:
    sure, just = replace(RIGHT, confidence=1.0), replace(RIGHT, confidence=0.97)
    rows = words([RIGHT, WRONG, UNSURE, sure, just], "calibration")
    assert [row[:2] for row in rows] == [
        ["0.950 to 0.970", "0"],
        ["0.970 to 0.990", "3"],
        ["0.990 to 0.999", "0"],
        ["0.999 to 1.000", "1"],
    ]
    assert rows[1][2].startswith("66.7")


def test_another_way_of_asking_is_compared_on_the_same_exercises() -> None:
    asked = replace(RIGHT, questions=3, asked=2)
    others = [replace(asked, part=Part.ROWS_AND_MOVES, asked=3)]
    (row,) = words([asked, replace(asked, seed=1001, exact=False), *others], "kinds")
    assert row[:6] == ["1", "3", "100.0 (20.6-100.0)", "2.0", "100.0 (20.6-100.0)", "3.0"]
    (row,) = words([replace(asked, part=Part.WRONG_ANSWERS)], "wrong-answers")
    assert row[2:4] == ["-", "-"]


def test_exercises_from_outside_are_not_to_be_learned_wrongly() -> None:
    outside = replace(WRONG, part=Part.OUTSIDE)
    rows = words([outside, replace(outside, status=LearnStatus.OUTSIDE, seed=1)], "outside")
    assert [row[2].split()[0] for row in rows] == ["50.0"]
    assert rows[0][4].startswith("50.0")
    assert rows[0][-1] == "47.0"
    (row,) = words([replace(outside, status=LearnStatus.OUTSIDE)], "outside")
    assert row[-1] == "reached"


def test_slips_are_counted_where_there_was_one_and_alarms_where_there_was_none() -> None:
    slip = replace(RIGHT, part=Part.SLIP, demonstrations=3, slipped=True, found=True)
    careful = replace(RIGHT, part=Part.NO_SLIP, demonstrations=3)
    found = [
        slip,
        replace(slip, located=True),
        replace(slip, slipped=False),
        careful,
        replace(careful, false_alarms=1),
    ]
    located, demonstration, beside, alarm = words(found, "slips")
    assert (located[1], located[2].split()[0], located[-1]) == ("2", "50.0", "35.0")
    assert demonstration[2].startswith("100.0")
    assert beside[2].startswith("0.0")
    assert (alarm[1], alarm[2].split()[0], alarm[-1]) == ("2", "50.0", "48.0")
    assert words([slip], "slips")[-1][-1] == "-"


def test_draws_of_the_papers_exercises_are_counted() -> None:
    paper = replace(RIGHT, part=Part.PAPER, family="curie", demonstrations=2)
    found = [paper, replace(paper, exact=False), replace(paper, questions=3)]
    assert words(found, "paper") == [
        ["`curie`", "1 of 2", "1 of 1"],
        ["wanted, of 100", "95", "100"],
    ]
    (heading, *columns) = table(
        [*found, replace(paper, part=Part.PAPER_ONE_START)], "paper"
    ).headings
    assert heading == "Exercise"
    assert columns[0] == "fresh starts, no question"
    assert columns[-1] == "one start, at most 3 questions"


def test_a_finding_tells_the_mistake_from_false_alarms() -> None:
    outcome = Outcome(
        seed=5,
        family="shape",
        person="uniform",
        demonstrations=3,
        questions=0,
        asked=0,
        status="ambiguous",
        confidence=0.123456,
        exact=True,
        exact_on_new_decks=True,
        slipped=None,
        slips=(),
        rules="",
        truth="",
    )
    slipped = replace(outcome, slipped=Mistake(1, (2, 3)), slips=((1, 3), (0, 2)))
    wrong, right = findings({Run(Part.SLIP, 5, 3): (slipped, replace(outcome, slips=((2, 0),)))})
    assert (wrong.slipped, wrong.found, wrong.located, wrong.false_alarms) == (True, True, True, 1)
    assert (right.slipped, right.found, right.located, right.false_alarms) == (
        False,
        False,
        False,
        1,
    )
    assert right.confidence == 0.1235
