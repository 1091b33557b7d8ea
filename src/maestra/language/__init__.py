"""What Maestra says: every sentence for users, in each language; nothing is said elsewhere."""

from maestra.language.languages import Language as Language
from maestra.language.lexicon import NO_LEXICON as NO_LEXICON
from maestra.language.lexicon import Lexicon as Lexicon
from maestra.language.lexicon_format import read_words as read_words
from maestra.language.sentences import ActionExplanation as ActionExplanation
from maestra.language.sentences import Sentence as Sentence
from maestra.language.sentences import check_sentence as check_sentence
from maestra.language.sentences import conjunction_sentences as conjunction_sentences
from maestra.language.sentences import explain_action as explain_action
from maestra.language.sentences import feature_of_token as feature_of_token
from maestra.language.sentences import gap_sentences as gap_sentences
from maestra.language.sentences import reason as reason
from maestra.language.sentences import rule_sentences as rule_sentences
