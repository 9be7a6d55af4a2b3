# Has no count yet when the very first sample is tilted.
# loses: detections_come, fall_reported
# cause: error.no-such-attribute
# says: 'DeskWatcher' object has no attribute 'tilted'
# replaces: self.tilted = 0  # samples in a row
