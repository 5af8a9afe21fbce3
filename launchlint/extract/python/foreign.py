"""Modules outside a program: which of them are known to make no names, or only those that are recognised by themselves.

Whatever is not listed here, is no part of Python and no message could talk: a program that calls it is open. Modules that talk and of
which it is known how are in :mod:`launchlint.extract.python.models`.
"""

from __future__ import annotations

import re
import sys

_ROS = frozenset(
    """
    rospy roslib rosgraph rospkg genpy genmsg gencpp catkin catkin_pkg roscpp rosunit rostest rosmake rosclean rosdep rosdistro rosmsg
    roswtf rosbag rosparam rosnode rosservice rosidl_runtime_py xmlrpc
    message_filters actionlib dynamic_reconfigure diagnostic_updater bondpy smach smach_ros smclib
    tf tf2_ros tf2_py tf2_geometry_msgs tf2_sensor_msgs tf2_kdl tf_conversions PyKDL pykdl eigen_conversions angles geodesy laser_geometry
    transforms3d quaternion
    cv_bridge image_geometry camera_calibration_parsers ros_numpy numpy_ros ros2_numpy pcl
    interactive_markers unique_id resource_retriever xacro urdf urdf_parser_py srdfdom kdl_parser_py hrl_geom
    rospy_message_converter genjava py_trees qt_gui qt_dotgraph rqt_gui rqt_gui_py python_qt_binding
    ament_index_python ament_package launch osrf_pycommon
    """.split()
)
"""Packages of ROS; those of their calls that make names are recognised."""

_OTHERS = frozenset(
    """
    numpy scipy matplotlib mpl_toolkits pylab pandas sympy sklearn skimage statsmodels numba cython networkx shapely pyproj utm geopy
    haversine pymap3d pykalman filterpy cma nlopt cvxopt cvxpy osqp quadprog casadi qpsolvers simple_pid pyswarm deap rtree pygraphviz
    graphviz pydot igraph mvpa2 ghmm hmmlearn svmutil svm libsvm joblib tqdm pint uncertainties quaternionic pyquaternion
    numpy_quaternion squaternion transformations tf_transformations pyassimp trimesh open3d meshio stl pybullet mujoco openravepy
    openravepy_int fcl pinocchio crocoddyl scikits seaborn plotly bokeh pyqtgraph vispy mayavi h5py ezdxf pykml fastkml gpxpy simplekml

    torch torchvision torchaudio torch_geometric tensorflow tensorflow_hub tflite_runtime keras theano caffe caffe2 mxnet chainer onnx
    onnxruntime tensorrt pycuda cupy jax flax transformers ultralytics yolov5 detectron2 mmcv mmdet timm einops albumentations imgaug
    imutils dlib face_recognition mediapipe facenet_pytorch segmentation_models_pytorch segment_anything supervision gym gymnasium
    stable_baselines3 diffusers huggingface_hub gdown
    packaging openai anthropic langchain nltk spacy gensim fuzzywuzzy rapidfuzz whisper faster_whisper vosk pocketsphinx
    sphinxbase speech_recognition aiml chatterbot rasa gtts pyttsx pyttsx3 espeak snowboydecoder

    cv cv2 PIL Image imageio exifread piexif pyzbar zbar pytesseract easyocr qrcode apriltag dt_apriltags pupil_apriltags picamera
    picamera2 uvc pyrealsense2 freenect pylepton seekcamera pypylon vimba PyCapture2 depthai depthai_sdk pyzed sl v4l2 av ffmpeg moviepy
    gphoto2

    pyaudio sounddevice soundcard soundfile librosa alsaaudio pyalsaaudio webrtcvad pydub simpleaudio playsound vlc wavio audioread
    pygst gst

    yaml ruamel json5 simplejson ujson jsonpickle jsonschema cerberus msgpack cbor cbor2 toml tomli tomlkit configobj lxml bs4 xmltodict
    defusedxml jinja2 empy em mako markdown docutils sphinx google protobuf flatbuffers bson h11 pyparsing parse regex lark ply antlr4
    dateutil pytz tzlocal arrow humanize openpyxl xlrd xlwt docx reportlab PyPDF2

    serial smbus smbus2 spidev RPi RPIO pigpio gpiozero Jetson Adafruit_GPIO Adafruit_BBIO Adafruit_PCA9685 Adafruit_MotorHAT
    Adafruit_PWM_Servo_Driver Adafruit_ADS1x15 Adafruit_SSD1306 adafruit_servokit adafruit_motorkit adafruit_pca9685 adafruit_bno055
    adafruit_bus_device adafruit_blinka board busio digitalio neopixel rpi_ws281x mraa wiringpi wiringpi2 smbus_cffi periphery gpiod i2c
    evdev uinput pynput keyboard inputs hid usb libusb1 pyudev bluetooth bleak gatt pexpect ptyprocess can cantools canopen pymodbus
    minimalmodbus modbus_tk snap7 opcua asyncua pycomm3 dynamixel_sdk pypot pyfirmata ax12 lx16a odrive pyvesc roboclaw sbp pynmea2
    pynmea ublox pyubx2 pyrtcm gps gpsd xsensdeviceapi mscl smopy rplidar pysicktoolbox hokuyo ouster velodyne_decoder pyhesai spnav
    cwiid xwiimote sfml pygame Xlib pyautogui screeninfo micropython dronekit dronekit_sitl pymavlink MAVProxy mavsdk uavcan dronecan
    cflib px4tools pyulog naoqi qi almath vision_definitions stretch_body

    requests requests_futures grequests urllib3 httpx aiohttp websocket websockets tornado twisted autobahn flask flask_cors
    flask_socketio socketio engineio django fastapi uvicorn bottle cherrypy gevent eventlet greenlet zmq nanomsg paho pika redis pymongo
    mongoengine sqlalchemy psycopg2 MySQLdb pymysql peewee influxdb boto boto3 botocore azure firebase_admin pyrebase slackclient
    telegram telepot tweepy twilio paramiko fabric netifaces scapy pyftpdlib ipinfo statsd sentry_sdk raven prometheus_client dns
    networktables ntcore wpilib wpimath ftputil

    PyQt4 PyQt5 PyQt6 PySide PySide2 PySide6 sip qtpy wx wxversion gi gtk gobject glib pygtk dbus kivy tkFileDialog ScrolledText
    ttkthemes pyglet OpenGL glfw moderngl bpy vtk urwid npyscreen blessed blessings curtsies prompt_toolkit

    pytest nose mock hypothesis parameterized coverage tox pylint flake8 mypy setuptools pkg_resources pip wheel past builtins future
    six typing_extensions attr attrs dataclasses enum34 futures trollius decorator wrapt toolz more_itertools sortedcontainers bidict
    frozendict cachetools diskcache munch addict easydict box traitlets pydantic marshmallow transitions pluggy click typer fire docopt
    argcomplete configargparse colorama termcolor colored colorlog coloredlogs loguru tabulate prettytable texttable rich progressbar
    progress psutil pyinotify watchdog schedule apscheduler filelock portalocker setproctitle sh git github gitlab docker vcstools
    wstool memory_profiler line_profiler guppy objgraph pympler debugpy ptvsd pydevd ipdb IPython ipykernel ipywidgets jupyter distro
    debian apt enchant popen2 faulthandler backports contextlib2 subprocess32 monotonic pathlib2 cffi pybind11 boost
    """.split()
)
"""Packages that have nothing to do with ROS, by the name they are imported as: numbers, learning, images, sound, files, devices, networks,
windows, tools."""

