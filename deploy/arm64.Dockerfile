# The course for students on ARM (Apple silicon, Raspberry Pi). There are no rclpy wheels for ARM, so we use ROS's own
# image, which has rclpy from apt. We haven't run this file yet; see environment.md. First build the course's wheel on an
# x86_64 machine with `make dist`.
#
#     docker build --platform linux/arm64 --file deploy/arm64.Dockerfile --tag rclpy-workbook .
#     docker run --rm --publish 127.0.0.1:8888:8888 --volume robots:/home/student/robots rclpy-workbook

FROM ros:jazzy-ros-core
RUN apt-get update \
 && apt-get install --yes --no-install-recommends bubblewrap python3-venv ros-jazzy-common-interfaces \
 && rm -rf /var/lib/apt/lists/*
COPY dist/*.whl /tmp/
# The wheel requires the ROS wheels, so pip installs it without dependencies. rclpy is a system package here.
RUN python3 -m venv --system-site-packages /opt/workbook \
 && /opt/workbook/bin/pip install --no-cache-dir 'argcomplete>=3.6' 'ipykernel>=7' 'ipywidgets>=8.1' 'jinja2>=3.1' \
        'jsonschema<4.25' 'jupyterlab>=4.4,<5' 'matplotlib>=3.10' 'mypy>=1.18' 'numpy>=2' 'onnxruntime>=1.23' \
        'opencv-python-headless>=4.13' 'scikit-learn>=1.6' 'scipy>=1.15' \
 && /opt/workbook/bin/pip install --no-cache-dir --no-deps /tmp/*.whl \
 && rm /tmp/*.whl
# Ubuntu's image already has a user with the ID 1000.
RUN userdel --remove ubuntu \
 && useradd --create-home --uid 1000 --shell /bin/bash student \
 && install --directory --owner=student --group=student /home/student/robots
# ROS's entry point sources setup.bash, which sets rclpy's paths. This step has to source setup.sh itself.
RUN . /opt/ros/jazzy/setup.sh && /opt/workbook/bin/python3 -m workbook.lab.jupyter_files
ENV PATH=/opt/workbook/bin:$PATH LANG=C.UTF-8
USER student
WORKDIR /home/student/robots
VOLUME /home/student/robots
EXPOSE 8888
HEALTHCHECK --interval=30s --timeout=5s --start-period=60s \
    CMD ["python3", "-c", "from urllib.request import urlopen; urlopen('http://127.0.0.1:8888/api', timeout=4)"]
CMD ["rclpy-workbook", "lab", "--no-browser", "--ip=0.0.0.0", "--port=8888"]
