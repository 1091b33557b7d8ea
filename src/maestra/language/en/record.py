"""English: what the commands on the record say."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

RECORD: Final[Mapping[str, str]] = MappingProxyType(
    {
        "sound": "sound: {signed} of {events} events are signed",
        "recovered": ", {recovered} of them only after a crash",
        "not-sound": "not sound: {finding} (at {sequence})",
        "broken-chain": "an event does not follow from the one before it",
        "gap": "events are missing",
        "not-as-signed": "an event is not what was signed",
        "cut-off": "events that were signed are missing at the end",
        "bad-head": "a head has a wrong signature, or is of another store",
        "no-head": "signed heads are missing",
        "backed-up": "{file}: rows: {count}",
        "restored": "events: {events}",
        "left-out": "; {count} rows of erased patients left out",
        "ask-name": "Name",
        "ask-erase": "Erase everything of {patient}, for ever? [y/N]",
        "yes": "y yes",
        "erased": "erased; delete yourself what you exported "
        "before, and files of keys written before",
    }
)
