"""Spanish: what the commands on the record say."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

RECORD: Final[Mapping[str, str]] = MappingProxyType(
    {
        "sound": "íntegro: {signed} de {events} sucesos están firmados",
        "recovered": ", {recovered} de ellos solo tras una interrupción",
        "not-sound": "no es íntegro: {finding} (en {sequence})",
        "broken-chain": "un suceso no sigue al anterior",
        "gap": "faltan sucesos",
        "not-as-signed": "un suceso no es el que se firmó",
        "cut-off": "faltan al final sucesos que se firmaron",
        "bad-head": "una cabecera tiene una firma falsa o es de otro registro",
        "no-head": "faltan cabeceras firmadas",
        "backed-up": "{file}: filas: {count}",
        "restored": "sucesos: {events}",
        "left-out": "; se omiten {count} filas de pacientes borrados",
        "ask-name": "Nombre",
        "ask-erase": "¿Borrar todo lo de {patient}, para siempre? [s/N]",
        "yes": "s sí si",
        "erased": "borrado; elimine usted lo que exportó antes "
        "y los archivos de claves escritos antes",
    }
)
