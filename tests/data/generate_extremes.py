"""Writes tests/data/extremes.json: inputs and answers of pyextremes and scipy for the comparison in src/extremes."""
import json
import importlib.metadata as meta

import numpy as np
import pandas as pd
import scipy.optimize
import scipy.signal
import scipy.stats
from pyextremes import EVA, get_extremes

rng = np.random.default_rng(20240)
n = 4000
# Autoregression of second order with exponential noise, times with gaps; rounded so that the text is short.
x = np.zeros(n)
e = rng.exponential(1.0, n) - 1.0
for k in range(2, n):
    x[k] = 1.4 * x[k - 1] - 0.6 * x[k - 2] + e[k]
x = np.round(x, 4)
seconds = np.cumsum(rng.choice([1, 1, 1, 2, 5], n))
index = pd.Timestamp("2000-01-01") + pd.to_timedelta(seconds, unit="s")
series = pd.Series(x, index=index)
place = {t: k for k, t in enumerate(index)}


def of(extremes):
    return {"index": [place[t] for t in extremes.index], "value": [float(v) for v in extremes.values]}


def tight(negative, start):
    """Minimum of a negative log-likelihood by Nelder-Mead to 1e-13, restarted."""
    for _ in range(6):
        start = scipy.optimize.minimize(negative, start, method="Nelder-Mead",
                                        options={"xatol": 1e-13, "fatol": 1e-13, "maxiter": 20000}).x
    return [float(v) for v in start]


block = get_extremes(series, "BM", extremes_type="high", block_size="100s", errors="ignore")
threshold, separation = 4.0, 8.0
pot = get_extremes(series, "POT", extremes_type="high", threshold=threshold, r="8s")

eva = EVA(series)
eva.get_extremes("BM", extremes_type="high", block_size="100s", errors="ignore")
eva.fit_model("MLE", distribution="gumbel_r")
gumbel = eva.model.fit_parameters
eva.get_extremes("POT", extremes_type="high", threshold=threshold, r="8s")
eva.fit_model("MLE", distribution="genpareto", distribution_kwargs={"floc": threshold})
pareto = eva.model.fit_parameters
y = pot.values
weibull = scipy.stats.weibull_min.fit(y, floc=threshold)

g = tight(lambda p: -np.sum(scipy.stats.gumbel_r.logpdf(block.values, p[0], p[1])), [gumbel["loc"], gumbel["scale"]])
p = tight(lambda p: -np.sum(scipy.stats.genpareto.logpdf(y, p[0], threshold, p[1])) if p[1] > 0 else np.inf,
          [pareto["c"], pareto["scale"]])
w = tight(lambda p: -np.sum(scipy.stats.weibull_min.logpdf(y, p[0], threshold, p[1])) if min(p) > 0 else np.inf,
          [weibull[0], weibull[2]])

spectra = []
for length in (256, 375):
    f, s = scipy.signal.welch(x, fs=4.0, window="hann", nperseg=length, noverlap=length // 2,
                              detrend="constant", scaling="density", average="mean")
    spectra.append({"length": length, "frequency": [float(v) for v in f], "density": [float(v) for v in s]})

out = {
    "about": {
        "programs": [
            {"name": k, "version": meta.version(k), "licence": l}
            for k, l in (("pyextremes", "MIT"), ("scipy", "BSD-3-Clause"), ("numpy", "BSD-3-Clause"))
        ],
        "note": "'program' is the fit as pyextremes gives it (scipy's fit: Nelder-Mead, xtol = ftol = 1e-4 of fmin); "
                "'tight' is the same likelihood of scipy minimised to 1e-13.",
    },
    "times": [int(v) for v in seconds],
    "values": [float(v) for v in x],
    "block_maxima": {"block": 100.0, **of(block)},
    "over_threshold": {"threshold": threshold, "separation": separation, **of(pot)},
    "gumbel": {"program": [float(gumbel["loc"]), float(gumbel["scale"])], "tight": g,
               "log_likelihood": float(np.sum(scipy.stats.gumbel_r.logpdf(block.values, *g)))},
    "pareto": {"program": [float(pareto["c"]), float(pareto["scale"])], "tight": p,
               "log_likelihood": float(np.sum(scipy.stats.genpareto.logpdf(y, p[0], threshold, p[1])))},
    "weibull": {"program": [float(weibull[0]), float(weibull[2])], "tight": w,
                "log_likelihood": float(np.sum(scipy.stats.weibull_min.logpdf(y, w[0], threshold, w[1])))},
    "special": {
        "ln_gamma": [[v, float(scipy.special.gammaln(v))] for v in (0.1, 0.7, 3.3, 14.9, 250.5, 1e5)],
        "chi_squared": [[k, q, float(scipy.stats.chi2.ppf(q, k))] for k in (1.0, 2.7, 15.3, 400.0) for q in (0.01, 0.5, 0.99)],
        "normal": [[q, float(scipy.stats.norm.ppf(q))] for q in (1e-12, 0.003, 0.3, 0.8, 0.9999)],
        "ln_beta_cdf": [[a, b, v, float(scipy.stats.beta.logcdf(v, a, b))]
                        for a, b in ((0.5, 0.5), (3.5, 20.5), (80.5, 40.5)) for v in (0.05, 0.4, 0.63)],
    },
    "spectra": spectra,
}
text = json.dumps(out, separators=(",", ":"))
open("tests/data/extremes.json", "w").write(text + "\n")
print(len(text), gumbel, g, pareto, p, weibull, w, len(block), len(pot))
