"""The command line: `maestra`. What each exit code and each output means is docs/reference's."""

from typing import NoReturn


def main() -> NoReturn:
    """Run Maestra with the process's arguments, and end the process."""
    from maestra.cli.program import main as run_and_exit

    run_and_exit()
