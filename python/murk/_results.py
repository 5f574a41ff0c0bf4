"""Results by the names of the JSON files of the program, and what all results have in common."""
from __future__ import annotations

import json
import os
import re
import tempfile
from typing import Any, Callable, Mapping, Sequence

from ._context import Context, default_context
from ._library import Error, Path, c_text, call, call_in, call_long, ffi, lib, string, yaml_of


class Result(dict):  # type: ignore[type-arg]
    """The fields of a result: a dict with the names of the JSON file of the program, nested; null is None.

    `result["coverage"]["held_out"]`, `result.coverage.held_out` and `result.get_path("coverage.held_out")` are the
    same number. Names that are methods of dict (`values`, `items`, ...) are reached in brackets alone. Results can be
    pickled and compared. Units: those of the names, listed in murk-results(5).

    Example: `print(plan.result.bound)`.
    """

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the result has no field {name}; it has {', '.join(self)}") from None

    def get_path(self, path: str) -> Any:
        """The value at a path, names and indices joined by dots. Raises KeyError or IndexError.

        A name may contain dots itself, such as `ground.001` of a material: the longest name that leads to a value counts.

        Example: `plan.result.get_path("sensors.0.position_m")`.
        """
        return _value_at(self, path.split("."))


def _value_at(value: Any, parts: list[str]) -> Any:
    """The value at a path from a value. Of a dict, the longest name that the parts begin with is tried first."""
    if not parts:
        return value
    if isinstance(value, list):
        if not re.fullmatch(r"-?\d+", parts[0]):
            raise KeyError(parts[0])
        return _value_at(value[int(parts[0])], parts[1:])
    failure: LookupError = KeyError(parts[0])
    for n in range(len(parts), 0, -1):
        name = ".".join(parts[:n])
        if isinstance(value, dict) and name in value:
            try:
                return _value_at(value[name], parts[n:])
            except LookupError as error:
                failure = error
    raise failure


def result_of(function: Any, handle: Any) -> Result:
    """The fields of a handle by its murk_..._fields()."""
    fields = ffi.new("const murk_fields **")
    call(function, handle, fields)
    return result_in(fields)


def result_in(fields: Any) -> Result:
    """The fields that a call has given back, as Python objects."""
    result: Result = json.loads(string(lib.murk_fields_json(fields[0])), object_hook=Result)
    return result


def restored(kind: Any, state: dict[str, Any]) -> Any:
    """An object from its values, without a handle: what pickle makes."""
    made = kind.__new__(kind)
    made.__dict__.update(state)
    return made


def handle_of(owner: Any) -> Any:
    """The handle of an object. Raises Error for one that was pickled."""
    if owner.c is None:
        raise Error(f"this {type(owner).__name__} was pickled: it has values, but the library holds nothing for it")
    return owner.c


class Fielded:
    """A handle whose fields are attributes."""

    result: Result
    context: Any = None  # of a pickled object
    c: Any = None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or "result" not in self.__dict__:
            raise AttributeError(name)
        return getattr(self.result, name)

    def __getitem__(self, name: str) -> Any:
        """The field of that name: `plan["coverage"]` is `plan.coverage`. Raises KeyError."""
        return self.result[name]

    def __reduce__(self) -> tuple[Any, ...]:
        return restored, (type(self), {"result": self.result})


def save(owner: Any, function: Any, folder: Path, exports: Sequence[str], replace: bool) -> None:
    """Writes the files of a handle by its murk_..._save()."""
    words = c_text(",".join(exports)) if exports else ffi.NULL  # lives as long as the call
    options = ffi.new("murk_save_options *", {"size": ffi.sizeof("murk_save_options"), "exports": words,
                                              "replaces": replace})
    call_long(owner.context, function, handle_of(owner), c_text(folder), options, ffi.NULL)


