#!/usr/bin/python3
"""The fast way of training KPP-Net (training/dragmesh_training/fast.py) against PyTorch: its gradients up to what bf16 rounds,
its descent up to float's rounding."""
import copy
import os
import sys
import types
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "training"))
import torch  # noqa: E402

from dragmesh_training import config, data, fast, train  # noqa: E402
from dragmesh_training.losses import weighted  # noqa: E402

CASES = 30  # not a multiple of what the encoders work on at a time
SETTINGS = config.KppTraining()


def make_batch():
    lab = data.Lab()
    arrays = data.make_batch(lab, "kpp", 5, CASES, data.trained_categories(lab), "train")
    return train.prepared(SETTINGS, data.to_tensors(arrays, "cpu"))


def gradients(model, batch):
    """Of everything the run descends on, in a model whose gradients are there."""
    for parameter in model.parameters():
        parameter.grad.zero_()
    loss = weighted(train.batch_losses(SETTINGS, model, batch), SETTINGS.weights)
    loss.backward()
    return float(loss), [parameter.grad.clone() for parameter in model.parameters()]


@unittest.skipUnless(fast.fits(SETTINGS), "this processor trains by PyTorch alone")
class Fast(unittest.TestCase):
    def test_gradients(self):
        torch.manual_seed(2)
        model, batch = train.make_network(SETTINGS), make_batch()
        for parameter in model.parameters():
            parameter.grad = torch.zeros_like(parameter)
        loss, exact = gradients(model, batch)
        for module, tokens in ((model._modules["global"], 48), (model.local, 24)):
            module.tokens = fast.Encoder(fast.open_lab(), module, tokens, CASES).tokens
        again, found = gradients(model, batch)
        self.assertLess(abs(again - loss), 0.003 * loss)
        for (name, _), a, b in zip(model.named_parameters(), exact, found):
            error = float((a - b).norm() / a.norm().clamp(min=1e-6))
            self.assertLess(error, 0.2, name)  # .16 is the most: small gradients of the candidate-scoring head
        whole = [torch.cat([g.flatten() for g in part]) for part in (exact, found)]
        cosine = float(torch.cosine_similarity(*whole, dim=0))
        self.assertGreater(cosine, 0.998)

    def test_descent(self):
        torch.manual_seed(3)
        exact = torch.nn.Sequential(torch.nn.Linear(7, 30), torch.nn.Linear(30, 2))
        average, own, own_average = (copy.deepcopy(exact) for _ in range(3))
        plain = types.SimpleNamespace(model=exact, average=average, averaged=0.3,
                                      optimizer=torch.optim.AdamW(exact.parameters(), lr=1, weight_decay=0.1))
        quick = types.SimpleNamespace(lab=fast.open_lab(), averaged=0.3, config=types.SimpleNamespace(decay=0.1), step=0)
        parameters = list(own.parameters())
        flat = fast.Flat(parameters)
        quick.weights, quick.averages = flat.moved(parameters), flat.moved(list(own_average.parameters()))
        quick.gradient, quick.mean, quick.square = flat.zeros(), flat.zeros(), flat.zeros()
        for parameter, gradient in zip(parameters, flat.views(quick.gradient)):
            parameter.grad = gradient
        inputs = torch.randn(50, 7)
        for step in range(20):
            for run, descend, network in ((plain, train.Run.descend, exact), (quick, fast.FastRun.descend, own)):
                descend(run, (4 * network(inputs) - inputs[:, :2]).pow(2).mean(), 0.01)
            quick.step += 1
        for name, a, b in (("weights", exact, own), ("average", average, own_average)):
            error = max(float((p - q).abs().max()) for p, q in zip(a.parameters(), b.parameters()))
            self.assertLess(error, 1e-5, name)


if __name__ == "__main__":
    unittest.main()
