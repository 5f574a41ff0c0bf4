"""Contexts: threads, messages, progress and cancelling of calls."""
from __future__ import annotations

import os
import sys
import threading
import warnings
from typing import Any, Callable, Union

from ._library import call, ffi, in_python, lib, string

Log = Callable[[bool, str, str], object]
Progress = Callable[[str, int, Union[int, None], str, float], object]


@ffi.callback("murk_log_function")  # type: ignore[misc]
def _log(user: Any, is_warning: bool, where: Any, message: Any) -> None:
    context: Context = ffi.from_handle(user)
    context._heard(bool(is_warning), string(where), in_python(string(message)))


@ffi.callback("murk_progress_function")  # type: ignore[misc]
def _progress(user: Any, state: Any) -> None:
    context: Context = ffi.from_handle(user)
    context._progressed(string(state.step), state.done, state.total or None, string(state.unit), state.elapsed_s)


def _level_of_user() -> int:
    """The `stacklevel` of warnings.warn() in the caller that names the first line outside of this package."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_FOLDER):
        level, frame = level + 1, frame.f_back
    return level


_FOLDER = os.path.dirname(_level_of_user.__code__.co_filename) + os.sep


class _Line:
    """One line of progress on standard error: redrawn on terminals and in notebooks, elsewhere (a file, a pipe) a line
    for each finished step."""

    def __init__(self) -> None:
        self.step, self.width, self.has_total = "", 0, False

    def finish(self) -> None:
        """Ends a line that was not ended: that of a step without a known length."""
        if self.width and sys.stderr is not None:
            sys.stderr.write("\n")
            sys.stderr.flush()
        self.width = 0

    def __call__(self, step: str, done: int, total: int | None, unit: str, elapsed_s: float) -> None:
        stream = sys.stderr
        if stream is None:  # a program without a console
            return
        is_end = total is not None and done >= total
        # Jupyter's streams are no terminals, and yet notebooks obey a carriage return.
        is_redrawn = stream.isatty() or type(stream).__module__.startswith("ipykernel")
        if not (is_redrawn or is_end):
            return
        if step != self.step and not self.has_total:
            self.finish()  # else the line is of a step inside of this one, and is written over
        self.step, self.has_total = step, total is not None
        share = f"{min(100, 100 * done / total):3.0f} %" if total else f"{done} {unit}" if done else ""
        text = f"{step:<12} {share:<16} {elapsed_s:6.1f} s"
        start = "\r" if is_redrawn else ""
        stream.write(start + text.ljust(self.width) + ("\n" if is_end else ""))
        stream.flush()
        self.width = 0 if is_end else len(text)


class Context:
    """Threads, messages and progress of the calls that are made with it.

    threads: 0 for as many as there are processors. log: a function called with (is_warning, where, text) for each
    warning and note; None: warnings become Python warnings, notes are dropped. progress: True for a line on standard
    error, which terminals and notebooks redraw, or a function called some five times a second with (step, done, total
    or None, unit, elapsed seconds); None: no progress. An exception in `log` or `progress` cancels the call that runs
    and is raised by it.

    A context, and all that is made with it, is used by one thread at a time. Scenes without a context take one that
    belongs to their thread. Raises Error if the machine refuses the threads.

    Example: `scene = murk.Scene(file="yard.yaml", context=murk.Context(threads=2, progress=True))`.
    """

    def __init__(self, threads: int = 0, log: Log | None = None, progress: Progress | bool | None = None) -> None:
        self._settings = threads, log, progress
        self._for_files: Context | None = None
        self._warnings: list[str] = []
        self._log = log
        self._line = _Line()
        self._told: Progress = self._line
        if callable(progress):
            self._told = progress
        self._exception: BaseException | None = None
        self.is_cancelled_by_exception = False  # true during long calls
        self._handle = ffi.new_handle(self)
        options = ffi.new("murk_context_options *")
        options.size = ffi.sizeof("murk_context_options")
        options.threads = threads
        options.log = _log
        options.progress = _progress if progress else ffi.NULL
        options.user = self._handle
        out = ffi.new("murk_context **")
        call(lib.murk_context_create, out, options)
        self.c = ffi.gc(out[0], lib.murk_context_destroy)

    def cancel(self) -> None:
        """Makes the long call that runs, or else the next long call, raise Interrupted; may be called from any thread.

        Example: `threading.Timer(60, context.cancel).start()`.
        """
        lib.murk_context_cancel(self.c)
        if self._for_files is not None:
            self._for_files.cancel()

    def finish(self) -> bool:
        """Makes the search for a plan that runs finish with the best plan so far; may be called from any thread.

        The plan is completed and measured as usual, and `plan.placement.cut_by` is "interrupt". Returns False, and does
        nothing, if no search for a plan runs, or if it was asked before.

        Example: `threading.Timer(600, context.finish).start()`.
        """
        return bool(lib.murk_context_finish(self.c))

    def _of_temporary_files(self) -> Context:
        """A context with the same settings for work on files that are removed afterwards.

        A context never writes over a file that it has read, and knows files by their inode, which a new file may get
        when a temporary one is gone."""
        self._for_files = Context(*self._settings)
        return self._for_files

    def _raise_of_callback(self) -> None:
        """Raises the exception that a callback raised during a call that has ended, else gives the warnings of the call
        at the line of the user's code that made the call; for the module itself."""
        self.is_cancelled_by_exception = False
        self._line.finish()
        heard, self._warnings = self._warnings, []
        exception, self._exception = self._exception, None
        if exception is not None:
            raise exception
        for text in heard:
            warnings.warn(text, stacklevel=_level_of_user())

    def _guard(self, function: Callable[..., object], *arguments: object) -> None:
        """Calls a function of the user; an exception is kept for the caller and stops long work."""
        try:
            function(*arguments)
        except BaseException as raised:
            if self._exception is None:
                self._exception = raised
            if self.is_cancelled_by_exception:
                self.cancel()

    def _heard(self, is_warning: bool, where: str, message: str) -> None:
        if self._log is not None:
            self._guard(self._log, is_warning, where, message)
        elif is_warning:
            self._warnings.append(f"{where}: {message}" if where else message)

    def _progressed(self, *state: Any) -> None:
        self._guard(self._told, *state)


_default = threading.local()


def default_context() -> Context:
    """A context for each thread, made when it is first needed."""
    if not hasattr(_default, "context"):
        _default.context = Context()
    context: Context = _default.context
    return context
