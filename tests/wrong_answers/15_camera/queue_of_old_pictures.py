# Takes 40 ms for each picture, and keeps a hundred of them.
# loses: keeps_up
# cause: keeps-up.queue-grows
# after: import math
import time
# replaces: self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)
self.create_subscription(Image, "/camera/image", self.on_image, 100)
# after: ball = find_ball(image)
time.sleep(0.04)
