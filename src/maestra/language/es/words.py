"""The words of Spanish; caregivers are addressed as "usted"."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from maestra.language.keys import Key, Predicate
from maestra.language.templates import Gender
from maestra.language.tongue import AttributeWords, Naming, VerbForms, Words
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW

_SENTENCES: Final = {
    Key.PLACE: "Ponga {tokens} en {row}, {order}.",
    Key.LEFT_TO_RIGHT: "de izquierda a derecha",
    Key.RIGHT_TO_LEFT: "de derecha a izquierda",
    Key.ENDS_FIRST: "de los extremos hacia el centro",
    Key.MIDDLE_FIRST: "del centro hacia los extremos",
    Key.ANY_ORDER: "en cualquier orden",
    Key.IN_THIS_ORDER: "en este orden",
    Key.THE_TOKENS: "las fichas",
    Key.SO_MANY_TOKENS: "{count} [count#ficha|fichas]",
    Key.FILL_ROW: "Llene toda {row}.",
    Key.UNTIL_TOTAL: "Pare cuando [attribute@los|las] {attribute:plural} sumen {k} o más.",
    Key.NTH_IS: "{nth:feminine}: {tokens}.",
    Key.NTH_IS_THERE: "{nth:feminine}: {tokens}, en {place}.",
    Key.NTH_THERE: "{nth:feminine}: {place}.",
    Key.ONLY: "Use solo {kind}.",
    Key.NONE: "No use {kind}.",
    Key.ONLY_THAT: "Use solo fichas que {does:do}.",
    Key.USE_ALL: "Use [kind@todos los|todas las] {kind}.",
    Key.USE_ALL_TOKENS: "Use todas las fichas.",
    Key.USE_ALL_THAT: "Use todas las fichas que {does:do}.",
    Key.HAS_ONE_THAT: "La fila debe tener {amount} ficha que {does:that}.",
    Key.HAS_MANY_THAT: "La fila debe tener {amount} fichas que {does:do}.",
    Key.ROW_HAS_ONE_THAT: "la fila tiene {amount} ficha que {does:that}",
    Key.ROW_HAS_MANY_THAT: "la fila tiene {amount} fichas que {does:do}",
    Key.PLACE_SO_MANY: "Ponga {amount} [count#ficha|fichas].",
    Key.HAS_MORE_THAN: "La fila debe tener más fichas que {first:do} que fichas que {second:do}.",
    Key.HAS_FEWER_THAN: (
        "La fila debe tener menos fichas que {first:do} que fichas que {second:do}."
    ),
    Key.HAS_AS_MANY_AS: (
        "La fila debe tener tantas fichas que {first:do} como fichas que {second:do}."
    ),
    Key.HAS_AT_LEAST_AS_MANY_AS: (
        "La fila debe tener al menos tantas fichas que {first:do} como fichas que {second:do}."
    ),
    Key.HAS_AT_MOST_AS_MANY_AS: (
        "La fila debe tener como máximo tantas fichas que {first:do} como fichas que {second:do}."
    ),
    Key.HAS_NOT_AS_MANY_AS: (
        "La fila no debe tener tantas fichas que {first:do} como fichas que {second:do}."
    ),
    Key.KINDS: (
        "El número de {attribute:plural} [attribute@distintos|distintas] de la fila "
        "debe ser {amount}."
    ),
    Key.TOTAL: "[attribute@Los|Las] {attribute:plural} de la fila deben sumar {amount}.",
    Key.EQUATION: "Según {attribute:the}, {left} debe dar {right}.",
    Key.WORD: "[attribute@Los|Las] {attribute:plural} deben formar una palabra de la lista.",
    Key.WORD_WITH: (
        "[attribute@Los|Las] {attribute:plural} deben formar una palabra de la lista, "
        "con {relation} «{value}»."
    ),
    Key.EXACTLY: "exactamente {k}",
    Key.AT_LEAST: "al menos {k}",
    Key.AT_MOST: "como máximo {k}",
    Key.MORE_THAN: "más de {k}",
    Key.FEWER_THAN: "menos de {k}",
    Key.NOT_EXACTLY: "un número distinto de {k}",
    Key.FROM_ROW: "Tome las fichas solo {row:of}.",
    Key.NOT_FROM_ROW: "No tome fichas {row:of}.",
    Key.FROM_COLUMN: "Tome las fichas solo de la columna {column}.",
    Key.NOT_FROM_COLUMN: "No tome fichas de la columna {column}.",
    Key.SAME_COLUMN: "Deje cada ficha en su columna.",
    Key.MIRRORED_COLUMN: "Lleve cada ficha a la columna opuesta, como en un espejo.",
    Key.TAKE: "La ficha que tome {does}.",
    Key.TAKE_OF_THOSE: "De las fichas que {among:do}, la ficha que tome {does}.",
    Key.EACH_TOKEN: "Cada ficha {does:must}.",
    Key.IN_EACH_PAIR: "De dos en dos: cada segunda ficha {does:must}.",
    Key.IN_RIGHT_HALF: "Cada ficha de la mitad derecha {does:must}.",
    Key.SUBJECT_MUST: "{subject} {does:must}.",
    Key.CYCLE_RISING: (
        "{along}, [attribute@los|las] {attribute:plural} van hacia delante; "
        "tras [attribute@el último|la última] viene [attribute@el primero|la primera]."
    ),
    Key.CYCLE_FALLING: (
        "{along}, [attribute@los|las] {attribute:plural} van hacia atrás; "
        "tras [attribute@el primero|la primera] viene [attribute@el último|la última]."
    ),
    Key.RISE_AND_FALL: (
        "{along}, [attribute@los|las] {attribute:plural} primero suben y luego bajan."
    ),
    Key.FALL_AND_RISE: (
        "{along}, [attribute@los|las] {attribute:plural} primero bajan y luego suben."
    ),
    Key.ZIGZAG: "{along}, [attribute@los|las] {attribute:plural} suben y bajan por turnos.",
    Key.EQUAL_STEPS: (
        "{along}, [attribute@los|las] {attribute:plural} cambian cada vez en lo mismo."
    ),
    Key.EQUAL_RATIOS: (
        "{along}, [attribute@los|las] {attribute:plural} se multiplican cada vez por lo mismo."
    ),
    Key.ALONG_THE_ROW: "de izquierda a derecha",
    Key.IN_TIME: "en el orden en que las ponga",
    Key.THIS_ROW: "Forme esta fila: {tokens:bare}.",
    Key.PATTERN: "{along}: {steps}.",
    Key.PATTERN_REPEATED: "{along}: {steps}, y otra vez desde el principio.",
    Key.NTH_DOES: "la {nth:feminine} {does}",
    Key.NTH_FREE: "la {nth:feminine} es cualquiera",
    Key.TEMPLATE: "{along}, [attribute@los|las] {attribute:plural} siguen el patrón {pattern}.",
    Key.TEMPLATE_REPEATED: (
        "{along}, [attribute@los|las] {attribute:plural} siguen el patrón {pattern} "
        "una y otra vez."
    ),
    Key.BLOCKS: "{along}, las fichas con [attribute@el mismo|la misma] {attribute} van juntas.",
    Key.IF_THEN: "Si {condition}, entonces {consequence}.",
    Key.SUBJECT_DOES: "{subject} {does}",
    Key.SMALL_TO_LARGE: "de menor a mayor.",
    Key.LARGE_TO_SMALL: "de mayor a menor.",
    Key.IN_THE_ALPHABET: "en orden alfabético.",
    Key.BACK_IN_THE_ALPHABET: "en orden alfabético inverso.",
    Key.FIRST_TO_LAST: (
        "[attribute@del primer|de la primera] {attribute} [attribute@al último|a la última]."
    ),
    Key.LAST_TO_FIRST: (
        "[attribute@del último|de la última] {attribute} [attribute@al primero|a la primera]."
    ),
    Key.ALL_THE_SAME: "todas las fichas tienen [attribute@el mismo|la misma] {attribute}.",
    Key.ALL_DIFFERENT: "todas las fichas tienen {attribute:plural} diferentes.",
    Key.NEIGHBOURS_DIFFER: "las fichas vecinas tienen {attribute:plural} diferentes.",
    Key.SPELL: "escriba {word}.",
    Key.HAS_OF_KIND: "La fila debe tener {amount} {kind}.",
    Key.EITHER_OF: "o bien {several}",
    Key.BOTH_OF: "a la vez {several}",
    Key.BY_ATTRIBUTE: "según {attribute:the}",
    Key.IN_THAT_ORDER: "en ese orden",
    Key.ALL_BEFORE: "Ponga todas las fichas que {first:do} antes que las que {second:do}.",
    Key.ALL_LEFT_OF: (
        "Todas las fichas que {first:do} deben ir a la izquierda de las que {second:do}."
    ),
    Key.NEXT_AFTER: (
        "Después de una ficha que {first:that}, ponga enseguida una que {second:that}."
    ),
    Key.LATER_AFTER: (
        "Después de una ficha que {first:that}, ponga más tarde una que {second:that}."
    ),
    Key.NEXT_RIGHT_OF: (
        "Justo a la derecha de una ficha que {first:that}, ponga una que {second:that}."
    ),
    Key.LATER_RIGHT_OF: "A la derecha de una ficha que {first:that}, ponga una que {second:that}.",
    Key.MODEL_COPIED: (
        "{row} es el modelo y no se mueve: cada ficha {does:must}, columna por columna."
    ),
    Key.MODEL_MIRRORED: (
        "{row} es el modelo y no se mueve: cada ficha {does:must}, como en un espejo."
    ),
    Key.MODEL_REVERSED: (
        "{row} es el modelo y no se mueve: cada ficha {does:must}, leído de derecha a izquierda."
    ),
    Key.CUE: "La ficha {place:of} no se mueve: cada ficha {does:must}.",
    Key.THE_ONE_ON_ITS_LEFT: "la de su izquierda",
    Key.THE_ONE_BEFORE_IT: "la anterior",
    Key.THE_NEIGHBOUR_ON_ITS_LEFT: "la que está justo a su izquierda",
    Key.THE_ONE_JUST_BEFORE_IT: "la que ha puesto justo antes",
    Key.EVERY_ONE_ON_ITS_LEFT: "todas las de su izquierda",
    Key.EVERY_ONE_BEFORE_IT: "todas las anteriores",
    Key.THE_OPPOSITE_ONE: "la opuesta",
    Key.ITS_MODEL: "su modelo",
    Key.THIS_ONE: "esta",
    Key.NTH_FROM_LEFT: "la {nth:feminine} ficha desde la izquierda",
    Key.NTH_FROM_RIGHT: "la {nth:feminine} ficha desde la derecha",
    Key.LAST_OF_ROW: "la última ficha de la fila",
    Key.MIDDLE_OF_ROW: "la ficha del centro",
    Key.NTH_PLACED: "la {nth:feminine} ficha que ponga",
    Key.LAST_PLACED: "la última ficha que ponga",
    Key.TOKEN_ON_ITS_LEFT: "{token} de su izquierda",
    Key.TOKEN_ON_ITS_RIGHT: "{token} de su derecha",
    Key.TOKEN_IN_PLACE: "{token} {place:of}",
    Key.IT: "",
    Key.TOKEN_IN_COLUMN: "{token} de la columna {column}",
    Key.WHAT_LIES_IN_COLUMNS: "las fichas {row:of}, columnas {columns}",
    Key.WHAT_LIES_THERE: "la ficha {place:of}",
    Key.SEEN_GO: "Hasta ahora solo he visto {tokens} en {nth} lugar.",
    Key.SEEN_COME: "Hasta ahora solo he visto {tokens} en {nth} lugar desde {place}.",
    Key.SEEN_GO_TO: "Hasta ahora solo he visto {tokens} en {nth} lugar hacia {place}.",
    Key.SEEN_ONLY_IF: "Hasta ahora, {tokens} solo puede ir en {nth} lugar si {conditions}.",
    Key.SEEN_TOO_SELDOM: (
        "Aún no he visto {tokens} en {nth} lugar en suficientes jugadas distintas."
    ),
    Key.MAY_GO: "{token} puede ir en {nth} lugar.",
    Key.MAY_GO_IF: "{token} puede ir en {nth} lugar si {conditions}.",
    Key.EXACT: "He comparado estas frases con lo que he aprendido: dicen lo mismo.",
    Key.NOT_COMPARED: "No he podido comparar estas frases con todo lo que he aprendido.",
    Key.GOES_TO: "va {place:to}",
    Key.COMES_FROM: "viene {place:of}",
    Key.COMES_FROM_ROW: "viene {row:of}",
    Key.COMES_FROM_COLUMN: "viene de la columna {column}",
    Key.GOES_TO_COLUMN: "va a la columna {column}",
    Key.KEEPS_COLUMN: "se queda en su columna",
    Key.COMES_FROM_STORAGE: "viene de una fila de reserva",
    Key.GOES_TO_GOAL_ROW: "va a la fila de destino",
    Key.IT_DOES: "{does}",
    Key.TOKEN_THERE_DOES: "la ficha {place:of} {does}",
    Key.LIES_THERE: "{token} está en {place}",
    Key.NOT_SO: "{does:clause}.",
    Key.WRONG_PLACE: "{token} va {place:to}.",
    Key.NEXT_PLACE: "La siguiente ficha va {place:to}.",
    Key.WRONG_COLUMN: "{token} va a la columna {column}.",
    Key.WRONG_ORIGIN: "Hasta ahora, {token} ha venido {place:of}.",
    Key.WRONG_ORIGIN_ROW: "Las fichas vienen {row:of}.",
    Key.WRONG_ORIGIN_COLUMN: "Hasta ahora, {token} ha venido de la columna {column}.",
    Key.OTHER_COLUMN: "{token} se queda en su columna.",
    Key.NOT_FROM_STORAGE: "{token} ya está en {row}.",
    Key.NOT_TO_GOAL_ROW: "Las fichas van {row:to}.",
    Key.NOTHING_THERE: "Aún no hay ninguna ficha en {place}.",
    Key.BELONGS_THERE: "Hasta ahora, antes estaba {token} en {place}.",
    Key.NOT_SHOWN: "Aún no he visto {tokens} en {nth} lugar.",
    Key.DEAD_END: "Así ya no se puede llenar la fila.",
    Key.NO_WAY_ON: "Así la fila ya no puede quedar bien.",
    Key.NOT_NOW: "Esta ficha no va aquí ahora.",
    Key.ASK_CAREGIVER: "Esto aún no lo he visto: pregunte a su acompañante.",
    Key.AFTER_THE_END: "La fila ya está completa.",
}

_PREDICATES: Final = {
    Predicate.ODD: ("ser", "[subject#impar|impares]"),
    Predicate.EVEN: ("ser", "[subject#par|pares]"),
    Predicate.PRIME: ("ser", "un número primo"),
    Predicate.VOWEL: ("ser", "[subject#una vocal|vocales]"),
    Predicate.CONSONANT: ("ser", "[subject#una consonante|consonantes]"),
    Predicate.MULTIPLE_OF: ("ser", "[subject#múltiplo|múltiplos] de {k}"),
    Predicate.DIGITS: ("tener", "{k} [k#cifra|cifras]"),
    Predicate.ABOVE: ("estar", "por encima de {k}"),
    Predicate.BELOW: ("estar", "por debajo de {k}"),
    Predicate.IS: ("ser", "{value}"),
    Predicate.SHOWS: ("ser", "de {attribute} {value}"),
    Predicate.HAS_ABOVE: ("tener", "{attribute:the} por encima de {k}"),
    Predicate.HAS_BELOW: ("tener", "{attribute:the} por debajo de {k}"),
    Predicate.AMOUNT: ("ser", "{amount}"),
    Predicate.HAS_AMOUNT: ("tener", "{attribute:the} de {amount}"),
    Predicate.LEVEL: ("ir", "en el mismo lugar que {other}"),
    Predicate.LEVEL_OR_AFTER: ("ir", "en el mismo lugar que {other} o después"),
    Predicate.LEVEL_OR_BEFORE: ("ir", "en el mismo lugar que {other} o antes"),
    Predicate.BEFORE_OR_AFTER: ("ir", "antes o después {other:of}"),
    Predicate.FROM_ROW: ("venir", "{row:of}"),
    Predicate.FROM_COLUMN: ("venir", "de la columna {column}"),
    Predicate.AMONG_MOST: ("estar", "entre las {count} {adjective}"),
    Predicate.AMONG_LEAST: ("estar", "entre las {count} {adjective}"),
    Predicate.AMONG_HIGHEST: ("estar", "entre las {count} de mayor {attribute}"),
    Predicate.AMONG_LOWEST: ("estar", "entre las {count} de menor {attribute}"),
    Predicate.AMONG_MOST_OF_ROW: ("estar", "entre las {adjective} que llenan la fila"),
    Predicate.AMONG_LEAST_OF_ROW: ("estar", "entre las {adjective} que llenan la fila"),
    Predicate.AMONG_HIGHEST_OF_ROW: ("estar", "entre las de mayor {attribute} que llenan la fila"),
    Predicate.AMONG_LOWEST_OF_ROW: ("estar", "entre las de menor {attribute} que llenan la fila"),
    Predicate.MOST: ("ser", "la {adjective} de la fila"),
    Predicate.LEAST: ("ser", "la {adjective} de la fila"),
    Predicate.HIGHEST: ("ser", "la de mayor {attribute} de la fila"),
    Predicate.LOWEST: ("ser", "la de menor {attribute} de la fila"),
    Predicate.MOST_LEFT: ("ser", "siempre la {adjective} de las que quedan"),
    Predicate.LEAST_LEFT: ("ser", "siempre la {adjective} de las que quedan"),
    Predicate.HIGHEST_LEFT: ("ser", "siempre la de mayor {attribute} de las que quedan"),
    Predicate.LOWEST_LEFT: ("ser", "siempre la de menor {attribute} de las que quedan"),
    Predicate.LEFTMOST: ("ser", "siempre la que está más a la izquierda de las que quedan"),
    Predicate.RIGHTMOST: ("ser", "siempre la que está más a la derecha de las que quedan"),
    Predicate.TOPMOST: ("ser", "siempre de la fila más alta de las que quedan"),
    Predicate.BOTTOMMOST: ("ser", "siempre de la fila más baja de las que quedan"),
    Predicate.ANYTHING: ("ser", "[subject#cualquiera|cualesquiera]"),
    Predicate.NOTHING: ("ser", "de ninguna clase"),
    Predicate.MORE: ("ser", "{adjective} que {other}"),
    Predicate.LESS: ("ser", "{adjective} que {other}"),
    Predicate.HAS_MORE: ("tener", "mayor {attribute} que {other}"),
    Predicate.HAS_LESS: ("tener", "menor {attribute} que {other}"),
    Predicate.AFTER: ("ir", "después {other:of}"),
    Predicate.BEFORE: ("ir", "antes {other:of}"),
    Predicate.AFTER_IN_ALPHABET: ("ir", "después {other:of} en el alfabeto"),
    Predicate.BEFORE_IN_ALPHABET: ("ir", "antes {other:of} en el alfabeto"),
    Predicate.MORE_BY: ("tener", "{k} más que {other}"),
    Predicate.LESS_BY: ("tener", "{k} menos que {other}"),
    Predicate.NEXT: ("ir", "justo después {other:of}"),
    Predicate.PREVIOUS: ("ir", "justo antes {other:of}"),
    Predicate.NEXT_IN_ALPHABET: ("ir", "justo después {other:of} en el alfabeto"),
    Predicate.PREVIOUS_IN_ALPHABET: ("ir", "justo antes {other:of} en el alfabeto"),
    Predicate.AFTER_BY: ("ir", "{k} posiciones después {other:of}"),
    Predicate.BEFORE_BY: ("ir", "{k} posiciones antes {other:of}"),
    Predicate.AFTER_BY_IN_ALPHABET: ("ir", "{k} posiciones después {other:of} en el alfabeto"),
    Predicate.BEFORE_BY_IN_ALPHABET: ("ir", "{k} posiciones antes {other:of} en el alfabeto"),
    Predicate.APART_BY: ("diferenciarse", "en {k} {other:of}"),
    Predicate.TWICE: ("ser", "el doble {other:of}"),
    Predicate.HALF: ("ser", "la mitad {other:of}"),
    Predicate.TIMES: ("ser", "{k} veces {other}"),
    Predicate.TOGETHER: ("sumar", "{k} con {other}"),
    Predicate.SAME: ("tener", "[attribute@el mismo|la misma] {attribute} que {other}"),
    Predicate.DIFFERENT: ("tener", "[attribute@otro|otra] {attribute} que {other}"),
    Predicate.SAME_ACROSS: ("tener", "como {attribute} {theirs:the} {other:of}"),
    Predicate.MORE_ACROSS: ("tener", "mayor {attribute} que {theirs:the} {other:of}"),
    Predicate.LESS_ACROSS: ("tener", "menor {attribute} que {theirs:the} {other:of}"),
    Predicate.RELATED: ("estar", "en relación «{relation}» con {other}"),
    Predicate.RELATED_BACK: ("estar", "en relación «{relation}» inversa con {other}"),
}

_KINDS: Final = {
    Predicate.ODD: "{things} impares",
    Predicate.EVEN: "{things} pares",
    Predicate.PRIME: "{things} [things@primos|primas]",
    Predicate.VOWEL: "vocales",
    Predicate.CONSONANT: "consonantes",
    Predicate.MULTIPLE_OF: "múltiplos de {k}",
    Predicate.DIGITS: "{things} de {k} [k#cifra|cifras]",
    Predicate.ABOVE: "{things} por encima de {k}",
    Predicate.BELOW: "{things} por debajo de {k}",
    Predicate.HAS_ABOVE: "fichas con {attribute:the} por encima de {k}",
    Predicate.HAS_BELOW: "fichas con {attribute:the} por debajo de {k}",
    Predicate.IS: "fichas {value:bare}",
    Predicate.SHOWS: "fichas de {attribute} {value}",
}


def _verb(base: str, third: str, that: str, those: str) -> VerbForms:
    return VerbForms(
        must=f"debe {base}",
        must_not=f"no debe {base}",
        does=third,
        does_not=f"no {third}",
        that=that,
        that_not=f"no {that}",
        do=those,
        do_not=f"no {those}",
    )


_VERBS: Final = {
    "ser": _verb("ser", "es", "sea", "sean"),
    "estar": _verb("estar", "está", "esté", "estén"),
    "tener": _verb("tener", "tiene", "tenga", "tengan"),
    "ir": _verb("ir", "va", "vaya", "vayan"),
    "venir": _verb("venir", "viene", "venga", "vengan"),
    "sumar": _verb("sumar", "suma", "sume", "sumen"),
    "diferenciarse": _verb("diferenciarse", "se diferencia", "se diferencie", "se diferencien"),
}

_BIG: Final = "mayor|mayor|mayores|mayores"
_SMALL: Final = "menor|menor|menores|menores"
_M, _F = Gender.MASCULINE, Gender.FEMININE


def _word(
    noun: str, plural: str, gender: Gender, naming: Naming | None = Naming.WORD
) -> AttributeWords:
    return AttributeWords(noun, gender, plural, naming=naming)


def _measure(
    noun: str, plural: str, gender: Gender, adjectives: tuple[str, str]
) -> AttributeWords:
    more, less = (_more(adjective) for adjective in adjectives)
    return AttributeWords(noun, gender, plural, more=more, less=less, most=more, least=less)


def _more(adjective: str) -> str:
    """The comparative in all four forms of an adjective given as ``larg|o`` or ``grande``."""
    stem, _, ending = adjective.partition("|")
    endings = ("o", "a", "os", "as") if ending else ("", "", "s", "s")
    return "|".join(f"más {stem}{end}" for end in endings)


_NUMBER: Final = AttributeWords(
    "número",
    _M,
    "números",
    things="números",
    more=_BIG,
    less=_SMALL,
    most=_BIG,
    least=_SMALL,
    naming=Naming.PLAIN,
)
_OLDER: Final = _more("viej|o")
_YOUNGER: Final = "más joven|más joven|más jóvenes|más jóvenes"
_COLOUR: Final = _word("color", "colores", _M, Naming.QUALITY)

_ATTRIBUTES: Final = {
    "value": _NUMBER,
    "number": _NUMBER,
    "letter": AttributeWords("letra", _F, "letras", things="letras", naming=Naming.PLAIN),
    "colour": _COLOUR,
    "color": _COLOUR,
    "shape": _word("forma", "formas", _F, None),
    "category": _word("categoría", "categorías", _F, None),
    "size": _measure("tamaño", "tamaños", _M, ("grande", "pequeñ|o")),
    "length": _measure("longitud", "longitudes", _F, ("larg|o", "cort|o")),
    "height": _measure("altura", "alturas", _F, ("alt|o", "baj|o")),
    "weight": _measure("peso", "pesos", _M, ("pesad|o", "liger|o")),
    "price": _measure("precio", "precios", _M, ("car|o", "barat|o")),
    "age": AttributeWords(
        "edad", _F, "edades", more=_OLDER, less=_YOUNGER, most=_OLDER, least=_YOUNGER
    ),
    "name": _word("nombre", "nombres", _M),
    "picture": _word("dibujo", "dibujos", _M),
    "word": _word("palabra", "palabras", _F),
    "day": _word("día", "días", _M),
    "month": _word("mes", "meses", _M),
    ORIGIN_ROW: _word("fila de salida", "filas de salida", _F, None),
    ORIGIN_COLUMN: _word("columna de salida", "columnas de salida", _F, None),
}

_COLOURS: Final = {
    "red": "rojo|roja|rojos|rojas",
    "blue": "azul|azul|azules|azules",
    "green": "verde|verde|verdes|verdes",
    "yellow": "amarillo|amarilla|amarillos|amarillas",
    "black": "negro|negra|negros|negras",
    "white": "blanco|blanca|blancos|blancas",
    "orange": "naranja",
    "pink": "rosa",
    "purple": "morado|morada|morados|moradas",
    "brown": "marrón|marrón|marrones|marrones",
    "grey": "gris|gris|grises|grises",
    "gray": "gris|gris|grises|grises",
}

WORDS: Final = Words(
    sentences=MappingProxyType(_SENTENCES),
    predicates=MappingProxyType(_PREDICATES),
    kinds=MappingProxyType(_KINDS),
    verbs=MappingProxyType(_VERBS),
    attributes=MappingProxyType(_ATTRIBUTES),
    values=MappingProxyType(
        {
            (attribute, value): word
            for attribute in ("colour", "color")
            for english, word in _COLOURS.items()
            for value in (english, word.split("|")[0])
        }
    ),
)
