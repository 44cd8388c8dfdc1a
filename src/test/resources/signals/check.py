"""Reads with other programs what wbv wrote: python check.py FOLDER; see README.md. Needs h5py, numpy, pandas, polars, pyarrow,
scipy, pyuff and soundfile."""
import sys

import h5py
import numpy as np
import pandas as pd
import polars as pl
import pyuff
import scipy.io
import scipy.io.wavfile
import soundfile

folder = sys.argv[1]
truth = pd.read_csv(f"{folder}/r.csv", comment="#")
channels = list(truth.columns[1:])


def near(name, channel, values, relative):
    error = np.abs(np.asarray(values, float).ravel() - truth[channel].values)
    assert (error <= relative * np.abs(truth[channel].values)).all(), f"{name} {channel}: off by {error.max()}"


for name, relative in (("r.uff", 0), ("r.unv", 1e-12)):
    file = pyuff.UFF(f"{folder}/{name}")
    sets = [file.read_sets(i) for i, kind in enumerate(file.get_set_types()) if kind == 58]
    assert [each["id1"] for each in sets] == channels
    for each in sets:
        near(name, each["id1"], each["data"], relative)
        assert abs(each["abscissa_inc"] * 1 / np.diff(truth["t"]).mean() - 1) < 1e-6
mat = scipy.io.loadmat(f"{folder}/r.mat")
for channel in truth.columns:
    near("r.mat", channel, mat[channel.replace(".", "_")], 0)
with h5py.File(f"{folder}/r.h5") as hdf:
    assert list(hdf.attrs["order"].astype(str)) == channels
    for channel in truth.columns:
        near("r.h5", channel, hdf[channel][:], 0)
        assert hdf[channel].attrs["unit"]
frame = pd.read_parquet(f"{folder}/r.parquet")
other = pl.read_parquet(f"{folder}/r.parquet")
assert list(frame.columns) == other.columns == ["t"] + channels
assert frame.attrs["rate_hz"] == round(1 / np.diff(truth["t"]).mean())
for channel in truth.columns:
    near("r.parquet", channel, frame[channel], 0)
    near("r.parquet", channel, other[channel].to_numpy(), 0)
rate, sound = scipy.io.wavfile.read(f"{folder}/r.wav")
other, again = soundfile.read(f"{folder}/r.wav", dtype="float32", always_2d=True)
assert rate == again == round(1 / np.diff(truth["t"]).mean())
for i, channel in enumerate(channels):
    near("r.wav", channel, sound[:, i], 6e-8)
    near("r.wav", channel, other[:, i], 6e-8)
print(f"{len(channels)} channels, {len(truth)} samples: pyuff, SciPy, h5py, pandas, polars and soundfile read what was written")
