"""Run one small convolutional network in ONNX Runtime, PyTorch, or Keras, with the same weights.

ONNX Runtime is in every environment. `make env EXTRAS=torch` adds PyTorch, and `EXTRAS=tensorflow` adds Keras. Each
library is imported only when its class is instantiated. The input is RGB, float32 from 0 to 1, shape (images, 3, 120,
160). The output is float32, shape (images, labels + 4, 30, 40).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from workbook.models.detection import Floats

FOLDER = Path(__file__).parent
ONNX_FILE = FOLDER / "desk_detector.onnx"
WEIGHTS_FILE = FOLDER / "desk_detector.npz"
PROVENANCE_FILE = FOLDER / "desk_detector.toml"
HEIGHT, WIDTH = 120, 160


@dataclass(frozen=True)
class Layer:
    """A convolution. The network's last convolution is its output; all others are followed by max(0, x)."""

    kernel: int
    stride: int = 1
    dilation: int = 1

    @property
    def padding(self) -> int:
        """The number of zeros to add at each edge, so that only the stride changes the image size."""
        return self.dilation * (self.kernel // 2)


CHANNELS = (3, 16, 24, 24, 24, 24, 32, 8)
LAYERS = (
    Layer(3, stride=2),
    Layer(3, stride=2),
    Layer(3),
    Layer(3, dilation=2),
    Layer(3),
    Layer(3),
    Layer(1),
)


class Network(Protocol):
    """A callable network: it takes images, and returns the output maps (see `decoded` for their meaning)."""

    def __call__(self, pixels: Floats) -> Floats: ...


def read_weights(path: Path = WEIGHTS_FILE) -> list[tuple[Floats, Floats]]:
    """Return each layer's weights, shape (channels out, channels in, rows, columns), and its biases (channels out)."""
    with np.load(path, allow_pickle=False) as stored:
        return [(stored[f"weight_{n}"], stored[f"bias_{n}"]) for n in range(len(LAYERS))]


class OnnxNetwork:
    """The network in ONNX Runtime, which runs on the CPU in one thread."""

    def __init__(self, path: Path = ONNX_FILE) -> None:
        import onnxruntime

        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = options.inter_op_num_threads = 1
        self._session = onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])

    def __call__(self, pixels: Floats) -> Floats:
        maps: Floats = self._session.run(["maps"], {"pixels": pixels})[0]
        return maps


class TorchNetwork:
    """The same network in PyTorch."""

    def __init__(self, weights: Sequence[tuple[Floats, Floats]] | None = None) -> None:
        import torch

        self._torch: Any = torch
        self._layers = [
            (torch.from_numpy(weight.copy()), torch.from_numpy(bias.copy()))
            for weight, bias in weights or read_weights()
        ]

    def __call__(self, pixels: Floats) -> Floats:
        torch = self._torch
        with torch.inference_mode():
            values = torch.from_numpy(np.ascontiguousarray(pixels))
            for number, (layer, (weight, bias)) in enumerate(zip(LAYERS, self._layers, strict=True)):
                values = torch.nn.functional.conv2d(
                    values, weight, bias, layer.stride, layer.padding, layer.dilation
                )
                if number < len(LAYERS) - 1:
                    values = torch.relu(values)
            maps: Floats = values.numpy()
        return maps


class KerasNetwork:
    """The same network in Keras, on TensorFlow. Keras puts channels last, so images and maps are transposed."""

    def __init__(self, weights: Sequence[tuple[Floats, Floats]] | None = None) -> None:
        import keras

        stack: list[Any] = [keras.Input((HEIGHT, WIDTH, 3))]
        for number, layer in enumerate(LAYERS):
            stack.append(keras.layers.ZeroPadding2D(layer.padding))
            stack.append(
                keras.layers.Conv2D(
                    CHANNELS[number + 1],
                    layer.kernel,
                    strides=layer.stride,
                    dilation_rate=layer.dilation,
                    activation="relu" if number < len(LAYERS) - 1 else None,
                )
            )
        self._model = keras.Sequential(stack)
        self._model.set_weights(
            [
                part
                for weight, bias in weights or read_weights()
                for part in (weight.transpose(2, 3, 1, 0), bias)
            ]
        )

    def __call__(self, pixels: Floats) -> Floats:
        answer = self._model(pixels.transpose(0, 2, 3, 1), training=False)
        return np.ascontiguousarray(np.asarray(answer, dtype=np.float32).transpose(0, 3, 1, 2))
