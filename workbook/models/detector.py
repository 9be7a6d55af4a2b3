"""Detect the objects on the desk in an image."""

import numpy as np
import numpy.typing as npt

from workbook.models.detection import Detection, Floats, decoded
from workbook.models.networks import HEIGHT, WIDTH, Network, OnnxNetwork

THRESHOLD = 0.5


def to_input(image: npt.NDArray[np.uint8]) -> Floats:
    """Convert an image to the network's input: numbers from 0 to 1, color channels first, shape (1, 3, 120, 160).

    `image`: RGB, uint8, shape (120 n, 160 n, 3). Each block of n by n pixels is averaged. Raises ValueError if the
    image has another shape or type.
    """
    if not isinstance(image, np.ndarray) or image.dtype != np.uint8:
        raise ValueError(
            f"The image is an array of uint8, not {getattr(image, 'dtype', type(image).__name__)}."
        )
    factor = image.shape[0] // HEIGHT if image.ndim == 3 else 0
    if factor < 1 or image.shape != (factor * HEIGHT, factor * WIDTH, 3):
        raise ValueError(
            f"The shape of the image is (120 n, 160 n, 3), for example (480, 640, 3), not {image.shape}."
        )
    sums = np.zeros((HEIGHT, WIDTH, 3), dtype=np.uint32)
    for row in range(factor):
        for column in range(factor):
            sums += image[row::factor, column::factor]
    pixels = sums.transpose(2, 0, 1)[np.newaxis] * np.float32(1.0 / (255.0 * factor * factor))
    return np.ascontiguousarray(pixels, dtype=np.float32)


class DeskDetector:
    """Detects balls, bricks, cups, and plates in an image of the desk. Its constructor loads the network.

    `network`: the network to run; by default, `OnnxNetwork`. `threshold`: detections with a lower score are dropped.
    """

    def __init__(self, network: Network | None = None, threshold: float = THRESHOLD) -> None:
        self._network = OnnxNetwork() if network is None else network
        self.threshold = threshold

    def __call__(self, image: npt.NDArray[np.uint8]) -> list[Detection]:
        """Return the detections in an image (see `to_input`), highest score first.

        Raises ValueError for a wrong shape or type.
        """
        pixels = to_input(image)
        return decoded(self._network(pixels)[0], self.threshold, image.shape[0] // HEIGHT)
