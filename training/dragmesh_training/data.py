"""Training data without end: worker processes make chunks with libdragmesh_lab, a pool in memory mixes them.

The k-th chunk of a stream depends on the seed and k alone, and chunks enter the pool in order, one at fixed steps: a run
is the same however fast the workers are.
"""
import multiprocessing

import numpy as np
import torch

from . import config
from .lab import VAE_FEATURES, Lab
from .loaders.batches import Loaded
from .losses import PRISMATIC, SCREW
from .networks import KPP_CHANNELS, KPP_DIRECTIONS

CHUNK = 256


def trained_categories(lab):
    return config.kinds_of(lab.kinds, "trained")


def make_batch(lab, network, seed, count, categories, split, mix=None):
    """Arrays of `count` generated cases."""
    make = lab.kpp_batch if network == "kpp" else lab.vae_batch
    return packed(network, make(seed, count, categories, split, **(mix or config.MIX)))


def packed(network, arrays):
    """KPP inputs as float16, which halves the pool."""
    if network == "kpp":
        for name in ("global_points", "global_centres", "local_points", "local_centres"):
            arrays[name] = arrays[name].astype(np.float16)
    return arrays


def to_tensors(arrays, device):
    """What the networks and losses read, from arrays of the lab."""
    batch = {}
    for name, array in arrays.items():
        tensor = torch.from_numpy(array).to(device)
        batch[name] = tensor.float() if tensor.is_floating_point() else tensor.long()
    if "features" in batch:
        parts = torch.split(batch.pop("features"), [size for _, size in VAE_FEATURES], dim=1)
        batch.update({name: part for (name, _), part in zip(VAE_FEATURES, parts)})
        batch["path"] = batch["path"].view(-1, 16, 5)
    return batch


def mirrored(batch):
    """A KPP batch with the second and the third axis of each case's frame turned round at random: half of the cases become
    their mirror images (a turn's axis is a pseudovector), but never a screw, whose thread has a hand."""
    count, device = len(batch["type"]), batch["axis"].device
    flips = torch.randint(0, 2, (count, 2), device=device) * 2.0 - 1
    flips[:, 1] = torch.where(batch["type"] == SCREW, flips[:, 0], flips[:, 1])
    mirror = torch.cat([torch.ones_like(flips[:, :1]), flips], dim=1)
    hand = torch.where(batch["type"] == PRISMATIC, torch.ones_like(flips[:, 0]), flips.prod(dim=1))
    channels = mirror.new_ones(count, KPP_CHANNELS)
    for first in (0, 4, 7, 10, 13):
        channels[:, first:first + 3] = mirror
    result = dict(batch)
    for name in ("global_points", "local_points"):
        result[name] = batch[name] * channels[:, None, None]
    for name in ("global_centres", "local_centres"):
        result[name] = batch[name] * mirror[:, None]
    result["axis"] = batch["axis"] * mirror * hand.unsqueeze(-1)
    result["origin"] = batch["origin"] * mirror
    lines = batch["shape"][:, :3 * KPP_DIRECTIONS].view(count, KPP_DIRECTIONS, 3) * mirror[:, None]
    largest = lines.gather(2, lines.abs().argmax(dim=2, keepdim=True))
    lines = lines * torch.where(largest < 0, -1.0, 1.0)
    ones = torch.ones_like(mirror)
    # The boxes' centres and half sides, the drag's point and vector, four numbers without a direction, contact.
    rest = torch.cat([mirror, ones, mirror, ones, mirror, mirror, ones, ones[:, :1], mirror, ones, ones[:, :1]], dim=1)
    result["shape"] = torch.cat([lines.flatten(1), batch["shape"][:, 3 * KPP_DIRECTIONS:] * rest], dim=1)
    return result


def mixed_batch(lab, network, seed, categories, loaded, share):
    """A chunk for training: generated cases, a share of them replaced by cases of loaded objects."""
    mix = config.TRAINING_MIX[network]
    arrays = make_batch(lab, network, seed, CHUNK, categories, "train", mix)
    count = round(share * CHUNK) if loaded else 0
    if count:
        theirs = packed(network, loaded.batch(lab, network, seed, count, mix))
        for name, array in arrays.items():
            array[:count] = theirs[name]
    return arrays


def _work(network, seed, first, stride, categories, folder, share, connection):
    lab, loaded = Lab(), Loaded(folder) if folder else None
    index = first
    try:
        while True:
            connection.send(mixed_batch(lab, network, seed * 1000003 + index, categories, loaded, share))
            index += stride
    except (BrokenPipeError, KeyboardInterrupt):
        pass


class Stream:
    """Chunks of the training split, in order, from worker processes that run ahead by one chunk each."""

    def __init__(self, network, seed, first, workers, folder="", share=0.0):
        context = multiprocessing.get_context("spawn")
        categories = trained_categories(Lab())
        self.connections, self.processes, self.next = [], [], 0
        for worker in range(workers):
            ours, theirs = context.Pipe(duplex=False)
            process = context.Process(target=_work, daemon=True,
                                      args=(network, seed, first + worker, workers, categories, folder, share, theirs))
            process.start()
            theirs.close()
            self.connections.append(ours)
            self.processes.append(process)

    def chunk(self):
        arrays = self.connections[self.next].recv()
        self.next = (self.next + 1) % len(self.connections)
        return arrays

    def close(self):
        for connection in self.connections:
            connection.close()
        for process in self.processes:
            process.join()


class Pool:
    """The newest `capacity` samples; batches are drawn from all of it, so each sample is seen a few times."""

    def __init__(self, stream, capacity, seed):
        self.stream, self.capacity = stream, capacity // CHUNK * CHUNK
        self.arrays, self.filled, self.position = None, 0, 0
        self.random = np.random.default_rng(seed)

    def add_chunk(self):
        chunk = self.stream.chunk()
        if self.arrays is None:
            self.arrays = {name: np.zeros((self.capacity, *a.shape[1:]), a.dtype) for name, a in chunk.items()}
        for name, array in chunk.items():
            self.arrays[name][self.position:self.position + CHUNK] = array
        self.position = (self.position + CHUNK) % self.capacity
        self.filled = min(self.filled + CHUNK, self.capacity)

    def batch(self, count):
        index = self.random.integers(0, self.filled, count)
        return {name: array[index] for name, array in self.arrays.items()}
