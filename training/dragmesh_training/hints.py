"""Fits the weights of asset hints: what names, the up direction and pivots say of candidate joints, counted on generated objects whose
parts have names and pivots as artists leave them. Writes sdk/kinematics/hints/hint_weights.def, which the library is built with.

  python3 -m dragmesh_training.hints make CASES.npz --seed 1 --count 6000     cases of the trained kinds
  python3 -m dragmesh_training.hints fit CASES.npz… -o hint_weights.def        the weights
  python3 -m dragmesh_training.hints refit CASES.npz… -o hint_weights.def      those of pivots and of sliding, from where they are
  python3 -m dragmesh_training.hints answer                                    the whole library on kinds nobody trained on
"""
import argparse
import ctypes
import os
import re

import numpy as np

from .files import save_arrays, write_whole
from .lab import LAB, PULLS, Options, category_weights, chosen_kinds, open_lab

ROOT = os.path.join(os.path.dirname(__file__), "..", "..")
MODELS = os.path.join(ROOT, "sdk", "models")
WEIGHTS = os.path.join(ROOT, "sdk", "kinematics", "hints", "hint_weights.def")
ROWS = 272  # candidates the prefilter keeps and those through the pivot
PIVOT_FEATURES = 8
SLIDES = 0b111  # the bits of kind features of which a slide has one
GOOD = 0.02  # pose error of a right candidate, object sizes
TINY = np.finfo(np.float32).tiny
# (name, dtype, shape of one case), in the order of dm_lab_hint_cases
ARRAYS = (("probability", np.float32, (ROWS,)), ("pose", np.float32, (ROWS,)), ("bits", np.uint32, (ROWS,)),
          ("pivot", np.float32, (ROWS, PIVOT_FEATURES)), ("used", np.int32, ()), ("kind", np.int32, ()), ("depth", np.int32, ()),
          ("place", np.int32, ()), ("has_drag", np.int32, ()), ("category", np.int32, ()))


class Shares(ctypes.Structure):
    """dm_lab_hint_options."""
    _fields_ = [(name, ctypes.c_float) for name in ("labels", "pivots", "lies", "wrong_up")]


class Cases(ctypes.Structure):
    """dm_lab_hint_cases."""
    _fields_ = [("rows", ctypes.c_uint32)] + [(name, ctypes.c_void_p) for name, _, _ in ARRAYS]


TRUST_ABOVE = 0.5  # factor of the weights of a kind that a name above the part's own tells; by hand
TYPE_SHARE = 0.5  # of the log odds of sliding that are counted, how much a name adds where there is no drag; chosen on later kinds
SMOOTHING = 4  # cases of the usual share of slides that each kind is given beside its own; by hand
SHARES = dict(labels=0.9, pivots=0.7, lies=0.04, wrong_up=0.08)  # by hand


def names_of(lab, which):
    lab.dm_lab_hint_name.restype = ctypes.c_char_p
    names = []
    while (name := lab.dm_lab_hint_name(which, len(names))) is not None:
        names.append(name.decode())
    return names


def make(lab, seed, count, split, chosen):
    weights = category_weights(lab, chosen)
    options = Options(seed, count, split, weights.ctypes.data, 0.5, 0.15, 0.0, 0.6, 10.0, 0, 0, PULLS["mixed"])
    data = {name: np.zeros((count, *shape), dtype) for name, dtype, shape in ARRAYS}
    batch = Cases(ROWS, *[data[name].ctypes.data for name, _, _ in ARRAYS])
    files = []
    for name in ("kpp_net", "ranker"):
        with open(os.path.join(MODELS, name + ".safetensors"), "rb") as file:
            files.append(file.read())
    result = lab.dm_lab_hint_batch(ctypes.byref(options), ctypes.byref(Shares(**SHARES)), files[0],
                                   ctypes.c_size_t(len(files[0])), files[1], ctypes.c_size_t(len(files[1])), ctypes.byref(batch))
    if result != 0:
        raise RuntimeError(f"dm_lab_hint_batch: {result}")
    return data


def run_make(arguments):
    lab = open_lab(arguments.lab)
    data = make(lab, arguments.seed, arguments.count, arguments.split, chosen_kinds(lab, arguments.only))
    save_arrays(arguments.out, compressed=True, **data)


