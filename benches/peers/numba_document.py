"""A document to its picture in plain numba: `numba_document.py REPORT OUT.png`, the other side of `compare --cases document`.

What one writes without dapple's means: Meinhardt's spots at one cell a px on a tile, by Euler steps, with centred differences for
the tensor, from a hexagonal lattice of spots, until dapple's own rule says that they have settled
(`src/engine/synth/grow/convergence.rs`), then coloured and written as PNG. The parameters, which would have to be searched for, are
those of dapple's REPORT of the same document.

Says `ready -|LAYER|0`, then grows once for each line of standard input and answers with the seconds.
"""

import json
import math
import sys
import time
import zlib
from pathlib import Path

import numba
import numpy as np
from numba import njit, prange

F = np.float32
#: p₂ of Meinhardt's spots: a unit of normalised time is 1 ÷ (p₂ · rate).
DECAY = 0.04
#: Of the largest stable Euler step: the reactions take some of it.
SAFE = 0.9
#: As in `src/engine/rd/systems/meinhardt_spots.rs` and `src/engine/synth/grow/convergence.rs`.
EVERY, EARLIEST, LATEST, DRIFT, FALLING, NEGLIGIBLE = 2.5, 15.0, 120.0, 0.004, 0.8, 0.0003
#: The share of the canvas that marks cover may differ by this much from dapple's, or this has not grown the document.
NEAR = 0.15
GROUND, MARK = (0xF4, 0xE3, 0xC1), (0x3B, 0x23, 0x14)


@njit(parallel=True, fastmath=True, error_model="numpy")
def steps(a, b, na, nb, xx, yy, xy, da, db, k, count):
    ny, nx = a.shape
    for _ in range(count):
        for y in prange(ny):
            up, down = y - 1 if y > 0 else ny - 1, y + 1 if y + 1 < ny else 0
            for x in range(nx):
                left, right = x - 1 if x > 0 else nx - 1, x + 1 if x + 1 < nx else 0
                u, v = a[y, x], b[y, x]
                su = xx * (a[y, left] + a[y, right] - F(2) * u) + yy * (a[up, x] + a[down, x] - F(2) * u)
                sv = xx * (b[y, left] + b[y, right] - F(2) * v) + yy * (b[up, x] + b[down, x] - F(2) * v)
                su += xy * (a[up, left] + a[down, right] - a[up, right] - a[down, left])
                sv += xy * (b[up, left] + b[down, right] - b[up, right] - b[down, left])
                source = F(0.01) * u * u
                na[y, x] = u + da * su + k * (source / v - F(0.03) * u)
                nb[y, x] = v + db * sv + k * (source - F(DECAY) * v)
        a, na = na, a
        b, nb = nb, b


class Document:
    """What dapple's report says about the only region of a document of spots."""

    def __init__(self, report):
        (layer,) = report["layers"]
        (region,) = layer["regions"]
        parameters, asked = region["parameters"], region["asked"]
        self.size = report["size"]
        self.covered = region["marks"] * region["got"]["area"] / (self.size[0] * self.size[1])
        self.spacing, self.level = asked["spacing"], parameters["level"]
        self.ratio, self.rate = parameters["ratio"], parameters["rate"] / parameters["cell"] ** 2
        along, across = 1 / parameters["stretch"], parameters["stretch"]
        c, s = (f(math.radians(parameters["direction"])) for f in (math.cos, math.sin))
        self.tensor = along * c * c + across * s * s, along * s * s + across * c * c, (along - across) * c * s
        self.peak = 3.3 * (self.ratio / 10) ** 0.765

    def start(self):
        """Bells on a hexagonal lattice of the wanted spacing."""
        nx, ny = self.size
        columns = round(nx / self.spacing)
        rows = 2 * round(ny / self.spacing / math.sqrt(0.75) / 2)
        xx, yy, xy = self.tensor
        y, x = np.mgrid[0:ny, 0:nx].astype(F)
        bells = np.zeros((ny, nx), F)
        radius = 0.6 * self.ratio**-0.45 * self.spacing
        for row in range(rows):
            for column in range(columns):
                dx = (x - (column + 0.5 * (row % 2)) * nx / columns + nx / 2) % nx - nx / 2
                dy = (y - row * ny / rows + ny / 2) % ny - ny / 2
                # The inverse of a tensor of determinant 1.
                away = yy * dx * dx - 2 * xy * dx * dy + xx * dy * dy
                np.maximum(bells, np.exp(-away / (2 * radius * radius)), out=bells)
        return F(0.02) + F(self.peak) * bells, np.full((ny, nx), 0.3, F)

    def grown(self, begun):
        """a once settled, and the normalised time that it took."""
        a, b = (begun.copy() for begun in begun)
        na, nb = a.copy(), b.copy()
        xx, yy, xy = self.tensor
        da, db = self.ratio**-0.5, self.ratio**0.5
        dt = SAFE / (2 * db * (xx + yy))
        arguments = [F(n) for n in (xx, yy, xy / 2, dt * da, dt * db, dt * self.rate)]
        # An even number, so that the arrays have changed places as often as not.
        count = 2 * math.ceil(EVERY / (dt * self.rate * DECAY) / 2)
        each = count * dt * self.rate * DECAY
        taken, last = 0.0, math.inf
        while True:
            before = a.copy()
            steps(a, b, na, nb, *arguments, count)
            taken += each
            change = float(np.abs(a - before).sum() / a.sum()) / each
            steady = change < DRIFT and change > FALLING * last
            if taken >= LATEST or taken >= EARLIEST and (steady or change < NEGLIGIBLE):
                return a, taken
            last = change

    def pattern(self, a):
        """0 on the ground, 1 in the middle of a mark, ½ at its edge."""
        share = np.clip(a / F(self.peak), 0, 1)
        up = share * F(1 - self.level)
        return up / (up + F(self.level) * (1 - share))


def write_png(path, pattern):
    ground, mark = (np.array(colour, F) for colour in (GROUND, MARK))
    image = np.rint(ground + pattern[..., None] * (mark - ground)).astype(np.uint8)
    height, width, _ = image.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), image.reshape(height, -1)], axis=1)

    def chunk(name, data):
        return len(data).to_bytes(4, "big") + name + data + zlib.crc32(name + data).to_bytes(4, "big")

    head = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 2, 0, 0, 0])
    chunks = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 1)) + chunk(b"IEND", b"")
    Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunks)


def main():
    document, out = Document(json.loads(Path(sys.argv[1]).read_text())), sys.argv[2]
    begun = document.start()
    pattern = document.pattern(document.grown(begun)[0])
    covered = float((pattern > 0.5).mean())
    if not abs(covered / document.covered - 1) < NEAR:
        raise SystemExit(f"numba's marks cover {covered:.3f} of the canvas, dapple's {document.covered:.3f}")
    print(f"ready -|{numba.threading_layer()}|0", flush=True)
    for _ in sys.stdin:
        started = time.perf_counter()
        write_png(out, document.pattern(document.grown(begun)[0]))
        print(time.perf_counter() - started, flush=True)


if __name__ == "__main__":
    main()
