#!/bin/sh
# Set up the course on a machine with ROS 2 Jazzy from apt (Ubuntu 24.04, including ARM), and open the lessons:
#
#     deploy/with_apt_ros.sh
#
# The environment is created in ~/rclpy-workbook-env, or in $WORKBOOK_ENV. See environment.md, "Ubuntu with apt".
set -eu
cd "$(dirname "$0")/.."
ros=/opt/ros/jazzy
env=${WORKBOOK_ENV:-$HOME/rclpy-workbook-env}

root=
[ "$(id -u)" = 0 ] || root=sudo
$root apt-get update --quiet
$root apt-get install --yes ros-jazzy-rclpy ros-jazzy-common-interfaces python3-venv

# ROS's setup script reads variables that may be unset.
set +u
# shellcheck disable=SC1091
. "$ros/setup.sh"
set -u

# The environment includes system packages, because rclpy is one of them.
[ -x "$env/bin/python" ] || python3 -m venv --system-site-packages "$env"
# Our package requires the ROS wheels, so pip installs it without dependencies.
"$env/bin/pip" install --quiet 'argcomplete>=3.6' flit_core 'ipykernel>=7' 'ipywidgets>=8.1' 'jinja2>=3.1' \
	'jsonschema<4.25' 'jupyterlab>=4.4,<5' 'matplotlib>=3.10' 'mypy>=1.18' 'numpy>=2' 'onnxruntime>=1.23' \
	'opencv-python-headless>=4.13' 'scikit-learn>=1.6' 'scipy>=1.15'
"$env/bin/pip" install --quiet --no-deps --no-build-isolation --editable .
"$env/bin/python" -m workbook.lab.jupyter_files
exec "$env/bin/workbook" lab "$@"
