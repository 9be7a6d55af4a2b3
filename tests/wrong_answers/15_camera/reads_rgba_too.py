# Reads rgba8 as well, by its first three bytes of four.
# loses: refuses_others
# cause: refuses-others.guesses
# replaces: TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV}
TO_HSV = {"rgb8": cv2.COLOR_RGB2HSV, "bgr8": cv2.COLOR_BGR2HSV, "rgba8": cv2.COLOR_RGB2HSV}
# replaces: rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
# replaces: pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
depth = 4 if image.encoding == "rgba8" else 3
pixels = rows[:, : depth * image.width].reshape(image.height, image.width, depth)[:, :, :3].copy()
