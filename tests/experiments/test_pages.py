import pytest

from maestra.core.faults import InvalidError
from maestra.experiments.pages import PageTable, filled, in_words, table_json
from maestra.experiments.shares import Share

TABLE = PageTable("sums", "Sums", ("What", "How much"), (("a\\1", Share(1, 2, 0.0945, 0.9055)),))
PAGE = "# Page\n\n<!-- table sums -->\nold\n<!-- end sums -->\n\nBy hand.\n"
FILLED = """# Page

<!-- table sums -->
Sums

| What | How much |
| --- | --: |
| a\\1 | 50.0 (9.4-90.5) |
<!-- end sums -->

By hand.
"""


def test_a_table_is_written_into_its_place_and_nowhere_else() -> None:
    assert filled(PAGE, [TABLE]) == FILLED
    assert filled(FILLED, [TABLE]) == FILLED


def test_a_page_without_a_place_is_refused_with_each_missing_table() -> None:
    other = PageTable("more", "More", (), ())
    with pytest.raises(InvalidError) as refused:
        filled("# Page\n", [TABLE, other])
    assert [fault.where for fault in refused.value.faults] == ["sums", "more"]


def test_nothing_of_nothing_is_no_share() -> None:
    assert in_words(Share.of_all([])) == "-"


def test_a_share_keeps_its_counts_in_json() -> None:
    cell = {"count": 1, "of": 2, "low": 0.0945, "high": 0.9055}
    assert table_json(TABLE)["rows"] == [["a\\1", cell]]
