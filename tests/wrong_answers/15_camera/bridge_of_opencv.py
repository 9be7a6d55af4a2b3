# cv_bridge comes with a full installation of ROS 2, and isn't here.
# loses: program_runs
# cause: error.module-not-installed
# says: cv_bridge is part of a full ROS 2 installation
# says: np.frombuffer
# replaces: import cv2
import cv2
from cv_bridge import CvBridge
