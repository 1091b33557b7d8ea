"""Files that a coverage-guided fuzzer invents, into every reader: `make fuzz`.

    python fuzz/readers.py demonstrations .cache/fuzz/demonstrations -max_total_time=60

The folder keeps what reached new code, so that the next run begins where this one ended.

What a reader may do with any bytes: give what it read, which must survive a round trip where
there is a writer, or raise `InvalidError`, the one line that a user sees. All else ends the run
and leaves the input beside the folder.
"""

import json
import random
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import atheris

with atheris.instrument_imports(include=["maestra"]):
    from maestra.core.demonstration import Demonstration
    from maestra.core.faults import InvalidError
    from maestra.core.formats import (
        decode_demonstration,
        encode_demonstration,
        read_demonstrations,
        read_plays,
    )
    from maestra.language import read_words
    from maestra.learning.grounded import learn_grounded
    from maestra.rules.exercise_format import decode_exercise, encode_exercise

EXAMPLES: Final = Path(__file__).parents[1] / "examples"

# What people and programs put where something else belongs.
INTRUDERS: Final[tuple[object, ...]] = (
    *(None, True, 0, 1, -1, 5, 2**53, 2**64, 1e300, 0.5, float("nan"), float("inf")),
    *("", "a", "\ud800", "\x00", "\n", "x" * 300, "l11", "ñ", "e\u0301", [], {}, [1, 1], [[]]),
    *({"value": 19}, {"": {}}, "maestra.demonstration/2", "maestra.exercise/9"),
)
# Half of the inputs are other JSON, the rest other bytes.
JSON_SHARE: Final = 0.5


class BrokenPromiseError(Exception):
    """A reader did what no reader may."""


@dataclass(frozen=True, slots=True)
class Target:
    """A reader, and a file it accepts: the fuzzer would take days to invent one."""

    read: Callable[[bytes], None]
    seed: Callable[[], bytes]


def demonstrations(data: bytes) -> None:
    """A file of demonstrations in two chunks, cut where the first byte says."""
    for demonstration in read_demonstrations(in_chunks(data), "fuzz.jsonl"):
        again = decode_demonstration(encode_demonstration(demonstration).encode())
        demand_same(demonstration, again)


def plays(data: bytes) -> None:
    """A file of plays, whose moves no board need have made."""
    for _, play in read_plays(in_chunks(data), "fuzz.jsonl"):
        ((_, again),) = read_plays([encode_demonstration(play).encode()], "again.jsonl")
        demand_same(play, again)


def exercises(data: bytes) -> None:
    """An exercise."""
    exercise = decode_exercise(data, "fuzz.json")
    demand_same(exercise, decode_exercise(encode_exercise(exercise).encode(), "again.json"))


def words(data: bytes) -> None:
    """A user's own words for attributes, values and relations."""
    read_words(data, "fuzz.json")


def in_chunks(data: bytes) -> Iterator[bytes]:
    """`data` in two pieces."""
    cut = data[0] * len(data) // 256 if data else 0
    yield data[:cut]
    yield data[cut:]


def demand_same(first: object, again: object) -> None:
    """Raise unless what was written and read again is what it was."""
    if first != again:
        msg = f"{first} comes back as {again}"
        raise BrokenPromiseError(msg)


def example(name: str) -> bytes:
    """The first two lines of an example, which is small enough to be changed everywhere."""
    lines = (EXAMPLES / name).read_bytes().splitlines(keepends=True)
    return b"".join(lines[:2])


def learned() -> bytes:
    """The exercise that two demonstrations teach."""
    shown: list[Demonstration] = list(read_demonstrations([example("curie.jsonl")], "seed"))
    return encode_exercise(learn_grounded(shown)).encode()


WORDS: Final = {
    "format": "maestra.words/1",
    "attributes": {"size": {"en": {"noun": "size", "gender": "m", "more": "bigger"}}},
    "values": {"colour": {"red": {"en": "red", "es": "rojo", "ca": "vermell"}}},
    "relations": {"partner": {"en": {"verb": "be", "rest": "the partner of {other}"}}},
}

TARGETS: Final = {
    "demonstrations": Target(demonstrations, lambda: example("ascending.jsonl")),
    "plays": Target(plays, lambda: example("plays/ascending.jsonl")),
    "exercises": Target(exercises, learned),
    "words": Target(words, lambda: json.dumps(WORDS).encode()),
}


def other_file(data: bytes, max_size: int, seed: int) -> bytes:
    """`data` with one value somewhere in its JSON exchanged, or with other bytes."""
    chance = random.Random(seed)
    lines = data.splitlines(keepends=True)
    if lines and chance.random() < JSON_SHARE:
        whole = chance.random() < JSON_SHARE  # an exercise is one value on many lines
        place = chance.randrange(len(lines))
        try:
            value = json.loads(data if whole else lines[place])
        except (ValueError, RecursionError):
            return bytes(atheris.Mutate(data, max_size))
        changed = json.dumps(exchanged(value, chance)).encode() + b"\n"
        rest = b"".join(lines[:place]), b"".join(lines[place + 1 :])
        return (changed if whole else changed.join(rest))[:max_size]
    return bytes(atheris.Mutate(data, max_size))


def exchanged(value: object, chance: random.Random) -> object:
    """`value` with one thing in it removed, doubled, moved or exchanged for an intruder."""
    holders = [holder for holder in nodes(value) if isinstance(holder, dict | list) and holder]
    if not holders:
        return chance.choice(INTRUDERS)
    holder = chance.choice(holders)
    new = chance.choice([chance.choice(INTRUDERS), chance.choice(list(nodes(value)))])
    new = json.loads(json.dumps(new))  # a copy: nothing may end up inside itself
    if isinstance(holder, dict):
        key = chance.choice(list(holder))
        change = chance.randrange(3)
        if change:
            holder[key if change == 1 else chance.choice(["odd", "label", key + "s"])] = new
        else:
            del holder[key]
    else:
        place = chance.randrange(len(holder))
        holder[place : place + chance.randrange(2)] = [new] * chance.randrange(3)
    return value


def nodes(value: object) -> Iterator[object]:
    """`value` and everything in it."""
    yield value
    inside = value.values() if isinstance(value, dict) else value
    if isinstance(value, dict | list):
        for one in inside:
            yield from nodes(one)


def promise(target: Target, data: bytes) -> None:
    """Read `data`, and demand of a refusal that it is one line."""
    try:
        target.read(data)
    except InvalidError as refusal:
        line = str(refusal)
        if not line.isprintable():
            msg = f"a refusal of more than a line: {line!r}"
            raise BrokenPromiseError(msg) from refusal


def main() -> None:
    """Fuzz the target that the first argument names, from the corpus in the second."""
    program, name, folder, *options = sys.argv
    target = TARGETS[name]
    corpus = Path(folder)
    corpus.mkdir(parents=True, exist_ok=True)
    seed = target.seed()
    target.read(seed)  # a seed of an old format would leave the fuzzer at the door
    (corpus / "seed").write_bytes(seed)
    atheris.Setup(
        [program, folder, *options],
        lambda data: promise(target, data),
        custom_mutator=other_file,
    )
    atheris.Fuzz()


if __name__ == "__main__":
    main()
