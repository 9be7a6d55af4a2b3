"""Define the class for detections, and decode detections from the network's output."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from workbook.scenes.tabletop import LABELS as LABELS

Floats = npt.NDArray[np.float32]
STRIDE = 4
"""The number of input pixels, in each direction, that correspond to one square of the network's output."""


@dataclass(frozen=True)
class Detection:
    """One detected object: the center and the size of its bounding box, in pixels of the given image.

    `label`: one of `LABELS`. `score`: the network's confidence, from 0 to 1, which isn't a probability.
    """

    label: str
    score: float
    u: float
    v: float
    width: float
    height: float


def decoded(maps: Floats, threshold: float, factor: int) -> list[Detection]:
    """Return the detections in the network's output, highest score first.

    `maps`: shape (labels + 4, rows, columns). Each square has one number per label, the center's position within the
    square, and the logarithms of width and height. `threshold`: the lowest score to return. `factor`: the number of
    image pixels, in each direction, that correspond to one input pixel of the network.
    """
    scores = 1.0 / (1.0 + np.exp(np.minimum(-maps[: len(LABELS)], 80.0)))
    best = scores.max(axis=0)
    rows, columns = np.nonzero((best >= threshold) & (best == _largest_around(best)))
    found = []
    for row, column in zip(rows.tolist(), columns.tolist(), strict=True):
        right, down, wide, high = (float(one) for one in maps[len(LABELS) :, row, column])
        u, v = (STRIDE * (column + right), STRIDE * (row + down))
        found.append(
            Detection(
                LABELS[int(scores[:, row, column].argmax())],
                float(best[row, column]),
                factor * (u + 0.5) - 0.5,
                factor * (v + 0.5) - 0.5,
                factor * float(np.exp(min(wide, 5.0))),
                factor * float(np.exp(min(high, 5.0))),
            )
        )
    return sorted(found, key=lambda one: one.score, reverse=True)


def _largest_around(best: Floats) -> Floats:
    """Return the largest number among each square and its eight neighbors."""
    padded = np.pad(best, 1, constant_values=-1.0)
    rows, columns = best.shape
    shifted = [padded[i : i + rows, j : j + columns] for i in range(3) for j in range(3)]
    largest: Floats = np.max(shifted, axis=0)
    return largest