def report(folder: Path, page: Path | None = None, context: Context | None = None) -> Path:
    """Writes one HTML page of a folder of results and returns its path.

    folder: what a `save()` or the program's `-o` wrote. page None: report.html in the folder. A file that murk did not
    write is not replaced. Arrays of the scene are in no file: the page shows them if the world, light, plan or fit that
    was saved to the folder last still exists, in the same context. Raises Error if the folder holds no results.
    Source: `murk report`.

    Example: `murk.report("out", "page.html")`.
    """
    _write_report(context or default_context(), folder, page)
    return os.path.join(os.fspath(folder), "report.html") if page is None else page


def _write_report(context: Context, folder: Path, page: Path | None, made_by: str | None = None) -> None:
    maker = c_text(made_by)  # lives as long as the call
    options = ffi.new("murk_save_options *", {"size": ffi.sizeof("murk_save_options"), "made_by": maker})
    call_long(context, lib.murk_context_write_report, context.c, c_text(folder), c_text(page), options, ffi.NULL)


def reference(name: str = "scene", context: Context | None = None) -> Result:
    """What murk knows of files and of itself, for editors and forms.

    name: "scene" or "study": `keys` of the top level, and `all`, a list of all keys with `path`, `type`, `value`, `range`,
    `words`, `unit`, `default`, `meaning` and so on; "scene.KEY" or "study.KEY": `rows` of one key, and `keys` of its map;
    "schema": a JSON Schema of both; "version": commit, compiler and packages. Raises Error if there is no such name or
    key. Source: `murk help`, `murk schema`.

    Example: `murk.reference("scene.media.fog.albedo").rows[0].value`.
    """
    context = context or default_context()
    fields = ffi.new("const murk_fields **")
    call(lib.murk_context_reference, context.c, c_text(name), fields)
    return result_in(fields)


def read_keys(path: Path, context: Context | None = None) -> dict[str, Any]:
    """The keys in a file of lines KEY: VALUE, such as calibrated.yaml of a fit, and their values: a dict for `Scene()`
    and `study()`.

    Warns if the data refused the model of the fit. Raises Error if the file cannot be read or is not such a map.
    Source: `--set @FILE` of the program.

    Example: `scene = murk.Scene(file="yard.yaml", **murk.read_keys("out/calibrated.yaml"))`.
    """
    context = context or default_context()
    fields = ffi.new("const murk_fields **")
    call_in(context, lib.murk_context_read_keys, context.c, c_text(path), fields)
    return {key.key: _scalar(key.value) for key in result_in(fields)["keys"]}


_WORDS = {"true": True, "false": False, "null": None, "~": None, "": None}


