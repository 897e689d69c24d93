"""Labelled textures of random sketches."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _dapple

KINDS = ("spots", "irregular-spots", "stripes", "pair-stripes", "stucco", "patches", "cells")
"""All kinds of textures; item k is of kind k mod their number."""


class Tip(NamedTuple):
    """A place where a stripe ends or forks."""

    kind: str
    """"end" or "fork"."""
    x: float
    """px."""
    y: float
    """px."""
    angle: float
    """Degrees in [0, 360) from +x towards +y: the way in which it ends, or in which the fork opens."""


class Item:
    """A labelled texture. Its arrays are moved from the engine when they are first asked for."""

    def __init__(self, made: _dapple.Item) -> None:
        """Wrap an item; `stream` makes it."""
        self._made = made

    @property
    def index(self) -> int:
        """Its index in the data set."""
        return self._made.index

    @property
    def kind(self) -> str:
        """One of `KINDS`."""
        return self._made.kind

    @cached_property
    def rgb(self) -> NDArray[np.uint8]:
        """The texture, (size, size, 3), sRGB."""
        return self._made.take_rgb()

    @cached_property
    def labels(self) -> NDArray[np.uint16]:
        """The label of the mark of each px, (size, size); 0 = ground."""
        return self._made.take_labels()

    @cached_property
    def size(self) -> NDArray[np.float32]:
        """What the sketch asks for at each px, (size, size): area of spots, px², or width of stripes, px."""
        return self._made.take_size()

    @cached_property
    def direction(self) -> NDArray[np.float32]:
        """What the sketch asks for at each px, (size, size): degrees in [0, 180)."""
        return self._made.take_direction()

    @cached_property
    def marks(self) -> dict[str, NDArray[np.float64]]:
        """Columns with one value a mark: label, x, y, whole, area, aspect, angle, width, and what was asked for."""
        return self._made.marks()

    @cached_property
    def tips(self) -> list[Tip]:
        """Ends and forks of stripes; empty of other kinds."""
        return [Tip(*tip) for tip in self._made.tips()]

    @cached_property
    def _object(self) -> dict[str, Any]:
        made: dict[str, Any] = json.loads(self._made.object_text())
        return made

    @property
    def document(self) -> dict[str, Any]:
        """The sketch: `grow` makes the same texture of it."""
        made: dict[str, Any] = self._object["document"]
        return made

    @property
    def report(self) -> dict[str, Any]:
        """The report of its layer, with the parameters of the simulation."""
        made: dict[str, Any] = self._object["report"]
        return made


def stream(seed: int = 1, *, size: int = 256, kinds: Sequence[str] = KINDS, first: int = 0) -> Iterator[Item]:
    """Yield labelled textures without end, beginning with item ``first``.

    Item k of a seed depends on the seed, ``size`` (px) and ``kinds`` alone: several processes can take every n-th one.
    """
    index = first
    while True:
        yield Item(_dapple.item(seed, index, size, list(kinds)))
        index += 1
