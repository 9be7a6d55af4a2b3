"""A trained detector for the toys on the desk, and what trained it. No ROS: NumPy and ONNX Runtime only.

`workbook.models.train` trains it again (`make model`) and needs PyTorch; nothing else here does unless it is asked to.
"""

from workbook.models.detection import LABELS, Detection
from workbook.models.detector import DeskDetector

__all__ = ["LABELS", "DeskDetector", "Detection"]
