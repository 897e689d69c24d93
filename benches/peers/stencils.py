"""Steps in well optimised numba: the same arithmetic as dapple's systems.

Rows are padded, so that no neighbour needs a test or a modulus; two pairs of arrays take turns; rows go to the
threads by prange; fastmath is on. The loop over a row is a function of its own that gets flat arrays and unsigned
indices: inlined into a prange loop, or given two-dimensional or signed indices, LLVM does not vectorise it, and
it is 2 to 2.5 times slower. (Found by trying; row views instead of flat arrays are as fast for the isotropic
step and up to 1.8 times slower with tensors.)

Tensors were tried in three forms, on one core at 1024²: a gather of each cell's own three offsets 110 M/s, all
eight offsets with a plane of weights each 410 M/s, runs of cells that share their three offsets 750 M/s. The last two
are kept; numba_side.py takes the faster.
"""

import numpy as np
from numba import njit, prange

F = np.float32
#: Without numpy's rule that x/0 is infinite, each division would carry a branch, and no loop with one be vectorised.
FAST = {"fastmath": True, "error_model": "numpy"}
#: As dapple_engine::rd::selling::OFFSETS; each with its opposite.
OFFSETS = ((1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 2), (2, -1), (1, -2))
#: Cells of padding on each side: as far as an offset reaches.
PAD = 2


@njit(**FAST)
def turing(a, b):
    ab = a * b
    return F(16) - ab, ab - b - F(12)


@njit(**FAST)
def turing_bound(b):
    return max(b, F(0))


@njit(**FAST)
def meinhardt(a, b):
    source = F(0.01) * a * a
    return source / b - F(0.03) * a, source - F(0.04) * b


@njit(**FAST)
def no_bound(b):
    return b


@njit(**FAST)
def wrap_row(u, nx):
    for i in range(PAD):
        u[i] = u[nx + i]
        u[nx + PAD + i] = u[PAD + i]


@njit(**FAST)
def wrap_rows(u):
    # By hand: in a parallel function a slice assignment would be handed out to all threads.
    ny = u.shape[0] - 2 * PAD
    for i in range(PAD):
        for x in range(u.shape[1]):
            u[i, x] = u[ny + i, x]
            u[ny + PAD + i, x] = u[PAD + i, x]


def isotropic(parallel):
    """Turing spots, 5-point, constant coefficients."""

    @njit(**FAST)
    def row(a, b, na, nb, start, n, stride, da, db, k):
        one = np.uint64(1)
        for x in range(n):
            i = start + x
            u, v = a[i], b[i]
            fa, fb = turing(u, v)
            sa = a[i - stride] + a[i + stride] + a[i - one] + a[i + one] - F(4) * u
            sb = b[i - stride] + b[i + stride] + b[i - one] + b[i + one] - F(4) * v
            na[i] = u + da * sa + k * fa
            nb[i] = turing_bound(v + db * sb + k * fb)

    @njit(**FAST, parallel=parallel)
    def steps(a, b, na, nb, da, db, k, count):
        ny, nx, stride = a.shape[0] - 2 * PAD, a.shape[1] - 2 * PAD, a.shape[1]
        for _ in range(count):
            fa, fb, fna, fnb = a.reshape(-1), b.reshape(-1), na.reshape(-1), nb.reshape(-1)
            for y in prange(ny):
                start = np.uint64((y + PAD) * stride + PAD)
                row(fa, fb, fna, fnb, start, np.uint64(nx), np.uint64(stride), da, db, k)
                wrap_row(na[y + PAD], nx)
                wrap_row(nb[y + PAD], nx)
            wrap_rows(na)
            wrap_rows(nb)
            a, na = na, a
            b, nb = nb, b

    return steps


def runs(parallel, react, bound):
    """A tensor, a rate and two mobilities a cell; runs of cells with the same offsets are stepped together."""

    @njit(**FAST)
    def run(a, b, na, nb, w0, w1, w2, ma, mb, k, start, cell, n, e0, e1, e2):
        for x in range(n):
            i, j = start + x, cell + x
            u, v = a[i], b[i]
            uu, vv = F(2) * u, F(2) * v
            p, q, r = w0[j], w1[j], w2[j]
            sa = p * (a[i + e0] + a[i - e0] - uu) + q * (a[i + e1] + a[i - e1] - uu) + r * (a[i + e2] + a[i - e2] - uu)
            sb = p * (b[i + e0] + b[i - e0] - vv) + q * (b[i + e1] + b[i - e1] - vv) + r * (b[i + e2] + b[i - e2] - vv)
            fa, fb = react(u, v)
            na[i] = u + ma[j] * sa + k[j] * fa
            nb[i] = bound(v + mb[j] * sb + k[j] * fb)

    @njit(**FAST, parallel=parallel)
    def steps(a, b, na, nb, first, places, offsets, weights, ma, mb, k, count):
        ny, nx, stride = a.shape[0] - 2 * PAD, a.shape[1] - 2 * PAD, a.shape[1]
        w0, w1, w2 = weights[0].reshape(-1), weights[1].reshape(-1), weights[2].reshape(-1)
        fma, fmb, fk = ma.reshape(-1), mb.reshape(-1), k.reshape(-1)
        for _ in range(count):
            fa, fb, fna, fnb = a.reshape(-1), b.reshape(-1), na.reshape(-1), nb.reshape(-1)
            for y in prange(ny):
                for i in range(first[y], first[y + 1]):
                    x, n = places[i, 0], places[i, 1]
                    start, cell = np.uint64((y + PAD) * stride + PAD + x), np.uint64(y * nx + x)
                    e0, e1, e2 = np.uint64(offsets[i, 0]), np.uint64(offsets[i, 1]), np.uint64(offsets[i, 2])
                    run(fa, fb, fna, fnb, w0, w1, w2, fma, fmb, fk, start, cell, np.uint64(n), e0, e1, e2)
                wrap_row(na[y + PAD], nx)
                wrap_row(nb[y + PAD], nx)
            wrap_rows(na)
            wrap_rows(nb)
            a, na = na, a
            b, nb = nb, b

    return steps