def load(paths):
    """Cases of all files that have a right candidate, those without hints left out."""
    parts = [np.load(path) for path in paths]
    data = {name: np.concatenate([part[name] for part in parts]) for name, _, _ in ARRAYS}
    rows = np.arange(ROWS)[None] < data["used"][:, None]
    data["right"] = (data["pose"] < GOOD) & rows
    kept = data["right"].any(1) & ((data["kind"] > 0) | (data["place"] >= 0))
    return {name: array[kept] for name, array in data.items()}


def tensors_of(data, kinds):
    import torch
    rows = np.arange(ROWS)[None] < data["used"][:, None]
    log = np.where(rows, np.log(np.maximum(data["probability"], TINY)), -1e9).astype(np.float32)
    bits = (data["bits"][:, :, None] >> np.arange(kinds)) & 1
    return {"log": torch.from_numpy(log), "bits": torch.from_numpy(bits.astype(np.float32)),
            "pivot": torch.from_numpy(data["pivot"]), "right": torch.from_numpy(data["right"].astype(np.float32)),
            "kind": torch.from_numpy(data["kind"].astype(np.int64)), "far": torch.from_numpy((data["depth"] > 0).astype(np.int64)),
            "place": torch.from_numpy(data["place"].astype(np.int64)),
            "slides": torch.from_numpy(((data["bits"] & SLIDES) != 0).astype(np.float32)),
            "tells_type": torch.from_numpy(((data["has_drag"] == 0) & (data["depth"] == 0)).astype(np.float32))}


def scores(model, batch):
    """Log posteriors of the candidates, not normalised."""
    trust = model["trust"][batch["far"]][:, None]
    label = (batch["bits"] * model["kinds"][batch["kind"]][:, None]).sum(2) * (batch["kind"] > 0)[:, None]
    label = trust * label + batch["tells_type"][:, None] * batch["slides"] * model["slides"][batch["kind"]][:, None]
    place = batch["place"].clamp(min=0)
    pivot = (batch["pivot"] * model["places"][place][:, None]).sum(2) * (batch["place"] >= 0)[:, None]
    return batch["log"] + label + pivot


def slide_odds(data, kinds):
    """By kind: what its name on the part itself adds to the log odds of sliding. What the ranker makes of generated parts tells
    their types already, so that a fit on top of it would learn little; real parts of a kind are less like each other. So the
    odds are counted, and a share of them counts."""
    near = np.where(np.arange(ROWS)[None] < data["used"][:, None], data["pose"], np.inf).argmin(1)
    slides = data["bits"][np.arange(len(near)), near] & SLIDES != 0
    usual, odds = slides.mean(), np.zeros(kinds, np.float32)
    for kind in range(1, kinds):
        own = slides[(data["kind"] == kind) & (data["depth"] == 0)]
        odds[kind] = np.log((own.sum() + SMOOTHING * usual) / ((~own).sum() + SMOOTHING * (1 - usual))) - np.log(usual / (1 - usual))
    return TYPE_SHARE * odds


def read_weights(lab, path):
    """The weights of kinds and places that a file of weights has, as arrays; new features of places are 0."""
    found = {"KIND": np.zeros((len(names_of(lab, 0)), len(names_of(lab, 1))), np.float32),
             "PIVOT": np.zeros((len(names_of(lab, 2)), PIVOT_FEATURES), np.float32)}
    rows = {"KIND": names_of(lab, 0), "PIVOT": names_of(lab, 2)}
    with open(path) as file:
        for which, name, numbers in re.findall(r"(KIND|PIVOT)_WEIGHTS\((\w+), ([^)]*)\)", file.read()):
            values = [float(number.rstrip("f")) for number in numbers.split(", ")]
            found[which][rows[which].index(name), :len(values)] = values
    return found["KIND"], found["PIVOT"]


def refit(data, lab, arguments):
    """The weights of places, likeliest on cases without a drag with a normal prior around those that are there, which are of all
    cases; the odds of sliding, counted. The weights of kinds stay."""
    import torch
    kinds, places = read_weights(lab, arguments.weights)
    centre = torch.from_numpy(places)
    model = {"kinds": torch.from_numpy(kinds), "places": centre.clone().requires_grad_(True),
             "trust": torch.tensor([1, TRUST_ABOVE]), "slides": torch.zeros(len(kinds))}
    chosen = {name: array[(data["has_drag"] == 0) & (data["place"] >= 0)] for name, array in data.items()}
    count = len(chosen["used"])
    optimiser = torch.optim.Adam([model["places"]], lr=0.03)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimiser, arguments.steps)
    generator = np.random.default_rng(1)
    for step in range(arguments.steps):
        some = generator.integers(count, size=arguments.batch)
        batch = tensors_of({name: array[some] for name, array in chosen.items()}, kinds.shape[1])
        log = torch.log_softmax(scores(model, batch), 1)
        loss = -torch.logsumexp(torch.where(batch["right"] > 0, log, torch.full_like(log, -1e9)), 1).mean()
        optimiser.zero_grad()
        (loss + arguments.refit_prior * ((model["places"] - centre) ** 2).sum() / count).backward()
        optimiser.step()
        schedule.step()
    model["slides"] = torch.from_numpy(slide_odds(data, len(kinds)))
    return {name: tensor.detach() for name, tensor in model.items()}


