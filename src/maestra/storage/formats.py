"""The record's files as JSON: signed heads, backups, keys, everything of a patient."""

from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr

HEAD_FORMAT: Final = "maestra.head/1"
BACKUP_FORMAT: Final = "maestra.backup/1"
KEYS_FORMAT: Final = "maestra.keys/1"
PATIENT_FORMAT: Final = "maestra.patient/1"

_Id = Annotated[StrictStr, Field(pattern=r"^[0-9a-fA-F]{32}$")]
_Key = Annotated[StrictStr, Field(pattern=r"^[0-9a-fA-F]{64}$")]
_Utc = Annotated[StrictStr, Field(min_length=1)]
_Count = Annotated[StrictInt, Field(ge=0)]
_Object = dict[str, Any]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class HeadJson(_Strict):
    """A line of `heads.jsonl`: how far the chain of events went, signed."""

    format: Annotated[Literal["maestra.head/1"], Field(description="This format's name.")]
    store: Annotated[_Id, Field(description="The database that it speaks of.")]
    kind: Annotated[
        Literal["begun", "written", "recovered", "restored"],
        Field(description="Why it was signed."),
    ]
    sequence: Annotated[_Count, Field(description="The last event; 0 if there is none yet.")]
    digest: Annotated[_Key, Field(description="Of the chain there: SHA-256.")]
    utc: Annotated[_Utc, Field(description="When it was signed.")]
    signature: Annotated[
        StrictStr,
        Field(
            pattern=r"^[0-9a-fA-F]{128}$",
            description="Ed25519, of the other fields as JSON: names sorted, no blanks.",
        ),
    ]


class BackupJson(_Strict):
    """The first line of a backup, unzipped.

    Each further line is a row, `[table, [values]]`, bytes as `{"base64": ...}`; the last one is
    `{"sha256": ...}` of all lines before it.
    """

    format: Annotated[Literal["maestra.backup/1"], Field(description="This format's name.")]
    store: Annotated[_Id, Field(description="The database; its keys have a folder of this name.")]
    tables: Annotated[StrictStr, Field(description="The version of the tables.")]


class KeysJson(_Strict):
    """All keys of a store in one file: whoever has it can read everything."""

    format: Annotated[Literal["maestra.keys/1"], Field(description="This format's name.")]
    store: Annotated[_Id, Field(description="The database that they open.")]
    tags: Annotated[_Key, Field(description="For HMAC-SHA256: tags of pseudonyms and sessions.")]
    signing: Annotated[_Key, Field(description="Ed25519, private: signs heads.")]
    heads: Annotated[
        list[StrictStr], Field(description="The lines of `heads.jsonl`, as `maestra.head/1`.")
    ]
    subjects: Annotated[
        dict[_Id, _Key], Field(description="For AES-256-GCM: a key for each patient.")
    ]


class EntryJson(_Strict):
    """What happened in a session, or what was done."""

    session: Annotated[StrictStr, Field(description="The session.")]
    key: Annotated[StrictStr, Field(description="Unique in the record: told twice, kept once.")]
    at: Annotated[_Count, Field(description="Milliseconds since the session began.")]
    utc: Annotated[_Utc, Field(description="The time of day.")]
    kind: Annotated[StrictStr, Field(description="start, event or commands.")]
    payload: Annotated[
        _Object | list[_Object], Field(description="The start, the event or the commands.")
    ]
    sequence: Annotated[_Count, Field(description="The place in the record.")]


class SessionJson(_Strict):
    """A session of a patient."""

    session: Annotated[StrictStr, Field(description="Its name.")]
    patient: Annotated[StrictStr, Field(description="A pseudonym.")]
    exercise: Annotated[StrictStr, Field(description="What was played.")]
    version: Annotated[_Count, Field(description="The exercise's.")]
    settings: Annotated[_Object, Field(description="When it began: `maestra.settings/1`.")]
    begun_utc: Annotated[_Utc, Field(description="When it began.")]
    ended_utc: Annotated[_Utc | None, Field(description="When it ended, if it did.")]
    events: Annotated[list[EntryJson], Field(description="What happened, in order.")]


class PatientJson(_Strict):
    """Everything that is kept of a patient."""

    format: Annotated[Literal["maestra.patient/1"], Field(description="This format's name.")]
    patient: Annotated[StrictStr, Field(description="A pseudonym.")]
    name: Annotated[StrictStr | None, Field(description="Who it is, if that is kept.")]
    settings: Annotated[
        _Object | None, Field(description="As `maestra.settings/1` has them, if there are any.")
    ]
    plan: Annotated[_Object | list[Any] | None, Field(description="What is planned, if anything.")]
    sessions: Annotated[list[SessionJson], Field(description="The oldest first.")]
