"""The words of Catalan; caregivers are addressed as "vós"."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from maestra.language.keys import Key, Predicate
from maestra.language.templates import Gender
from maestra.language.tongue import AttributeWords, Naming, VerbForms, Words
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW

_SENTENCES: Final = {
    Key.PLACE: "Poseu {tokens} a {row}, {order}.",
    Key.LEFT_TO_RIGHT: "d'esquerra a dreta",
    Key.RIGHT_TO_LEFT: "de dreta a esquerra",
    Key.ENDS_FIRST: "dels extrems cap al mig",
    Key.MIDDLE_FIRST: "del mig cap als extrems",
    Key.ANY_ORDER: "en qualsevol ordre",
    Key.IN_THIS_ORDER: "en aquest ordre",
    Key.THE_TOKENS: "les fitxes",
    Key.SO_MANY_TOKENS: "{count} [count#fitxa|fitxes]",
    Key.FILL_ROW: "Ompliu tota {row}.",
    Key.UNTIL_TOTAL: "Pareu quan [attribute@els|les] {attribute:plural} sumin {k} o més.",
    Key.NTH_IS: "{nth:feminine}: {tokens}.",
    Key.NTH_IS_THERE: "{nth:feminine}: {tokens}, a {place}.",
    Key.NTH_THERE: "{nth:feminine}: {place}.",
    Key.ONLY: "Feu servir només {kind}.",
    Key.NONE: "No feu servir {kind}.",
    Key.ONLY_THAT: "Feu servir només fitxes que {does:do}.",
    Key.USE_ALL: "Feu servir [kind@tots els|totes les] {kind}.",
    Key.USE_ALL_TOKENS: "Feu servir totes les fitxes.",
    Key.USE_ALL_THAT: "Feu servir totes les fitxes que {does:do}.",
    Key.HAS_ONE_THAT: "La fila ha de tenir {amount} fitxa que {does:that}.",
    Key.HAS_MANY_THAT: "La fila ha de tenir {amount} fitxes que {does:do}.",
    Key.ROW_HAS_ONE_THAT: "la fila té {amount} fitxa que {does:that}",
    Key.ROW_HAS_MANY_THAT: "la fila té {amount} fitxes que {does:do}",
    Key.PLACE_SO_MANY: "Poseu {amount} [count#fitxa|fitxes].",
    Key.HAS_MORE_THAN: "La fila ha de tenir més fitxes que {first:do} que fitxes que {second:do}.",
    Key.HAS_FEWER_THAN: (
        "La fila ha de tenir menys fitxes que {first:do} que fitxes que {second:do}."
    ),
    Key.HAS_AS_MANY_AS: (
        "La fila ha de tenir tantes fitxes que {first:do} com fitxes que {second:do}."
    ),
    Key.HAS_AT_LEAST_AS_MANY_AS: (
        "La fila ha de tenir com a mínim tantes fitxes que {first:do} com fitxes que {second:do}."
    ),
    Key.HAS_AT_MOST_AS_MANY_AS: (
        "La fila ha de tenir com a màxim tantes fitxes que {first:do} com fitxes que {second:do}."
    ),
    Key.HAS_NOT_AS_MANY_AS: (
        "La fila no ha de tenir tantes fitxes que {first:do} com fitxes que {second:do}."
    ),
    Key.KINDS: (
        "El nombre de {attribute:plural} [attribute@diferents|diferents] de la fila "
        "ha de ser {amount}."
    ),
    Key.TOTAL: "[attribute@Els|Les] {attribute:plural} de la fila han de sumar {amount}.",
    Key.EQUATION: "Segons {attribute:the}, {left} ha de fer {right}.",
    Key.WORD: "[attribute@Els|Les] {attribute:plural} han de formar una paraula de la llista.",
    Key.WORD_WITH: (
        "[attribute@Els|Les] {attribute:plural} han de formar una paraula de la llista, "
        "amb {relation} «{value}»."
    ),
    Key.EXACTLY: "exactament {k}",
    Key.AT_LEAST: "com a mínim {k}",
    Key.AT_MOST: "com a màxim {k}",
    Key.MORE_THAN: "més de {k}",
    Key.FEWER_THAN: "menys de {k}",
    Key.NOT_EXACTLY: "un nombre diferent de {k}",
    Key.FROM_ROW: "Agafeu les fitxes només {row:of}.",
    Key.NOT_FROM_ROW: "No agafeu fitxes {row:of}.",
    Key.FROM_COLUMN: "Agafeu les fitxes només de la columna {column}.",
    Key.NOT_FROM_COLUMN: "No agafeu fitxes de la columna {column}.",
    Key.SAME_COLUMN: "Deixeu cada fitxa a la seva columna.",
    Key.MIRRORED_COLUMN: "Porteu cada fitxa a la columna oposada, com en un mirall.",
    Key.TAKE: "La fitxa que agafeu {does}.",
    Key.TAKE_OF_THOSE: "De les fitxes que {among:do}, la fitxa que agafeu {does}.",
    Key.EACH_TOKEN: "Cada fitxa {does:must}.",
    Key.IN_EACH_PAIR: "De dues en dues: cada segona fitxa {does:must}.",
    Key.IN_RIGHT_HALF: "Cada fitxa de la meitat dreta {does:must}.",
    Key.SUBJECT_MUST: "{subject} {does:must}.",
    Key.CYCLE_RISING: (
        "{along}, [attribute@els|les] {attribute:plural} van endavant; "
        "després [attribute@de l'últim|de l'última] ve [attribute@el primer|la primera]."
    ),
    Key.CYCLE_FALLING: (
        "{along}, [attribute@els|les] {attribute:plural} van enrere; "
        "després [attribute@del primer|de la primera] ve [attribute@l'últim|l'última]."
    ),
    Key.RISE_AND_FALL: (
        "{along}, [attribute@els|les] {attribute:plural} primer pugen i després baixen."
    ),
    Key.FALL_AND_RISE: (
        "{along}, [attribute@els|les] {attribute:plural} primer baixen i després pugen."
    ),
    Key.ZIGZAG: "{along}, [attribute@els|les] {attribute:plural} pugen i baixen per torns.",
    Key.EQUAL_STEPS: (
        "{along}, [attribute@els|les] {attribute:plural} canvien cada cop en el mateix."
    ),
    Key.EQUAL_RATIOS: (
        "{along}, [attribute@els|les] {attribute:plural} es multipliquen cada cop pel mateix."
    ),
    Key.ALONG_THE_ROW: "d'esquerra a dreta",
    Key.IN_TIME: "en l'ordre en què les poseu",
    Key.THIS_ROW: "Formeu aquesta fila: {tokens:bare}.",
    Key.PATTERN: "{along}: {steps}.",
    Key.PATTERN_REPEATED: "{along}: {steps}, i un altre cop des del principi.",
    Key.NTH_DOES: "la {nth:feminine} {does}",
    Key.NTH_FREE: "la {nth:feminine} és qualsevol",
    Key.TEMPLATE: "{along}, [attribute@els|les] {attribute:plural} segueixen el patró {pattern}.",
    Key.TEMPLATE_REPEATED: (
        "{along}, [attribute@els|les] {attribute:plural} segueixen el patró {pattern} "
        "una vegada i una altra."
    ),
    Key.BLOCKS: "{along}, les fitxes amb [attribute@el mateix|la mateixa] {attribute} van juntes.",
    Key.IF_THEN: "Si {condition}, llavors {consequence}.",
    Key.SUBJECT_DOES: "{subject} {does}",
    Key.SMALL_TO_LARGE: "de petit a gran.",
    Key.LARGE_TO_SMALL: "de gran a petit.",
    Key.IN_THE_ALPHABET: "en ordre alfabètic.",
    Key.BACK_IN_THE_ALPHABET: "en ordre alfabètic invers.",
    Key.FIRST_TO_LAST: (
        "[attribute@del primer|de la primera] {attribute} [attribute@a l'últim|a l'última]."
    ),
    Key.LAST_TO_FIRST: (
        "[attribute@de l'últim|de l'última] {attribute} [attribute@al primer|a la primera]."
    ),
    Key.ALL_THE_SAME: "totes les fitxes tenen [attribute@el mateix|la mateixa] {attribute}.",
    Key.ALL_DIFFERENT: "totes les fitxes tenen {attribute:plural} diferents.",
    Key.NEIGHBOURS_DIFFER: "les fitxes veïnes tenen {attribute:plural} diferents.",
    Key.SPELL: "escriviu {word}.",
    Key.HAS_OF_KIND: "La fila ha de tenir {amount} {kind}.",
    Key.EITHER_OF: "o bé {several}",
    Key.BOTH_OF: "alhora {several}",
    Key.BY_ATTRIBUTE: "segons {attribute:the}",
    Key.IN_THAT_ORDER: "en aquest ordre",
    Key.ALL_BEFORE: "Poseu totes les fitxes que {first:do} abans que les que {second:do}.",
    Key.ALL_LEFT_OF: (
        "Totes les fitxes que {first:do} han d'anar a l'esquerra de les que {second:do}."
    ),
    Key.NEXT_AFTER: (
        "Després d'una fitxa que {first:that}, poseu tot seguit una que {second:that}."
    ),
    Key.LATER_AFTER: (
        "Després d'una fitxa que {first:that}, poseu més endavant una que {second:that}."
    ),
    Key.NEXT_RIGHT_OF: (
        "Just a la dreta d'una fitxa que {first:that}, poseu-ne una que {second:that}."
    ),
    Key.LATER_RIGHT_OF: "A la dreta d'una fitxa que {first:that}, poseu-ne una que {second:that}.",
    Key.MODEL_COPIED: (
        "{row} és el model i no es mou: cada fitxa {does:must}, columna per columna."
    ),
    Key.MODEL_MIRRORED: (
        "{row} és el model i no es mou: cada fitxa {does:must}, com en un mirall."
    ),
    Key.MODEL_REVERSED: (
        "{row} és el model i no es mou: cada fitxa {does:must}, llegit de dreta a esquerra."
    ),
    Key.CUE: "La fitxa {place:of} no es mou: cada fitxa {does:must}.",
    Key.THE_ONE_ON_ITS_LEFT: "la de la seva esquerra",
    Key.THE_ONE_BEFORE_IT: "l'anterior",
    Key.THE_NEIGHBOUR_ON_ITS_LEFT: "la que és just a la seva esquerra",
    Key.THE_ONE_JUST_BEFORE_IT: "la que heu posat just abans",
    Key.EVERY_ONE_ON_ITS_LEFT: "totes les de la seva esquerra",
    Key.EVERY_ONE_BEFORE_IT: "totes les anteriors",
    Key.THE_OPPOSITE_ONE: "l'oposada",
    Key.ITS_MODEL: "el seu model",
    Key.THIS_ONE: "aquesta",
    Key.NTH_FROM_LEFT: "la {nth:feminine} fitxa per l'esquerra",
    Key.NTH_FROM_RIGHT: "la {nth:feminine} fitxa per la dreta",
    Key.LAST_OF_ROW: "l'última fitxa de la fila",
    Key.MIDDLE_OF_ROW: "la fitxa del mig",
    Key.NTH_PLACED: "la {nth:feminine} fitxa que poseu",
    Key.LAST_PLACED: "l'última fitxa que poseu",
    Key.TOKEN_ON_ITS_LEFT: "{token} de l'esquerra",
    Key.TOKEN_ON_ITS_RIGHT: "{token} de la dreta",
    Key.TOKEN_IN_PLACE: "{token} {place:of}",
    Key.IT: "",
    Key.TOKEN_IN_COLUMN: "{token} de la columna {column}",
    Key.WHAT_LIES_IN_COLUMNS: "les fitxes {row:of}, columnes {columns}",
    Key.WHAT_LIES_THERE: "la fitxa {place:of}",
    Key.SEEN_GO: "Fins ara només he vist {tokens} en {nth} lloc.",
    Key.SEEN_COME: "Fins ara només he vist {tokens} en {nth} lloc des {place:of}.",
    Key.SEEN_GO_TO: "Fins ara només he vist {tokens} en {nth} lloc cap {place:to}.",
    Key.SEEN_ONLY_IF: "Fins ara, {tokens} només pot anar en {nth} lloc si {conditions}.",
    Key.SEEN_TOO_SELDOM: "Encara no he vist {tokens} en {nth} lloc en prou jugades diferents.",
    Key.MAY_GO: "{token} pot anar en {nth} lloc.",
    Key.MAY_GO_IF: "{token} pot anar en {nth} lloc si {conditions}.",
    Key.EXACT: "He comparat aquestes frases amb el que he après: diuen el mateix.",
    Key.NOT_COMPARED: "No he pogut comparar aquestes frases amb tot el que he après.",
    Key.GOES_TO: "va {place:to}",
    Key.COMES_FROM: "ve {place:of}",
    Key.COMES_FROM_ROW: "ve {row:of}",
    Key.COMES_FROM_COLUMN: "ve de la columna {column}",
    Key.GOES_TO_COLUMN: "va a la columna {column}",
    Key.KEEPS_COLUMN: "es queda a la seva columna",
    Key.COMES_FROM_STORAGE: "ve d'una fila de reserva",
    Key.GOES_TO_GOAL_ROW: "va a la fila de destinació",
    Key.IT_DOES: "{does}",
    Key.TOKEN_THERE_DOES: "la fitxa {place:of} {does}",
    Key.LIES_THERE: "{token} és a {place}",
    Key.NOT_SO: "{does:clause}.",
    Key.WRONG_PLACE: "{token} va {place:to}.",
    Key.NEXT_PLACE: "La fitxa següent va {place:to}.",
    Key.WRONG_COLUMN: "{token} va a la columna {column}.",
    Key.WRONG_ORIGIN: "Fins ara, {token} ha vingut {place:of}.",
    Key.WRONG_ORIGIN_ROW: "Les fitxes venen {row:of}.",
    Key.WRONG_ORIGIN_COLUMN: "Fins ara, {token} ha vingut de la columna {column}.",
    Key.OTHER_COLUMN: "{token} es queda a la seva columna.",
    Key.NOT_FROM_STORAGE: "{token} ja és a {row}.",
    Key.NOT_TO_GOAL_ROW: "Les fitxes van {row:to}.",
    Key.NOTHING_THERE: "Encara no hi ha cap fitxa a {place}.",
    Key.BELONGS_THERE: "Fins ara, abans hi havia {token} a {place}.",
    Key.NOT_SHOWN: "Encara no he vist {tokens} en {nth} lloc.",
    Key.DEAD_END: "Així ja no es pot omplir la fila.",
    Key.NO_WAY_ON: "Així la fila ja no pot quedar bé.",
    Key.NOT_NOW: "Aquesta fitxa no va aquí ara.",
    Key.ASK_CAREGIVER: "Això encara no ho he vist: pregunti al seu acompanyant.",
    Key.AFTER_THE_END: "La fila ja està completa.",
}

_PREDICATES: Final = {
    Predicate.ODD: ("ser", "[subject#senar|senars]"),
    Predicate.EVEN: ("ser", "[subject#parell|parells]"),
    Predicate.PRIME: ("ser", "un nombre primer"),
    Predicate.VOWEL: ("ser", "[subject#una vocal|vocals]"),
    Predicate.CONSONANT: ("ser", "[subject#una consonant|consonants]"),
    Predicate.MULTIPLE_OF: ("ser", "[subject#múltiple|múltiples] de {k}"),
    Predicate.DIGITS: ("tenir", "{k} [k#xifra|xifres]"),
    Predicate.ABOVE: ("estar", "per sobre de {k}"),
    Predicate.BELOW: ("estar", "per sota de {k}"),
    Predicate.IS: ("ser", "{value}"),
    Predicate.SHOWS: ("ser", "{attribute:of} {value}"),
    Predicate.HAS_ABOVE: ("tenir", "{attribute:the} per sobre de {k}"),
    Predicate.HAS_BELOW: ("tenir", "{attribute:the} per sota de {k}"),
    Predicate.AMOUNT: ("ser", "{amount}"),
    Predicate.HAS_AMOUNT: ("tenir", "{attribute:the} de {amount}"),
    Predicate.LEVEL: ("anar", "al mateix lloc que {other}"),
    Predicate.LEVEL_OR_AFTER: ("anar", "al mateix lloc que {other} o després"),
    Predicate.LEVEL_OR_BEFORE: ("anar", "al mateix lloc que {other} o abans"),
    Predicate.BEFORE_OR_AFTER: ("anar", "abans o després {other:of}"),
    Predicate.FROM_ROW: ("venir", "{row:of}"),
    Predicate.FROM_COLUMN: ("venir", "de la columna {column}"),
    Predicate.AMONG_MOST: ("estar", "entre les {count} {adjective}"),
    Predicate.AMONG_LEAST: ("estar", "entre les {count} {adjective}"),
    Predicate.AMONG_HIGHEST: ("estar", "entre les {count} amb més {attribute}"),
    Predicate.AMONG_LOWEST: ("estar", "entre les {count} amb menys {attribute}"),
    Predicate.AMONG_MOST_OF_ROW: ("estar", "entre les {adjective} que omplen la fila"),
    Predicate.AMONG_LEAST_OF_ROW: ("estar", "entre les {adjective} que omplen la fila"),
    Predicate.AMONG_HIGHEST_OF_ROW: ("estar", "entre les de més {attribute} que omplen la fila"),
    Predicate.AMONG_LOWEST_OF_ROW: ("estar", "entre les de menys {attribute} que omplen la fila"),
    Predicate.MOST: ("ser", "la {adjective} de la fila"),
    Predicate.LEAST: ("ser", "la {adjective} de la fila"),
    Predicate.HIGHEST: ("ser", "la de més {attribute} de la fila"),
    Predicate.LOWEST: ("ser", "la de menys {attribute} de la fila"),
    Predicate.MOST_LEFT: ("ser", "sempre la {adjective} de les que queden"),
    Predicate.LEAST_LEFT: ("ser", "sempre la {adjective} de les que queden"),
    Predicate.HIGHEST_LEFT: ("ser", "sempre la de més {attribute} de les que queden"),
    Predicate.LOWEST_LEFT: ("ser", "sempre la de menys {attribute} de les que queden"),
    Predicate.LEFTMOST: ("ser", "sempre la que és més a l'esquerra de les que queden"),
    Predicate.RIGHTMOST: ("ser", "sempre la que és més a la dreta de les que queden"),
    Predicate.TOPMOST: ("ser", "sempre de la fila més alta de les que queden"),
    Predicate.BOTTOMMOST: ("ser", "sempre de la fila més baixa de les que queden"),
    Predicate.ANYTHING: ("ser", "[subject#qualsevol|qualssevol]"),
    Predicate.NOTHING: ("ser", "de cap mena"),
    Predicate.MORE: ("ser", "{adjective} que {other}"),
    Predicate.LESS: ("ser", "{adjective} que {other}"),
    Predicate.HAS_MORE: ("tenir", "més {attribute} que {other}"),
    Predicate.HAS_LESS: ("tenir", "menys {attribute} que {other}"),
    Predicate.AFTER: ("anar", "després {other:of}"),
    Predicate.BEFORE: ("anar", "abans {other:of}"),
    Predicate.AFTER_IN_ALPHABET: ("anar", "després {other:of} en l'alfabet"),
    Predicate.BEFORE_IN_ALPHABET: ("anar", "abans {other:of} en l'alfabet"),
    Predicate.MORE_BY: ("tenir", "{k} més que {other}"),
    Predicate.LESS_BY: ("tenir", "{k} menys que {other}"),
    Predicate.NEXT: ("anar", "just després {other:of}"),
    Predicate.PREVIOUS: ("anar", "just abans {other:of}"),
    Predicate.NEXT_IN_ALPHABET: ("anar", "just després {other:of} en l'alfabet"),
    Predicate.PREVIOUS_IN_ALPHABET: ("anar", "just abans {other:of} en l'alfabet"),
    Predicate.AFTER_BY: ("anar", "{k} posicions després {other:of}"),
    Predicate.BEFORE_BY: ("anar", "{k} posicions abans {other:of}"),
    Predicate.AFTER_BY_IN_ALPHABET: ("anar", "{k} posicions després {other:of} en l'alfabet"),
    Predicate.BEFORE_BY_IN_ALPHABET: ("anar", "{k} posicions abans {other:of} en l'alfabet"),
    Predicate.APART_BY: ("diferenciar-se", "en {k} {other:of}"),
    Predicate.TWICE: ("ser", "el doble {other:of}"),
    Predicate.HALF: ("ser", "la meitat {other:of}"),
    Predicate.TIMES: ("ser", "{k} vegades {other}"),
    Predicate.TOGETHER: ("sumar", "{k} amb {other}"),
    Predicate.SAME: ("tenir", "[attribute@el mateix|la mateixa] {attribute} que {other}"),
    Predicate.DIFFERENT: ("tenir", "[attribute@un altre|una altra] {attribute} que {other}"),
    Predicate.SAME_ACROSS: ("tenir", "com a {attribute} {theirs:the} {other:of}"),
    Predicate.MORE_ACROSS: ("tenir", "més {attribute} que {theirs:the} {other:of}"),
    Predicate.LESS_ACROSS: ("tenir", "menys {attribute} que {theirs:the} {other:of}"),
    Predicate.RELATED: ("estar", "en relació «{relation}» amb {other}"),
    Predicate.RELATED_BACK: ("estar", "en relació «{relation}» inversa amb {other}"),
}

_KINDS: Final = {
    Predicate.ODD: "{things} [things@senars|senars]",
    Predicate.EVEN: "{things} [things@parells|parelles]",
    Predicate.PRIME: "{things} [things@primers|primeres]",
    Predicate.VOWEL: "vocals",
    Predicate.CONSONANT: "consonants",
    Predicate.MULTIPLE_OF: "múltiples de {k}",
    Predicate.DIGITS: "{things} de {k} [k#xifra|xifres]",
    Predicate.ABOVE: "{things} per sobre de {k}",
    Predicate.BELOW: "{things} per sota de {k}",
    Predicate.HAS_ABOVE: "fitxes amb {attribute:the} per sobre de {k}",
    Predicate.HAS_BELOW: "fitxes amb {attribute:the} per sota de {k}",
    Predicate.IS: "fitxes {value:bare}",
    Predicate.SHOWS: "fitxes {attribute:of} {value}",
}


def _verb(base: str, present: str, subjunctive: tuple[str, str]) -> VerbForms:
    that, those = subjunctive
    of = "d'" if base[0] in "ae" else "de "
    return VerbForms(
        must=f"ha {of}{base}",
        must_not=f"no ha {of}{base}",
        does=present,
        does_not=f"no {present}",
        that=that,
        that_not=f"no {that}",
        do=those,
        do_not=f"no {those}",
    )


_VERBS: Final = {
    "ser": _verb("ser", "és", ("sigui", "siguin")),
    "estar": _verb("estar", "està", ("estigui", "estiguin")),
    "tenir": _verb("tenir", "té", ("tingui", "tinguin")),
    "anar": _verb("anar", "va", ("vagi", "vagin")),
    "venir": _verb("venir", "ve", ("vingui", "vinguin")),
    "sumar": _verb("sumar", "suma", ("sumi", "sumin")),
    "diferenciar-se": _verb(
        "diferenciar-se", "es diferencia", ("es diferenciï", "es diferenciïn")
    ),
}

_M, _F = Gender.MASCULINE, Gender.FEMININE


def _word(
    noun: str, plural: str, gender: Gender, naming: Naming | None = Naming.WORD
) -> AttributeWords:
    return AttributeWords(noun, gender, plural, naming=naming)


def _measure(
    noun: str, plural: str, gender: Gender, adjectives: tuple[str, str]
) -> AttributeWords:
    more, less = adjectives
    return AttributeWords(noun, gender, plural, more=more, less=less, most=more, least=less)


_BIG: Final = "més gran|més gran|més grans|més grans"
_SMALL: Final = "més petit|més petita|més petits|més petites"
_LONG: Final = "més llarg|més llarga|més llargs|més llargues"
_SHORT: Final = "més curt|més curta|més curts|més curtes"
_HIGH: Final = "més alt|més alta|més alts|més altes"
_LOW: Final = "més baix|més baixa|més baixos|més baixes"
_HEAVY: Final = "més pesant|més pesant|més pesants|més pesants"
_LIGHT: Final = "més lleuger|més lleugera|més lleugers|més lleugeres"
_DEAR: Final = "més car|més cara|més cars|més cares"
_CHEAP: Final = "més barat|més barata|més barats|més barates"
_OLD: Final = "més vell|més vella|més vells|més velles"
_YOUNG: Final = "més jove|més jove|més joves|més joves"

_NUMBER: Final = AttributeWords(
    "nombre",
    _M,
    "nombres",
    things="nombres",
    more=_BIG,
    less=_SMALL,
    most=_BIG,
    least=_SMALL,
    naming=Naming.PLAIN,
)
_COLOUR: Final = _word("color", "colors", _M, Naming.QUALITY)

_ATTRIBUTES: Final = {
    "value": _NUMBER,
    "number": _NUMBER,
    "letter": AttributeWords("lletra", _F, "lletres", things="lletres", naming=Naming.PLAIN),
    "colour": _COLOUR,
    "color": _COLOUR,
    "shape": _word("forma", "formes", _F, None),
    "category": _word("categoria", "categories", _F, None),
    "size": _measure("mida", "mides", _F, (_BIG, _SMALL)),
    "length": _measure("longitud", "longituds", _F, (_LONG, _SHORT)),
    "height": _measure("alçada", "alçades", _F, (_HIGH, _LOW)),
    "weight": _measure("pes", "pesos", _M, (_HEAVY, _LIGHT)),
    "price": _measure("preu", "preus", _M, (_DEAR, _CHEAP)),
    "age": _measure("edat", "edats", _F, (_OLD, _YOUNG)),
    "name": _word("nom", "noms", _M),
    "picture": _word("dibuix", "dibuixos", _M),
    "word": _word("paraula", "paraules", _F),
    "day": _word("dia", "dies", _M),
    "month": _word("mes", "mesos", _M),
    ORIGIN_ROW: _word("fila de sortida", "files de sortida", _F, None),
    ORIGIN_COLUMN: _word("columna de sortida", "columnes de sortida", _F, None),
}

_COLOURS: Final = {
    "red": "vermell|vermella|vermells|vermelles",
    "blue": "blau|blava|blaus|blaves",
    "green": "verd|verda|verds|verdes",
    "yellow": "groc|groga|grocs|grogues",
    "black": "negre|negra|negres|negres",
    "white": "blanc|blanca|blancs|blanques",
    "orange": "taronja",
    "pink": "rosa",
    "purple": "lila",
    "brown": "marró|marró|marrons|marrons",
    "grey": "gris|grisa|grisos|grises",
    "gray": "gris|grisa|grisos|grises",
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
