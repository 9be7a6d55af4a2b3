# Sleeps for eight seconds before it spins.
# loses: heartbeat_kept
# cause: heartbeat-kept.begins-late
# replaces: threading.Thread(target=self.look, daemon=True).start()
threading.Thread(target=self.look, daemon=True).start()
threading.Event().wait(8.0)
