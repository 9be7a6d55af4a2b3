# Takes the center of gravity of everything that is orange.
# loses: direction_right, bgr_right, no_ball_said
# skips: light_changes, padding_right
# cause: direction.beside
# replaces: for outline in sorted(outlines, key=cv2.contourArea, reverse=True):
for outline in outlines[:1]:
# replaces: sums = cv2.moments(cv2.drawContours(np.zeros_like(orange), [outline], -1, 1, cv2.FILLED), True)
sums = cv2.moments(orange, True)
# replaces: if sums["m00"] >= SMALLEST and sums["m00"] >= ROUND * np.pi * (radius + 0.5) ** 2:
if sums["m00"] >= SMALLEST:
