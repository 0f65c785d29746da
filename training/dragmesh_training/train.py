"""The training loop of both networks: seeded, resumable, with a progress line and a CSV log. See ../train."""
import csv
import math
import os
import sys
import time
from dataclasses import asdict, replace

import torch

from . import evaluate, export
from .choice import choice_loss, question
from .data import CHUNK, Pool, Stream, mirrored, to_tensors
from .files import whole_file
from .losses import kpp_losses, vae_losses, weighted
from .networks import KPP_SIZES, VAE_SIZES, DqVae, KppNet

FIRST_CHUNKS = 8  # in the pool before the first step
WARM_UP = 200  # steps
LONGEST = 1.0  # gradient that is taken as it is
AVERAGE = 0.999  # of the weights that are scored and exported
EVALUATE_EVERY = 1000
SAVE_EVERY = 250
REPORT_EVERY = 50


def make_network(config):
    sizes, network = (KPP_SIZES, KppNet) if config.network == "kpp" else (VAE_SIZES, DqVae)
    return network(replace(sizes[config.size], **{part: bool(there) for part, there in config.parts.items()}))


def run_network(network, model, batch, sample):
    """The network's raw outputs for a batch of tensors."""
    if network == "kpp":
        return model(batch["global_points"], batch["global_centres"], batch["local_points"], batch["local_centres"],
                     batch["shape"])
    return model(batch, sample)


def prepared(config, batch):
    """A batch as the losses take it: KPP-Net's in one of four mirror images, with what its candidate-scoring head is trained on."""
    if config.network != "kpp":
        return batch
    batch = mirrored(batch)
    return {**batch, "question": question(batch)} if config.weights["choice"] > 0 else batch


def batch_losses(config, model, batch):
    """Of a prepared batch."""
    output = run_network(config.network, model, batch, sample=True)
    if config.network == "kpp":
        losses = kpp_losses(output, batch)
        chosen = config.weights["choice"] > 0
        losses["choice"] = choice_loss(model, output["known"], batch["question"]) if chosen else torch.zeros(())
        return losses
    return vae_losses(*output, batch, config.free_nats)


def rate_at(config, step, done):
    """A cosine down to a hundredth, and again from a little lower at each restart; every one warms up. done: share of the run."""
    begins = [0.0, *(share for share in config.restarts if share <= done)]
    begun, ends = begins[-1], min([1.0, *(share for share in config.restarts if share > done)])
    peak = config.rate / (1 + 0.25 * (len(begins) - 1))
    warm = min(1.0, (step + 1) / WARM_UP, 0.01 + (done - begun) / 0.002 if begun else 1.0)
    return peak * warm * (0.01 + 0.99 * 0.5 * (1 + math.cos(math.pi * (done - begun) / (ends - begun))))


def weights_at(config, done):
    """The candidate-scoring head is trained once the encoders are."""
    if config.network == "kpp" and done < config.choice_from:
        return {**config.weights, "choice": 0.0}
    return config.weights


def begin_from(model, path):
    """Exported weights as a start; what they lack keeps its own start, what they have too much is an error."""
    tensors, _ = export.load_safetensors(path)
    lacking, unknown = model.load_state_dict(tensors, strict=False)
    if unknown:
        raise SystemExit(f"training: {path} has {', '.join(unknown)}, which the network has not")
    if lacking:
        print(f"training: {path} lacks {', '.join(lacking)}", flush=True)


