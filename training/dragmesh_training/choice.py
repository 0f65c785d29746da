"""What KPP-Net's candidate-scoring head (networks.Choice) is trained on: lines through and beside the part, and how far each
one's motion is from the true joint's. sdk/kinematics/features/kpp_ensemble.c computes the same numbers of a line."""
import torch
import torch.nn.functional as F

from .networks import KPP_DIRECTIONS, KPP_LINE
from .losses import PRISMATIC

PROPOSALS = 64  # a case; the first is the truth
NEAR = 0.05  # share by which the motions of two joints differ: about this much is as good as equal
CONE = 0.8  # least cosine between the drag and a candidate's motion, as in sdk/kinematics/candidates/candidates.c
LEAST_SPEED = 0.04  # and least speed of the dragged point


def read_shape(shape):
    """Directions, the part's box (centre, half sides), drag point and vector of B x 56 shape numbers."""
    directions = shape[:, :3 * KPP_DIRECTIONS].view(-1, KPP_DIRECTIONS, 3)
    centre, half, _, _, point, vector = shape[:, 3 * KPP_DIRECTIONS:3 * KPP_DIRECTIONS + 18].split(3, dim=-1)
    return directions, centre, half, point, vector


def velocity(slides, axis, origin, points):
    """Of points at unit speed."""
    return torch.where(slides.unsqueeze(-1), axis.expand_as(points), torch.linalg.cross(axis, points - origin))


def line_numbers(slides, axis, origin, shape):
    """B x K x 21 of candidates (unit axes, B x K x 3), the same for an axis and its opposite: what they are, their direction,
    where they pass the part's box, how they move the dragged point."""
    _, centre, half, point, vector = (t.unsqueeze(1) for t in read_shape(shape))
    turns = (~slides).unsqueeze(-1).to(axis.dtype)
    foot = origin - centre
    foot = (foot - (foot * axis).sum(-1, keepdim=True) * axis) * turns
    x, y, z = axis.unbind(-1)
    square = torch.stack([x * x, y * y, z * z, x * y, y * z, z * x], dim=-1)
    moved = velocity(slides, axis, origin, point.expand_as(axis))
    along = (moved * vector).sum(-1, keepdim=True)
    moved = moved * torch.where(along < 0, -1.0, 1.0)
    speed = moved.norm(dim=-1, keepdim=True)
    moved = moved / speed.clamp(min=1e-3)
    dragged = (vector.norm(dim=-1, keepdim=True) > 0).to(axis.dtype)
    in_box = (foot / (half + 0.02)).clamp(-3, 3)
    return torch.cat([slides.unsqueeze(-1).to(axis.dtype), square, foot, in_box, in_box.abs(),
                      (moved * vector).sum(-1, keepdim=True) * dragged, moved * dragged, speed.clamp(max=3) * dragged * turns], dim=-1)


def pick(choices, index):
    """Of B x N x 3, at B x K."""
    return choices.gather(1, index.unsqueeze(-1).expand(-1, -1, 3))


def jittered(vectors, share, scale):
    """A share of the vectors moved at random, by sizes over three orders of magnitude up to `scale`."""
    moved = torch.rand(vectors.shape[:2], device=vectors.device) < share
    size = scale * 10 ** (-3 * torch.rand_like(vectors[..., :1]))
    return vectors + size * torch.randn_like(vectors) * moved.unsqueeze(-1)


def propose(batch):
    """Lines that geometry suggests (directions of part and body; corners, sides and middle of the part's box, points of the
    part), some off by little: B x K slides, axis, origin."""
    directions, centre, half, _, _ = read_shape(batch["shape"])
    count, device = len(centre), centre.device
    frame = torch.eye(3, device=device).expand(count, 3, 3)
    # The truth is among the choices again: of turns about its axis elsewhere, and of other directions through its place.
    axes = torch.cat([directions, frame, batch["axis"].unsqueeze(1).expand(-1, 3, -1)], dim=1)
    axis = pick(axes, torch.randint(0, axes.shape[1], (count, PROPOSALS), device=device))
    axis = F.normalize(jittered(axis, 0.3, 0.3), dim=-1)
    lattice = torch.randint(-1, 2, (count, PROPOSALS, 3), device=device).to(half.dtype)
    place = centre.unsqueeze(1) + half.unsqueeze(1) * lattice
    own = pick(batch["local_centres"], torch.randint(0, batch["local_centres"].shape[1], (count, PROPOSALS), device=device))
    kind = torch.rand(count, PROPOSALS, 1, device=device)
    origin = torch.where(kind < 0.6, place, torch.where(kind < 0.85, own, batch["origin"].unsqueeze(1).expand_as(own)))
    origin = jittered(origin, 0.5, 0.3)
    slides = torch.rand(count, PROPOSALS, device=device) < 0.2
    slides[:, 0] = batch["type"] == PRISMATIC
    axis[:, 0], origin[:, 0] = batch["axis"], batch["origin"]
    return slides, axis, origin


def differences(slides, axis, origin, points):
    """B x K: by how much candidates move the points otherwise than the first, up to speed and sign: the sine of the angle between
    the velocities taken over all points (as in sdk/kinematics/inference/joint_inference.c); 1 where the type is another."""
    moved = velocity(slides.unsqueeze(-1), axis.unsqueeze(2), origin.unsqueeze(2), points.unsqueeze(1).expand(-1, axis.shape[1], -1, -1))
    truth = moved[:, :1]
    cosine = (moved * truth).sum((-1, -2)) / (moved.pow(2).sum((-1, -2)) * truth.pow(2).sum((-1, -2)) + 1e-12).sqrt()
    return torch.where(slides == slides[:, :1], (1 - cosine ** 2).clamp(min=0).sqrt(), torch.ones_like(cosine))


def considered(slides, axis, origin, batch):
    """B x K: which of the proposals the library would make: those that follow a drag, and always the truth."""
    _, _, _, point, vector = (t.unsqueeze(1) for t in read_shape(batch["shape"]))
    moved = velocity(slides, axis, origin, point.expand_as(axis))
    speed = moved.norm(dim=-1)
    follows = ((moved * vector).sum(-1).abs() >= CONE * speed) & (speed >= LEAST_SPEED)
    result = follows | (batch["has_drag"] == 0).unsqueeze(-1)
    result[:, 0] = True
    return result


def question(batch):
    """What the candidate-scoring head is trained on in a batch: the numbers of the proposals' lines, which of them count (0; else next to
    nothing), and how they share a probability of one, by how near their motions are to the truth."""
    slides, axis, origin = propose(batch)
    off = differences(slides, axis, origin, batch["local_centres"][:, ::2])
    out = torch.where(considered(slides, axis, origin, batch), 0.0, -1e9)
    return {"lines": line_numbers(slides, axis, origin, batch["shape"]), "out": out,
            "wanted": torch.softmax(out - (off / NEAR) ** 2, dim=-1)}


def choice_loss(model, known, asked):
    """Cross-entropy of the answer to a question."""
    scores = model.choice(known, asked["lines"])
    return -(asked["wanted"] * torch.log_softmax(scores + asked["out"], dim=-1)).sum(-1).mean()
