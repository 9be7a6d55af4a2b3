"""A trained detector for the toys on the desk, what trained it, and samples of a robot that falls. No ROS.

`workbook.models.train` trains it again (`make model`) and needs PyTorch; nothing else here does unless it is asked to.
"""

from workbook.models.detection import LABELS, Detection
from workbook.models.detector import DeskDetector

__all__ = ["LABELS", "DeskDetector", "Detection"]
