"""The caregiver's side of `--protocol jsonl`: one line of JSON on standard input an answer."""

from collections.abc import Collection, Iterator
from typing import Annotated, Final

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr, ValidationError

from maestra.cli.streams import STANDARD, named, read_chunks
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, shorten
from maestra.core.formats import decode_demonstration
from maestra.core.json_faults import Expecting, faults_of_validation
from maestra.core.json_lines import FormatError, parse_object, split_lines

ENOUGH: Final = "enough"
"""The answer to anything that ends the questions."""
COLUMN: Final = "column"
"""In place of an answer: which cell is wrong."""
AGAIN: Final = "again"
"""The answer that a demonstration comes with."""


class AnswerJson(BaseModel):
    """One answer."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    id: Annotated[StrictInt, Expecting("the whole number of a question")]
    answer: Annotated[StrictStr | None, Expecting("a word")] = None
    column: Annotated[StrictInt | None, Expecting("a whole number from 1")] = None
    demonstration: Annotated[
        dict[str, object] | None, Expecting("a demonstration"), Field(repr=False)
    ] = None


class AnswerLines:
    """Answers as they come in."""

    def __init__(self) -> None:
        """Read standard input."""
        self._file = named(STANDARD)
        self._lines: Iterator[tuple[int, bytes]] = split_lines(read_chunks(STANDARD), self._file)
        self._number, self._line = 1, b""

    def next(self, question: int, words: Collection[str], columns: int = 0) -> AnswerJson:
        """The answer to a question; `enough` where there are no more lines.

        Args:
            question: its id.
            words: what may be answered, besides `enough`.
            columns: how many columns there are to answer with; 0: none may be.

        Raises:
            FormatError: a line that is no answer to it.
        """
        self._number, self._line = next(self._lines, (self._number, b""))
        if not self._line:
            return AnswerJson(id=question, answer=ENOUGH)
        fields = parse_object(self._line, self._file, self._number)
        try:
            answer = AnswerJson.model_validate(fields)
        except ValidationError as error:
            faults = faults_of_validation(error, AnswerJson)
            raise FormatError(self._file, self._number, faults) from None
        fault = _fault(answer, question, words, columns)
        if fault is not None:
            raise self.refused(fault)
        return answer

    def demonstration(self, like: Demonstration) -> Demonstration:
        """The demonstration that came with the last answer, on the same board as `like`.

        Raises:
            FormatError: it is none.
        """
        import json

        fields = parse_object(self._line, self._file, self._number)
        line = json.dumps(fields["demonstration"], default=float).encode()
        try:
            shown = decode_demonstration(line, self._file, self._number)
        except FormatError as error:
            faults = tuple(fault.under("demonstration") for fault in error.faults)
            raise FormatError(self._file, self._number, faults) from None
        if (shown.board, shown.deck) != (like.board, like.deck):
            expected = "the board and the tokens of the one it stands for"
            raise self.refused(Fault("demonstration", "another board or other tokens", expected))
        return shown

    def refused(self, fault: Fault) -> FormatError:
        """That something is wrong with the last line."""
        return FormatError(self._file, self._number, (fault,))


def _fault(
    answer: AnswerJson, question: int, words: Collection[str], columns: int
) -> Fault | None:
    """What makes an answer none to this question."""
    if answer.id != question:
        return Fault("id", str(answer.id), f"{question}, the id of the question")
    if answer.column is not None and not (columns and answer.answer is None):
        return Fault("column", str(answer.column), "no column beside an answer")
    if answer.column is not None:
        if 1 <= answer.column <= columns:
            return None
        return Fault("column", str(answer.column), f"1 to {columns}")
    allowed = [*words, ENOUGH]
    if answer.answer not in allowed:
        found = "missing" if answer.answer is None else shorten(answer.answer)
        return Fault("answer", found, f"one of {', '.join(allowed)}")
    if (answer.answer == AGAIN) is not (answer.demonstration is not None):
        found = "missing" if answer.answer == AGAIN else "a demonstration"
        return Fault("demonstration", found, f'one just with the answer "{AGAIN}"')
    return None
