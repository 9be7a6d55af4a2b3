# Never starts the thread that looks.
# loses: detections_come
# skips: stamps_kept, fresh, right, survives
# cause: detections-come.nothing
# replaces: threading.Thread(target=self.look, daemon=True).start()
