# Takes 8UC3 for bgr8, as cv_bridge does where it is asked to.
# loses: refuses_others
# cause: refuses-others.guesses
# replaces: TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV}
TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV, "8UC3": cv2.COLOR_BGR2HSV}
