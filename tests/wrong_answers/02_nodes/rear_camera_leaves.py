# Destroys the rear camera after its eighth picture.
# loses: rear_pictures, shared_faults
# cause: pictures.camera-gone
# says: /robot/rear_camera left the graph
# replaces: for camera in make_cameras():
front, rear = make_cameras()
for camera in (front, rear):

# replaces: executor.spin()
while rear.frames < 8:
    executor.spin_once()
executor.remove_node(rear)
rear.destroy_node()
executor.spin()
