"""``python -m maestra`` is ``maestra``."""

from maestra.cli import main

if __name__ == "__main__":
    main()
