# Parks, and then begins the next night at once.
# loses: ends_cleanly, node_gone
# cause: ends-cleanly.walks-on
# replaces: main()
while True:
    main()
