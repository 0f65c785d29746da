"""Losses of both networks (paper §3.4 and §3.5). Each returns a dict of unweighted scalars; weights come from config.py."""
import torch
import torch.nn.functional as F

REVOLUTE, PRISMATIC, SCREW, CONTINUOUS = range(4)
# Indices into the limits head that a joint type has: turn lower, upper, slide lower, upper, pitch.
LIMITS_OF_TYPE = ((1, 1, 0, 0, 0), (0, 0, 1, 1, 0), (1, 1, 0, 0, 1), (0, 0, 0, 0, 0))


def masked_mean(values, mask):
    return (values * mask).sum() / mask.sum().clamp(min=1)


def angle_between(a, b):
    """Angle of 3-vectors, with a gradient everywhere (acos has none worth using near 0)."""
    cross = torch.linalg.cross(a, b)
    return torch.atan2(torch.sqrt((cross * cross).sum(-1) + 1e-8), (a * b).sum(-1))


# ---- KPP-Net ---------------------------------------------------------------------------------------------------

def kpp_losses(output, batch):
    """With a drag the axis is signed (positive motion follows the drag); without one its sign is free."""
    kind = batch["type"]
    turning = kind != PRISMATIC
    raw = torch.where(turning.unsqueeze(-1), output["turn_axis"], output["slide_axis"])
    axis = F.normalize(raw, dim=-1)
    cosine = (axis * batch["axis"]).sum(-1)
    flip = torch.where((batch["has_drag"] == 0) & (cosine < 0), -1.0, 1.0)
    angle = angle_between(axis * flip.unsqueeze(-1), batch["axis"])
    # A point of the axis is known up to a slide along it: the line's distance counts, the slide hardly.
    error = output["origin"] - batch["origin"]
    along = (error * batch["axis"]).sum(-1, keepdim=True) * batch["axis"]
    line = F.smooth_l1_loss(error - along, torch.zeros_like(error), beta=0.05, reduction="none").sum(-1)
    slide = F.smooth_l1_loss(along, torch.zeros_like(along), beta=0.05, reduction="none").sum(-1)
    # Equal limits are none (loaded objects); generated joints always have theirs.
    turn, slide_range = (batch["limits"][:, lower] != batch["limits"][:, lower + 1] for lower in (0, 2))
    known = torch.stack([turn, turn, slide_range, slide_range, torch.ones_like(turn)], dim=-1)
    has_limit = (kind.new_tensor(LIMITS_OF_TYPE)[kind] * known).to(error.dtype)
    limits = F.smooth_l1_loss(output["limits"], batch["limits"], beta=0.1, reduction="none")
    # Only the axes' directions are asked for: without this their lengths grow, and the gradient of a direction falls with them.
    lengths = torch.stack([output["turn_axis"], output["slide_axis"]]).norm(dim=-1)
    return {"type": F.cross_entropy(output["type_logits"], kind, label_smoothing=0.02), "cosine": (1 - cosine * flip).mean(),
            "geodesic": angle.mean(), "length": ((lengths - 1) ** 2).mean(), "origin": masked_mean(line, turning), "along": masked_mean(slide, turning),
            "limits": masked_mean(limits, has_limit)}


# ---- dual quaternions, x y z w ---------------------------------------------------------------------------------

def quaternion_multiply(a, b):
    av, aw, bv, bw = a[..., :3], a[..., 3:], b[..., :3], b[..., 3:]
    vector = aw * bv + bw * av + torch.linalg.cross(av, bv)
    return torch.cat([vector, aw * bw - (av * bv).sum(-1, keepdim=True)], dim=-1)


def rotate(q, v):
    """Points v by unit quaternions q (broadcasting)."""
    u, w = q[..., :3], q[..., 3:]
    u, v = torch.broadcast_tensors(u, v)
    twice = 2 * torch.linalg.cross(u, v)
    return v + w * twice + torch.linalg.cross(u, twice)


def joint_poses(kind, axis, pitch, values):
    """Rotation (B x T x 4) and translation about the joint origin (B x T x 3) of joints at values (B x T)."""
    turns = (kind != PRISMATIC).unsqueeze(-1)
    half = torch.where(turns, 0.5 * values, torch.zeros_like(values)).unsqueeze(-1)
    rotation = torch.cat([torch.sin(half) * axis.unsqueeze(1), torch.cos(half)], dim=-1)
    slide = torch.where(turns, pitch.unsqueeze(-1) * values, values)
    return rotation, slide.unsqueeze(-1) * axis.unsqueeze(1)


