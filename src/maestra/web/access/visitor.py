"""Who asks for a page, and what their role lets them do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Final, NewType

from maestra.language import Language

AccountId = NewType("AccountId", str)
"""Random, and never shown: names can be changed."""


class Role(Enum):
    """What somebody is here."""

    CAREGIVER = "caregiver"
    RESEARCHER = "researcher"
    ADMINISTRATOR = "administrator"


class Right(Enum):
    """What a page may demand of who opens it."""

    TEACH = "teach"
    """Exercises: teach, edit, import, share."""
    ACCOMPANY = "accompany"
    """Their own patients: settings, sessions, progress, names."""
    STUDY = "study"
    """Progress and exports of all patients, by pseudonym only."""
    ADMINISTER = "administer"
    """Accounts, devices, the audit."""


RIGHTS: Final[Mapping[Role, frozenset[Right]]] = MappingProxyType(
    {
        Role.CAREGIVER: frozenset({Right.TEACH, Right.ACCOMPANY}),
        Role.RESEARCHER: frozenset({Right.TEACH, Right.STUDY}),
        Role.ADMINISTRATOR: frozenset(Right),
    }
)


@dataclass(frozen=True, slots=True)
class Visitor:
    """Who is logged in."""

    account: AccountId
    name: str
    role: Role
    language: Language

    def may(self, right: Right) -> bool:
        """Whether the role gives this right."""
        return right in RIGHTS[self.role]
