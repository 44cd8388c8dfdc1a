"""Stores what scipy.linalg.solve_discrete_are says of random equations: python3 riccati_scipy.py > ../resources/wbv/control/riccati.json"""
import json
import numpy
import scipy
import scipy.linalg

random = numpy.random.default_rng(23)
cases = []
for n, m, radius in [(1, 1, 0.9), (2, 1, 1.3), (3, 2, 0.99), (4, 1, 0.999), (5, 2, 1.05), (6, 3, 0.7), (8, 1, 1.01), (9, 3, 0.995)]:
    a = random.standard_normal((n, n))
    a *= radius / max(abs(numpy.linalg.eigvals(a)))
    b = random.standard_normal((n, m))
    c = random.standard_normal((n, n))
    q = c.T @ c
    d = random.standard_normal((m, m))
    r = d.T @ d + numpy.eye(m)
    x = scipy.linalg.solve_discrete_are(a, b, q, r)
    cases.append({"a": a.tolist(), "b": b.tolist(), "q": q.tolist(), "r": r.tolist(), "x": x.tolist()})
for n, m, share in [(2, 1, 50.0), (4, 2, 20.0), (9, 2, 10.0)]:  # games: the last inputs are the opponent's, whose weight is negative
    a = random.standard_normal((n, n))
    a *= 0.95 / max(abs(numpy.linalg.eigvals(a)))
    b = random.standard_normal((n, m))
    w = 0.1 * random.standard_normal((n, m))
    q = numpy.eye(n)
    alone = scipy.linalg.solve_discrete_are(a, b, q, numpy.eye(m))
    square = share * max(numpy.linalg.eigvalsh(w.T @ alone @ w))
    r = numpy.diag([1.0] * m + [-square] * m)
    b = numpy.hstack([b, w])
    x = scipy.linalg.solve_discrete_are(a, b, q, r)
    cases.append({"a": a.tolist(), "b": b.tolist(), "q": q.tolist(), "r": r.tolist(), "x": x.tolist()})
print(json.dumps({"maker": f"scipy.linalg.solve_discrete_are, SciPy {scipy.__version__}, NumPy {numpy.__version__}", "cases": cases}))
