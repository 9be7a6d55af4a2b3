#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds an autograder's image. It installs the packages in the lock file.
set -euo pipefail

root="${AUTOGRADER_ROOT:-/autograder}"
course="${AUTOGRADER_COURSE:-$root/source/course}"
fits='import sys, ensurepip, venv; sys.exit(not (3, 11) <= sys.version_info < (3, 15))'

suitable() {
    for name in python3.12 python3.13 python3.11 python3.14 python3; do
        if "$name" -I -c "$fits" >/dev/null 2>&1; then
            command -v "$name"
            return
        fi
    done
}

export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
apt-get install -y -qq --no-install-recommends bubblewrap ca-certificates python3 python3-pip python3-venv

python="$(suitable)"
if [ -z "$python" ]; then
    for version in 3.12 3.13 3.11; do
        if apt-get install -y -qq --no-install-recommends "python$version" "python$version-venv"; then
            break
        fi
    done
    python="$(suitable)"
fi
if [ -z "$python" ]; then
    # The image has no Python version that the wheels support, so uv installs one, in a folder that everyone may read.
    export UV_PYTHON_INSTALL_DIR=/opt/python
    python3 -m pip install --quiet uv
    python3 -m uv python install 3.12
    python="$(python3 -m uv python find 3.12)"
fi

"$python" -I "$course/workbook/lab/bootstrap.py" --chosen-python
"$course/.venv/bin/python" -c "import rclpy"
