# score: 10
"""Has topics whose names break the rules of ROS, or are no text at all, by way of the C library. The right ones count."""
import ctypes
import time

import rclpy
from std_msgs.msg import String


class Time(ctypes.Structure):
    _fields_ = [("sec", ctypes.c_uint64), ("nsec", ctypes.c_uint64)]


class Quality(ctypes.Structure):
    _fields_ = [
        ("history", ctypes.c_int),
        ("depth", ctypes.c_size_t),
        ("reliability", ctypes.c_int),
        ("durability", ctypes.c_int),
        ("deadline", Time),
        ("lifespan", Time),
        ("liveliness", ctypes.c_int),
        ("lease", Time),
        ("as_it_is", ctypes.c_bool),
    ]


def publish_under(node, name):
    libraries = {line.split()[-1] for line in open("/proc/self/maps") if "/lib" in line}
    rcl = ctypes.CDLL(next(path for path in libraries if path.endswith("/librcl.so")))
    rmw = ctypes.CDLL(next(path for path in libraries if path.endswith("/librmw_fastrtps_cpp.so")))
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
    handle, create = rcl.rcl_node_get_rmw_handle, rmw.rmw_create_publisher
    handle.restype = create.restype = ctypes.c_void_p
    handle.argtypes = (ctypes.c_void_p,)
    create.argtypes = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_void_p)
    String.__class__.__import_type_support__()
    quality = ctypes.byref(Quality(1, 10, 1, 2, as_it_is=True))
    options = ctypes.create_string_buffer(64)
    kind = pointer(String._TYPE_SUPPORT, None)
    assert create(handle(node.handle.pointer), kind, name, quality, options), "there is no such topic"


context = rclpy.context.Context()
rclpy.init(context=context)
node = rclpy.create_node("beside", context=context, start_parameter_services=False)
for name in (b"rt/bad name", b"rt//a", b"rt/1x", "rt/\u00e4".encode(), b"rt/", b"rt/\x1b[31m"):
    publish_under(node, name)
time.sleep(1.0)
publish_under(node, b"rt/\xff\xfe")  # from now on nobody can list the topics
@@GOOD@@
