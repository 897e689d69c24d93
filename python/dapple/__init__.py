"""A sketch of a pattern in, a grown texture out.

Lengths are px, x to the right, y down; angles are degrees from +x towards +y, axial (read mod 180).

    >>> import dapple
    >>> spots = [dapple.ellipse([30, 30], [8, 5], angle=30), dapple.ellipse([58, 34], [8, 5], angle=30)]
    >>> grown = dapple.grow(dapple.document([96, 96], layers=[dapple.layer(spots)]))
    >>> grown.rgb.shape
    (96, 96, 3)
"""

from ._build import document, ellipse, freehand, layer, line, outline, path
from ._dapple import Error
from ._data_set import KINDS, Item, Tip, stream
from ._model import GrownModel, grow_on_model
from ._texture import Grown, check, from_photo, grow, lookup, measure, read, schema

__all__ = [
    "KINDS",
    "Error",
    "Grown",
    "GrownModel",
    "Item",
    "Tip",
    "check",
    "document",
    "ellipse",
    "freehand",
    "from_photo",
    "grow",
    "grow_on_model",
    "layer",
    "line",
    "lookup",
    "measure",
    "outline",
    "path",
    "read",
    "schema",
    "stream",
]
__version__ = "0.1.0"