def split_pose(raw):
    """Unit rotation, translation, and the length of the real part, of raw B x T x 8 (t = 2 q_d q_r*, paper §3.2)."""
    length = torch.sqrt((raw[..., :4] ** 2).sum(-1, keepdim=True) + 1e-12)
    real, dual = raw[..., :4] / length, raw[..., 4:] / length
    conjugate = real * real.new_tensor([-1.0, -1.0, -1.0, 1.0])
    return real, 2 * quaternion_multiply(dual, conjugate)[..., :3], length.squeeze(-1)


# ---- DQ-VAE ----------------------------------------------------------------------------------------------------

def chamfer(a, b):
    """Two-way squared Chamfer distance of point sets (... x N x 3)."""
    distance = ((a.unsqueeze(-2) - b.unsqueeze(-3)) ** 2).sum(-1)
    return distance.amin(-1).mean(-1) + distance.amin(-2).mean(-1)


def axis_error(kind, axis, rotation, translation):
    """Squared sine between the rotation axis and the joint's (softened where there is hardly a rotation), and the squared
    translation across the axis for joints that slide: the stable cross product of paper §3.4."""
    axis = axis.unsqueeze(1)
    vector = rotation[..., :3]
    turned = (vector ** 2).sum(-1)
    across = (torch.linalg.cross(vector, axis.expand_as(vector)) ** 2).sum(-1) / (turned + 1e-3)
    slid = (torch.linalg.cross(translation, axis.expand_as(translation)) ** 2).sum(-1)
    kind = kind.unsqueeze(-1)
    return torch.where(kind == PRISMATIC, slid, torch.where(kind == SCREW, across + slid, across))


def kl_divergence(mean, log_variance):
    """Per sample and latent dimension, to the standard normal."""
    return 0.5 * (mean ** 2 + log_variance.exp() - 1 - log_variance)


def vae_losses(raw, mean, log_variance, batch, free_nats):
    """All losses of paper §3.4, per frame with frame 0 counted twice, and drag consistency: the dragged point goes where the
    drag means it to go."""
    kind, axis = batch["type"], batch["axis"]
    true_rotation, true_translation = joint_poses(kind, axis, batch["pitch"], batch["values"])
    rotation, translation, length = split_pose(raw)
    frame = raw.new_ones(raw.shape[1])
    frame[0] = 2.0
    frame = frame / frame.sum()

    def over_frames(values):
        return (values * frame).sum(-1)

    # The first points of the cloud lie on the part; the drag point moves with it.
    points = torch.cat([batch["xyz"][:, :192:6], batch["drag_point"].unsqueeze(1)], dim=1)
    points = (points - batch["origin"].unsqueeze(1)).unsqueeze(1)
    moved = rotate(rotation.unsqueeze(2), points) + translation.unsqueeze(2)
    truth = rotate(true_rotation.unsqueeze(2), points) + true_translation.unsqueeze(2)
    # Relative to the stroke's length: a button's short way matters as much to its player as a door's.
    stroke = (truth[:, :, -1] - points[:, :, -1]).pow(2).sum(-1)
    missed = (moved[:, :, -1] - truth[:, :, -1]).pow(2).sum(-1) / (stroke.amax(-1, keepdim=True) + 2e-2 ** 2)
    turns_alone = ((kind == REVOLUTE) | (kind == CONTINUOUS)).to(raw.dtype)
    slides_alone = (kind == PRISMATIC).to(raw.dtype)
    # Motions begin at the identity, so quaternions have a sign along the path: the signed distance also tells turns
    # beyond pi from their shorter doubles.
    return {
        "mesh": over_frames(((moved - truth) ** 2).sum(-1).mean(-1)).mean(),
        "qr": over_frames(1 - (rotation * true_rotation).sum(-1)).mean(),
        "qd": over_frames(((translation - true_translation) ** 2).sum(-1)).mean(),
        "cd": over_frames(chamfer(moved[:, :, :-1:2], truth[:, :, :-1:2])).mean(),
        "axis": over_frames(axis_error(kind, axis, rotation, translation)).mean(),
        "qd0": masked_mean(over_frames((translation ** 2).sum(-1)), turns_alone),
        "qr1": masked_mean(over_frames((2 * rotation[..., :3]).pow(2).sum(-1)), slides_alone),
        "drag": over_frames(missed).mean(),
        "unit": over_frames((length - 1) ** 2).mean(),
        "kl": F.relu(kl_divergence(mean, log_variance).sum(-1) - free_nats).mean(),
    }


def weighted(losses, weights):
    """The sum that is minimised; losses of weight 0 take no part in the gradient."""
    return sum(weights[name] * value for name, value in losses.items() if weights[name] != 0)
