"""Weights to safetensors, the file format that the library loads (docs/networks.md). `python -m dragmesh_training.export RUN OUT`."""
import json
import os
import struct
import subprocess
import sys

import numpy as np
import torch

from .files import write_whole

ARCHITECTURES = {"kpp": "dragmesh-kpp-net", "vae": "dragmesh-dq-vae"}


def write_safetensors(path, arrays, metadata):
    """Arrays in the order given, float16 or float32. The header is padded so that data starts 8-byte aligned."""
    header, offset = {"__metadata__": metadata}, 0
    for name, array in arrays.items():
        header[name] = {"dtype": {"float16": "F16", "float32": "F32"}[array.dtype.name], "shape": list(array.shape),
                        "data_offsets": [offset, offset + array.nbytes]}
        offset += array.nbytes
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 8)
    write_whole(path, struct.pack("<Q", len(text)) + text + b"".join(array.tobytes() for array in arrays.values()))


def save_safetensors(path, tensors, metadata):
    """float16 tensors in order of name: half the bytes, and outputs that differ by about 1e-3 of what training had."""
    write_safetensors(path, {name: tensors[name].detach().cpu().half().contiguous().numpy() for name in sorted(tensors)},
                      metadata)


def perceptron_tensors(name, net):
    """Tensors of a Sequential's Linear layers as the library loads them: NAME.0, NAME.2, ..., the odd places being ReLU's. A layer
    without a bias gets one of zeros."""
    layers, tensors = [layer for layer in net if isinstance(layer, torch.nn.Linear)], {}
    for index, layer in enumerate(layers):
        bias = layer.bias if layer.bias is not None else torch.zeros(layer.out_features)
        tensors[f"{name}.{2 * index}.weight"] = layer.weight.detach().numpy()
        tensors[f"{name}.{2 * index}.bias"] = bias.detach().numpy()
    return tensors


def write_joint_models(path, tensors, metadata):
    """Arrays of joint models, or of one of them: the matrices of the trees and of the limit networks, which are most of the file,
    as float16, everything else as float32."""
    halves = {name for name, array in tensors.items() if array.ndim == 2 and name.startswith(("trees.", "limits."))}
    write_safetensors(path, {name: np.ascontiguousarray(array, np.float16 if name in halves else np.float32)
                             for name, array in tensors.items()}, metadata)


def load_safetensors(path):
    """(tensors, metadata) of a file that write_safetensors wrote. The tensors are float32, in the order of the file."""
    with open(path, "rb") as file:
        size, = struct.unpack("<Q", file.read(8))
        header, data = json.loads(file.read(size)), bytearray(file.read())
    metadata = header.pop("__metadata__")
    tensors = {}
    for name, entry in header.items():
        begin, end = entry["data_offsets"]
        kind = {"F32": torch.float32, "F16": torch.float16}[entry["dtype"]]
        tensors[name] = torch.frombuffer(data[begin:end], dtype=kind).float().reshape(entry["shape"])
    return tensors, metadata


def commit():
    here = os.path.dirname(os.path.abspath(__file__))
    try:
        found = subprocess.run(["git", "-C", here, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True)
    except FileNotFoundError:  # no git on this machine
        return "unknown"
    return found.stdout.strip() or "unknown"


def export_run(folder, out):
    """The averaged weights of a run's checkpoint. Nothing of the machine or the time goes in: the same run, the same bytes."""
    state = torch.load(os.path.join(folder, "checkpoint.pt"), map_location="cpu")
    config = state["config"]
    trained = (f"{state['step']} steps of {config['batch']}, size {config['size']}, "
               "procedural objects (training/generator)")
    save_safetensors(out, state["average"],
                     {"architecture": ARCHITECTURES[config["network"]], "version": "1", "commit": commit(),
                      "seed": str(config["seed"]), "trained": trained})


if __name__ == "__main__":
    export_run(sys.argv[1], sys.argv[2])
