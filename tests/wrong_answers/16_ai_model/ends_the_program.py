# The exception of the model ends the executor, and the program with it.
# loses: survives, fall_reported
# cause: survives.ended
# on: right/groups_and_threads.py
# replaces: try:
# replaces:     found = self.model(rgb)
# replaces: except Exception:
# replaces:     self.get_logger().error("no detections for this picture", once=False)
# replaces:     import traceback
# replaces:
# replaces:     self.get_logger().error(traceback.format_exc())
# replaces:     return
found = self.model(rgb)
