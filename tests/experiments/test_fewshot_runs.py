import json
from pathlib import Path

import pytest

from maestra.core.json_lines import FormatError
from maestra.experiments.fewshot_findings import findings, findings_csv, findings_from_csv
from maestra.experiments.fewshot_runs import DESIGNS, Part, Run, fewshot_runs, wanted_runs
from maestra.experiments.fewshot_tables import tables
from maestra.learning.fewshot.questions import QuestionKind

SMALL = [Run(Part.LANGUAGE, 1001, 1), Run(Part.PAPER_ONE_START, 4, 2)]


def test_every_part_has_its_runs_and_the_papers_exercises_take_turns() -> None:
    wanted = wanted_runs(list(Part), exercises=10, draws=2, seed=1000)
    assert len(set(wanted)) == len(wanted)
    counts = {part: sum(run.part is part for run in wanted) for part in Part}
    assert counts == {
        Part.LANGUAGE: 30,
        Part.ROWS_AND_MOVES: 12,
        Part.WRONG_ANSWERS: 12,
        Part.OUTSIDE: 18,
        Part.SLIP: 10,
        Part.NO_SLIP: 10,
        Part.PAPER: 12,
        Part.PAPER_ONE_START: 12,
    }
    assert {run.seed for run in wanted if run.part is Part.LANGUAGE} == set(range(1000, 1010))
    one = wanted_runs([Part.OUTSIDE], 1, 1, 7, demonstrations=[2])
    assert one == [Run(Part.OUTSIDE, 7, 2)]


def test_the_parts_that_are_compared_ask_what_they_say() -> None:
    kinds = DESIGNS[Part.ROWS_AND_MOVES].circumstances.kinds
    assert kinds == {QuestionKind.ROW, QuestionKind.MOVE}
    assert DESIGNS[Part.WRONG_ANSWERS].circumstances.wrong == 0.03


def test_a_stopped_experiment_goes_on_and_comes_out_the_same(tmp_path: Path) -> None:
    file = tmp_path / "runs.jsonl"
    advanced: list[int] = []
    first = fewshot_runs(SMALL, 1, file, advanced.append)
    assert advanced == [0, 1, 1]
    assert [one.family for one in first[SMALL[1]]] == ["curie", "curie"]
    whole = file.read_text()
    head, one, _ = whole.splitlines(keepends=True)
    file.write_text(head + one + '{"part": "pap')
    again = fewshot_runs(SMALL, 1, file, advanced.append)
    assert advanced == [0, 1, 1, 1, 1]
    assert again == first
    assert file.read_text() == whole


@pytest.mark.parametrize(
    "change",
    [
        {"part": "nothing"},
        {"outcomes": []},
        {"outcomes": "none"},
        {"seed": "first"},
    ],
)
def test_a_record_that_is_no_run_is_refused_with_its_line(
    tmp_path: Path, change: dict[str, object]
) -> None:
    file = tmp_path / "runs.jsonl"
    fewshot_runs(SMALL[1:], 1, file)
    head, one = file.read_text().splitlines(keepends=True)
    file.write_text(head + json.dumps({**json.loads(one), **change}) + "\n")
    with pytest.raises(FormatError, match="line 2: no run, expected a finished run"):
        fewshot_runs(SMALL, 1, file)


def test_findings_come_back_from_csv_and_make_the_same_tables() -> None:
    found = list(findings(fewshot_runs(SMALL)))
    assert len(found) == 5
    text = findings_csv(found)
    assert findings_from_csv(text) == found
    assert tables(findings_from_csv(text)) == tables(found)
