# Reads gray pictures, too: nothing in them is orange.
# loses: refuses_others
# cause: refuses-others.says-no-ball
# replaces: if image.encoding not in TO_HSV:
if image.encoding not in (*TO_HSV, "mono8"):
# replaces: ball = find_ball(image)
ball = find_ball(image) if image.encoding in TO_HSV else None
