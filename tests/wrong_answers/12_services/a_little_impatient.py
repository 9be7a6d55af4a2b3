# Gives up after 0.73 s, so an answer that takes 0.8 s is lost.
# loses: unanswered_told
# also: results_told
# cause: unanswered-told.always-early, results-told.given-up-early
# on: right/asyncio_beside_a_spinning_thread.py
# replaces: success = await asyncio.wait_for(node.ask(asyncio.get_running_loop()), timeout=1.5)
success = await asyncio.wait_for(node.ask(asyncio.get_running_loop()), timeout=0.73)
