# A rate in the loop of the main thread, and nobody spins.
# loses: none_missed, once_in_order, quick
# cause: none-missed.no-report
# on: starter
# replaces: receiving = threading.Thread(target=receive, args=(monitor,))
# replaces: receiving.start()
rate = monitor.create_rate(50)

# replaces: time.sleep(0.2)
rate.sleep()

# replaces: receiving.join()
