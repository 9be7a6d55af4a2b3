"""Train the detector again, and check that it reaches the promised accuracy (`make model`). Needs the extra `torch`.

Without arguments, nothing is saved. `--write` replaces the committed files.
"""

import argparse
import sys
import time
import tomllib
from typing import Any

import numpy as np
import torch
from torch import nn

from workbook.models.accuracy import IMAGES_HELD_BACK, Accuracy, accuracy
from workbook.models.detection import LABELS, STRIDE, Floats
from workbook.models.detector import DeskDetector, to_input
from workbook.models.export import write_files
from workbook.models.networks import CHANNELS, FOLDER, HEIGHT, LAYERS, PROVENANCE_FILE, WIDTH, TorchNetwork
from workbook.scenes.desk import DeskCamera
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.tabletop import tabletop, things_in

SEED = 16
IMAGES = 3000
EPOCHS = 10
BATCH = 32
RATE = 4e-3
SEEN_ENOUGH, SEEN_TOO_LITTLE = 0.6, 0.25
"""Objects less visible than the first fraction aren't targets. Objects less visible than the second are background."""
ROWS, COLUMNS = HEIGHT // STRIDE, WIDTH // STRIDE
OUT = len(LABELS)


def targets(number: int, pinhole: Pinhole) -> tuple[Floats, Floats]:
    """Return one image's target output, shape (labels + 4, rows, columns), and a mask of the squares that count.

    The mask has two maps. The first is 1 where the labels count, and the second is 1 at objects' centers.
    """
    wanted = np.zeros((OUT + 4, ROWS, COLUMNS), dtype=np.float32)
    counts = np.zeros((2, ROWS, COLUMNS), dtype=np.float32)
    counts[0] = 1.0
    rows, columns = np.mgrid[:ROWS, :COLUMNS]
    for thing in things_in(tabletop(SEED, number), pinhole):
        column, row = round(thing.u / STRIDE), round(thing.v / STRIDE)
        near_u, near_v = (columns * STRIDE - thing.u) / thing.width, (rows * STRIDE - thing.v) / thing.height
        if thing.visible < SEEN_ENOUGH or not (0 <= row < ROWS and 0 <= column < COLUMNS):
            if thing.visible >= SEEN_TOO_LITTLE:
                counts[0][(abs(near_u) < 0.7) & (abs(near_v) < 0.7)] = 0.0
            continue
        hill = np.exp(-((near_u / 0.3) ** 2 + (near_v / 0.3) ** 2) / 2)
        hill[row, column] = 1.0
        label = LABELS.index(thing.label)
        wanted[label] = np.maximum(wanted[label], hill)
        offset = thing.u / STRIDE - column, thing.v / STRIDE - row
        wanted[OUT:, row, column] = (*offset, np.log(thing.width), np.log(thing.height))
        counts[1, row, column] = 1.0
    return wanted, counts


def examples(number: int = IMAGES) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Return `number` images, their target outputs, and the masks of squares that count (see `targets`)."""
    pinhole = Pinhole(WIDTH, HEIGHT, 0.875 * WIDTH)
    camera = DeskCamera(pinhole, SEED)
    pictures = [to_input(camera.picture(tabletop(SEED, one), one))[0] for one in range(number)]
    answers = [targets(one, pinhole) for one in range(number)]
    stacked = pictures, [wanted for wanted, _ in answers], [counts for _, counts in answers]
    first, second, third = (torch.from_numpy(np.stack(one)) for one in stacked)
    return first, second, third


def network() -> nn.Sequential:
    """Return an untrained network with batch normalization, which `folded` later merges into the weights."""
    stack: list[nn.Module] = []
    for number, layer in enumerate(LAYERS):
        last = number == len(LAYERS) - 1
        stack.append(
            nn.Conv2d(
                CHANNELS[number],
                CHANNELS[number + 1],
                layer.kernel,
                layer.stride,
                layer.padding,
                layer.dilation,
                bias=last,
            )
        )
        if not last:
            stack += [nn.BatchNorm2d(CHANNELS[number + 1]), nn.ReLU()]
    nn.init.constant_(stack[-1].bias[:OUT], -3.0)
    return nn.Sequential(*stack)


def loss_of(maps: torch.Tensor, wanted: torch.Tensor, counts: torch.Tensor) -> torch.Tensor:
    """Return CenterNet's focal loss for the labels, plus half the mean error of position and size at the centers."""
    hills, middles = wanted[:, :OUT], counts[:, 1:]
    score = torch.sigmoid(maps[:, :OUT]).clamp(1e-4, 1 - 1e-4)
    at_middle = hills == 1.0
    hit = torch.where(
        at_middle,
        (1 - score) ** 2 * torch.log(score),
        (1 - hills) ** 4 * score**2 * torch.log(1 - score),
    )
    number = middles.sum().clamp(min=1.0)
    found = -(hit * counts[:, :1]).sum() / number
    placed = ((maps[:, OUT:] - wanted[:, OUT:]).abs() * middles).sum() / number
    return found + 0.5 * placed


