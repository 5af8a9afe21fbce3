"""Functions of Python's library whose outcome only the machine and the moment know: what kind of value each gives. They raise nothing."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.python.values import MISSING, External, Function, Handle, Quiet, Text, Value
from launchlint.python.values import Class as FollowedClass
from launchlint.source import Place

THING = "thing"
"""An object of Python's library that raises nothing whatever it is asked."""
_TEXTS = """tempfile.mktemp tempfile.mkdtemp tempfile.gettempdir tempfile.gettempprefix os.getcwd os.path.expandvars time.strftime
    time.ctime socket.gethostname socket.getfqdn platform.node platform.machine platform.platform platform.release platform.version
    platform.processor platform.python_version getpass.getuser os.urandom textwrap.indent textwrap.fill textwrap.shorten
    pprint.pformat traceback.format_exc ament_index_python.get_search_paths"""
_VALUES = """time.time time.monotonic time.perf_counter time.time_ns os.getpid os.getppid os.getuid os.getgid os.cpu_count os.getloadavg
    multiprocessing.cpu_count random.random random.randint random.uniform random.choice random.sample random.randrange random.gauss
    shutil.which uuid.uuid4 uuid.uuid1 os.access os.path.getsize os.path.getmtime ament_index_python.packages.get_search_paths
    launch.logging.get_logging_level"""
_THINGS = """logging.getLogger launch.logging.get_logger rclpy.logging.get_logger datetime.datetime.now datetime.datetime.today
    datetime.datetime.utcnow datetime.date.today datetime.timedelta datetime.now logging.StreamHandler logging.Formatter
    tempfile.TemporaryDirectory"""
_NOTHING = """time.sleep random.seed warnings.warn warnings.filterwarnings warnings.simplefilter logging.basicConfig logging.debug
    logging.info logging.warning logging.error logging.critical logging.exception logging.disable pprint.pprint traceback.print_exc
    sys.stdout.write sys.stdout.flush sys.stderr.write sys.stderr.flush signal.signal atexit.register gc.collect random.shuffle
    launch.logging.launch_config.set_level"""
_MAY_FAIL = """os.remove os.unlink os.rmdir os.removedirs os.mkdir os.makedirs os.rename os.replace os.chmod os.symlink os.link os.chdir
    shutil.rmtree shutil.chown os.kill os.utime"""
"""Functions that give nothing, and may raise an exception."""
_KINDS: Mapping[str, str] = {
    name: kind
    for kind, names in (("text", _TEXTS), ("value", _VALUES), (THING, _THINGS), ("nothing", _NOTHING), ("risk", _MAY_FAIL))
    for name in names.split()
}
_DECORATORS = ("pytest.mark.", "pytest.fixture", "launch_testing.", "launch_pytest.", "launch.frontend.expose_", "unittest.skip")
"""What gives back the function or class it is given, or something that does."""


def call(name: str, positional: list[Value], place: Place) -> tuple[Value, bool]:
    """What a function gives, MISSING where nothing is known of it; and whether it may raise an exception."""
    if name.startswith(_DECORATORS):
        first = positional[0] if len(positional) == 1 else None
        return (first if isinstance(first, (Function, FollowedClass)) else External("copy.copy")), False
    kind = _KINDS.get(name)
    if kind == "text":
        return Text(f"{{{name}()}}"), False
    if kind == "value":
        return Quiet("only the machine and the moment know it", place), False
    if kind == THING:
        return Handle(THING, {}), False
    return (None, kind == "risk") if kind in ("nothing", "risk") else (MISSING, False)


def method(name: str, place: Place) -> Value:
    """What a method of such an object gives."""
    if name in ("strftime", "isoformat", "ctime", "__str__"):
        return Text(f"{{{name}()}}")
    return Handle(THING, {}) if name in ("replace", "getChild", "date", "time") else Quiet("only the machine and the moment know it", place)
