# SPDX-License-Identifier: GPL-3.0-or-later
"""A host of co-simulation units in a page of Python: unpacks one, reads its description, and loads its library.

Types and signatures are those of FMI 2.0.4 and FMI 3.0.2.
"""
import ctypes as c
import pathlib
import xml.etree.ElementTree
import zipfile

OK, WARNING, DISCARD, ERROR, FATAL = range(5)
FOLDERS = {"2.0": "linux64", "3.0": "x86_64-linux"}

Logger2 = c.CFUNCTYPE(None, c.c_void_p, c.c_char_p, c.c_int, c.c_char_p, c.c_char_p, c.c_char_p)
Logger3 = c.CFUNCTYPE(None, c.c_void_p, c.c_int, c.c_char_p, c.c_char_p)


class Callbacks2(c.Structure):
    _fields_ = [("logger", Logger2), ("allocate", c.c_void_p), ("free", c.c_void_p), ("finished", c.c_void_p),
                ("environment", c.c_void_p)]


class Unit:
    """A unit in a folder of its own."""

    def __init__(self, file, folder):
        self.folder = pathlib.Path(folder).resolve()  # the standard asks for absolute paths
        with zipfile.ZipFile(file) as archive:
            archive.extractall(self.folder)
        self.description = xml.etree.ElementTree.parse(self.folder / "modelDescription.xml").getroot()
        self.version = self.description.get("fmiVersion")
        self.token = self.description.get("guid" if self.version == "2.0" else "instantiationToken")
        identifier = self.description.find("CoSimulation").get("modelIdentifier")
        self.library_file = self.folder / "binaries" / FOLDERS[self.version] / f"{identifier}.so"
        self.library = c.CDLL(str(self.library_file))
        self.references = {v.get("name"): int(v.get("valueReference"))
                           for v in self.description.find("ModelVariables")}

    def instantiate(self, **options):
        return (Instance2 if self.version == "2.0" else Instance3)(self, **options)


class Refused(Exception):
    """A call of the unit that did not succeed."""

    def __init__(self, call, status, messages):
        super().__init__(f"{call}: {status}: {messages[-1] if messages else ''}")
        self.status = status


class Instance:
    """The calls that both versions share; `prefix` is that of the functions."""

    prefix, state_name, deserialize_name, real, whole = "", "", "", "", ""

    def call(self, name, *arguments):
        function = getattr(self.unit.library, self.prefix + name)
        function.restype = c.c_int
        status = function(self.pointer, *arguments)
        if status != OK:
            raise Refused(name, status, self.messages)

    def free(self):
        function = getattr(self.unit.library, self.prefix + "FreeInstance")
        function.restype = None
        function(self.pointer)

    def exit_initialization(self):
        self.call("ExitInitializationMode")

    def terminate(self):
        self.call("Terminate")

    def reset(self):
        self.call("Reset")

    def _values(self, call, names, values, kind):
        n = len(names)
        references = (c.c_uint * n)(*[self.unit.references.get(name, name) for name in names])
        array = (kind * n)(*values)
        self.call(call, references, c.c_size_t(n), array, *self._counts(n))
        return list(array)

    def get(self, names, whole=False):
        kind = self.whole_type if whole else c.c_double
        return self._values("Get" + (self.whole if whole else self.real), names, [0] * len(names), kind)

    def set(self, values, whole=False):
        kind = self.whole_type if whole else c.c_double
        self._values("Set" + (self.whole if whole else self.real), list(values), list(values.values()), kind)

    def get_state(self, state=None):
        state = state or c.c_void_p()
        self.call("Get" + self.state_name, c.byref(state))
        return state

    def set_state(self, state):
        self.call("Set" + self.state_name, state)

    def free_state(self, state):
        self.call("Free" + self.state_name, c.byref(state))

    def serialize(self, state):
        size = c.c_size_t()
        self.call(f"Serialized{self.state_name}Size", state, c.byref(size))
        array = (c.c_char * size.value)()
        self.call(f"Serialize{self.state_name}", state, array, size)
        return bytes(array)

    def deserialize(self, data):
        state = c.c_void_p()
        self.call(self.deserialize_name, data, c.c_size_t(len(data)), c.byref(state))
        return state

    def _said(self, category, message):
        self.messages.append(message.decode())
        self.categories.append(category.decode())


class Instance2(Instance):
    prefix, state_name, deserialize_name, real, whole = "fmi2", "FMUstate", "DeSerializeFMUstate", "Real", "Integer"
    whole_type = c.c_int

    def __init__(self, unit, name="test", token=None, resources=None, kind=1, logging=True):
        self.unit, self.messages, self.categories = unit, [], []
        # The message is what the format "%s" prints.
        self.logger = Logger2(lambda _e, _n, _s, category, _format, text: self._said(category, text))
        self.callbacks = Callbacks2(self.logger, None, None, None, None)
        instantiate = unit.library.fmi2Instantiate
        instantiate.restype = c.c_void_p
        pointer = instantiate(name.encode(), kind, (token or unit.token).encode(),
                              (resources or (unit.folder / "resources").as_uri()).encode(), c.byref(self.callbacks), 0,
                              int(logging))
        self.pointer = c.c_void_p(pointer)

    def _counts(self, _n):
        return ()

    def enter_initialization(self, start=0.0, stop=None):
        self.call("SetupExperiment", 0, c.c_double(0), c.c_double(start), int(stop is not None), c.c_double(stop or 0))
        self.call("EnterInitializationMode")

    def step(self, at, size):
        self.call("DoStep", c.c_double(at), c.c_double(size), 0)


class Instance3(Instance):
    prefix, state_name, deserialize_name, real, whole = "fmi3", "FMUState", "DeserializeFMUState", "Float64", "Int64"
    whole_type = c.c_int64

    def __init__(self, unit, name="test", token=None, resources=None, logging=True, event_mode=False):
        self.unit, self.messages, self.categories = unit, [], []
        self.logger = Logger3(lambda _e, _s, category, message: self._said(category, message))
        instantiate = unit.library.fmi3InstantiateCoSimulation
        instantiate.restype = c.c_void_p
        flag = c.c_bool
        pointer = instantiate(name.encode(), (token or unit.token).encode(),
                              (resources or f"{unit.folder / 'resources'}/").encode(), flag(False), flag(logging),
                              flag(event_mode), flag(False), None, c.c_size_t(0), None, self.logger, None)
        self.pointer = c.c_void_p(pointer)

    def _counts(self, n):
        return (c.c_size_t(n),)

    def enter_initialization(self, start=0.0, stop=None):
        self.call("EnterInitializationMode", c.c_bool(False), c.c_double(0), c.c_double(start),
                  c.c_bool(stop is not None), c.c_double(stop or 0))

    def step(self, at, size):
        flags = [c.c_bool(True) for _ in range(3)]
        reached = c.c_double(-1.0)
        self.call("DoStep", c.c_double(at), c.c_double(size), c.c_bool(False), *[c.byref(f) for f in flags],
                  c.byref(reached))
        assert not any(flag.value for flag in flags)
        self.reached = reached.value
