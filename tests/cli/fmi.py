# SPDX-License-Identifier: Apache-2.0
"""An importer of FMI 2.0 for co-simulation: loads the binary of an archive and calls it in the standard's order."""
import ctypes
import pathlib
import xml.etree.ElementTree as ElementTree
import zipfile

OK, WARNING, DISCARD, ERROR = range(4)

LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p)
ALLOCATE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)
RELEASE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ALLOCATE), ("release", RELEASE), ("finished", ctypes.c_void_p),
                ("environment", ctypes.c_void_p)]


class Unit:
    """The library of an FMU with its description."""

    def __init__(self, archive, folder):
        with zipfile.ZipFile(archive) as files:
            files.extractall(folder)
        self.folder = pathlib.Path(folder)
        self.description = ElementTree.parse(self.folder / "modelDescription.xml").getroot()
        self.guid = self.description.get("guid")
        name = self.description.find("CoSimulation").get("modelIdentifier")
        self.library = ctypes.CDLL(str(self.folder / "binaries/linux64" / (name + ".so")))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.variables = {v.get("name"): v for v in self.description.find("ModelVariables")}

    def reference(self, name):
        return int(self.variables[name].get("valueReference"))


class Instance:
    """One instance, with the memory that it has of its tool."""

    def __init__(self, unit, guid=None, kind=1):
        self.unit, self.library = unit, unit.library
        self.messages, self.held = [], set()
        libc = ctypes.CDLL(None)
        libc.calloc.restype, libc.calloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t, ctypes.c_size_t]
        libc.free.argtypes = [ctypes.c_void_p]

        def allocate(count, size):
            memory = libc.calloc(count, size)
            self.held.add(memory)
            return memory

        def release(memory):
            self.held.remove(memory)
            libc.free(memory)

        def log(_environment, _name, _status, _category, _pattern, message):
            self.messages.append(message.decode())

        self.callbacks = Callbacks(LOGGER(log), ALLOCATE(allocate), RELEASE(release), None, None)
        self.component = ctypes.c_void_p(self.library.fmi2Instantiate(
            b"motor", kind, (guid or unit.guid).encode(), b"", ctypes.byref(self.callbacks), 0, 1))
        self.time = 0.0

    def call(self, name, *arguments):
        return getattr(self.library, "fmi2" + name)(self.component, *arguments)

    def begin(self, **parameters):
        assert self.call("SetupExperiment", 0, ctypes.c_double(0), ctypes.c_double(0), 0, ctypes.c_double(0)) == OK
        self.set(**parameters)
        assert self.call("EnterInitializationMode") == OK
        assert self.call("ExitInitializationMode") == OK
        return self

    def _access(self, verb, name, value=None):
        kind = next(child.tag for child in self.unit.variables[name] if child.tag in ("Real", "Integer", "Boolean"))
        of = ctypes.c_double if kind == "Real" else ctypes.c_int
        reference, cell = (ctypes.c_uint * 1)(self.unit.reference(name)), (of * 1)(value or 0)
        return self.call(verb + kind, reference, ctypes.c_size_t(1), cell), cell[0]

    def set(self, **values):
        for name, value in values.items():
            status, _ = self._access("Set", name, value)
            if status != OK:
                return status
        return OK

    def __getitem__(self, name):
        status, value = self._access("Get", name)
        assert status == OK, (name, self.messages)
        return value

    def step(self, seconds):
        status = self.call("DoStep", ctypes.c_double(self.time), ctypes.c_double(seconds), 1)
        self.time += seconds
        return status

    def state(self):
        state = ctypes.c_void_p(None)
        assert self.call("GetFMUstate", ctypes.byref(state)) == OK
        return state

    def end(self):
        """Frees it; what it still holds of the tool's memory."""
        self.call("Terminate")
        self.call("FreeInstance")
        return self.held
