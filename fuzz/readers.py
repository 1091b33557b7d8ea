"""Bytes that a coverage-guided fuzzer invents, into every reader: `make fuzz`.

    python fuzz/readers.py demonstrations .cache/fuzz/demonstrations -max_total_time=60

The folder keeps what reached new code, so that the next run begins where this one ended.

What a reader may do with any bytes: yield what it read, which must survive a round trip, or
raise `InvalidError`, the one line that a user sees. All else ends the run with the input.
"""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

import atheris

with atheris.instrument_imports(include=["maestra"]):
    from maestra.core.faults import InvalidError
    from maestra.core.formats import (
        decode_demonstration,
        encode_demonstration,
        read_demonstrations,
    )

# A valid line to begin with; the fuzzer would take days to invent one.
SEED: Final = (
    b'{"format": "maestra.demonstration/1", "board": {"rows": 4, "columns": 5, "goal_row": 1},'
    b' "tokens": {"04A3B2": {"value": 19, "letter": "C"}, "04A3B3": {"day": "Monday"}},'
    b' "start": {"04A3B2": [2, 1], "04A3B3": [3, 4]},'
    b' "orders": {"day": ["Monday", "Tuesday"]}, "relations": {"partner": [["cup", "saucer"]]},'
    b' "moves": [{"token": "04A3B2", "origin": [2, 1], "destination": [1, 1]}],'
    b' "lexicon": ["CURIE"], "label": "one", "times_ms": [5], "source": "simulated"}\n'
)


def demonstrations(data: bytes) -> None:
    """A file of demonstrations, in two chunks cut where the first byte says."""
    cut = data[0] * len(data) // 256 if data else 0

    def chunks() -> Iterator[bytes]:
        yield data[:cut]
        yield data[cut:]

    try:
        read = list(read_demonstrations(chunks(), "fuzz.jsonl"))
    except InvalidError as refusal:
        line = str(refusal)
        if not line.isprintable():
            msg = f"a refusal of more than a line: {line!r}"
            raise AssertionError(msg) from refusal
        return
    for demonstration in read:
        again = decode_demonstration(encode_demonstration(demonstration).encode())
        if again != demonstration:
            msg = f"{demonstration} comes back as {again}"
            raise AssertionError(msg)


TARGETS: Final[dict[str, tuple[Callable[[bytes], None], bytes]]] = {
    "demonstrations": (demonstrations, SEED),
}


def main() -> None:
    """Fuzz the target that the first argument names, from the corpus in the second."""
    program, name, folder, *options = sys.argv
    target, seed = TARGETS[name]
    corpus = Path(folder)
    corpus.mkdir(parents=True, exist_ok=True)
    (corpus / "seed").write_bytes(seed)
    atheris.Setup([program, folder, *options], target)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
