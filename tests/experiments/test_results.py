from pathlib import Path

import pytest

from maestra.core.json_lines import FormatError
from maestra.experiments.results import open_results

HEADER = {"experiment": "curve", "seed": 1}


def test_what_was_added_is_there_when_the_file_is_opened_again(tmp_path: Path) -> None:
    path = tmp_path / "runs.jsonl"
    with open_results(path, HEADER) as results:
        assert results.records == []
        results.add({"run": 1})
    with open_results(path, HEADER) as results:
        assert results.records == [{"run": 1}]
        results.add({"run": 2})
    lines = path.read_text().splitlines()
    assert lines[0] == '{"format": "maestra.experiment/1", "experiment": "curve", "seed": 1}'
    assert lines[1:] == ['{"run": 1}', '{"run": 2}']


def test_a_line_that_was_cut_off_is_dropped(tmp_path: Path) -> None:
    path = tmp_path / "runs.jsonl"
    with open_results(path, HEADER) as results:
        results.add({"run": 1})
    with path.open("ab") as file:
        file.write(b'{"run": 2, "exa')
    with open_results(path, HEADER) as results:
        assert results.records == [{"run": 1}]
        results.add({"run": 3})
    assert path.read_text().splitlines()[1:] == ['{"run": 1}', '{"run": 3}']


def test_a_header_that_was_cut_off_is_written_anew(tmp_path: Path) -> None:
    path = tmp_path / "runs.jsonl"
    path.write_bytes(b'{"format": "maes')
    with open_results(path, HEADER) as results:
        results.add({"run": 1})
    with open_results(path, HEADER) as results:
        assert results.records == [{"run": 1}]


def test_results_of_other_settings_are_refused_with_every_difference(tmp_path: Path) -> None:
    path = tmp_path / "runs.jsonl"
    with open_results(path, {**HEADER, "level": "A"}):
        pass
    with pytest.raises(FormatError) as refused, open_results(path, {**HEADER, "seed": 2}):
        pass
    assert refused.value.line == 1
    assert [fault.where for fault in refused.value.faults] == ["seed", "level"]
    assert "seed: 1, expected 2 as in this experiment" in str(refused.value)


@pytest.mark.parametrize("content", [b"[1]\n", b"nonsense\n", b"\xff\xfe\n"])
def test_a_file_with_something_else_is_refused_and_kept(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "runs.jsonl"
    path.write_bytes(content)
    with pytest.raises(FormatError, match="no JSON object"), open_results(path, HEADER):
        pass
    assert path.read_bytes() == content


def test_two_experiments_cannot_write_to_one_file(tmp_path: Path) -> None:
    path = tmp_path / "runs.jsonl"
    with (
        open_results(path, HEADER),
        pytest.raises(FormatError, match="in use by another experiment"),
        open_results(path, HEADER),
    ):
        pass
