# Parks, and then begins the next night at once.
# loses: ends_cleanly, node_gone
# cause: ends-cleanly.walks-on
# after:     rclpy.try_shutdown()
main(args)
