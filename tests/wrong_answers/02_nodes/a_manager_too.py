# A node too many, outside of the namespace.
# loses: nobody_else
# cause: nobody-else.outside-namespace
# says: /camera_manager
# replaces: return [front, rear]
return [Node("camera_manager"), front, rear]
