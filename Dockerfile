# The students' course in one image, for amd64. environment.md (Docker) explains how to use it, and lists what we tested.
#
#     docker build --tag rclpy-workbook .
#     docker run --rm --publish 127.0.0.1:8888:8888 --volume robots:/home/student/robots rclpy-workbook

FROM debian:bookworm-slim AS build
RUN apt-get update \
 && apt-get install --yes --no-install-recommends ca-certificates git make python3 python3-venv
COPY . /course
WORKDIR /course
RUN make dist
# Install exactly the packages that the course is tested with. Their lock file is in the wheel.
RUN python3 -m venv /opt/workbook \
 && /opt/workbook/bin/pip install --no-cache-dir --no-deps dist/*.whl \
 && /opt/workbook/bin/pip install --no-cache-dir --no-deps --require-hashes \
        --requirement /opt/workbook/lib/python3.11/site-packages/workbook/course/requirements.lock \
 && /opt/workbook/bin/pip uninstall --yes pip setuptools \
 && /opt/workbook/bin/python3 -m workbook.lab.jupyter_files

FROM debian:bookworm-slim
RUN apt-get update \
 && apt-get install --yes --no-install-recommends bubblewrap python3 \
 && rm -rf /var/lib/apt/lists/* \
 && useradd --create-home --uid 1000 --shell /bin/bash student \
 && install --directory --owner=student --group=student /home/student/robots
COPY --from=build /opt/workbook /opt/workbook
ENV PATH=/opt/workbook/bin:$PATH LANG=C.UTF-8
USER student
WORKDIR /home/student/robots
VOLUME /home/student/robots
EXPOSE 8888
HEALTHCHECK --interval=30s --timeout=5s --start-period=60s \
    CMD ["python", "-c", "from urllib.request import urlopen; urlopen('http://127.0.0.1:8888/api', timeout=4)"]
# This command prints the address to open, including its token.
CMD ["rclpy-workbook", "lab", "--no-browser", "--ip=0.0.0.0", "--port=8888"]
