"""hmmlearn's processor time on what wbv.bench.StatesTiming does: 43 200 rows of 18 features, 7 states, ten rounds."""
import os
os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
import time
import numpy as np
from hmmlearn.hmm import GaussianHMM

rng = np.random.default_rng(1)
centres = 2 * rng.normal(size=(7, 18))
rows = centres[np.arange(43200) // 60 % 7] + rng.normal(size=(43200, 18))
for kind in ("full", "diag"):
    fits, passes = [], []
    for _ in range(5):
        m = GaussianHMM(7, kind, n_iter=10, tol=-1e9, init_params="")
        m.startprob_ = np.full(7, 1 / 7)
        m.transmat_ = np.full((7, 7), 0.1 / 6) + np.eye(7) * (0.9 - 0.1 / 6)
        m.means_ = rows[rng.integers(0, 43200, 7)]
        m.covars_ = np.array([np.eye(18) * 4] * 7) if kind == "full" else np.full((7, 18), 4.0)
        t = time.process_time()
        m.fit(rows)
        fits.append(time.process_time() - t)
        t = time.process_time()
        m.score(rows)
        passes.append(time.process_time() - t)
    print(f"{kind}: ten rounds {np.median(fits):.2f} s, forward pass {1e9 * np.median(passes) / 43200:.0f} ns a sample")
