"""The C library through cffi: declarations from murk.h itself, errors as
exceptions, arrays without copies.

cffi in ABI mode was chosen: the declarations are those of the installed header,
so no second list of functions exists, nothing is compiled for Python, and one
package serves every Python 3.
"""
import ctypes.util
import os
import re
import threading

import cffi
import numpy

ffi = cffi.FFI()


def _first(paths, what):
    for path in paths:
        if path and os.path.exists(path):
            return path
    raise ImportError(f"murk: no {what}; the package libmurk0 or MURK_LIBRARY, MURK_HEADER must name it")


def _header():
    """The text of murk.h: beside this file, or of an installation."""
    here = os.path.dirname(os.path.abspath(__file__))
    path = _first([os.environ.get("MURK_HEADER"), os.path.join(here, "murk.h"), "/usr/include/murk.h",
                   "/usr/local/include/murk.h"], "murk.h")
    with open(path, encoding="utf-8") as file:
        return file.read()


def _declarations(text):
    """What cffi reads: without C++, includes and macros, whose values it cannot compute."""
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.S)
    text = re.sub(r"#define (\w+)[^\n\\]*\\\n(?:[^\n]*\\\n)*[^\n]*", "", text)
    dimensions = re.search(r"#define MURK_ARRAY_DIMENSIONS (\d+)", text).group(1)
    text = re.sub(r"^\s*#[^\n]*", "", text, flags=re.M)
    return text.replace("MURK_ARRAY_DIMENSIONS", dimensions)


ffi.cdef(_declarations(_header()))
_path = os.environ.get("MURK_LIBRARY") or ctypes.util.find_library("murk") or "libmurk.so.0"
lib = ffi.dlopen(_path)


class Error(Exception):
    """A failure of murk.

    Attributes: code (name of the status, such as "MURK_BAD_VALUE"), text (the value found and the allowed values,
    with units), where (the place as one text), file, line and column (0: none), key (path of the key in a scene, or
    "").
    """

    def __init__(self, text, code="MURK_BAD_VALUE", where="", file="", line=0, column=0, key=""):
        super().__init__(f"{where}: {text}" if where else text)
        self.text, self.code, self.where = text, code, where
        self.file, self.line, self.column, self.key = file, line, column, key

    def __reduce__(self):
        return Error, (self.text, self.code, self.where, self.file, self.line, self.column, self.key)


class Interrupted(Error):
    """The work was cancelled."""


def _string(chars):
    return ffi.string(chars).decode("utf-8", "replace")


def _raise(status, error):
    code = _CODES.get(status, str(status))
    if status == lib.MURK_NO_MEMORY and not _string(error.text):
        raise MemoryError
    kind = Interrupted if status == lib.MURK_INTERRUPTED else Error
    raise kind(_string(error.text), code, _string(error.where), _string(error.file), error.line, error.column,
               _string(error.key))


_CODES = {value: name for name, value in ffi.typeof("murk_status").relements.items()}


def new_error():
    error = ffi.new("murk_error *")
    error.size = ffi.sizeof("murk_error")
    return error


def call(function, *arguments):
    """Calls a function that fills an error; raises Error."""
    error = new_error()
    status = function(*arguments, error)
    if status:
        _raise(status, error)


def call_long(context, function, *arguments):
    """The same for long work: Ctrl-C cancels it. The work runs in a thread, so that the interpreter, whose lock is
    released meanwhile, sees the signal."""
    if threading.current_thread() is not threading.main_thread():
        call(function, *arguments)
        return
    failure, is_done = [], threading.Event()

    def work():
        try:
            call(function, *arguments)
        except BaseException as raised:  # handed to the caller below
            failure.append(raised)
        finally:
            is_done.set()

    threading.Thread(target=work, name="murk").start()
    # An event is waited for, not the thread: in Python 3.11 an interrupt in join() makes a running thread count as
    # ended (bpo-45274).
    try:
        while not is_done.wait(0.1):
            pass
    except KeyboardInterrupt:
        lib.murk_context_cancel(context)
        is_done.wait()
        if not failure or isinstance(failure[0], Interrupted):
            raise
    if failure:
        raise failure[0]


def text(value):
    """A str or path as a C string; None is NULL."""
    if value is None:
        return ffi.NULL
    return ffi.new("char[]", os.fsencode(os.fspath(value)))


# ---- arrays ----

_TYPES = {lib.MURK_TYPE_UINT8: numpy.uint8, lib.MURK_TYPE_UINT16: numpy.uint16, lib.MURK_TYPE_UINT32: numpy.uint32,
          lib.MURK_TYPE_UINT64: numpy.uint64, lib.MURK_TYPE_FLOAT32: numpy.float32,
          lib.MURK_TYPE_FLOAT64: numpy.float64}


class _Memory:
    """Memory of a handle as NumPy takes it; keeps the owner of the handle alive."""

    def __init__(self, owner, address, dtype, shape, strides):
        self.owner = owner
        self.__array_interface__ = {"version": 3, "data": (address, True), "typestr": numpy.dtype(dtype).str,
                                    "descr": numpy.dtype(dtype).descr, "shape": shape, "strides": strides}


def new_view():
    view = ffi.new("murk_array *")
    view.size = ffi.sizeof("murk_array")
    return view


def view_address(view):
    return int(ffi.cast("uintptr_t", view.data))


def as_numpy(owner, view):
    """A view of murk as a read-only array that keeps `owner` alive; no copy."""
    n = view.dimensions
    shape = tuple(view.shape[k] for k in range(n))
    if 0 in shape or view.data == ffi.NULL:
        return numpy.zeros(shape, _TYPES[view.type])
    strides = tuple(view.stride[k] for k in range(n))
    return numpy.asarray(_Memory(owner, view_address(view), _TYPES[view.type], shape, strides))


def structured(owner, address, n, itemsize, fields):
    """Records of n items as a structured array; fields: {name: (dtype, offset)}."""
    dtype = numpy.dtype({"names": list(fields), "formats": [f[0] for f in fields.values()],
                         "offsets": [f[1] for f in fields.values()], "itemsize": itemsize})
    if n == 0:
        return numpy.zeros(0, dtype)
    raw = numpy.asarray(_Memory(owner, address, numpy.uint8, (n * itemsize,), (1,)))
    return raw.view(dtype)


def from_numpy(array, dimensions, name, types=(numpy.float32, numpy.float64)):
    """(view, array that must stay alive) of an array of the caller."""
    array = numpy.asarray(array)
    if array.dtype not in types:
        array = array.astype(types[-1])
    if array.ndim != dimensions:
        raise Error(f"has {array.ndim} dimensions, must have {dimensions}", where=name)
    view = new_view()
    view.data = ffi.cast("const void *", array.ctypes.data)
    view.type = next(code for code, dtype in _TYPES.items() if dtype == array.dtype.type)
    view.dimensions = dimensions
    for k in range(dimensions):
        view.shape[k], view.stride[k] = array.shape[k], array.strides[k]
    return view, array