def _scalar(text: str) -> Any:
    """The value of a YAML text that is not quoted."""
    if re.fullmatch(r"[-+]?\d+", text):
        return int(text)
    if re.fullmatch(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?", text):
        return float(text)
    return _WORDS.get(text, text)


def report_of(saved: Any, page: Path) -> Path:
    """The page of an object that has save(), through a folder that is removed."""
    handle_of(saved)
    with tempfile.TemporaryDirectory(prefix="murk-") as folder:
        saved.save(folder)
        _write_report(saved.context, folder, page, f"{type(saved).__name__}.report() of a program in Python")
        return page


def shard_of(shard: tuple[int, int] | None) -> tuple[int, int]:
    """The number of a part and the number of parts; (0, 0) for None. Raises Error."""
    number, count = (0, 0) if shard is None else shard
    if shard is not None and not (1 <= number <= count <= 100000):
        raise Error(f"({number}, {count}), must be (K, N): part K of N, at most 100000", where="argument shard")
    return number, count


class Study(Fielded):
    """The rows of a study: `result` has the fields of study.json, each of which is an attribute, too.

    `rows` is a list with `values`, `standard_errors` and `failed` of each row. Pickles with its fields.
    Source: `murk study`.

    Example: `[row["values"]["density"] for row in murk.study("fog.yaml").rows]`.
    """

    def __init__(self, path: Path, folder: Path | None = None, context: Context | None = None,
                 keys: Mapping[str, Any] | None = None, shard: tuple[int, int] | None = None,
                 parts: Sequence[Path] = ()) -> None:
        self.context = context or default_context()
        out = ffi.new("murk_study **")
        # Strings live as long as the call.
        kept, names = c_text(folder), [c_text(key) for key in keys or {}]
        values = [c_text(yaml_of(key, value)) for key, value in (keys or {}).items()]
        folders = [c_text(part) for part in parts]
        number, count = shard_of(shard)
        options = ffi.new("murk_study_options *", {"size": ffi.sizeof("murk_study_options"), "folder": kept,
                                                   "n": len(names), "shard_number": number, "shard_count": count,
                                                   "parts": len(folders)})
        arrays = [ffi.new("const char *[]", texts) for texts in (names, values, folders)]
        options.key, options.value, options.part = arrays
        call_long(self.context, lib.murk_study_read, out, self.context.c, c_text(path), options)
        self.c = ffi.gc(out[0], lib.murk_study_destroy)
        call_long(self.context, lib.murk_study_run, self.c)
        self.result = result_of(lib.murk_study_fields, self.c)

    def save(self, folder: Path, replace: bool = False) -> None:
        """Writes the files of `murk study` to a folder: study.json, table.csv. replace: as in `Plan.save()`.

        Raises Error.

        Example: `study.save("out")`.
        """
        save(self, lib.murk_study_save, folder, (), replace)

    def report(self, page: Path) -> Path:
        """Writes one HTML page of the study and returns its path. Raises Error.

        Example: `study.report("study.html")`.
        """
        return report_of(self, page)


class Follow(Fielded):
    """The steps of a timeline: `result` has the fields of follow.json, each of which is an attribute, too.

    `steps` is a list with the columns of follow.csv. Pickles with its fields. Source: `murk follow`.

    Example: `[step.coverage for step in scene.follow().steps]`.
    """

    def __init__(self, scene: Any, folder: Path | None, each: Callable[[Result], object] | None, exports: Sequence[str],
                 replace: bool, shard: tuple[int, int] | None, parts: Sequence[Path]) -> None:
        self.context = scene.context
        number, count = shard_of(shard)
        out, row = ffi.new("murk_follow **"), ffi.new("const murk_fields **")
        words = c_text(",".join(exports)) if exports else ffi.NULL  # lives as long as the call
        options = ffi.new("murk_save_options *", {"size": ffi.sizeof("murk_save_options"), "exports": words,
                                                  "replaces": replace})
        call_long(self.context, lib.murk_follow_create, out, handle_of(scene), c_text(folder), options)
        self.c = ffi.gc(out[0], lib.murk_follow_destroy)
        if shard is not None:
            call_long(self.context, lib.murk_follow_shard, self.c, number, count)
        if parts:
            folders = [c_text(part) for part in parts]
            call_long(self.context, lib.murk_follow_merge, self.c, ffi.new("const char *[]", folders), len(folders))
        call_long(self.context, lib.murk_follow_next, self.c, row)
        while row[0] != ffi.NULL:
            if each:
                each(result_in(row))
            call_long(self.context, lib.murk_follow_next, self.c, row)
        self.result = result_of(lib.murk_follow_fields, self.c)
        if folder is not None:
            call_long(self.context, lib.murk_follow_save, self.c, ffi.NULL)


def study(path: Path, folder: Path | None = None, context: Context | None = None,
          keys: Mapping[str, Any] | None = None, shard: tuple[int, int] | None = None,
          parts: Sequence[Path] = ()) -> Study:
    """Runs the rows of a study file: Study.

    folder: keeps finished rows, which are not run again by the next call. keys: paths of keys that are set in the scene
    of each row, and their values, such as those of `read_keys()`. A row that fails has the reason in its field
    `failed`. Raises Error if the study file or its scene is wrong. Groups of rows run in subprocesses.

    shard: (K, N): runs part K of N of the rows alone, and keeps it in the folder, on any machine. parts: such folders, in
    any order, whose rows are taken over; rows of missing parts are run, with a warning. The results are those of a single
    run, in every bit. Raises Error for parts of another study. Source: `murk study --shard`, `murk merge`.

    Example: `study = murk.study("scenes/studies/fog-yard.yaml", folder="rows")`.
    """
    return Study(path, folder, context, keys, shard, parts)
