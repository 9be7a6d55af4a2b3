"""Isolated answers can still use OpenCV, ONNX Runtime, and PyTorch within the default limits."""

import importlib.util
from collections.abc import Iterator
from pathlib import Path

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.feedback.text import as_text
from workbook.grading.slots.client import Slot
from workbook.isolation.bubblewrap import sandbox_problem

pytestmark = [pytest.mark.sandbox, pytest.mark.slow, pytest.mark.whole]
ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
OPENCV = """
import cv2
import numpy as np
cv2.setNumThreads(@@THREADS@@)
image = (np.random.default_rng(1).random((1080, 1920, 3)) * 255).astype(np.uint8)
edges = cv2.Canny(cv2.GaussianBlur(image, (9, 9), 0), 50, 150)
assert edges.shape == (1080, 1920) and edges.any()
"""
ONNX_RUNTIME = """
import numpy as np
import onnxruntime

def part(number, content):
    # One field of a message of Protocol Buffers: bytes, text, or a small number.
    if isinstance(content, int):
        return bytes((number << 3, content))
    content = content.encode() if isinstance(content, str) else content
    assert len(content) < 128
    return bytes((number << 3 | 2, len(content))) + content

def value(name):
    return part(1, name) + part(2, part(1, part(1, 1) + part(2, part(1, part(1, 3)))))

node = part(1, "x") + part(2, "y") + part(4, "Relu")
graph = part(1, node) + part(2, "g") + part(11, value("x")) + part(12, value("y"))
model = part(1, 8) + part(7, graph) + part(8, part(2, 13))
options = onnxruntime.SessionOptions()
options.intra_op_num_threads = @@THREADS@@
session = onnxruntime.InferenceSession(model, options, providers=["CPUExecutionProvider"])
[found] = session.run(None, {"x": np.array([-1, 0, 2], dtype=np.float32)})
assert found.tolist() == [0, 0, 2], found
"""
PYTORCH = """
import torch
torch.set_num_threads(@@THREADS@@)
image = torch.rand(1, 3, 240, 320)
layer = torch.nn.Conv2d(3, 8, 3)
layer(image).relu().sum().backward()
assert layer.weight.grad is not None and (torch.rand(600, 600) @ torch.rand(600, 600)).min() > 0
"""
PROGRAMS = {"cv2": OPENCV, "onnxruntime": ONNX_RUNTIME, "torch": PYTORCH}
THREADS = (1, 2, 64)


@pytest.fixture(scope="module")
def slot() -> Iterator[Slot]:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    with Slot("sandbox") as slot:
        yield slot


@pytest.mark.parametrize("threads", THREADS)
@pytest.mark.parametrize("library", PROGRAMS)
def test_a_right_answer_that_uses_a_library_gets_full_marks(library: str, threads: int, slot: Slot) -> None:
    """With too many threads, the kernel refuses one if it counts them. The feedback names the limit and the remedy."""
    if importlib.util.find_spec(library) is None:
        pytest.skip(f"{library} is not installed")
    right = load_exercise(STEM, ROOT).source.solution_code
    program = PROGRAMS[library].replace("@@THREADS@@", str(threads))
    judgement = slot.judge(STEM, Answer(program + right), soak=False)
    told = as_text(judgement)
    assert judgement.recording is not None
    if threads == max(THREADS) and not judgement.full_marks:
        assert judgement.recording.process.limits_hit == ("processes",), judgement.recording.process.log
        assert "OMP_NUM_THREADS" in told, told
    else:
        assert judgement.full_marks, told + judgement.recording.process.log
