# Publishes a corner of the box in the place of its middle.
# loses: right
# cause: right.corner
# replaces: marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)  # pixels
marker.pose.position.x, marker.pose.position.y = one.u - one.width / 2, one.v - one.height / 2
