"""Stores the least gamma of seats: python3 seat_h_infinity.py > ../resources/wbv/control/h-infinity.json

By bisection over two discrete Riccati equations of SciPy and their coupling; where there is no solution SciPy may give what leaves a
residual, which is refused. The seat's equations are written out again here, so that the program's are held to them.
"""
import json
import math
import numpy
import scipy.linalg

STEP = 1 / 250
FRAME, STIFFNESS, BESIDE, LAG = 15.0, 6000.0, 200.0, 0.010 + 0.004 + STEP / 2
WEIGHTING = 546.1, 86.51, 1892.0, 82.17
SENSORS = 5e-4, 0.05, 2.0


def seat(rigid, moving, frequency, damping, floor, width, rms, price):
    w = 2 * math.pi * frequency
    k, c = moving * w * w, 2 * damping * moving * w
    mass = FRAME + rigid
    wf = 2 * math.pi * floor
    frame = numpy.array([-STIFFNESS, -BESIDE, k, c, 1, 0, 0, 0, 0]) / mass
    a = numpy.zeros((9, 9))
    a[0, 1] = a[2, 3] = a[7, 8] = 1
    a[1] = frame
    a[1, 5] -= 1
    a[3] = -frame
    a[3, 2] -= w * w
    a[3, 3] -= 2 * damping * w
    a[4, 4] = -1 / LAG
    a[5, 5], a[5, 6], a[6, 5] = -2 * width * wf, -wf, wf
    a[8] = frame
    a[8, 7] -= WEIGHTING[2]
    a[8, 8] -= WEIGHTING[3]
    b1 = numpy.zeros((9, 6))
    b1[5, 0] = math.sqrt(4 * width * wf) * rms
    b1[1, 1], b1[3, 1], b1[3, 2] = 10 / mass, -10 / mass, 10 / mass
    b2 = numpy.zeros((9, 1))
    b2[4, 0] = 1 / LAG
    c1 = numpy.zeros((3, 9))
    c1[0, 7], c1[0, 8], c1[1, 0] = WEIGHTING[0], WEIGHTING[1], math.sqrt(price) / 0.02
    d12 = numpy.array([[0], [0], [1 / (2 * (FRAME + rigid + moving))]])
    c2 = numpy.zeros((3, 9))
    c2[0, 0] = c2[1, 5] = 1
    c2[2] = frame
    # states in units in which they are of the order of one, for the numbers' sake
    units = numpy.array([0.02, 0.2, 0.005, 0.1, 100, 1, 1, 1e-3, 0.02])
    return a * units / units[:, None], b1 / units[:, None], b2 / units[:, None], c1 * units, d12, c2 * units


def riccati(a, b, q, r):
    x = scipy.linalg.solve_discrete_are(a, b, q, r)
    left = a.T @ x @ a - x - a.T @ x @ b @ numpy.linalg.solve(r + b.T @ x @ b, b.T @ x @ a) + q
    if numpy.linalg.norm(left) > 1e-9 * numpy.linalg.norm(x) or min(numpy.linalg.eigvalsh(x)) <= 0:
        raise numpy.linalg.LinAlgError
    return x


def least(f, b1, b2, c1, d12, c):
    exponential = scipy.linalg.expm(STEP * numpy.block([[f, b2], [numpy.zeros((1, 10))]]))
    a, b = exponential[:9, :9], exponential[:9, 9:]
    noise = STEP * b1 @ b1.T + 1e-9 * numpy.eye(9)
    cost = c1.T @ c1 + 1e-9 * numpy.eye(9)
    price = (d12.T @ d12).item()
    shaken, costly = numpy.linalg.cholesky(noise), numpy.linalg.cholesky(cost)
    variance = numpy.diag(SENSORS) ** 2
    below, above = 1e-6, 1e6
    while above / below > 1.0001:
        square = math.sqrt(below * above)
        try:
            x = riccati(a, numpy.hstack([b, shaken]), cost, numpy.diag(numpy.r_[price, -square * numpy.ones(9)]))
            p = riccati(a.T, numpy.hstack([c.T, costly]), noise, scipy.linalg.block_diag(variance, -square * numpy.eye(9)))
            corrected = p - p @ c.T @ numpy.linalg.solve(c @ p @ c.T + variance, c @ p)
            possible = max(numpy.linalg.eigvals(noise @ x).real) < square and max(numpy.linalg.eigvals(corrected @ x).real) < square
        except numpy.linalg.LinAlgError:
            possible = False
        if possible:
            above = square
        else:
            below = square
    return math.sqrt(above)


cases = []
for numbers in [(5, 60, 5, 0.35, 2.2, 0.3, 1.7, 0.4), (5, 60, 5, 0.35, 2.2, 0.3, 1.7, 20), (8, 90, 4, 0.3, 7.6, 0.35, 1.6, 0.05), (4, 40, 6, 0.4, 3.3, 0.1, 2.2, 3)]:
    cases.append({"numbers": numbers, "gamma": least(*seat(*numbers))})
print(json.dumps({"maker": f"scipy.linalg.solve_discrete_are, SciPy {scipy.__version__}, NumPy {numpy.__version__}", "cases": cases}))
