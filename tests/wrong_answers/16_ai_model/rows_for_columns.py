# Exchanges columns and rows.
# loses: right
# cause: right.rows-for-columns
# replaces: marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)  # pixels
marker.pose.position.x, marker.pose.position.y = float(one.v), float(one.u)
