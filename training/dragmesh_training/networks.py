"""KPP-Net and DQ-VAE in PyTorch, module for module and name for name as docs/networks.md specifies them.

The C forward passes (sdk/kinematics/kpp/kpp_net.c, sdk/motion/dq_vae.c) read the state_dict of the `game` size;
golden tests hold both sides together. `paper` is the size of the paper's own networks.
"""
from dataclasses import dataclass

import torch
from torch import nn

# Fixed by the boundary or by the inputs, the same for every size (docs/networks.md).
TYPES = 4  # revolute, prismatic, screw, continuous
PRISMATIC = 1
FRAMES = 16
PATH = 16
PATH_CHANNELS = 5
KPP_GROUP = 16
KPP_GLOBAL_GROUPS = 48
KPP_LOCAL_GROUPS = 24
KPP_CHANNELS = 17
KPP_DIRECTIONS = 9
KPP_SHAPE = 56
KPP_SNAP_DIRECTIONS = 6
KPP_SNAP_COSINE = 0.9397  # 20 degrees
KPP_LINE = 21  # numbers of a candidate joint, see choice.line_numbers
VAE_POINTS = 64
VAE_NEIGHBOURS = 4


@dataclass(frozen=True)
class KppConfig:
    """Widths of KPP-Net (paper §3.5)."""

    dim: int = 96
    heads: int = 4
    ff: int = 192
    point_hidden: int = 64
    position_hidden: int = 48
    global_layers: int = 3
    local_layers: int = 2
    axis_hidden: int = 128
    scalar_hidden: int = 96
    choice_hidden: int = 128
    # What an ablation takes away (docs/research/ablations.md); the library reads the whole network alone.
    mask: bool = True  # the input tells part from body
    drag: bool = True  # the input has the drag
    attention: bool = True  # two streams of grouped points with Transformers; else one PointNet over all points
    decoupled: bool = True  # a head for each answer; else one for all
    shape: bool = True  # the shape's directions and boxes


@dataclass(frozen=True)
class VaeConfig:
    """Widths of the DQ-VAE (paper §3.3)."""

    small: int = 32  # a direction, a position, a scalar pair
    type_dim: int = 16
    feature: int = 64  # f_joint, f_local, f_motion, per-point features
    path_heads: int = 2
    path_ff: int = 64
    hidden: int = 96
    latent: int = 32
    encoder_hidden: int = 128
    dim: int = 96
    heads: int = 4
    ff: int = 384
    layers: int = 3
    correction_hidden: int = 64
    # What an ablation takes away (docs/research/ablations.md); the library reads the whole network alone.
    transformer: bool = True  # decoder; else an MLP from z and f_joint to all frames
    fusion: bool = True  # local sampler and gate; else the encoder sees the whole cloud's features
    local_film: bool = True  # FiLM of the local sampler
    decoder_film: bool = True  # FiLM after every decoder layer
    correction: bool = True  # physics correction


KPP_SIZES = {
    "game": KppConfig(),
    "paper": KppConfig(dim=512, heads=8, ff=1024, point_hidden=256, position_hidden=128, global_layers=6,
                       local_layers=4, axis_hidden=512, scalar_hidden=256),
}
VAE_SIZES = {
    "game": VaeConfig(),
    "paper": VaeConfig(small=128, type_dim=64, feature=512, path_heads=4, path_ff=512, hidden=1024, latent=256,
                       encoder_hidden=512, dim=512, heads=8, ff=2048, layers=8, correction_hidden=512),
}


def mlp(inputs, hidden, outputs):
    """MLP(a->b->c): `.0` and `.2` are its Linears, no activation after the last."""
    return nn.Sequential(nn.Linear(inputs, hidden), nn.ReLU(inplace=True), nn.Linear(hidden, outputs))


