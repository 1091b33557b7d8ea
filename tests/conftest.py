"""What all tests share: Hypothesis profiles and the plugins of our own."""

from hypothesis import HealthCheck, settings

pytest_plugins = ("pytester", "tests.coverage_floors")

# Two cores shared by everything make slow examples and slow draws normal, and speed has
# benchmarks of its own; so no profile has a deadline.
settings.register_profile(
    "common", deadline=None, print_blob=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("dev", parent=settings.get_profile("common"), max_examples=50)
# The same examples on every run: a red CI is red again on the developer's machine. As few as let
# the whole suite end in minutes with coverage on; `make properties` draws 5,000.
settings.register_profile(
    "ci", parent=settings.get_profile("common"), max_examples=40, derandomize=True, database=None
)
settings.register_profile("nightly", parent=settings.get_profile("common"), max_examples=5_000)
settings.load_profile("dev")
