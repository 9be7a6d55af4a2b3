# The pinhole model of a package that isn't here.
# loses: program_runs
# cause: error.module-not-installed
# says: image_geometry is part of a full ROS 2 installation
# replaces: import cv2
import cv2
from image_geometry import PinholeCameraModel
