"""The C library through cffi: declarations from murk.h itself, errors as
exceptions, arrays without copies.

cffi in ABI mode was chosen: the declarations are those of the installed header,
so no second list of functions exists, nothing is compiled for Python, and one
package serves every Python 3.
"""
from __future__ import annotations

import ctypes.util
import json
import os
import re
import threading
from concurrent import futures
from typing import TYPE_CHECKING, Any, Sequence, Union

import cffi
import numpy
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from ._context import Context

ffi: Any = cffi.FFI()
Path = Union[str, "os.PathLike[str]"]


def _first(paths: Sequence[str | None], what: str) -> str:
    for path in paths:
        if path and os.path.exists(path):
            return path
    raise ImportError(f"murk: no {what}; the package libmurk0 or MURK_LIBRARY, MURK_HEADER must name it")


def header() -> str:
    """The text of murk.h: beside this file, or of an installation."""
    here = os.path.dirname(os.path.abspath(__file__))
    path = _first([os.environ.get("MURK_HEADER"), os.path.join(here, "murk.h"), "/usr/include/murk.h",
                   "/usr/local/include/murk.h"], "murk.h")
    with open(path, encoding="utf-8") as file:
        return file.read()


def _declarations(text: str) -> str:
    """What cffi reads: without C++, includes and macros, whose values it cannot compute."""
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.S)
    text = re.sub(r"#define (\w+)[^\n\\]*\\\n(?:[^\n]*\\\n)*[^\n]*", "", text)
    dimensions = re.findall(r"#define MURK_ARRAY_DIMENSIONS (\d+)", text)
    text = re.sub(r"^\s*#[^\n]*", "", text, flags=re.M)
    return text.replace("MURK_ARRAY_DIMENSIONS", dimensions[0])


ffi.cdef(_declarations(header()))
_path = os.environ.get("MURK_LIBRARY") or ctypes.util.find_library("murk") or "libmurk.so.0"
lib: Any = ffi.dlopen(_path)


class Error(Exception):
    """A failure of murk.

    Attributes: `code` (the status of murk.h, "MURK_BAD_VALUE"), `text` (the value found and the allowed values, with
    units), `where` (the place as one text), `file`, `line` and `column` (from 1; "" and 0 if there is none), `key`
    (the path of the key in the scene, "lights.0.power_w"; "" if there is none). Errors can be pickled.

    Example: `try: scene.check()`, then `except murk.Error as error: print(error.file, error.line, error.key)`.
    """

    def __init__(self, text: str, code: str = "MURK_BAD_VALUE", where: str = "", file: str = "", line: int = 0,
                 column: int = 0, key: str = "") -> None:
        super().__init__(f"{where}: {text}" if where else text)
        self.text, self.code, self.where = text, code, where
        self.file, self.line, self.column, self.key = file, line, column, key

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.text, self.code, self.where, self.file, self.line, self.column, self.key)


class Interrupted(Error):
    """The work was cancelled by `Context.cancel()`; Ctrl-C raises KeyboardInterrupt instead.

    Example: `except murk.Interrupted: print("stopped")`.
    """


def string(chars: Any) -> str:
    """A C string as str."""
    return str(ffi.string(chars).decode("utf-8", "replace"))


def in_python(text: str) -> str:
    """A message of the library, which names settings of its C interface."""
    return re.sub(r"options->(\w+)", r"argument \1", text)


def _raise(status: int, error: Any) -> None:
    code = _CODES.get(status, str(status))
    if status == lib.MURK_NO_MEMORY and not string(error.text):
        raise MemoryError
    kind = Interrupted if status == lib.MURK_INTERRUPTED else Error
    where, file, key = string(error.where), string(error.file), string(error.key)
    text = in_python(string(error.text))
    if file == DICT or where.startswith("set "):  # values of Python, whose place is the key
        raise kind(text, code, where=key, key=key)
    raise kind(text, code, where, file, error.line, error.column, key)


# The name of a text that was made from a dict: lines and columns of it mean nothing to the caller.
DICT = "dict of Python"
_CODES: dict[int, str] = {value: name for name, value in ffi.typeof("murk_status").relements.items()}


def call(function: Any, *arguments: Any) -> None:
    """Calls a function that fills an error; raises Error."""
    error = ffi.new("murk_error *")
    error.size = ffi.sizeof("murk_error")
    status = function(*arguments, error)
    if status:
        _raise(status, error)


def call_in(context: Context, function: Any, *arguments: Any) -> None:
    """The same for short work in a context: an exception of a log function is raised, and warnings are given."""
    try:
        call(function, *arguments)
    except Exception:
        _end_failed(context)
        raise
    _end(context, arguments)


def _end_failed(context: Context) -> None:
    """Ends a call that has failed; the failure says more than a warning that is an error."""
    try:
        context._raise_of_callback()
    except Warning:
        pass


def _end(context: Context, arguments: tuple[Any, ...]) -> None:
    """Ends a call that has not failed. Destroys the handle that it has made, if an exception of a callback or a warning
    that is an error is raised: the caller does not get it."""
    try:
        context._raise_of_callback()
    except BaseException:
        made = re.fullmatch(r"(murk_\w+) \* \*", ffi.typeof(arguments[0]).cname)
        if made and arguments[0][0]:
            getattr(lib, f"{made[1]}_destroy")(arguments[0][0])
        raise


# The thread of long work, made when it is first needed. There is one for all calls, because Embree keeps some memory
# for each thread that has built a scene.
_worker: list[futures.ThreadPoolExecutor] = []
os.register_at_fork(after_in_child=_worker.clear)


