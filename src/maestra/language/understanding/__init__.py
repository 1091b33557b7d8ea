"""From sentences to rules: the tables that say rules, read the other way round."""

from maestra.language.understanding.examples import rules_like as rules_like
from maestra.language.understanding.listener import MAX_SENTENCE as MAX_SENTENCE
from maestra.language.understanding.listener import Listener as Listener
from maestra.language.understanding.listener import Several as Several
from maestra.language.understanding.listener import Understanding as Understanding
from maestra.language.understanding.listener import Understood as Understood
from maestra.language.understanding.listener import Unknown as Unknown
from maestra.language.understanding.listener import listener_for as listener_for
