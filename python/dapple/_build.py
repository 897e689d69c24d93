"""Documents put together by named arguments: plain dictionaries, as in a .dapple file."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

Point = Sequence[float]
Json = dict[str, Any]


def document(
    size: Sequence[int],
    *,
    layers: Iterable[Json],
    name: str = "",
    regions: Sequence[int] | None = None,
    edges: str = "closed",
    seed: int = 1,
    **more: Any,  # noqa: ANN401
) -> Json:
    """Return a document.

    ``size`` is [width, height] in px; ``regions`` [columns, rows], or None: each mark sets what grows around it;
    ``edges`` "closed" or "wrap" (a seamless tile). ``more`` are other keys of docs/format.md, such as ``finish``.
    """
    made: Json = {"format": "dapple", "version": 2, "name": name, "size": [int(side) for side in size]}
    if regions is not None:
        made["regions"] = [int(count) for count in regions]
    return {**made, "edges": edges, "seed": seed, "layers": list(layers), **more}


def layer(
    strokes: Iterable[Json],
    *,
    system: str = "auto",
    after: str = "between",
    options: Json | None = None,
    colours: Json | None = None,
    **more: Any,  # noqa: ANN401
) -> Json:
    """Return a layer of these strokes: ellipses, or lines and paths. ``more`` are other keys of docs/format.md."""
    made: Json = {"system": system, "after": after, "strokes": list(strokes), "options": options or {}}
    return {**made, **({} if colours is None else {"colours": colours}), **more}


def ellipse(center: Point, radii: Point, angle: float = 0.0) -> Json:
    """Return an ellipse: its centre (px), its radii along the angle and across it (px), its angle (degrees)."""
    return {"kind": "ellipse", "center": _point(center), "radii": _point(radii), "angle": float(angle)}


def line(start: Point, end: Point, width: float = 6.0) -> Json:
    """Return a line from ``start`` to ``end`` with this width, px."""
    return {"kind": "line", "from": _point(start), "to": _point(end), "width": float(width)}


def path(points: Iterable[Point], width: float = 6.0) -> Json:
    """Return a piece of a stripe that may bend, px."""
    return {"kind": "path", "points": [_point(point) for point in points], "width": float(width)}


def freehand(points: Iterable[Point], width: float = 6.0) -> Json:
    """Return a pen stroke, px: closed it becomes an ellipse, open a path of this width or a line."""
    return {"kind": "freehand", "points": [_point(point) for point in points], "width": float(width)}


def outline(points: Iterable[Point]) -> Json:
    """Return a patch: the corners of a closed polygon, px."""
    return {"kind": "outline", "points": [_point(point) for point in points]}


def _point(point: Point) -> list[float]:
    return [float(along) for along in point]
