"""Detect toys on a desk with a trained network, retrain it, and simulate a robot that falls. Nothing here needs ROS.

`workbook.models.train` trains the network again (`make model`), which needs PyTorch. Nothing else here needs PyTorch,
unless you create a `TorchNetwork`.
"""

from workbook.models.detection import LABELS, Detection
from workbook.models.detector import DeskDetector

__all__ = ["LABELS", "DeskDetector", "Detection"]
