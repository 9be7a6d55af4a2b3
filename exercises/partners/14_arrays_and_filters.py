"""The robot with noisy encoders. Exercise 14's program filters its joint angles."""

from lesson_nodes.noisy_joints import main

if __name__ == "__main__":
    main()