def evenness(categories):
    """Weights of cases, 1 in the mean: a category with many counts less for each, so that kinds are learnt across categories."""
    _, index, counts = np.unique(categories, return_inverse=True, return_counts=True)
    weight = 1 / np.sqrt(counts[index])
    return (weight / weight.mean()).astype(np.float32)


def fit(data, lab, arguments):
    """Conditional logit: the likeliest weights, with a normal prior on them."""
    import torch
    counts = len(names_of(lab, 0)), len(names_of(lab, 1)), len(names_of(lab, 2))
    model = {"kinds": torch.zeros(counts[0], counts[1], requires_grad=True),
             "places": torch.zeros(counts[2], PIVOT_FEATURES, requires_grad=True), "trust": torch.tensor([1, TRUST_ABOVE]),
             "slides": torch.from_numpy(slide_odds(data, counts[0]))}
    optimiser = torch.optim.Adam([model["kinds"], model["places"]], lr=0.05)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimiser, arguments.steps)
    generator = np.random.default_rng(1)
    count = len(data["used"])
    even = evenness(data["category"])
    for step in range(arguments.steps):
        chosen = generator.integers(count, size=arguments.batch)
        batch = tensors_of({name: array[chosen] for name, array in data.items()}, counts[1])
        log = torch.log_softmax(scores(model, batch), 1)
        loss = -torch.logsumexp(torch.where(batch["right"] > 0, log, torch.full_like(log, -1e9)), 1)
        loss = (loss * torch.from_numpy(even[chosen])).mean()
        prior = arguments.kind_prior * (model["kinds"] ** 2).sum() + arguments.pivot_prior * (model["places"] ** 2).sum()
        optimiser.zero_grad()
        (loss + prior / count).backward()
        optimiser.step()
        schedule.step()
        with torch.no_grad():
            model["kinds"][0] = 0
        if step % 100 == 99:
            print(f"step {step + 1}: loss {loss.item():.4f}", flush=True)
    return {name: tensor.detach() for name, tensor in model.items()}


def report(model, data, lab, title):
    """Share of right answers before and after, by the sum of probability near enough: the candidate with the most."""
    batch = tensors_of(data, len(names_of(lab, 1)))
    before, after = batch["log"].argmax(1).numpy(), scores(model, batch).argmax(1).numpy()
    index = np.arange(len(before))
    right = data["right"][index, before], data["right"][index, after]
    for name, mask in (("all", index >= 0), ("drag", data["has_drag"] != 0), ("no drag", data["has_drag"] == 0),
                       ("label alone", data["place"] < 0), ("pivot alone", data["kind"] == 0),
                       ("both", (data["kind"] > 0) & (data["place"] >= 0))):
        print(f"{title} {name:12}: {mask.sum():6} cases, right {right[0][mask].mean():.3f} -> {right[1][mask].mean():.3f}")
    for place, name in enumerate(names_of(lab, 2)):
        mask = data["place"] == place
        if mask.any():
            print(f"  {name:9} {mask.sum():6} {right[0][mask].mean():.3f} -> {right[1][mask].mean():.3f}  "
                  + " ".join(f"{w:6.2f}" for w in model["places"][place].numpy()))


def write(model, lab, path):
    def numbers(values):
        return ", ".join(f"{value:.3f}f" for value in values)
    lines = ["/* Weights of asset hints, by kind of part and by place of the pivot. Written by dragmesh_training/hints.py: not to be",
             " * edited. Defines what its reader has not defined as nothing, and undefines it all. */", "/* clang-format off */"]
    tables = ("KIND_WEIGHTS", "KIND_SLIDES", "PIVOT_WEIGHTS", "LABEL_TRUST")
    for table in tables:
        lines += [f"#ifndef {table}", f"#define {table}(...)", "#endif"]
    lines += ["", f"LABEL_TRUST({numbers(model['trust'].numpy())})"]
    lines += [f"PIVOT_WEIGHTS({name}, {numbers(row)})" for name, row in zip(names_of(lab, 2), model["places"].numpy())]
    lines += [f"KIND_SLIDES({name}, {value:.3f}f)" for name, value in zip(names_of(lab, 0), model["slides"].numpy())]
    lines += [f"KIND_WEIGHTS({name}, {numbers(row)})" for name, row in zip(names_of(lab, 0), model["kinds"].numpy())]
    lines += [""] + [f"#undef {table}" for table in tables]
    write_whole(path, ("\n".join(lines) + "\n").encode())