def call_long(context: Context, function: Any, *arguments: Any) -> None:
    """The same for long work: Ctrl-C and an exception of a callback cancel it and are raised.

    The work runs in a thread, so that the interpreter, whose lock is released meanwhile, sees the signal. Signals
    reach the main thread alone; other threads call directly."""
    context.is_cancelled_by_exception = True
    failure: BaseException | None = None
    if threading.current_thread() is not threading.main_thread():
        try:
            call(function, *arguments)
        except Exception as raised:
            failure = raised
    else:
        if not _worker:
            _worker.append(futures.ThreadPoolExecutor(1, "murk"))
        work = _worker[0].submit(call, function, *arguments)
        try:
            while not futures.wait([work], 0.1).done:
                pass
        except KeyboardInterrupt:
            context.cancel()
            failure = work.exception()
            if failure is None or isinstance(failure, Interrupted):
                context._exception = None  # that of a callback, if there is one, is not that of the next call
                _end_failed(context)
                raise
        failure = work.exception()
    if failure:
        _end_failed(context)
        raise failure.with_traceback(None)  # frames of the thread say nothing
    _end(context, arguments)


def c_text(value: Path | None) -> Any:
    """A str or path as a C string; None is NULL."""
    if value is None:
        return ffi.NULL
    return ffi.new("char[]", os.fsencode(os.fspath(value)))


def _plain(value: Any) -> Any:
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"{type(value).__name__} is no value of a scene")


def yaml_of(key: str, value: Any) -> str:
    """A Python value in YAML flow style."""
    try:
        return json.dumps(value, allow_nan=False, default=_plain)
    except (TypeError, ValueError) as wrong:
        raise Error(f"{value!r}: {wrong}", where=key, key=key) from None


# ---- arrays ----

_TYPES: dict[int, Any] = {lib.MURK_TYPE_UINT8: numpy.uint8, lib.MURK_TYPE_UINT16: numpy.uint16, lib.MURK_TYPE_UINT32: numpy.uint32,
          lib.MURK_TYPE_UINT64: numpy.uint64, lib.MURK_TYPE_FLOAT32: numpy.float32,
          lib.MURK_TYPE_FLOAT64: numpy.float64}


class _Memory:
    """Memory of a handle as NumPy takes it; keeps the handle alive. The owner is
    the handle and not the object that has it: NumPy arrays take no part in garbage collection, so that an object with
    a view of itself would never be freed."""

    def __init__(self, owner: object, address: int, dtype: Any, shape: tuple[int, ...],
                 strides: tuple[int, ...]) -> None:
        self.owner = owner
        self.__array_interface__ = {"version": 3, "data": (address, True), "typestr": numpy.dtype(dtype).str,
                                    "descr": numpy.dtype(dtype).descr, "shape": shape, "strides": strides}


def new_view() -> Any:
    view = ffi.new("murk_array *")
    view.size = ffi.sizeof("murk_array")
    return view


def view_address(view: Any) -> int:
    return int(ffi.cast("uintptr_t", view.data))


def as_numpy(owner: object, view: Any) -> NDArray[Any]:
    """A view of murk as a read-only array that keeps `owner` alive; no copy."""
    n = view.dimensions
    shape = tuple(view.shape[k] for k in range(n))
    if 0 in shape or view.data == ffi.NULL:
        return numpy.zeros(shape, _TYPES[view.type])
    strides = tuple(view.stride[k] for k in range(n))
    return numpy.asarray(_Memory(owner, view_address(view), _TYPES[view.type], shape, strides))


def structured(owner: object, address: int, n: int, itemsize: int, fields: dict[str, tuple[Any, int]]) -> NDArray[Any]:
    """Records of n items as a structured array; fields: {name: (dtype, offset)}."""
    dtype = numpy.dtype({"names": list(fields), "formats": [f[0] for f in fields.values()],
                         "offsets": [f[1] for f in fields.values()], "itemsize": itemsize})
    if n == 0:
        return numpy.zeros(0, dtype)
    raw = numpy.asarray(_Memory(owner, address, numpy.uint8, (n * itemsize,), (1,)))
    return raw.view(dtype)


def three(numbers: Sequence[float], name: str) -> Any:
    """The numbers as double[3] of C."""
    if len(numbers) != 3:
        raise Error(f"has {len(numbers)} numbers, must have 3", where=f"argument {name}")
    return ffi.new("double[3]", [float(x) for x in numbers])


def from_numpy(array: ArrayLike, dimensions: int, name: str,
               types: Sequence[Any] = (numpy.float32, numpy.float64)) -> tuple[Any, NDArray[Any]]:
    """(view, array that must stay alive) of an array of the caller."""
    values = numpy.asarray(array)
    if values.dtype.kind not in "biuf":
        raise Error(f"holds {values.dtype}, must hold numbers", where=f"argument {name}")
    if values.dtype not in types:
        converted = values.astype(types[-1])
        if issubclass(types[-1], numpy.integer) and not numpy.array_equal(converted, values):
            raise Error("must hold whole numbers from 0", where=f"argument {name}")
        values = converted
    if values.ndim != dimensions:
        raise Error(f"has {values.ndim} dimensions, must have {dimensions}", where=f"argument {name}")
    view = new_view()
    view.data = ffi.cast("const void *", values.ctypes.data)
    view.type = next(code for code, dtype in _TYPES.items() if dtype == values.dtype.type)
    view.dimensions = dimensions
    for k in range(dimensions):
        view.shape[k], view.stride[k] = values.shape[k], values.strides[k]
    return view, values