def planes(parallel, react, bound):
    """The same with all eight offsets at every cell."""

    @njit(**FAST)
    def row(a, b, na, nb, w0, w1, w2, w3, w4, w5, w6, w7, ma, mb, k, start, cell, n, s):
        l, t = np.uint64(1), np.uint64(2)
        ss = s + s
        for x in range(n):
            i, j = start + x, cell + x
            u, v = a[i], b[i]
            uu, vv = F(2) * u, F(2) * v
            sa = w0[j] * (a[i + l] + a[i - l] - uu) + w1[j] * (a[i + s] + a[i - s] - uu)
            sb = w0[j] * (b[i + l] + b[i - l] - vv) + w1[j] * (b[i + s] + b[i - s] - vv)
            sa += w2[j] * (a[i + s + l] + a[i - s - l] - uu) + w3[j] * (a[i - s + l] + a[i + s - l] - uu)
            sb += w2[j] * (b[i + s + l] + b[i - s - l] - vv) + w3[j] * (b[i - s + l] + b[i + s - l] - vv)
            sa += w4[j] * (a[i + s + t] + a[i - s - t] - uu) + w5[j] * (a[i + ss + l] + a[i - ss - l] - uu)
            sb += w4[j] * (b[i + s + t] + b[i - s - t] - vv) + w5[j] * (b[i + ss + l] + b[i - ss - l] - vv)
            sa += w6[j] * (a[i - s + t] + a[i + s - t] - uu) + w7[j] * (a[i - ss + l] + a[i + ss - l] - uu)
            sb += w6[j] * (b[i - s + t] + b[i + s - t] - vv) + w7[j] * (b[i - ss + l] + b[i + ss - l] - vv)
            fa, fb = react(u, v)
            na[i] = u + ma[j] * sa + k[j] * fa
            nb[i] = bound(v + mb[j] * sb + k[j] * fb)

    @njit(**FAST, parallel=parallel)
    def steps(a, b, na, nb, weights, ma, mb, k, count):
        ny, nx, stride = a.shape[0] - 2 * PAD, a.shape[1] - 2 * PAD, a.shape[1]
        w = weights.reshape(8, -1)
        w0, w1, w2, w3, w4, w5, w6, w7 = w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7]
        fma, fmb, fk = ma.reshape(-1), mb.reshape(-1), k.reshape(-1)
        for _ in range(count):
            fa, fb, fna, fnb = a.reshape(-1), b.reshape(-1), na.reshape(-1), nb.reshape(-1)
            for y in prange(ny):
                start, cell = np.uint64((y + PAD) * stride + PAD), np.uint64(y * nx)
                n, s = np.uint64(nx), np.uint64(stride)
                row(fa, fb, fna, fnb, w0, w1, w2, w3, w4, w5, w6, w7, fma, fmb, fk, start, cell, n, s)
                wrap_row(na[y + PAD], nx)
                wrap_row(nb[y + PAD], nx)
            wrap_rows(na)
            wrap_rows(nb)
            a, na = na, a
            b, nb = nb, b

    return steps


def in_runs(weights, stride):
    """Eight planes of weights -> first run of each row, (column, length) and offsets of each run, three planes."""
    _, ny, nx = weights.shape
    assert (weights > 0).sum(axis=0).max() <= 3, "a cell uses more than three offsets"
    used = np.sort(np.argsort(weights <= 0, axis=0, kind="stable")[:3], axis=0)
    three = np.ascontiguousarray(np.take_along_axis(weights, used, 0))
    linear = np.array([dy * stride + dx for dx, dy in OFFSETS], dtype=np.int64)
    sets = (used[0] * 8 + used[1]) * 8 + used[2]
    first, places, offsets = [0], [], []
    for y in range(ny):
        cuts = [0, *(np.flatnonzero(np.diff(sets[y])) + 1).tolist(), nx]
        for x, end in zip(cuts, cuts[1:]):
            places.append((x, end - x))
            offsets.append(linear[used[:, y, x]])
        first.append(len(places))
    return np.array(first), np.array(places), np.array(offsets), three