def trained(data: tuple[torch.Tensor, torch.Tensor, torch.Tensor], epochs: int = EPOCHS) -> nn.Sequential:
    """Train a new network for this many passes over all images, and return it. Prints the progress."""
    pictures, wanted, counts = data
    model = network().train()
    steps = epochs * (len(pictures) // BATCH)
    optimizer = torch.optim.AdamW(model.parameters(), RATE, weight_decay=1e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, steps)
    for epoch in range(epochs):
        order, total = torch.randperm(len(pictures)), 0.0
        for start in range(0, len(order) - BATCH + 1, BATCH):
            some = order[start : start + BATCH]
            batch, answer, valid = pictures[some], wanted[some], counts[some]
            loss = loss_of(model(batch), answer, valid)
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            schedule.step()
            total += loss.item()
        print(f"epoch {epoch + 1:2} of {epochs}: loss {total * BATCH / len(order):.3f}", flush=True)
    return model.eval()


def folded(model: nn.Sequential) -> list[tuple[Floats, Floats]]:
    """Return the convolutions' weights and biases, with each batch normalization merged into its convolution."""
    weights: list[tuple[Floats, Floats]] = []
    parts: list[Any] = list(model)
    for number, part in enumerate(parts):
        if not isinstance(part, nn.Conv2d):
            continue
        weight = part.weight.detach().numpy()
        if part.bias is not None:
            weights.append((weight.copy(), part.bias.detach().numpy().copy()))
            continue
        norm = parts[number + 1]
        scale = (norm.weight / torch.sqrt(norm.running_var + norm.eps)).detach().numpy()
        shift = norm.bias.detach().numpy() - scale * norm.running_mean.numpy()
        weights.append((weight * scale[:, np.newaxis, np.newaxis, np.newaxis], shift))
    return weights


def promised() -> float:
    """Return the accuracy that the committed provenance promises, or 0 if there is no provenance yet."""
    if not PROVENANCE_FILE.is_file():
        return 0.0
    found: float = tomllib.loads(PROVENANCE_FILE.read_text(encoding="utf-8"))["accuracy"]["told"]
    return found


def main(arguments: list[str] | None = None) -> int:
    """Train a network and measure its accuracy. Return exit code 0 if it reaches the promised accuracy, or 1 if not."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--write", action="store_true", help="replace the committed network")
    parser.add_argument("--told", type=float, help="the accuracy to promise from now on, with --write")
    options = parser.parse_args(arguments)
    began = time.monotonic()
    torch.manual_seed(SEED)
    torch.set_num_threads(2)
    print(f"rendering {IMAGES} images (seed {SEED}) ...", flush=True)
    weights = folded(trained(examples()))
    reached = accuracy(DeskDetector(TorchNetwork(weights)))
    wanted = options.told if options.told is not None else promised()
    print(f"{reached.words()}, in {time.monotonic() - began:.0f} s; promised: {wanted}")
    if options.write:
        write_files(weights, FOLDER, provenance(reached, wanted))
    return 0 if reached.right >= wanted else 1


def provenance(reached: Accuracy, wanted: float) -> dict[str, dict[str, Any]]:
    """Return the weights' provenance as TOML tables."""
    return {
        "training": {
            "command": "python -m workbook.models.train --write",
            "seed": SEED,
            "images": IMAGES,
            "epochs": EPOCHS,
            "batch": BATCH,
            "torch": str(torch.__version__),
        },
        "accuracy": {
            "images_held_back": IMAGES_HELD_BACK,
            "reached": round(reached.right, 4),
            "found": round(reached.found, 4),
            "false": round(reached.false, 4),
            "told": wanted,
        },
    }


if __name__ == "__main__":
    sys.exit(main())
