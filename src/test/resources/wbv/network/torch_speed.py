"""PyTorch in Python on the network of one mode that ships, beside which docs/benchmarks.md sets ours. One thread.

python3 torch_speed.py ../../../../main/resources/wbv/network/pooled-1-dof.safetensors
"""
import json
import struct
import sys
import time

import numpy as np
import torch
from torch import nn

torch.set_num_threads(1)
torch.set_num_interop_threads(1)
raw = open(sys.argv[1], "rb").read()
size = struct.unpack("<Q", raw[:8])[0]
head = json.loads(raw[8:8 + size])
words = {k: v for k, v in head.pop("__metadata__").items()}
numbers = {k: np.array(json.loads(words[k])) for k in ("plane_mean", "plane_deviation", "mean", "deviation", "widening")}
tensors = [torch.from_numpy(np.frombuffer(raw[8 + size + v["data_offsets"][0]:8 + size + v["data_offsets"][1]], "<f4")
                            .reshape(v["shape"]).copy()) for v in head.values()]


class Pooled(nn.Module):
    """1x1 and 3x1 convolutions with batch normalisation, a gated mean over time, two dense layers."""

    def __init__(self):
        super().__init__()
        self.a, self.an = nn.Conv2d(4, 24, 1), nn.BatchNorm2d(24)
        self.b, self.bn = nn.Conv2d(24, 24, (3, 1), padding=(1, 0)), nn.BatchNorm2d(24)
        self.v, self.g = nn.Conv2d(24, 16, 1), nn.Conv2d(24, 16, 1)
        self.c, self.d = nn.Linear(512, 64), nn.Linear(64, 4)
        order = [self.a.weight, self.a.bias, self.an.weight, self.an.bias, self.an.running_mean, self.an.running_var,
                 self.b.weight, self.b.bias, self.bn.weight, self.bn.bias, self.bn.running_mean, self.bn.running_var,
                 self.v.weight, self.v.bias, self.g.weight, self.g.bias, self.c.weight, self.c.bias, self.d.weight, self.d.bias]
        with torch.no_grad():
            for into, tensor in zip(order, tensors, strict=True):
                into.copy_(tensor)

    def forward(self, x):
        x = torch.relu(self.an(self.a(x)))
        x = torch.relu(self.bn(self.b(x)))
        x = (self.v(x) * torch.softmax(self.g(x), 3)).sum(3)
        return self.d(torch.relu(self.c(x.flatten(1))))


WINDOW = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(64) / 64)
AT = 5 * np.arange(32)[:, None] + np.arange(64)


def image(motion):
    """Level, gain, cosine and sine of 32 lines at 32 moments, standardised; motion is batch, 2, 219."""
    x = motion[..., AT]
    x = np.fft.rfft((x - x.mean(-1, keepdims=True)) * WINDOW)[..., 1:].swapaxes(-1, -2)
    p = np.abs(x) ** 2 + 1e-8
    u, y, cross = p[:, 0], p[:, 1], x[:, 1] * np.conj(x[:, 0])
    level = 0.5 * np.log(u)
    root = np.sqrt(u * y)
    planes = np.stack([level - level.mean((1, 2), keepdims=True), 0.5 * np.log(y / u), cross.real / root, cross.imag / root], 1)
    return torch.from_numpy(((planes - numbers["plane_mean"][:, None, None]) / numbers["plane_deviation"][:, None, None])
                            .astype(np.float32))


net = Pooled().eval()
n = np.arange(219)
motion = np.stack([np.sin(0.21 * n) + 0.6 * np.cos(0.57 * n + 1) + 0.3 * np.sin(0.93 * n + 2),
                   1.3 * np.sin(0.21 * n - 0.4) + 0.7 * np.cos(0.57 * n) + 0.1 * np.sin(0.93 * n)])[None]


def timed(what, repeats):
    for _ in range(repeats // 5 + 1):
        what()
    each = []
    for _ in range(5):
        start = time.perf_counter()
        for _ in range(repeats):
            what()
        each.append((time.perf_counter() - start) / repeats * 1e3)
    return f"{np.mean(each):.3f} ± {np.std(each, ddof=1):.3f} ms"


with torch.inference_mode():
    out = net(image(motion)).numpy()[0]
    print("value", numbers["mean"] + numbers["deviation"] * out[:2], "deviation",
          numbers["deviation"] * numbers["widening"] * np.exp(0.5 * out[2:]))
    many = np.repeat(motion, 128, 0)
    one, batch = image(motion), image(many)
    print("torch", torch.__version__)
    print("one, from the image:    ", timed(lambda: net(one), 500))
    print("128, from the image:    ", timed(lambda: net(batch), 20))
    print("one, from the samples:  ", timed(lambda: net(image(motion)), 500))
    print("128, from the samples:  ", timed(lambda: net(image(many)), 20))
