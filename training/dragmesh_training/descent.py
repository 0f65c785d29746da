"""How the library's small networks are fitted: AdamW, a rate that falls evenly, and weights averaged over the steps."""
import torch


def descend(net, steps, rate, last_rate, decay, least_share, loss_of):
    """loss_of(step): the loss of a fresh batch. The net is left with the average of its weights, to which a step gives
    at least that share."""
    optimiser = torch.optim.AdamW(net.parameters(), rate, weight_decay=decay)
    average = {name: value.clone() for name, value in net.state_dict().items()}
    for step in range(steps):
        for group in optimiser.param_groups:
            group["lr"] = rate * (1 - step / steps) + last_rate
        loss = loss_of(step)
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        for name, value in net.state_dict().items():
            average[name].lerp_(value, max(least_share, 1 / (step + 1)))
    net.load_state_dict(average)


def listwise_loss(scores, log_weights, costs):
    """A case's candidates share a probability of one by exp(-cost); the softmax over their scores is to share it alike. A row
    stands for exp(log weight) candidates."""
    wanted = torch.softmax(log_weights - costs, 1)
    return -(wanted * torch.log_softmax(scores + log_weights, 1)).sum(1).mean()
