# Takes the right edge of the box around the ball for its middle.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.edge
# replaces: return sums["m10"] / sums["m00"], sums["m01"] / sums["m00"]
left, top, width, height = cv2.boundingRect(outline)
return left + width, top + height / 2