class Run:
    """A training run in its folder: checkpoint.pt, log.csv."""

    def __init__(self, config, folder, device, workers, start=None):
        self.config, self.folder, self.device = config, folder, device
        torch.manual_seed(config.seed)
        self.model = make_network(config).to(device)
        self.average = make_network(config).to(device)
        if start:
            begin_from(self.model, start)
        self.average.load_state_dict(self.model.state_dict())
        self.optimizer = torch.optim.AdamW(self.model.parameters(), lr=config.rate, weight_decay=config.decay)
        self.step, self.chunks, self.seconds = 0, 0, 0.0
        self.resume()
        self.begun = time.monotonic() - self.seconds
        self.chunks = max(0, self.chunks - FIRST_CHUNKS)
        self.stream = Stream(config.network, config.seed, self.chunks, workers, config.data, config.data_share)
        self.pool = Pool(self.stream, config.pool, config.seed + self.step)
        for _ in range(min(FIRST_CHUNKS, config.pool // CHUNK)):
            self.pool.add_chunk()
            self.chunks += 1

    @property
    def checkpoint(self):
        return os.path.join(self.folder, "checkpoint.pt")

    @property
    def done(self):
        """Share of the run, by steps or, where the config limits it, by time."""
        by_time = (time.monotonic() - self.begun) / (60 * self.config.minutes) if self.config.minutes else 0.0
        return min(1.0, max(self.step / self.config.steps, by_time))

    def resume(self):
        os.makedirs(self.folder, exist_ok=True)
        if not os.path.exists(self.checkpoint):
            return
        state = torch.load(self.checkpoint, map_location=self.device)
        for name in ("model", "average", "optimizer"):
            getattr(self, name).load_state_dict(state[name])
        self.step, self.chunks, self.seconds = state["step"], state["chunks"], state["seconds"]
        torch.set_rng_state(state["random"])

    def save(self):
        self.seconds = time.monotonic() - self.begun
        state = {name: getattr(self, name).state_dict() for name in ("model", "average", "optimizer")}
        state.update(step=self.step, chunks=self.chunks, seconds=self.seconds, random=torch.get_rng_state(),
                     config=asdict(self.config))
        with whole_file(self.checkpoint) as file:
            torch.save(state, file)

    def drawn(self, config, step):
        """The batch of a step, which are to be asked for in order."""
        if step * config.fresh // CHUNK != (step + 1) * config.fresh // CHUNK:
            self.pool.add_chunk()
            self.chunks += 1
        return prepared(config, to_tensors(self.pool.batch(config.batch), self.device))

    def next_batch(self, config):
        return self.drawn(config, self.step)

    @property
    def averaged(self):
        """Share of this step's weights in their average."""
        return 1 - min(AVERAGE, (self.step + 1) / (self.step + 10))

    def descend(self, loss, rate):
        for group in self.optimizer.param_groups:
            group["lr"] = rate
        self.optimizer.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.model.parameters(), LONGEST)
        self.optimizer.step()
        with torch.no_grad():
            for averaged, weight in zip(self.average.parameters(), self.model.parameters()):
                averaged.lerp_(weight, self.averaged)

    def advance(self):
        """One step; the losses as floats."""
        config = replace(self.config, weights=weights_at(self.config, self.done))
        losses = batch_losses(config, self.model, self.next_batch(config))
        total = weighted(losses, config.weights)
        self.descend(total, rate_at(config, self.step, self.done))
        self.step += 1
        return {"total": float(total), **{name: float(value) for name, value in losses.items()}}

    def close(self):
        self.stream.close()

    def log(self, row):
        path = os.path.join(self.folder, "log.csv")
        new = not os.path.exists(path)
        with open(path, "a", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=list(row))
            if new:
                writer.writeheader()
            writer.writerow(row)


def progress(run, losses, per_second, note):
    config, seconds = run.config, time.monotonic() - run.begun
    left = (config.steps - run.step) * config.batch / max(per_second, 1e-6)
    if config.minutes:
        left = min(left, 60 * config.minutes - seconds)
    text = (f"{config.network} {run.step:6d}/{config.steps} {100 * run.done:5.1f} %  loss {losses['total']:.4f}  "
            f"{per_second:5.0f} samples/s  ETA {int(left // 3600)}:{int(left // 60 % 60):02d}:{int(left % 60):02d}  {note}")
    print(text, end="\r" if sys.stdout.isatty() else "\n", flush=True)


def train(config, folder, threads, workers, out=None, until=None, start=None, make_run=Run):
    """Trains to the end of the config (or step `until`), from the folder's checkpoint when it has one; exports to `out`. The
    last scores. make_run: Run, or fast.FastRun where fast.fits."""
    torch.set_num_threads(threads)
    torch.set_flush_denormal(True)
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    run = make_run(config, folder, device, workers, start)
    scores, sums, since, begun = {}, {}, 0, time.monotonic()
    done = run.done
    while done < 1 and run.step != until:
        for name, value in run.advance().items():
            sums[name] = sums.get(name, 0.0) + value
        since += 1
        done = run.done
        if run.step % SAVE_EVERY == 0 or run.step == until or done == 1:
            run.save()
        if run.step % REPORT_EVERY and done < 1:
            continue
        if run.step % EVALUATE_EVERY == 0 or done == 1:
            scores = evaluate.quick_scores(config.network, run.average, device)
        means = {name: value / since for name, value in sums.items()}
        validation = {f"val_{name}": scores.get(name, math.nan) for name in evaluate.QUICK[config.network]}
        run.log({"step": run.step, "seconds": round(time.monotonic() - run.begun, 1),
                 **{name: f"{value:.6g}" for name, value in {**means, **validation}.items()}})
        progress(run, means, since * config.batch / (time.monotonic() - begun),
                 "  ".join(f"{name} {value:.4g}" for name, value in scores.items()))
        sums, since, begun = {}, 0, time.monotonic()
    run.close()
    if out:
        export.export_run(folder, out)
    return scores
