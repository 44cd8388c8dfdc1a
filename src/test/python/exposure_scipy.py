"""What SciPy takes for a minute of 30 channels of Wk: beside wbv.bench.ExposureBenchmark. Run: python3 exposure_scipy.py"""
import time

import numpy as np
import scipy
from scipy import signal


def wk(rate):
    """Second-order sections of Wk by the bilinear transform at a rate [Hz]."""
    def w(f):
        return 2 * np.pi * f
    q = 2 ** -0.5
    analog = [([1, 0, 0], [1, w(.4) / q, w(.4) ** 2]), ([1], [1 / w(100) ** 2, 1 / (q * w(100)), 1]),
              ([1 / w(12.5), 1], [1 / w(12.5) ** 2, 1 / (.63 * w(12.5)), 1]),
              ([1 / w(3.35) ** 2, w(2.37) / (.91 * w(3.35) ** 2), (2.37 / 3.35) ** 2],
               [1 / w(3.35) ** 2, 1 / (.91 * w(3.35)), 1])]
    rows = []
    for b, a in analog:
        bz, az = signal.bilinear(b, a, rate)
        rows.append(np.r_[bz, np.zeros(3 - len(bz)), az, np.zeros(3 - len(az))])
    return np.array(rows)


def best(work, repeats=9):
    times = []
    for _ in range(repeats):
        begun = time.perf_counter()
        work()
        times.append(time.perf_counter() - begun)
    return 1e3 * min(times)


rate, factor, channels = 60, 14, 30
sections = wk(rate * factor)
x = np.random.default_rng(1).uniform(-1, 1, (channels, 60 * rate))
raised = signal.resample_poly(x, factor, 1, axis=1, window=('kaiser', 7))


def lfilter():
    y = raised
    for row in sections:
        y = signal.lfilter(row[:3], row[3:], y, axis=1)
    return y


def whole():
    y = signal.sosfilt(sections, signal.resample_poly(x, factor, 1, axis=1, window=('kaiser', 7)), axis=1)
    squares = y * y
    second = rate * factor
    sums = np.cumsum(squares, axis=1)
    np.sqrt(np.maximum(sums[:, second:] - sums[:, :-second], 0) / second).max(axis=1)
    signal.lfilter([-np.expm1(-1 / second)], [1, np.expm1(-1 / second)], squares, axis=1).max(axis=1)
    (squares * squares).sum(axis=1)


print(f'NumPy {np.__version__}, SciPy {scipy.__version__}; {channels} channels, 60 s at {rate} Hz, x{factor}')
print(f'lfilter, four sections in turn, at {rate * factor} Hz: {best(lfilter):.1f} ms')
print(f'sosfilt at {rate * factor} Hz:                         {best(lambda: signal.sosfilt(sections, raised, axis=1)):.1f} ms')
print(f'resample_poly, sosfilt, running means, dose:  {best(whole):.1f} ms')
