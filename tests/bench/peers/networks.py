#!/usr/bin/env python3
"""The networks in PyTorch on one thread: ours, and ones of the reference implementation's size. One JSON object a line."""
import json
import math
import sys
import time
from pathlib import Path

START = time.process_time()
import torch  # noqa: E402
from torch import nn  # noqa: E402

IMPORTED = time.process_time()
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "training"))
from dragmesh_training.networks import KPP_CHANNELS, KPP_SHAPE, VAE_SIZES, DqVae, KppNet  # noqa: E402

REFERENCE_POINTS = 4096


class ReferenceKpp(nn.Module):
    """The reference's KPP-Net by size: Transformers with full attention over 4096 points (10 numbers each) and over the part's half
    of them, 512 wide; 19 M parameters, some 240 GFLOP."""

    def __init__(self, dim=512):
        super().__init__()
        layer = lambda: nn.TransformerEncoderLayer(dim, 8, 4 * dim, dropout=0.0, batch_first=True)  # noqa: E731
        self.embed = nn.ModuleList([nn.Linear(10, dim), nn.Linear(10, dim)])
        self.streams = nn.ModuleList([nn.TransformerEncoder(layer(), 3), nn.TransformerEncoder(layer(), 3)])
        self.heads = nn.ModuleList([nn.Sequential(nn.Linear(2 * dim, dim), nn.ReLU(), nn.Linear(dim, 3)) for _ in range(2)])

    def forward(self, points):
        streams = [stream(embed(x)).amax(dim=1) for embed, stream, x in
                   zip(self.embed, self.streams, [points, points[:, :REFERENCE_POINTS // 2]])]
        known = torch.cat(streams, dim=-1)
        return [head(known) for head in self.heads]


def kpp_inputs():
    return (torch.randn(1, 48, 16, KPP_CHANNELS), torch.randn(1, 48, 3), torch.randn(1, 24, 16, KPP_CHANNELS),
            torch.randn(1, 24, 3), torch.randn(1, KPP_SHAPE))


def vae_batch(points):
    return {"type": torch.zeros(1, dtype=torch.int64), "axis": torch.randn(1, 3), "origin": torch.randn(1, 3),
            "joint_scalars": torch.randn(1, 3), "rotation_direction": torch.randn(1, 3),
            "mean_velocity": torch.randn(1, 3), "chords": torch.randn(1, 9), "amplitude": torch.randn(1, 2),
            "path": torch.randn(1, 16, 5), "xyz": torch.randn(1, points, 3), "mask": torch.ones(1, points),
            "near_origin": torch.arange(32).view(1, 32), "near_drag": torch.arange(32).view(1, 32)}


def show(what, module, call, rounds):
    """Median over rounds of the processor time of this process: others on the machine cost little of the truth."""
    taken = []
    with torch.no_grad():
        for _ in range(max(1, rounds // 10)):
            call()
        for _ in range(rounds):
            start = time.process_time()
            call()
            taken.append(time.process_time() - start)
    taken.sort()
    print(json.dumps({"who": "pytorch", "what": what, "median_ns": 1e9 * taken[len(taken) // 2], "least_ns": 1e9 * taken[0],
                      "parameters": sum(math.prod(p.shape) for p in module.parameters())}), flush=True)


def seconds(call):
    start = time.process_time()
    with torch.no_grad():
        call()
    return time.process_time() - start


def show_first(what, first, again):
    print(json.dumps({"who": "pytorch", "first": what, "first_ns": 1e9 * first, "again_ns": 1e9 * again}), flush=True)


def main():
    torch.set_num_threads(1)
    torch.manual_seed(1)
    vae, kpp = DqVae().eval(), KppNet().eval()
    batch, inputs = vae_batch(512), kpp_inputs()
    show_first("import it", IMPORTED - START, 0)
    show_first("compute KPP-Net", *[seconds(lambda: kpp(*inputs)) for _ in range(2)])
    show("motion, same network", vae, lambda: vae(batch), 200)
    show("kinematics, same network alone", kpp, lambda: kpp(*inputs), 200)
    large, batch = DqVae(VAE_SIZES["paper"]).eval(), vae_batch(REFERENCE_POINTS)
    show("motion, reference size", large, lambda: large(batch), 10)
    reference, points = ReferenceKpp().eval(), torch.randn(1, REFERENCE_POINTS, 10)
    show("kinematics, reference size", reference, lambda: reference(points), 2)


if __name__ == "__main__":
    main()
