"""Catalan: what the coach says."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

PHRASES: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "welcome": (
            "Hola. Juguem plegats.",
            "Quina alegria veure-us. Comencem.",
            "Us dono la benvinguda. El tauler és a punt.",
            "Hola una altra vegada. Aquest és el nostre exercici.",
        ),
        "your-turn": (
            "Us toca a vós.",
            "Podeu començar quan vulgueu.",
            "Si us plau, agafeu una fitxa.",
            "La següent és vostra.",
        ),
        "complete": (
            "L'exercici està complet. Molt bé!",
            "Era l'última. Bravo!",
            "La fila està acabada. Quina bona partida!",
            "Tot és al seu lloc. Enhorabona!",
        ),
        "goodbye": (
            "Això és tot per avui. Gràcies per jugar.",
            "Ho deixem aquí. Ha estat un plaer jugar amb vós.",
            "Acabem aquí. Fins aviat.",
            "Gràcies pel vostre temps. Fins a la propera.",
        ),
        "paused": (
            "Descansem una estona.",
            "Fem una petita pausa.",
            "Ara un descans.",
            "Parem un moment.",
        ),
        "resumed": (
            "Continuem on érem.",
            "Som-hi una altra vegada.",
            "S'ha acabat la pausa. Continuem.",
            "Ara seguim.",
        ),
        "board-lost": (
            "Un moment, si us plau.",
            "Espereu una mica, si us plau.",
            "Necessito un momentet.",
            "Esperem un moment.",
        ),
        "board-back": (
            "Gràcies per esperar.",
            "Ja puc continuar.",
            "Torno a ser aquí.",
            "Ja torno a veure el tauler.",
        ),
        "may-stop": (
            "La fila es pot quedar així. També podeu continuar.",
            "Aquest podria ser el final. Hi caben més fitxes.",
            "Podeu parar aquí. En podeu posar una altra.",
            "Així està bé. També en podeu afegir més.",
        ),
        "not-yet": (
            "Encara queda alguna cosa per moure.",
            "Falta una miqueta.",
            "Ja gairebé hi som.",
            "Encara falta alguna cosa a la fila.",
        ),
        "let-us-go-on": (
            "Continuem amb la següent.",
            "Anem per la següent.",
            "Seguim amb una altra fitxa.",
            "Mirem la següent.",
        ),
        "accepted": (
            "Així també està bé.",
            "Ho deixem així.",
            "Bé, es queda aquí.",
            "D'acord, s'hi pot quedar.",
        ),
        "praise": (
            "Molt bé!",
            "Sí, hi encaixa.",
            "Fantàstic!",
            "Això mateix.",
            "Perfecte, aquest és el seu lloc.",
            "Que bé, continueu així.",
        ),
        "praise-own-correction": (
            "Ara encaixa. Molt bé!",
            "L'heu trobada. Fantàstic!",
            "Això mateix. Ben pensat!",
            "Aquest és el seu lloc. Genial!",
        ),
        "thanks-for-putting-back": (
            "Gràcies. Provem-ne una altra.",
            "Bé. Tornem a mirar.",
            "Gràcies. Quina podria ser?",
            "D'acord. Mirem-ho una altra vegada.",
        ),
        "refused": (
            "Bon intent. {reason}",
            "Mirem-ho un altre cop. {reason}",
            "Gairebé. {reason}",
            "Fem una altra ullada. {reason}",
            "Pensem-hi plegats. {reason}",
        ),
        "refused-by-caregiver": (
            "Provem-ne una altra aquí.",
            "Aquí n'encaixa millor una altra.",
            "Busquem-ne una altra.",
            "Intentem-ho amb una de diferent.",
        ),
        "please-put-back": (
            "Si us plau, torneu {token} {place:to}.",
            "{token} torna {place:to}.",
            "Podeu tornar {token} {place:to}?",
            "Portem {token} de tornada {place:to}.",
        ),
        "i-put-back": (
            "Jo torno {token} al seu lloc.",
            "Deixeu-me tornar {token}.",
            "Jo m'enduc {token} de tornada.",
            "Poso {token} una altra vegada a la seva casella.",
        ),
        "help-comes": (
            "Algú ens ajudarà.",
            "Esperem un cop de mà.",
            "He demanat una mica d'ajuda.",
            "L'ajuda ja ve.",
        ),
        "one-at-a-time": (
            "Agafem les fitxes d'una en una.",
            "Una darrere l'altra, si us plau.",
            "Només una fitxa alhora, si us plau.",
            "Movem una sola fitxa.",
        ),
        "unknown-token": (
            "No conec aquesta fitxa. Deixem-la de banda.",
            "Aquesta fitxa és nova per a mi. Aparteu-la, si us plau.",
            "Aquesta és d'un altre joc.",
            "Aquesta fitxa no ens cal.",
        ),
        "encourage": (
            "Preneu-vos el temps que calgui.",
            "Ho esteu fent bé.",
            "No hi ha cap pressa.",
            "Segur que n'hi ha una.",
            "Mirem amb calma.",
        ),
        "remind": (
            "Recordeu: {rule}",
            "La idea és aquesta: {rule}",
            "Això és el que fem: {rule}",
            "Us ho torno a dir: {rule}",
        ),
        "look-at-row": (
            "Mireu {row}.",
            "N'hi ha una que encaixa a {row}.",
            "Donem una ullada a {row}.",
            "La podeu trobar a {row}.",
        ),
        "one-of-these": (
            "Podria ser {tokens}.",
            "Una d'aquestes encaixa: {tokens}.",
            "Deu ser {tokens}?",
            "Quina és: {tokens}?",
        ),
        "this-one": (
            "{token} encaixa a {place}.",
            "Posem {token} a {place}.",
            "Podeu posar {token} a {place}.",
            "{token} pot anar {place:to}.",
        ),
        "together": (
            "Posem plegats {token} a {place}?",
            "Plegats posem {token} a {place}.",
            "Portem plegats {token} {place:to}.",
            "Movem {token} {place:to} entre tots dos.",
        ),
        "i-place": (
            "Jo poso {token} a {place}.",
            "Deixeu-me posar {token} a {place}.",
            "Jo porto {token} {place:to}.",
            "Aquesta la faig jo: {token} a {place}.",
        ),
        "i-cannot": (
            "No hi arribo.",
            "El meu braç no hi arriba.",
            "Aquest moviment em costa.",
            "Aquesta no la puc moure.",
        ),
        "i-am-here": (
            "Soc aquí amb vós.",
            "Estic mirant amb vós.",
            "Tenim tot el temps del món.",
            "Continuo al vostre costat.",
        ),
        "show-me": (
            "Ensenyeu-me com va.",
            "Si us plau, jugueu-hi una vegada per a mi.",
            "Estic mirant. Comenceu, si us plau.",
            "Si us plau, ensenyeu-me una partida correcta.",
        ),
        "seen": (
            "Ho he vist.",
            "Gràcies, m'hi he fixat bé.",
            "Bé, aquesta ja la tinc.",
            "Ho recordaré.",
        ),
        "show-another": (
            "Si us plau, ensenyeu-me'n una altra.",
            "Una més m'ajudaria.",
            "Podeu jugar-hi una vegada d'una altra manera?",
            "Si us plau, jugueu-hi amb altres fitxes.",
        ),
        "clear-the-row": (
            "Si us plau, buideu la fila per a la següent.",
            "Torneu les fitxes a qualsevol casella del magatzem.",
            "Ara necessitem la fila buida.",
            "Si us plau, deixeu lliure la fila de destinació.",
        ),
        "taken-back": (
            "D'acord, aquest no compta.",
            "Oblido aquest moviment.",
            "Bé, ho desfem.",
            "Molt bé, com si res.",
        ),
        "nothing-shown": (
            "Primer moveu una fitxa, si us plau.",
            "Encara no he vist cap moviment.",
            "Encara no hi ha res per aprendre.",
            "Em falta veure un moviment.",
        ),
        "forgotten": (
            "D'acord, oblido aquesta partida.",
            "Aquesta partida no compta.",
            "Aquesta la deixem fora.",
            "Esborro el que acabo de veure.",
        ),
        "understood": (
            "Això és el que entenc: {rules}",
            "Fins ara entenc això: {rules}",
            "Jo ho veig així: {rules}",
            "Tal com ho entenc: {rules}",
        ),
        "not-clear": (
            "Encara no ho tinc del tot clar.",
            "Encara no n'estic segur.",
            "Em queden dubtes.",
            "Es pot entendre de més d'una manera.",
        ),
        "learned": (
            "Gràcies, he après l'exercici.",
            "Ara sé com va.",
            "Ja hi puc jugar amb altres persones.",
            "Tinc clar l'exercici.",
        ),
        "thanks": (
            "Gràcies.",
            "Gràcies, això m'ajuda.",
            "És bo saber-ho.",
            "Ho entenc, gràcies.",
        ),
    }
)

ASKED: Final[Mapping[str, str]] = MappingProxyType(
    {
        "put-back": "Si us plau, torneu al seu lloc o feu tornar: {tokens}.",
        "check-board": "Si us plau, reviseu el tauler: les fitxes no són on haurien de ser.",
        "place": "Si us plau, poseu {token} a {place}.",
        "no-way-on": "Ja no hi ha cap moviment correcte. Si us plau, acabeu la sessió o jutgeu "
        "d'una altra manera l'últim moviment.",
        "long-silence": "Fa molta estona que ningú no mou. Voleu fer una pausa?",
        "demonstration": "No he pogut aprendre d'aquesta partida. Si us plau, torneu-la a "
        "ensenyar.",
    }
)
