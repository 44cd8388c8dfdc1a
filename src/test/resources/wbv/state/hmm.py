"""Makes hmm.json: hmmlearn's likelihoods, posteriors, paths and fits of small sequences (hmmlearn 0.3.3, numpy 2).

Every prior of hmmlearn is switched off, so that its fit is plain maximum likelihood.
"""
import json
import numpy as np
from hmmlearn.hmm import GaussianHMM, GMMHMM

rng = np.random.default_rng(20)


def rows(a):
    return np.asarray(a).tolist()


def sequences(start, trans, means, covs, lengths):
    out = []
    for n in lengths:
        s = rng.choice(len(start), p=start)
        seq = []
        for _ in range(n):
            seq.append(rng.multivariate_normal(means[s], covs[s]))
            s = rng.choice(len(start), p=trans[s])
        out.append(np.round(seq, 6))
    return out


K, D = 3, 2
start = np.array([0.5, 0.3, 0.2])
trans = np.array([[0.9, 0.07, 0.03], [0.1, 0.8, 0.1], [0.05, 0.15, 0.8]])
means = np.array([[0.0, 0.0], [2.0, 1.0], [-1.0, 3.0]])
covs = np.array([[[1.0, 0.3], [0.3, 0.5]], [[0.6, -0.2], [-0.2, 1.2]], [[0.4, 0.0], [0.0, 0.7]]])
seqs = sequences(start, trans, means, covs, [120, 1, 75])
X, L = np.concatenate(seqs), [len(s) for s in seqs]
out = {"source": "hmmlearn 0.3.3, numpy 2.4.6; made by hmm.py", "sequences": [rows(s) for s in seqs]}
begin_means = np.array([[0.3, -0.2], [1.5, 1.5], [-0.5, 2.5]])
for name in ("full", "diag"):
    m = GaussianHMM(K, name, init_params="", n_iter=1, tol=0, covars_prior=0, covars_weight=0, means_weight=0, min_covar=0)
    m.startprob_, m.transmat_ = np.full(K, 1 / 3), np.array([[0.8, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.1, 0.8]])
    m.means_ = begin_means
    m.covars_ = np.array([np.eye(D) * 1.5] * K) if name == "full" else np.full((K, D), 1.5)
    case = {"start": {"initial": rows(m.startprob_), "transition": rows(m.transmat_), "means": rows(m.means_),
                      "covariances": rows([np.eye(D) * 1.5] * K)}}
    case["log_likelihood"] = m.score(X, L)
    case["posteriors"] = rows(m.predict_proba(X, L))
    case["path"] = rows(m.decode(X, L)[1])
    case["fitted"] = []
    for rounds in (1, 10):
        f = GaussianHMM(K, name, init_params="", n_iter=rounds, tol=-1e9, covars_prior=0, covars_weight=0, means_weight=0)
        f.startprob_, f.transmat_, f.means_, f.covars_ = m.startprob_, m.transmat_, m.means_.copy(), np.array(
            [np.eye(D) * 1.5] * K) if name == "full" else np.full((K, D), 1.5)
        f.fit(X, L)
        case["fitted"].append({"rounds": rounds, "initial": rows(f.startprob_), "transition": rows(f.transmat_),
                               "means": rows(f.means_), "covariances": rows(f.covars_), "log_likelihood": f.score(X, L)})
    out[name] = case

# hmmlearn takes covariances about the means of the round before, so only the end of the road is comparable: many rounds.
g = GMMHMM(2, 2, covariance_type="full", init_params="", n_iter=4000, tol=-1e9, weights_prior=1, means_weight=0,
           covars_prior=np.zeros((2, 2, D, D)), covars_weight=-(1 + D + 1) * np.ones((2, 2)))
g.startprob_, g.transmat_ = np.array([0.5, 0.5]), np.array([[0.9, 0.1], [0.2, 0.8]])
g.weights_ = np.array([[0.6, 0.4], [0.5, 0.5]])
g.means_ = np.array([[[0.0, 0.0], [2.0, 1.0]], [[-1.0, 3.0], [1.0, 2.0]]])
g.covars_ = np.array([[np.eye(D)] * 2] * 2)
case = {"start": {"initial": rows(g.startprob_), "transition": rows(g.transmat_), "weights": rows(g.weights_),
                  "means": rows(g.means_), "covariances": rows(g.covars_)}}
case["log_likelihood"] = g.score(X, L)
case["posteriors"] = rows(g.predict_proba(X, L))
g.fit(X, L)
case["fitted"] = [{"rounds": 4000, "initial": rows(g.startprob_), "transition": rows(g.transmat_), "weights": rows(g.weights_),
                   "means": rows(g.means_), "covariances": rows(g.covars_), "log_likelihood": g.score(X, L)}]
out["mixture"] = case
with open("hmm.json", "w") as file:
    json.dump(out, file)
print({k: out[k]["log_likelihood"] for k in ("full", "diag", "mixture")})
