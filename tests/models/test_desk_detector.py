"""The committed detector: its origin, its accuracy, and its errors on wrong images."""

import subprocess
import sys
import tomllib
from dataclasses import astuple
from hashlib import sha256

import numpy as np
import pytest

from workbook.models import DeskDetector, Detection
from workbook.models.accuracy import accuracy
from workbook.models.detection import decoded
from workbook.models.detector import to_input
from workbook.models.networks import (
    FOLDER,
    HEIGHT,
    LAYERS,
    ONNX_FILE,
    PROVENANCE_FILE,
    WIDTH,
    KerasNetwork,
    Network,
    OnnxNetwork,
    TorchNetwork,
    read_weights,
)
from workbook.scenes.desk import DeskCamera
from workbook.scenes.painting import Picture
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.tabletop import LABELS, tabletop

PROVENANCE = tomllib.loads(PROVENANCE_FILE.read_text(encoding="utf-8"))
KEPT_BACK = 23


def picture(number: int, width: int = WIDTH) -> Picture:
    pinhole = Pinhole(width, 3 * width // 4, 0.875 * width)
    return DeskCamera(pinhole, KEPT_BACK).picture(tabletop(KEPT_BACK, number), number)


def pictures(number: int) -> np.ndarray:
    return np.concatenate([to_input(picture(one)) for one in range(number)])


def by_hand(pixels: np.ndarray) -> np.ndarray:
    """Run the network with NumPy and loops over the kernel only."""
    values = pixels.astype(np.float64)
    for number, (layer, (weight, bias)) in enumerate(zip(LAYERS, read_weights(), strict=True)):
        around = [(0, 0), (0, 0), (layer.padding, layer.padding), (layer.padding, layer.padding)]
        padded = np.pad(values, around)
        rows, columns = (length // layer.stride for length in values.shape[2:])
        sums = np.zeros((len(values), len(weight), rows, columns))
        for row in range(layer.kernel):
            for column in range(layer.kernel):
                first, left = layer.dilation * row, layer.dilation * column
                part = padded[:, :, first:, left:][:, :, :: layer.stride, :: layer.stride][
                    ..., :rows, :columns
                ]
                sums += np.einsum("oi,nirc->norc", weight[:, :, row, column], part)
        values = sums + bias[:, np.newaxis, np.newaxis]
        if number < len(LAYERS) - 1:
            values = np.maximum(values, 0.0)
    return values


def test_the_provenance_names_the_committed_files() -> None:
    assert set(PROVENANCE["sha256"]) == {"desk_detector.onnx", "desk_detector.npz"}
    for name, told in PROVENANCE["sha256"].items():
        assert sha256((FOLDER / name).read_bytes()).hexdigest() == told, name
    assert ONNX_FILE.stat().st_size < 400_000


def test_the_committed_detector_is_as_good_as_told() -> None:
    found = accuracy(DeskDetector())
    assert found.right >= PROVENANCE["accuracy"]["told"] >= 0.9
    assert found.right == pytest.approx(PROVENANCE["accuracy"]["reached"], abs=0.005)


def test_wrong_color_order_and_wrong_scaling_cost_accuracy() -> None:
    right = accuracy(DeskDetector(), 60).right
    swapped = accuracy(DeskDetector(), 60, lambda image: np.ascontiguousarray(image[..., ::-1])).right
    assert swapped < right / 2
    network = OnnxNetwork()
    assert accuracy(DeskDetector(lambda pixels: network(255 * pixels)), 60).right < right / 2


def test_onnx_runtime_computes_what_the_weights_say() -> None:
    pixels = pictures(2)
    assert OnnxNetwork()(pixels) == pytest.approx(by_hand(pixels), abs=1e-3)


@pytest.mark.parametrize(("module", "network"), [("torch", TorchNetwork), ("keras", KerasNetwork)])
def test_other_libraries_run_the_same_network(module: str, network: type[Network]) -> None:
    pytest.importorskip(module)
    other = network()
    assert other(pictures(3)) == pytest.approx(OnnxNetwork()(pictures(3)), abs=1e-3)
    detector = DeskDetector(other)
    labels = [[(one.label, round(one.u)) for one in detector(picture(number))] for number in range(5)]
    own = DeskDetector()
    assert labels == [[(one.label, round(one.u)) for one in own(picture(number))] for number in range(5)]
    assert any(labels)


def test_batches_give_what_single_pictures_give() -> None:
    network, pixels = OnnxNetwork(), pictures(3)
    singly = np.concatenate([network(one[np.newaxis]) for one in pixels])
    assert network(pixels) == pytest.approx(singly, abs=1e-4)


def test_detections_are_in_pixels_of_the_image_and_sorted() -> None:
    detector = DeskDetector()
    small, large = (detector(picture(4, width)) for width in (160, 640))
    assert [one.label for one in small] and {one.label for one in small} <= set(LABELS)
    scores = [one.score for one in small]
    assert scores == sorted(scores, reverse=True)
    places = {(one.label, round((one.u + 0.5) / 40), round((one.v + 0.5) / 40)) for one in large}
    assert len(places) == len(large) == len(small)
    by_place = {label: sorted(one.width for one in large if one.label == label) for label in LABELS}
    for label in LABELS:
        widths = [4 * one.width for one in small if one.label == label]
        assert by_place[label] == pytest.approx(sorted(widths), rel=0.25)


def test_the_middle_of_a_square_and_its_place() -> None:
    maps = np.full((8, 30, 40), -9.0, dtype=np.float32)
    maps[:, 10, 20] = (-9.0, 3.0, -9.0, -9.0, 0.25, -0.5, np.log(12.0), np.log(6.0))
    maps[1, 10, 21] = 2.0  # less confident, and next to it
    (found,) = decoded(maps, 0.5, 2)
    assert found.label == "brick"
    wanted = (1 / (1 + np.exp(-3.0)), 2 * (81.0 + 0.5) - 0.5, 2 * (38.0 + 0.5) - 0.5, 24.0, 12.0)
    assert astuple(found)[1:] == pytest.approx(wanted)
    assert decoded(maps, 0.99, 2) == []


def test_the_input_is_the_mean_of_pixels_color_first() -> None:
    image = np.random.default_rng(1).integers(0, 256, (240, 320, 3), dtype=np.uint8)
    means = image.reshape(120, 2, 160, 2, 3).mean(axis=(1, 3)).transpose(2, 0, 1) / 255
    assert to_input(image)[0] == pytest.approx(means, abs=1e-6)


@pytest.mark.parametrize(
    ("image", "words"),
    [
        (np.zeros((HEIGHT, WIDTH), np.uint8), r"not \(120, 160\)"),
        (np.zeros((HEIGHT, WIDTH, 4), np.uint8), r"not \(120, 160, 4\)"),
        (np.zeros((3, HEIGHT, WIDTH), np.uint8), r"not \(3, 120, 160\)"),
        (np.zeros((WIDTH, HEIGHT, 3), np.uint8), r"not \(160, 120, 3\)"),
        (np.zeros((100, 100, 3), np.uint8), r"not \(100, 100, 3\)"),
        (np.zeros((HEIGHT, WIDTH, 3), np.float32), "not float32"),
        ([1, 2], "not list"),
        (np.zeros((), np.uint8), r"not \(\)"),
    ],
)
def test_other_images_are_refused(image: np.ndarray, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        DeskDetector()(image)


def test_a_detection_cannot_be_changed() -> None:
    with pytest.raises(AttributeError):
        Detection("cup", 0.9, 1.0, 2.0, 3.0, 4.0).score = 1.0  # type: ignore[misc]


def test_training_learns_and_tells_when_it_is_not_good_enough() -> None:
    pytest.importorskip("torch")
    code = (
        "from workbook.models import train; train.IMAGES, train.EPOCHS = 64, 1;"
        "data = train.examples(64); model = train.trained(data, 1); train.examples = lambda: data;"
        "train.trained = lambda _: model; raise SystemExit(train.main([]))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 1, done.stderr
    assert "promised: 0.9" in done.stdout