class Attention(nn.Module):
    """Multi-head self-attention with one packed projection: rows q, then k, then v; heads are consecutive slices."""

    def __init__(self, dim, heads):
        super().__init__()
        self.heads = heads
        self.qkv = nn.Linear(dim, 3 * dim)
        self.out = nn.Linear(dim, dim)

    def forward(self, x):
        batch, tokens, dim = x.shape
        packed = self.qkv(x).view(batch, tokens, 3, self.heads, dim // self.heads)
        q, k, v = packed.permute(2, 0, 3, 1, 4)
        scores = q @ k.transpose(-1, -2) * (dim // self.heads) ** -0.5
        mixed = torch.softmax(scores, dim=-1) @ v
        return self.out(mixed.transpose(1, 2).reshape(batch, tokens, dim))


class TransformerLayer(nn.Module):
    """Pre-norm layer: x += attn(LN x); x += ff2(ReLU(ff1(LN x)))."""

    def __init__(self, dim, heads, ff):
        super().__init__()
        self.norm1 = nn.LayerNorm(dim)
        self.attn = Attention(dim, heads)
        self.norm2 = nn.LayerNorm(dim)
        self.ff1 = nn.Linear(dim, ff)
        self.ff2 = nn.Linear(ff, dim)

    def forward(self, x):
        x = x + self.attn(self.norm1(x))
        return x + self.ff2(torch.relu(self.ff1(self.norm2(x))))


class Maximum(torch.autograd.Function):
    """Maximum along a dimension. As amax, but twice as fast backwards, which shares a gradient among equals; and several times
    faster than max, which looks for indices."""

    @staticmethod
    def forward(context, x, dim):
        maximum = x.amax(dim=dim)
        context.save_for_backward(x, maximum)
        context.dim = dim
        return maximum

    @staticmethod
    def backward(context, gradient):
        x, maximum = context.saved_tensors
        here = x == maximum.unsqueeze(context.dim)
        return torch.where(here, gradient.unsqueeze(context.dim), gradient.new_zeros(())), None


class PointEncoder(nn.Module):
    """Grouped points to one vector: PointNet a group, then a Transformer over the groups (paper §3.5)."""

    def __init__(self, config, layers):
        super().__init__()
        self.point = mlp(KPP_CHANNELS, config.point_hidden, config.dim)
        self.position = mlp(3, config.position_hidden, config.dim)
        self.layers = nn.ModuleList(
            TransformerLayer(config.dim, config.heads, config.ff) for _ in range(layers))
        self.norm = nn.LayerNorm(config.dim)

    def tokens(self, points, positions):
        """Of every group, before the last norm; what fast.py does in other ways."""
        tokens = Maximum.apply(self.point(points), 2) + positions
        for layer in self.layers:
            tokens = layer(tokens)
        return tokens

    def forward(self, points, centres):
        tokens = self.norm(self.tokens(points, self.position(centres)))
        return torch.cat([tokens.mean(dim=1), Maximum.apply(tokens, 1)], dim=-1)


class PointNet(nn.Module):
    """The ablation's encoder: all points of all groups by one MLP, then their maximum."""

    def __init__(self, config):
        super().__init__()
        self.point = mlp(KPP_CHANNELS, 2 * config.dim, 4 * config.dim)

    def forward(self, points):
        return self.point(points.flatten(1, 2)).amax(dim=1)


class Choice(nn.Module):
    """A score of any candidate joint, given what the encoders saw: where regression can only answer the middle between two
    hinges, this says that either is likely."""

    def __init__(self, known, hidden):
        super().__init__()
        self.known = nn.Linear(known, hidden)
        self.line = nn.Linear(KPP_LINE, hidden)
        self.score = mlp(hidden, hidden // 2, 1)

    def forward(self, known, lines):
        """known: B x n, lines: B x K x 21; B x K."""
        return self.score(torch.relu(self.known(known).unsqueeze(1) + self.line(lines))).squeeze(-1)


class KppNet(nn.Module):
    """Joint type, turn axis, slide axis, origin and limits from the input that sdk/kinematics/kpp/kpp_input.c makes."""

    def __init__(self, config=KPP_SIZES["game"]):
        super().__init__()
        self.config = config
        # "global" is a keyword of Python and "type" a method of Module: both are reached through _modules.
        if config.attention:
            self.add_module("global", PointEncoder(config, config.global_layers))
            self.local = PointEncoder(config, config.local_layers)
        else:
            self.add_module("global", PointNet(config))
        known = 4 * config.dim + KPP_SHAPE
        sizes = {"type": TYPES, "axis": 2 * (3 + KPP_DIRECTIONS), "origin": 6, "limits": 5}
        self.sizes = sizes
        if not config.decoupled:
            self.all = mlp(known, config.axis_hidden, sum(sizes.values()))
            return
        self.type = mlp(known, config.scalar_hidden, sizes["type"])
        self.axis = mlp(known, config.axis_hidden, sizes["axis"])
        self.origin = mlp(known, config.axis_hidden, sizes["origin"])
        self.limits = mlp(known, config.scalar_hidden, sizes["limits"])
        self.choice = Choice(known, config.choice_hidden)

    @staticmethod
    def read_axis(head, directions):
        """A vector, plus a share of each of the shape's own directions: joints mostly follow one of them exactly."""
        return head[:, :3] + (head[:, 3:].unsqueeze(-1) * directions).sum(1)

    @staticmethod
    def snapped(axis, shape):
        """What the library reads: the nearest of the part's, the body's and the frame's directions, when that is within 20 degrees."""
        directions = torch.cat([shape[:, :3 * KPP_SNAP_DIRECTIONS].view(-1, KPP_SNAP_DIRECTIONS, 3),
                                torch.eye(3, device=shape.device).expand(len(shape), 3, 3)], dim=1)
        length = axis.norm(dim=-1, keepdim=True)
        along = (directions * axis.unsqueeze(1)).sum(-1)
        best = along.abs().argmax(dim=1, keepdim=True)
        cosine = along.gather(1, best)
        nearest = directions.gather(1, best.unsqueeze(-1).expand(-1, -1, 3)).squeeze(1)
        return torch.where(cosine.abs() > KPP_SNAP_COSINE * length, nearest * length * cosine.sign(), axis)

    def answer(self, *inputs):
        """The outputs as the library gives them: axes snapped to the shape's directions."""
        output = self(*inputs)
        if self.config.shape:
            for name in ("turn_axis", "slide_axis"):
                output[name] = self.snapped(output[name], inputs[-1])
        return output

    def without(self, points):
        """The channels that the config leaves (docs/networks.md: y 3, mask, drag point 3, drag vector 3, offset 3, normal 3, nearness)."""
        if self.config.mask and self.config.drag:
            return points
        keep = points.new_ones(KPP_CHANNELS)
        if not self.config.mask:
            keep[3] = 0
        if not self.config.drag:
            keep[4:10] = 0
        return points * keep

    def features(self, global_points, global_centres, local_points, local_centres):
        whole = self._modules["global"]
        if not self.config.attention:
            return whole(self.without(global_points))
        return torch.cat([whole(self.without(global_points), global_centres),
                          self.local(self.without(local_points), local_centres)], dim=-1)

    def heads(self, known):
        if self.config.decoupled:
            return [self._modules[name](known) for name in self.sizes]
        return torch.split(self.all(known), list(self.sizes.values()), dim=-1)

    def forward(self, global_points, global_centres, local_points, local_centres, shape):
        """global_points: B x 48 x 16 x 17, global_centres: B x 48 x 3; local the same with 24 groups; shape: B x 56."""
        if not self.config.shape:
            shape = torch.zeros_like(shape)
        known = torch.cat([self.features(global_points, global_centres, local_points, local_centres), shape], dim=-1)
        kind, axis, origin, limits = self.heads(known)
        turn, slide = axis.chunk(2, dim=-1)
        directions = shape[:, :3 * KPP_DIRECTIONS].view(-1, KPP_DIRECTIONS, 3)
        centre, half = shape[:, 3 * KPP_DIRECTIONS:3 * KPP_DIRECTIONS + 6].chunk(2, dim=-1)
        in_box, offset = origin.chunk(2, dim=-1)
        return {"known": known, "type_logits": kind, "turn_axis": self.read_axis(turn, directions),
                "slide_axis": self.read_axis(slide, directions), "origin": centre + half * in_box + offset,
                "limits": limits}


class JointEncoder(nn.Module):
    """Joint condition encoder (paper §3.3.1): type, axis, origin and scalars to f_joint."""

    def __init__(self, config):
        super().__init__()
        self.type = nn.Embedding(TYPES, config.type_dim)
        self.axis = mlp(3, config.small, config.small)
        self.origin = mlp(3, config.small, config.small)
        self.fuse = mlp(config.type_dim + 2 * config.small + 3, config.feature, config.feature)

    def forward(self, kind, axis, origin, scalars):
        embedded = self._modules["type"](kind)
        parts = [embedded, self.axis(axis), self.origin(origin), scalars]
        return self.fuse(torch.cat(parts, dim=-1)), embedded


class IntentEncoder(nn.Module):
    """Motion intent encoder (paper §3.3.1): what the drag asks for, with a small Transformer over its path."""

    def __init__(self, config):
        super().__init__()
        self.direction = mlp(3, config.small, config.small)
        self.velocity = mlp(3, config.small, config.small)
        self.chord = mlp(9, config.feature, 2 * config.small)
        self.amplitude = mlp(2, config.small, config.small)
        self.path_in = nn.Linear(PATH_CHANNELS, config.small)
        self.path_position = nn.Parameter(0.1 * torch.randn(PATH, config.small))
        self.path_layer = TransformerLayer(config.small, config.path_heads, config.path_ff)
        self.fuse = mlp(4 * config.small, config.hidden, config.feature)

    def forward(self, kind, direction, velocity, chords, amplitude, path):
        turning = torch.cat([self.direction(direction), self.velocity(velocity)], dim=-1)
        motion = torch.where((kind == PRISMATIC).unsqueeze(-1), self.chord(chords), turning)
        ordered = self.path_layer(self.path_in(path) + self.path_position)
        return self.fuse(torch.cat([motion, self.amplitude(amplitude), ordered.mean(dim=1)], dim=-1))


class LocalSampler(nn.Module):
    """Features near the joint origin and the drag point, FiLM-modulated by f_joint (paper §3.3.2)."""

    def __init__(self, config):
        super().__init__()
        self.mlp = mlp(3 * config.feature, config.hidden, config.feature)
        self.film = nn.Linear(config.feature, 2 * config.feature) if config.local_film else None

    @staticmethod
    def pooled(features, neighbours):
        index = neighbours.unsqueeze(-1).expand(-1, -1, features.shape[-1])
        return Maximum.apply(features.gather(1, index), 1)

    def forward(self, features, near_origin, near_drag, f_joint):
        pooled = [self.pooled(features, near_origin), self.pooled(features, near_drag),
                  Maximum.apply(features, 1)]
        local = self.mlp(torch.cat(pooled, dim=-1))
        if self.film is None:
            return torch.relu(local)
        gamma, beta = self.film(f_joint).chunk(2, dim=-1)
        return torch.relu(local * (1 + gamma) + beta)


class Gate(nn.Module):
    """Learned gate over [f_local, f_joint, f_motion] to f_fused (paper §3.3.2)."""

    def __init__(self, config):
        super().__init__()
        self.gate = nn.Linear(3 * config.feature, 3 * config.feature)
        self.mlp = mlp(3 * config.feature, config.hidden, config.hidden)

    def forward(self, context):
        return self.mlp(context * torch.sigmoid(self.gate(context)))


class Decoder(nn.Module):
    """Non-autoregressive Transformer over the frames, FiLM after every layer (paper §3.3.3)."""

    def __init__(self, config):
        super().__init__()
        self.position = nn.Parameter(0.5 * torch.randn(FRAMES, config.small))
        self.input = nn.Linear(config.small + config.latent + 2 * config.feature, config.dim)
        self.layers = nn.ModuleList(
            TransformerLayer(config.dim, config.heads, config.ff) for _ in range(config.layers))
        self.film = nn.ModuleList(nn.Linear(config.feature, 2 * config.dim) for _ in range(config.layers)
                                  if config.decoder_film)
        self.norm = nn.LayerNorm(config.dim)
        self.head = mlp(config.dim, config.dim, 8)

    def forward(self, z, f_joint):
        condition = torch.cat([z, f_joint, 0.1 * f_joint], dim=-1)
        tokens = torch.cat([self.position.expand(z.shape[0], -1, -1),
                            condition.unsqueeze(1).expand(-1, FRAMES, -1)], dim=-1)
        x = self.input(tokens)
        for number, layer in enumerate(self.layers):
            x = layer(x)
            if self.film:
                gamma, beta = self.film[number](f_joint).unsqueeze(1).chunk(2, dim=-1)
                x = x * (1 + gamma) + beta
        return self.head(self.norm(x))


class MlpDecoder(nn.Module):
    """The ablation's decoder: all frames at once from z and f_joint."""

    def __init__(self, config):
        super().__init__()
        self.layers = mlp(config.latent + config.feature, 4 * config.dim, FRAMES * 8)

    def forward(self, z, f_joint):
        return self.layers(torch.cat([z, f_joint], dim=-1)).view(-1, FRAMES, 8)


class DqVae(nn.Module):
    """Dual-quaternion VAE: joint, points and drag path to 16 poses about the joint origin."""

    def __init__(self, config=VAE_SIZES["game"]):
        super().__init__()
        self.joint = JointEncoder(config)
        self.points = mlp(4, config.small, config.feature)
        self.intent = IntentEncoder(config)
        if config.fusion:
            self.local = LocalSampler(config)
            self.gate = Gate(config)
        else:
            self.plain = mlp(3 * config.feature, config.hidden, config.hidden)
        self.encoder = mlp(config.hidden + config.feature, config.encoder_hidden, 2 * config.latent)
        self.decoder = Decoder(config) if config.transformer else MlpDecoder(config)
        if config.correction:
            self.correction = mlp(8 + config.type_dim + 2 * config.feature + 6, config.correction_hidden, 8)
            self.along = nn.Linear(config.correction_hidden, 2)
            nn.init.zeros_(self.along.weight)
            nn.init.zeros_(self.along.bias)
        else:
            self.correction = None

    def fused(self, batch, f_joint):
        cloud = torch.cat([batch["xyz"], batch["mask"].unsqueeze(-1)], dim=-1)
        features = torch.relu(self.points(cloud))
        f_motion = self.intent(batch["type"], batch["rotation_direction"], batch["mean_velocity"], batch["chords"],
                               batch["amplitude"], batch["path"])
        if "plain" in self._modules:
            return self.plain(torch.cat([features.amax(dim=1), f_joint, f_motion], dim=-1))
        f_local = self.local(features, batch["near_origin"], batch["near_drag"], f_joint)
        return self.gate(torch.cat([f_local, f_joint, f_motion], dim=-1))

    def encode(self, batch):
        """f_joint, the type embedding, and the latent's mean and log variance."""
        f_joint, embedded = self.joint(batch["type"], batch["axis"], batch["origin"], batch["joint_scalars"])
        f_fused = self.fused(batch, f_joint)
        mean, log_variance = self.encoder(torch.cat([f_fused, f_joint], dim=-1)).chunk(2, dim=-1)
        return f_joint, embedded, mean, log_variance.clamp(-8.0, 4.0)

    def corrected(self, base, f_joint, embedded, axis):
        """Physics correction: a residual of each base pose, and amounts of turn and slide that lie exactly on the joint's axis
        whatever they are."""
        condition = torch.cat([embedded, f_joint, 0.1 * f_joint, axis, 0.1 * axis], dim=-1)
        condition = condition.unsqueeze(1).expand(-1, FRAMES, -1)
        hidden = self.correction[1](self.correction[0](torch.cat([base, condition], dim=-1)))
        turn, slide = self.along(hidden).chunk(2, dim=-1)
        on_axis = torch.cat([turn * axis.unsqueeze(1), torch.zeros_like(turn), slide * axis.unsqueeze(1),
                             torch.zeros_like(turn)], dim=-1)
        return base + self.correction[2](hidden) + on_axis

    def decode(self, z, f_joint, embedded, axis):
        """B x 16 x 8: x, y, z, w of the real part, then of the dual part; not normalised."""
        poses = self.decoder(z, f_joint)
        if self.correction is not None:
            poses = self.corrected(poses, f_joint, embedded, axis)
        return poses + poses.new_tensor([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0])

    def forward(self, batch, sample=False):
        """batch: type B (int64), axis, origin, joint_scalars, rotation_direction, mean_velocity B x 3, chords B x 9,
        amplitude B x 2, path B x 16 x 5, xyz B x 64 x 3, mask B x 64, near_origin, near_drag B x 4 (int64).
        sample: z is drawn (training); else z = mean (run time)."""
        f_joint, embedded, mean, log_variance = self.encode(batch)
        z = mean + torch.exp(0.5 * log_variance) * torch.randn_like(mean) if sample else mean
        return self.decode(z, f_joint, embedded, batch["axis"]), mean, log_variance
