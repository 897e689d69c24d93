# %% [markdown]
# # Asked = got
#
# Spots are drawn with one attribute changed step by step. What has grown is measured on the pattern, by the
# package and, of the area, by counting px.

# %%
from __future__ import annotations

import numpy as np

import dapple


def spots(area: float, aspect: float, angle: float, spacing: float) -> dict:
    """Three ellipses with these attributes on a seamless tile."""
    along = np.sqrt(area / np.pi / aspect)
    places = [[0, 0], [1, 0], [0.5, np.sqrt(0.75)]]
    marks = [
        dapple.ellipse([90 + spacing * x, 90 + spacing * y], [along, along * aspect], angle=angle) for x, y in places
    ]
    return dapple.document([256, 256], layers=[dapple.layer(marks, system="meinhardt-spots")], edges="wrap")


USUAL = {"area": 180.0, "aspect": 0.6, "angle": 30.0, "spacing": 36.0}
STEPS = {
    "area": [100.0, 180.0, 240.0],
    "aspect": [0.4, 0.6, 0.8],
    "angle": [0.0, 30.0, 75.0, 140.0],
    "spacing": [30.0, 36.0, 48.0],
}

# %%
print(f"{'attribute':10} {'asked':>8} {'got':>8}")
for attribute, values in STEPS.items():
    for value in values:
        asked = {**USUAL, attribute: value}
        grown = dapple.grow(spots(**asked))
        got = grown.report["layers"][0]["regions"][0]["got"]
        print(f"{attribute:10} {value:8.2f} {got[attribute]:8.2f}")
        off = got[attribute] - value
        if attribute == "angle":
            assert abs((off + 90) % 180 - 90) < 3, (asked, got)
        else:
            assert abs(off) < (0.05 if attribute == "aspect" else 0.1 * value), (asked, got)
        if attribute == "area":
            # Another ruler: px above one half ÷ marks, on a tile.
            marks = grown.report["layers"][0]["regions"][0]["marks"]
            counted = (grown.pattern >= 0.5).sum() / marks
            assert abs(counted / got["area"] - 1) < 0.05, (counted, got)
