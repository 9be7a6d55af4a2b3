# Never empties its message.
# loses: stamps_kept
# skips: fresh, right
# cause: stamps-kept.several-pictures
# replaces: message = MarkerArray()
message = to_markers.__dict__.setdefault("message", MarkerArray())
# replaces: message.markers.append(marker)
message.markers = [*message.markers, marker][-12:]
