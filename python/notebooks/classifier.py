# %% [markdown]
# # A classifier trained on grown textures
#
# Textures with labels are grown, not collected: a classifier learns from one part of the stream which kind a
# texture is, and is tested on another part, whose sketches it has not seen.

# %%
from __future__ import annotations

import itertools

import numpy as np
from sklearn.linear_model import LogisticRegression
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

import dapple

KINDS = ["spots", "stripes", "stucco"]
TRAINING, TEST, SIZE = 90, 45, 96


def features(rgb: np.ndarray) -> np.ndarray:
    """Numbers that do not depend on the colours: the spectrum by distance and by direction."""
    gray = rgb.astype(float).mean(axis=2)
    gray = (gray - gray.mean()) / (gray.std() + 1e-9)
    window = np.hanning(SIZE)
    power = np.abs(np.fft.fftshift(np.fft.fft2(gray * window[:, None] * window))) ** 2
    y, x = np.mgrid[:SIZE, :SIZE] - SIZE // 2
    distance, angle = np.hypot(x, y), np.arctan2(y, x) % np.pi
    rings = [np.log1p(power[(distance >= r) & (distance < r + 3)].sum()) for r in range(2, SIZE // 2, 3)]
    ring = (distance > 3) & (distance < 30)
    sectors = np.sort([power[ring & (angle >= a) & (angle < a + np.pi / 8)].sum() for a in np.arange(8) * np.pi / 8])
    skew = (gray**3).mean()
    return np.array([*rings, *(sectors / sectors.sum()), skew, abs(skew)])


# %%
items = itertools.islice(dapple.stream(seed=11, size=SIZE, kinds=KINDS), TRAINING + TEST)
known, wanted = map(np.array, zip(*((features(item.rgb), item.kind) for item in items), strict=True))
model = make_pipeline(StandardScaler(), LogisticRegression(max_iter=2000))
model.fit(known[:TRAINING], wanted[:TRAINING])
right = model.score(known[TRAINING:], wanted[TRAINING:])
print(f"{len(KINDS)} kinds, {TRAINING} textures to learn from, {TEST} others: {100 * right:.0f} % right")
assert right > 0.8, right
