"""Catalan: what the commands on the record say."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

RECORD: Final[Mapping[str, str]] = MappingProxyType(
    {
        "sound": "íntegre: {signed} de {events} esdeveniments estan signats",
        "recovered": ", {recovered} d'ells només després d'una interrupció",
        "not-sound": "no és íntegre: {finding} (a {sequence})",
        "broken-chain": "un esdeveniment no segueix l'anterior",
        "gap": "falten esdeveniments",
        "not-as-signed": "un esdeveniment no és el que es va signar",
        "cut-off": "falten al final esdeveniments que es van signar",
        "bad-head": "una capçalera té una signatura falsa o és d'un altre registre",
        "no-head": "falten capçaleres signades",
        "backed-up": "{file}: files: {count}",
        "restored": "esdeveniments: {events}",
        "left-out": "; s'ometen {count} files de pacients esborrats",
        "ask-name": "Nom",
        "ask-erase": "Voleu esborrar-ho tot de {patient}, per sempre? [s/N]",
        "yes": "s sí si",
        "erased": "esborrat; elimineu vosaltres el que vau exportar "
        "abans i els fitxers de claus escrits abans",
    }
)
