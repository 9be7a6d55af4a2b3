"""From text to notebooks: builds, runs and checks lessons and exercises. For authors; needs the `dev` extra."""
