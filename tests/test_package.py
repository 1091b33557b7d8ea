"""The package says what it is."""

from importlib.metadata import version

import maestra


def test_the_version_is_that_of_the_installed_package() -> None:
    assert maestra.__version__ == version("maestra")
