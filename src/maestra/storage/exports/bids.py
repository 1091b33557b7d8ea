"""The record as a BIDS data set: one `events.tsv` a session, in the folder `beh`.

After the Brain Imaging Data Structure 1.10, behavioural experiments with no neural recordings
(https://bids-specification.readthedocs.io). Labels in file names are letters and digits alone, so
`participants.tsv` and the side files say which pseudonym and exercise each stands for.
"""

import csv
import json
from collections.abc import Iterable, Mapping
from itertools import groupby
from pathlib import Path
from typing import Final

from maestra import __version__
from maestra.storage.exports.rows import Row

BIDS_VERSION: Final = "1.10.0"
_DESCRIPTIONS: Final[Mapping[str, str]] = {
    "sequence": "Place of the event in the whole record, from 1",
    "source": "start: how the session began; event: what happened; commands: what Maestra did",
    "token": "Id of the token concerned",
    "row": "Row of the board, from 1, the goal row unless the exercise says otherwise",
    "column": "Column of the board, from 1, from the left of the one who plays",
    "step": "Which move of the play is tried, from 1",
    "attempt": "Which attempt at that move, from 1",
    "level": "Assistance: 0 none, 1 encouragement, 2 where to look, 3 a few tokens, "
    "4 the token and its place, 5 offered or placed",
    "by": "Who made or granted the move",
    "text": "What was said",
    "utc": "Time of day, ISO 8601",
}
_COLUMNS: Final = ("onset", "duration", "trial_type", *_DESCRIPTIONS)


def write_bids(rows: Iterable[Row], folder: Path) -> int:
    """Write the data set into `folder`; returns the number of sessions.

    Raises:
        OSError: it cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    subjects, tasks = _Labels(), _Labels()
    sessions: dict[str, int] = {}
    count = 0
    for _, group in groupby(rows, key=lambda row: row.session):
        played = list(group)
        first = played[0]
        sessions[first.patient] = sessions.get(first.patient, 0) + 1
        subject, task = subjects.of(first.patient), tasks.of(first.exercise)
        session = f"{sessions[first.patient]:03}"
        place = folder / f"sub-{subject}" / f"ses-{session}" / "beh"
        place.mkdir(parents=True, exist_ok=True)
        name = f"sub-{subject}_ses-{session}_task-{task}_events"
        _write_events(played, place / f"{name}.tsv")
        _write_json(_about(first), place / f"{name}.json")
        count += 1
    _write_whole(subjects, folder)
    return count


class _Labels:
    """Labels of letters and digits, a different one for each name."""

    def __init__(self) -> None:
        self.known: dict[str, str] = {}

    def of(self, name: str) -> str:
        if name not in self.known:
            plain = "".join(sign for sign in name if sign.isascii() and sign.isalnum()) or "x"
            taken = set(self.known.values())
            label, number = plain, 2
            while label in taken:
                label, number = f"{plain}x{number}", number + 1
            self.known[name] = label
        return self.known[name]


def _write_events(rows: Iterable[Row], path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(
            file,
            delimiter="\t",
            lineterminator="\n",
            quoting=csv.QUOTE_NONE,
            escapechar=None,
            quotechar=None,
        )
        writer.writerow(_COLUMNS)
        for row in rows:
            told = [_cell(getattr(row, name)) for name in _DESCRIPTIONS]
            writer.writerow([f"{row.at_ms / 1000:.3f}", "0", row.type, *told])


def _cell(value: str | int | None) -> str:
    """A value as BIDS has it: `n/a` for none, and no tabulator within."""
    return " ".join(str(value).split()) or "n/a" if value is not None else "n/a"


def _about(row: Row) -> dict[str, object]:
    return {
        "TaskName": row.exercise,
        "TaskDescription": "A rearranging exercise, played with Maestra",
        "StimulusPresentation": {
            "SoftwareName": "Maestra",
            "SoftwareVersion": row.maestra or __version__,
        },
        "ExerciseVersion": row.version,
        "Seed": row.seed,
        "Session": row.session,
        "trial_type": {"Description": "What happened, or what was done or noted"},
        **{name: {"Description": text} for name, text in _DESCRIPTIONS.items()},
    }


def _write_whole(subjects: _Labels, folder: Path) -> None:
    _write_json(
        {
            "Name": "Sessions recorded by Maestra",
            "BIDSVersion": BIDS_VERSION,
            "DatasetType": "raw",
            "GeneratedBy": [{"Name": "Maestra", "Version": __version__}],
        },
        folder / "dataset_description.json",
    )
    (folder / "README").write_text(
        "Sessions of rearranging exercises, recorded by Maestra. Participants are pseudonyms. "
        "Onsets are seconds since the session began. No event lasts: each has duration 0.\n",
        encoding="utf-8",
    )
    lines = ["participant_id\tpseudonym"]
    lines += [f"sub-{label}\t{name}" for name, label in subjects.known.items()]
    (folder / "participants.tsv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    _write_json(
        {"pseudonym": {"Description": "What Maestra calls the participant"}},
        folder / "participants.json",
    )


def _write_json(value: object, path: Path) -> None:
    path.write_text(json.dumps(value, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
