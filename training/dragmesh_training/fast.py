"""KPP-Net's training several times as fast, on processors with tiles of bf16: the encoders by training/lab/encoder.h, the
descent by training/lab/adam.h, batches made ahead by a thread. The same run as train.Run's but for how sums are rounded."""
import ctypes
import os
import queue
import threading
from dataclasses import replace

import torch

from . import train
from .data import Lab  # noqa: F401  (finds the bindings)
from .networks import KPP_GLOBAL_GROUPS, KPP_LOCAL_GROUPS, KPP_SIZES
from dragmesh.library import find_library

LINE = 16  # floats in a cache line: where a tensor begins
AHEAD = 4  # batches
M_TRIM_THRESHOLD, M_TOP_PAD, M_MMAP_THRESHOLD = -1, -2, -3  # of malloc.h


class _AdamState(ctypes.Structure):
    _fields_ = [("count", ctypes.c_size_t),
                *((name, ctypes.c_void_p) for name in ("weights", "mean", "square", "average", "gradient"))]


class _AdamStep(ctypes.Structure):
    _fields_ = [("number", ctypes.c_uint32), *((name, ctypes.c_float) for name in ("rate", "decay", "share", "most"))]


def open_lab():
    lab = ctypes.CDLL(os.environ.get("DRAGMESH_LAB") or find_library("libdragmesh_lab.so"))
    lab.dm_lab_encoder_make.restype = ctypes.c_void_p
    return lab


def fits(config):
    """Whether this machine and this library can train that way, and the network is one that they know."""
    return (config.network == "kpp" and not torch.cuda.is_available() and open_lab().dm_lab_encoder_available() != 0 and
            train.make_network(config).config == KPP_SIZES["game"])


def keep_memory():
    """Freed memory stays with the process: every step asks for the same again, and new pages are a tenth of its time."""
    libc = ctypes.CDLL(None)
    for option, value in ((M_MMAP_THRESHOLD, 1 << 30), (M_TRIM_THRESHOLD, 1 << 30), (M_TOP_PAD, 1 << 26)):
        libc.mallopt(option, value)


def address(tensor):
    return ctypes.c_void_p(tensor.data_ptr())


class _Tokens(torch.autograd.Function):
    """Encoder.tokens: gradients of the weights go straight to where the encoder is bound to, only the positions' is returned."""

    @staticmethod
    def forward(context, points, positions, encoder):
        context.encoder = encoder
        return encoder.forward(points.contiguous(), positions.contiguous())

    @staticmethod
    def backward(context, gradient):
        return None, context.encoder.backward(gradient.contiguous()), None


class Encoder:
    """What stands in for the layers of a networks.PointEncoder, whose parameters have gradients that stay where they are."""

    def __init__(self, lab, module, tokens, batch):
        self.lab = lab
        self.handle = ctypes.c_void_p(lab.dm_lab_encoder_make(tokens, len(module.layers), batch))
        if not self.handle:
            raise MemoryError("dm_lab_encoder_make")
        self.parameters = [*module.point.parameters()]
        for layer in module.layers:
            for part in (layer.norm1, layer.attn.qkv, layer.attn.out, layer.norm2, layer.ff1, layer.ff2):
                self.parameters += [part.weight, part.bias]

    def bind(self):
        """To the weights of now."""
        pointers = ctypes.c_void_p * len(self.parameters)
        self.lab.dm_lab_encoder_bind(self.handle, pointers(*(p.data_ptr() for p in self.parameters)),
                                     pointers(*(p.grad.data_ptr() for p in self.parameters)))

    def tokens(self, points, positions):
        self.bind()
        return _Tokens.apply(points, positions, self)

    def forward(self, points, positions):
        out = torch.empty_like(positions)
        self.lab.dm_lab_encoder_forward(self.handle, len(points), address(points), address(positions), address(out))
        return out

    def backward(self, gradient):
        out = torch.empty_like(gradient)
        self.lab.dm_lab_encoder_backward(self.handle, len(gradient), address(gradient), address(out))
        return out

    def close(self):
        self.lab.dm_lab_encoder_free(self.handle)
        self.handle = None


class Flat:
    """A network's numbers, and others of their shapes, in one piece of memory each."""

    def __init__(self, parameters):
        self.shapes = [p.shape for p in parameters]
        self.begins, self.count = [], 0
        for p in parameters:
            self.begins.append(self.count)
            self.count += (p.numel() + LINE - 1) // LINE * LINE

    def zeros(self):
        memory = torch.zeros(self.count + LINE)
        begin = -memory.data_ptr() % (4 * LINE) // 4
        return memory[begin:begin + self.count]

    def views(self, memory):
        return [memory[begin:begin + shape.numel()].view(shape) for begin, shape in zip(self.begins, self.shapes)]

    def moved(self, parameters):
        """The parameters' numbers, which from now on live there."""
        memory = self.zeros()
        for parameter, view in zip(parameters, self.views(memory)):
            view.copy_(parameter.data)
            parameter.data = view
        return memory


class FastRun(train.Run):
    def __init__(self, config, folder, device, workers, start=None):
        keep_memory()
        super().__init__(config, folder, device, workers, start)
        self.lab = open_lab()
        parameters = list(self.model.parameters())
        flat = Flat(parameters)
        self.weights, self.averages = flat.moved(parameters), flat.moved(list(self.average.parameters()))
        self.gradient, self.mean, self.square = flat.zeros(), flat.zeros(), flat.zeros()
        for parameter, gradient, mean, square in zip(parameters, *map(flat.views, (self.gradient, self.mean, self.square))):
            parameter.grad = gradient
            before = self.optimizer.state.get(parameter)
            if before:  # of a run that goes on
                mean.copy_(before["exp_avg"])
                square.copy_(before["exp_avg_sq"])
            self.optimizer.state[parameter] = {"step": torch.tensor(0.0), "exp_avg": mean, "exp_avg_sq": square}
        self.encoders = []
        for module, tokens in ((self.model._modules["global"], KPP_GLOBAL_GROUPS), (self.model.local, KPP_LOCAL_GROUPS)):
            self.encoders.append(Encoder(self.lab, module, tokens, config.batch))
            module.tokens = self.encoders[-1].tokens
        self.made, self.ending = queue.Queue(AHEAD), False
        self.thread = threading.Thread(target=self.make_ahead, args=(self.step,), daemon=True)
        self.thread.start()

    def make_ahead(self, step):
        # The candidate-scoring head joins some time: all batches have what it is trained on.
        config = replace(self.config, weights={**self.config.weights, "choice": 1.0})
        try:
            while not self.ending:
                with torch.no_grad():
                    self.made.put(self.drawn(config, step))
                step += 1
        except Exception as error:  # goes on where the batch is missed
            self.made.put(error)

    def next_batch(self, config):
        batch = self.made.get()
        if isinstance(batch, Exception):
            raise batch
        return batch

    def descend(self, loss, rate):
        self.gradient.zero_()
        loss.backward()
        memory = (self.weights, self.mean, self.square, self.averages, self.gradient)
        state = _AdamState(len(self.weights), *(tensor.data_ptr() for tensor in memory))
        step = _AdamStep(self.step + 1, rate, self.config.decay, self.averaged, train.LONGEST)
        self.lab.dm_lab_adam(ctypes.byref(state), ctypes.byref(step))

    def save(self):
        for state in self.optimizer.state.values():
            state["step"].fill_(self.step)
        super().save()

    def close(self):
        self.ending = True
        while self.thread.is_alive():
            try:
                self.made.get(timeout=0.05)
            except queue.Empty:
                pass
        super().close()
        for encoder in self.encoders:
            encoder.close()
