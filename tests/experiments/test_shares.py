import pytest

from maestra.experiments.shares import Share


def test_a_share_has_wilsons_interval() -> None:
    # Wilson 1927, as computed by statsmodels' proportion_confint(8, 10, method="wilson").
    share = Share.of_all([True] * 8 + [False] * 2)
    assert (share.count, share.of) == (8, 10)
    assert (share.low, share.high) == (0.4902, 0.9433)


@pytest.mark.parametrize(("hits", "bounds"), [([], (0.0, 1.0)), ([True] * 20, (0.8389, 1.0))])
def test_a_share_never_leaves_0_to_1(hits: list[bool], bounds: tuple[float, float]) -> None:
    share = Share.of_all(hits)
    assert (share.low, share.high) == bounds