def run_fit(arguments):
    lab = open_lab(arguments.lab)
    data = load(arguments.data)
    model = arguments.fit(data, lab, arguments)
    some = {name: array[:4000] for name, array in data.items()}
    report(model, some, lab, "fitted on")
    if arguments.test:
        report(model, load([arguments.test]), lab, "test")
    write(model, lab, arguments.out)


def run_answer(arguments):
    """What the whole library answers on the same cases without hints, with names, pivots and both, and with lies among them."""
    from .ranker import ANSWER_ARRAYS
    lab = open_lab(arguments.lab)
    weights = category_weights(lab, chosen_kinds(lab, arguments.only))
    files = [open(os.path.join(MODELS, name + ".safetensors"), "rb").read() for name in ("kpp_net", "ranker")]
    rows = (("none", {}), ("names", dict(labels=1)), ("pivots", dict(pivots=1)), ("both", dict(labels=1, pivots=1)),
            ("a tenth lies", dict(labels=1, pivots=1, lies=0.1)), ("wrong up", dict(labels=1, wrong_up=1)))
    for title, shares in rows:
        options = Options(arguments.seed, arguments.count, 1, weights.ctypes.data, 0.5, 0.3, 0.0, 0.7, 8.0, 0, 0, PULLS["mixed"])
        found = {name: np.zeros(arguments.count, dtype) for name, dtype in ANSWER_ARRAYS}
        pointers = (ctypes.c_void_p * len(found))(*[array.ctypes.data for array in found.values()])
        result = lab.dm_lab_answer_hinted(ctypes.byref(options), ctypes.byref(Shares(**shares)), files[0],
                                          ctypes.c_size_t(len(files[0])), files[1], ctypes.c_size_t(len(files[1])), pointers)
        if result != 0:
            raise RuntimeError(f"dm_lab_answer_hinted: {result}")
        text = []
        for name, mask in (("drag", found["has_drag"] != 0), ("no drag", found["has_drag"] == 0)):
            good = found["pose"][mask] < GOOD
            text.append(f"{name} pose<2% {good.mean():.3f} type {found['right_type'][mask].mean():.3f} stated "
                        f"{found['confidence'][mask].mean():.3f}")
        print(f"{arguments.only} kinds, {title:12}: {', '.join(text)}", flush=True)


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lab", default=LAB)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("make")
    one.add_argument("out")
    one.add_argument("--seed", type=int, default=1)
    one.add_argument("--count", type=int, default=6000)
    one.add_argument("--split", type=int, default=0)
    one.add_argument("--only", default="trained")
    one.set_defaults(run=run_make)
    two = commands.add_parser("fit")
    two.add_argument("data", nargs="+")
    two.add_argument("--test", help="cases that are only looked at")
    two.add_argument("--steps", type=int, default=1200)
    two.add_argument("--batch", type=int, default=512)
    two.add_argument("--kind-prior", type=float, default=2.0)
    two.add_argument("--pivot-prior", type=float, default=0.5)
    two.add_argument("-o", "--out", default=WEIGHTS)
    two.set_defaults(run=run_fit, fit=fit)
    again = commands.add_parser("refit")
    again.add_argument("data", nargs="+")
    again.add_argument("--test", help="cases that are only looked at")
    again.add_argument("--weights", default=WEIGHTS, help="the weights that are there")
    again.add_argument("--steps", type=int, default=500)
    again.add_argument("--batch", type=int, default=512)
    again.add_argument("--refit-prior", type=float, default=1.0)
    again.add_argument("-o", "--out", default=WEIGHTS)
    again.set_defaults(run=run_fit, fit=refit)
    three = commands.add_parser("answer", help="what the whole library answers with and without hints")
    three.add_argument("--only", default="test_only")
    three.add_argument("--count", type=int, default=2000)
    three.add_argument("--seed", type=int, default=91)
    three.set_defaults(run=run_answer)
    arguments = parser.parse_args(words)
    arguments.run(arguments)


if __name__ == "__main__":
    main()
