# A node too many, in the namespace of the robot.
# loses: nobody_else
# cause: nobody-else.extra-node
# says: /robot/rig
# replaces: return [front, rear]
return [front, rear, Node("rig", namespace="/robot")]
