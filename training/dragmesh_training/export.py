"""Weights to safetensors, the file format the library loads (design §4). `python -m dragmesh_training.export RUN OUT`."""
import json
import os
import struct
import subprocess
import sys

import numpy as np
import torch

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
    with open(path + ".new", "wb") as file:
        file.write(struct.pack("<Q", len(text)) + text + b"".join(array.tobytes() for array in arrays.values()))
    os.replace(path + ".new", path)


def save_safetensors(path, tensors, metadata):
    """float16 tensors in order of name: half the bytes, and outputs that differ by about 1e-3 of what training had."""
    write_safetensors(path, {name: tensors[name].detach().cpu().half().contiguous().numpy() for name in sorted(tensors)},
                      metadata)


def write_ranker_tensors(path, tensors, metadata):
    """Arrays of the ranker's file: the matrices of the forest and of the limits' networks, which are most of it, as float16,
    everything else as float32."""
    halves = {name for name, array in tensors.items() if array.ndim == 2 and name.startswith(("forest.", "limits."))}
    write_safetensors(path, {name: np.ascontiguousarray(array, np.float16 if name in halves else np.float32)
                             for name, array in tensors.items()}, metadata)


def load_safetensors(path):
    """(tensors, metadata) of a file that save_safetensors wrote."""
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
