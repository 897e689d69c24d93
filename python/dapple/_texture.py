"""Growing, measuring and looking up."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _dapple

Document = Mapping[str, Any] | str | os.PathLike[str]
"""A document as a dictionary, or the path of a .dapple file or of a PNG that dapple wrote."""


class Grown:
    """A grown texture. Its arrays are made when they are first asked for."""

    def __init__(self, made: _dapple.Grown) -> None:
        """Wrap a grown texture; `grow` makes it."""
        self._made = made

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the canvas, px."""
        return self._made.size

    @cached_property
    def rgb(self) -> NDArray[np.uint8]:
        """The texture, (height, width, 3), sRGB."""
        return self._made.rgb

    @cached_property
    def rgba(self) -> NDArray[np.uint8]:
        """The texture with its opacity, (height, width, 4), sRGB."""
        return self._made.rgba

    @cached_property
    def pattern(self) -> NDArray[np.float32]:
        """The pattern of the layer that painted each px, (height, width), 0 to 1.

        0 is ground, 0.5 the edge of a mark, 1 its middle.
        """
        return self._made.pattern

    @cached_property
    def labels(self) -> NDArray[np.uint8]:
        """The layer whose mark covers each px, (height, width): 0 = none, 1 = the lowest."""
        return self._made.labels

    @cached_property
    def mask(self) -> NDArray[np.uint8]:
        """The layer whose mark covers each px after the finish, (height, width); without a finish the labels."""
        return self._made.mask

    @cached_property
    def report(self) -> dict[str, Any]:
        """What was asked, looked up and grown: the keys of `grow --report` in docs/format.md."""
        made: dict[str, Any] = json.loads(self._made.report_text())
        return made

    @cached_property
    def document(self) -> dict[str, Any]:
        """The document that was grown, with the seed that was used."""
        made: dict[str, Any] = json.loads(self._made.document_text())
        return made

    def layer_pattern(self, layer: int) -> NDArray[np.float32]:
        """Return the pattern of one layer, 0 = the lowest: (height, width), 0 to 1."""
        return self._made.layer_pattern(layer)

    def save(self, path: str | os.PathLike[str], *, scale: int = 1) -> None:
        """Write a picture (.png, .tif, .exr, .jpg, .webp) or outlines (.svg, .dxf), complete or not at all.

        ``scale`` writes so many times the px along each side, 1 to 64. A PNG holds the document.
        """
        self._made.save(os.fspath(path), scale)

    def outlines(self, *, scale: int = 1) -> str:
        """Return the outlines of the marks as SVG, in mm by the document's dpi."""
        return self._made.outlines(scale)

    def material(
        self, folder: str | os.PathLike[str], *, name: str = "dapple", relief: float | None = None, scale: int = 1
    ) -> None:
        """Write colour, height, normals, roughness and occlusion for engines into a folder (docs/materials.md).

        ``relief`` is the height of the marks above the ground, px (6; with a finish that of docs/finish.md).
        """
        self._made.material(os.fspath(folder), name, relief, scale)


def grow(
    document: Document,
    *,
    size: Sequence[int] | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Callable[[str, float], object] | None = None,
) -> Grown:
    """Grow a document.

    ``size`` is another canvas, [width, height] in px, with marks of the same size; ``seed`` another seed;
    ``threads`` how many threads are used (all cores); ``progress`` is called with the stage ("plan", "grow",
    "refine", "write") and the share of it that is done, 0 to 1. Ctrl-C, and an exception of ``progress``, stop it.

    Raises `Error`, with `place` and `allowed`, if the document is not valid or cannot be grown.
    """
    text, source, beside = _text(document)
    canvas = None if size is None else (int(size[0]), int(size[1]))
    return Grown(_dapple.grow(text, source, beside, canvas, seed, threads, progress))


def check(document: Document) -> list[list[str]]:
    """Return the notes on each layer: what cannot be reached. Raises `Error` if it cannot be grown."""
    text, source, _ = _text(document)
    return _dapple.check(text, source)


def read(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the document in a .dapple file, or in a PNG that dapple wrote."""
    made: dict[str, Any] = json.loads(_dapple.read(os.fspath(path)))
    return made


def schema() -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of documents."""
    made: dict[str, Any] = json.loads(_dapple.schema())
    return made


def measure(
    array: NDArray[np.float32] | NDArray[np.float64] | NDArray[np.uint8], *, invert: bool = False
) -> dict[str, Any]:
    """Return the attributes of the spots or stripes in a pattern or a picture.

    A pattern is (height, width) of floats with its edges at 0.5; a picture (height, width, 3) or (height, width) of
    uint8, in which the marks are the colour that covers less (``invert``: more). Lengths are px, areas px², angles
    degrees: the keys of `dapple measure --json` in docs/format.md.
    """
    if array.dtype == np.uint8:
        colours = array if array.ndim == 3 else np.repeat(array[:, :, None], 3, axis=2)
        text = _dapple.measure(np.ascontiguousarray(colours[:, :, :3], dtype=np.uint8), invert)
    else:
        text = _dapple.measure(np.ascontiguousarray(array, dtype=np.float32), invert)
    made: dict[str, Any] = json.loads(text)
    return made


def from_photo(array: NDArray[np.uint8], *, invert: bool = False) -> dict[str, Any]:
    """Return a document: a sketch of the spots or stripes in a photograph, (height, width, 3) of uint8."""
    made: dict[str, Any] = json.loads(_dapple.photo(np.ascontiguousarray(array[:, :, :3]), invert))
    return made


def lookup(
    system: str,
    *,
    angle: float,
    area: float | None = None,
    aspect: float | None = None,
    spacing: float | None = None,
    width: float | None = None,
    wavelength: float | None = None,
) -> dict[str, Any]:
    """Return the parameters with which a reaction-diffusion system grows such marks.

    Of spots ``area`` (px²), ``aspect`` (0 to 1) and, if it is not free, ``spacing`` (px); of stripes ``width`` (px) and
    ``wavelength`` (px). ``angle`` is in degrees. Keys: system, asked, parameters, predicted, coverage, nearest.
    """
    found = _dapple.lookup(system, angle, area, aspect, spacing, width, wavelength)
    made: dict[str, Any] = json.loads(found)
    return made


def _text(document: Document) -> tuple[str, str, str | None]:
    """Return the text of a document, its name in messages, and the path of its file."""
    if isinstance(document, Mapping):
        return json.dumps(document), "the document", None
    path = os.fspath(document)
    return _dapple.read(path), path, None if path.lower().endswith(".png") else path
