"""Write trained weights to a NumPy file and an ONNX file, and their provenance to a TOML file."""

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from workbook.models.detection import STRIDE, Floats
from workbook.models.networks import CHANNELS, HEIGHT, LAYERS, ONNX_FILE, PROVENANCE_FILE, WEIGHTS_FILE, WIDTH

OPSET = 17


def write_files(
    weights: Sequence[tuple[Floats, Floats]], folder: Path, provenance: Mapping[str, Mapping[str, Any]]
) -> None:
    """Write the weights (.npz), the network (.onnx), and a TOML file with the provenance and the files' hashes."""
    arrays = {}
    for number, (weight, bias) in enumerate(weights):
        arrays[f"weight_{number}"], arrays[f"bias_{number}"] = weight, bias
    np.savez(folder / WEIGHTS_FILE.name, **arrays)  # type: ignore[arg-type]
    (folder / ONNX_FILE.name).write_bytes(onnx_model(weights).SerializeToString())
    written = {name: sha256(folder / name) for name in (ONNX_FILE.name, WEIGHTS_FILE.name)}
    lines = ["# Written by workbook/models/train.py."]
    for table, entries in {**provenance, "sha256": written}.items():
        lines += ["", f"[{table}]", *(f"{_key(key)} = {json.dumps(value)}" for key, value in entries.items())]
    (folder / PROVENANCE_FILE.name).write_text("\n".join(lines) + "\n", encoding="utf-8")


def sha256(path: Path) -> str:
    """Return a file's SHA-256 hash in hexadecimal."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def _key(name: str) -> str:
    return json.dumps(name) if "." in name else name


def onnx_model(weights: Sequence[tuple[Floats, Floats]]) -> Any:
    """Return the network as an ONNX model that accepts any number of images, all of the same fixed size."""
    nodes, stored, values = [], [], "pixels"
    for number, (layer, (weight, bias)) in enumerate(zip(LAYERS, weights, strict=True)):
        last = number == len(LAYERS) - 1
        stored += [numpy_helper.from_array(np.ascontiguousarray(weight, np.float32), f"weight_{number}")]
        stored += [numpy_helper.from_array(np.ascontiguousarray(bias, np.float32), f"bias_{number}")]
        result = "maps" if last else f"sum_{number}"
        convolution = helper.make_node(
            "Conv",
            [values, f"weight_{number}", f"bias_{number}"],
            [result],
            strides=[layer.stride] * 2,
            pads=[layer.padding] * 4,
            dilations=[layer.dilation] * 2,
        )
        nodes.append(convolution)
        if not last:
            values = f"values_{number}"
            nodes.append(helper.make_node("Relu", [result], [values]))
    shape_in = ["pictures", 3, HEIGHT, WIDTH]
    shape_out = ["pictures", CHANNELS[-1], HEIGHT // STRIDE, WIDTH // STRIDE]
    graph = helper.make_graph(
        nodes,
        "desk_detector",
        [helper.make_tensor_value_info("pixels", TensorProto.FLOAT, shape_in)],
        [helper.make_tensor_value_info("maps", TensorProto.FLOAT, shape_out)],
        stored,
    )
    model = helper.make_model(
        graph, producer_name="rclpy-workbook", opset_imports=[helper.make_opsetid("", OPSET)], ir_version=8
    )
    onnx.checker.check_model(model)
    return model
