"""A parse forest as `Reader` sees it: lark's own nodes, which have no types, looked at from here.

Earley's parser shares what several trees have in common [1], so a sentence that can be read in
very many ways still has few nodes.

[1] E. Scott, SPPF-Style Parsing From Earley Recognisers, 2008, which lark implements.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias, cast

from lark.parsers.earley_forest import TokenNode

Node: TypeAlias = object
"""A node of lark's: a token, a symbol, or the left part of a production."""


@dataclass(frozen=True, slots=True)
class Way:
    """One way in which a node came about."""

    alias: str
    """The name of its production; empty if it has none."""
    sides: tuple[Node, ...]
    """What it is made of: the left part of the production and the last symbol."""


def token_of(node: Node) -> tuple[str, str] | None:
    """The terminal and the text, if the node is a token."""
    if not isinstance(node, TokenNode):
        return None
    token = cast("Any", node).token
    return str(token.type), str(token)


def symbol_of(node: Node) -> str:
    """The symbol that the node derives; empty for a part of a production."""
    found = cast("Any", node)
    return "" if found.is_intermediate else str(found.s.name)


def ways_of(node: Node) -> list[Way]:
    """Every way in which the node came about."""
    return [
        Way(
            str(packed.rule.alias or ""),
            tuple(side for side in (packed.left, packed.right) if side is not None),
        )
        for packed in cast("Any", node).children
    ]
