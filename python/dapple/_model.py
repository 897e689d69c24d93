"""Growing on models."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

from . import _dapple
from ._texture import Document, _text


class GrownModel:
    """A model with what has grown on it."""

    def __init__(self, made: _dapple.GrownModel) -> None:
        """Wrap a grown model; `grow_on_model` makes it."""
        self._made = made

    @cached_property
    def report(self) -> dict[str, Any]:
        """What was asked, looked up and grown: the keys of `grow --report` in docs/bodies.md."""
        made: dict[str, Any] = json.loads(self._made.report_text())
        return made

    @cached_property
    def unfit(self) -> str | None:
        """Why a texture cannot be on the texture coordinates of the model's file; None if it can.

        Textures are then on automatic coordinates, which only the written models have.
        """
        return self._made.unfit()

    def save(
        self, path: str | os.PathLike[str], *, size: Sequence[int] | None = None, relief: float | None = None
    ) -> None:
        """Write the model (.glb or .obj with its texture, .ply with colours by vertex), complete or not at all.

        ``size`` is [width, height] of the texture, texels (2048, 2048); ``relief`` the height of the marks, px of
        the sketch (6; with a finish that of docs/finish.md). A .glb of a model without texture coordinates has
        colours by vertex, too.
        """
        self._made.save(os.fspath(path), _pair(size), relief)

    def material(
        self,
        folder: str | os.PathLike[str],
        *,
        name: str = "dapple",
        size: Sequence[int] | None = None,
        relief: float | None = None,
    ) -> None:
        """Write colour, height, normals, roughness and occlusion into a folder, and the model as glTF with them.

        ``size`` is [width, height] of the maps, texels (2048, 2048); ``relief`` the height of the marks, px of the
        sketch (6; with a finish that of docs/finish.md). The files begin with ``name`` (docs/materials.md).
        """
        self._made.material(os.fspath(folder), name, _pair(size), relief)


def grow_on_model(
    document: Document,
    *,
    model: str | os.PathLike[str] | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Callable[[str, float], object] | None = None,
) -> GrownModel:
    """Grow a document on its model.

    ``model`` is a file to grow on in place of the one that the document names (.obj, .ply, .stl, .glb, .gltf); the
    rest is that of `grow`. Raises `Error` if the document has no model, or cannot be grown.
    """
    text, source, beside = _text(document)
    named = None if model is None else os.fspath(model)
    return GrownModel(_dapple.grow_model(text, source, beside, named, seed, threads, progress))


def _pair(size: Sequence[int] | None) -> tuple[int, int] | None:
    return None if size is None else (int(size[0]), int(size[1]))