_STANDARD = sys.stdlib_module_names | {
    "Tkinter", "tkMessageBox", "Queue", "ConfigParser", "StringIO", "cStringIO", "cPickle", "thread", "urllib2", "httplib", "commands",
    "SocketServer", "BaseHTTPServer", "SimpleHTTPServer", "HTMLParser", "xmlrpclib", "SimpleXMLRPCServer", "__builtin__", "imp", "cgi",
    "urlparse", "anydbm", "md5", "sets", "exceptions", "asyncore", "asynchat", "telnetlib", "pipes", "distutils", "ttk", "tkFont",
}  # fmt: skip
_GENERATED = frozenset(("msg", "srv", "action", "cfg"))
_SILENT = _ROS | _OTHERS | _STANDARD
_PLAIN = (_OTHERS | _STANDARD) - {"importlib", "imp", "runpy", "pkgutil", "pkg_resources"}
_DECLARED = re.compile(rb">\s*python3?-([A-Za-z0-9][\w.-]{0,80}?)(?:-pip)?\s*<")
_REQUIRED = re.compile(rb"^[ \t]*([A-Za-z0-9][\w.-]{0,80})", re.MULTILINE)


def is_silent(name: str, declared: frozenset[str] = frozenset(), more: frozenset[str] = frozenset()) -> bool:
    """Whether what stands in a module is known to make no names that are not recognised by themselves.

    Args:
        name: the full name of a module, or of something in it.
        declared: libraries of Python that the package says it needs.
        more: packages that make no names but those that are recognised, in one middleware only.
    """
    top, _, rest = name.partition(".")
    if top in _SILENT or top in more or top.endswith(("_msgs", "_srvs")) or rest.partition(".")[0] in _GENERATED:
        return True
    if any(part.endswith(("_pb2", "_pb2_grpc")) for part in name.split(".")):
        return True  # what protoc generates
    return top.lower() in declared


def has_no_ros(name: str) -> bool:
    """Whether a module has nothing to do with ROS, and brings no other modules by names that are worked out."""
    return name.partition(".")[0] in _PLAIN


def declared_libraries(manifest: bytes, requirements: bytes) -> frozenset[str]:
    """Libraries of Python that are needed: rosdep's keys ``python3-…`` in ``package.xml``, and the lines of ``requirements.txt``."""
    names = [each.decode("ascii", "replace").lower() for each in (*_DECLARED.findall(manifest), *_REQUIRED.findall(requirements))]
    words = {each.replace("-", "_").replace(".", "_") for each in names}
    return frozenset(words | {each.removeprefix("python_").removesuffix("_python") for each in words} | {f"py{each}" for each in words})
