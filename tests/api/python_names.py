"""The public names of the Python module: each has a docstring with an example, annotations, and its place in
doc/python/README.md; mypy finds no mistake in the annotations; every function of murk.h is used by the module, or
named here with the reason.

    python_names.py MURK LIBRARY
"""
import importlib.machinery
import importlib.util
import inspect
import os
import re
import subprocess
import sys
import tempfile

from python_module import check, done, library, murk, top

UNUSED = {
    "murk_array_of": "arrays are described by NumPy's own strides",
    "murk_status_text": "the text of an error says more",
    "murk_fields_kind": "fields are read as JSON, all at once",
    "murk_fields_double": "as murk_fields_kind",
    "murk_fields_int64": "as murk_fields_kind",
    "murk_fields_bool": "as murk_fields_kind",
    "murk_fields_string": "as murk_fields_kind",
    "murk_fields_length": "as murk_fields_kind",
    "murk_fields_name": "as murk_fields_kind",
    "murk_plan_for_matrix": "plans of Python are of scenes, whose matrix is an array",
    "murk_context_preset": "the optics of a medium are those of a scene that names the preset",
    "murk_context_profile_grid": "grids of Python are arrays, which NumPy makes of a profile",
    "murk_sensors_count": "lists of sensors are lists of Python",
    "murk_sensors_get": "as murk_sensors_count",
    "murk_plan_sensors": "the field `sensors` of a plan has them",
    "murk_world_check_save": "folders are checked when files are saved",
    "murk_study_check_save": "as murk_world_check_save",
    "murk_fit_check_save": "as murk_world_check_save",
    "murk_picture_check": "as murk_world_check_save",
}


def tool():
    """tools/python_reference as a module."""
    loader = importlib.machinery.SourceFileLoader("python_reference", os.path.join(top, "tools/python_reference"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def annotated(name, function):
    signature = inspect.signature(function)
    check(signature.return_annotation is not inspect.Signature.empty, f"{name} has an annotation of its result")
    for parameter in signature.parameters.values():
        check(parameter.name == "self" or parameter.annotation is not inspect.Parameter.empty,
              f"{name}: the argument {parameter.name} has an annotation")


def described(name, thing):
    text = inspect.getdoc(thing) or ""
    check(len(text.split()) >= 3, f"{name} has a docstring")
    check("Example: `" in text or f"`{name.split('.')[0].lower()}[" in text or "`\"" in text or "`plan[" in text,
          f"the docstring of {name} has an example")
    return text


def names():
    reference = tool()
    public = {name for name in vars(murk) if not name.startswith("_") and not inspect.ismodule(getattr(murk, name))}
    check(public == set(murk.__all__), f"all public names are in __all__: {public ^ set(murk.__all__)}")
    for name in murk.__all__:
        thing = getattr(murk, name)
        described(name, thing)
        check(thing.__module__ == "murk", f"{name} is of the package")
        if not inspect.isclass(thing):
            annotated(name, thing)
            continue
        if inspect.isfunction(vars(thing).get("__init__")):
            annotated(f"{name}.__init__", thing.__init__)
        for member_name, member in reference.members_of(thing):
            text = described(f"{name}.{member_name}", member)
            function = member.fget if isinstance(member, property) else member
            annotated(f"{name}.{member_name}", function)
            # Work of the library can fail.
            if "call" in function.__code__.co_names or "call_long" in function.__code__.co_names:
                check("Raises" in text or member_name == "matrix", f"{name}.{member_name} says when it fails")
    run = subprocess.run([sys.executable, os.path.join(top, "tools/python_reference"), library, "--check"],
                         capture_output=True, text=True)
    check(run.returncode == 0, run.stderr)


def functions_of_the_header():
    with open(os.path.join(top, "src/murk.h"), encoding="utf-8") as file:
        declared = set(re.findall(r"^[a-z].*[ *](murk_[a-z0-9_]*)\(", file.read(), re.M))
    text = ""
    folder = os.path.join(top, "python/murk")
    for name in sorted(os.listdir(folder)):
        if name.endswith(".py"):
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                text += file.read()
    used = set(re.findall(r"lib\.(murk_\w+)", text))
    check(used <= declared, f"not in murk.h: {used - declared}")
    check(not used & set(UNUSED), f"used after all: {used & set(UNUSED)}")
    check(declared == used | set(UNUSED), f"not used and not named here: {declared - used - set(UNUSED)}")


def types():
    if not os.path.exists("/usr/bin/mypy"):
        print("skipped: no mypy, the types are not checked")
        return
    # A user of the module: mistakes of type are found.
    user = "import murk\nplan = murk.Scene(file='a.yaml').place()\nplan.save(3)\nmurk.Light().surface\nx: str = plan.report('a')[0]\n" \
           "murk.Scene().trace(each_batch=lambda batch: batch.colour)\nmurk.Scene().trace(each_batch=3)\n" \
           "murk.Scene().trace(lambda batch: batch.number < 9)\n"
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "user.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(user)
        for what, lines in ((["--strict", "-p", "murk"], []), ([path], [3, 4, 5, 6, 7])):
            run = subprocess.run(["/usr/bin/mypy", "--ignore-missing-imports", "--no-error-summary", "--cache-dir", folder,
                                  *what], cwd=os.path.join(top, "python"), capture_output=True, text=True)
            found = [int(line.split(":")[1]) for line in run.stdout.splitlines()]
            check(found == lines, run.stdout + run.stderr)


names()
functions_of_the_header()
types()
done()
