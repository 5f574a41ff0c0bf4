"""The examples of the Python module, run as they are. Their figures are compared within the errors that they state:
with references that do not come from murk where there are some, else with figures recorded here from an earlier run,
which differ by no more than the last bits of another machine make them. A difference may be SIGMA standard errors,
which a right program exceeds in 6e-7 of comparisons.

    python_examples.py MURK LIBRARY [KEEP]

Pictures are kept in the folder KEEP.
"""
import json
import os
import runpy
import shutil
import subprocess
import sys
import tempfile

from python_module import check, done, murk, top

SIGMA = 5
folder = os.path.join(top, "python/examples")


def near(found, error, expected, expected_error, what):
    both = (error**2 + expected_error**2) ** 0.5
    check(abs(found - expected) <= SIGMA * both, f"{what}: {found} +- {error}, not {expected} +- {expected_error}")


def run(name, *arguments):
    """The variables of an example after its run."""
    before, sys.argv = sys.argv, [name, *arguments]
    try:
        return runpy.run_path(os.path.join(folder, name), run_name="__main__")
    finally:
        sys.argv = before


def photon_cube():
    """Absorbed shares of the cube: MMC 2025.10 and MCX-CL 2025.10, .17700 without reflection at the faces and .27255
    with it, to the last digit."""
    v = run("photon_cube.py", "100000")
    for name, expected in (("faces let all light out", 0.17700), ("faces reflect", 0.27255)):
        share, error = v["absorbed"][name]
        near(share, error, expected, 0.5e-5, f"cube, {name}")
        check(abs(share - 1.05 * expected) > SIGMA * error, f"cube, {name}: 5 % more is refused")
    check(v["fluence"].shape == (60, 60, 60) and (v["errors"] >= 0).all(), "an array of fluence with errors")
    # the same photons, counted along their ways
    share, error = v["absorbed"]["faces reflect"]
    near(v["absorbed_by_fluence"], error, share, error, "cube: fluence times absorption is what is absorbed")
    check(v["fluence"][30, 30, 0] == v["fluence"].max(), "cube: brightest where the beam enters")


def visibility_sweep(kept):
    picture = os.path.join(kept, "visibility_sweep.png")
    v = run("visibility_sweep.py", picture)
    recorded = RECORDED_SWEEP
    for value, found, error, (expected, expected_error) in zip(v["visibility_m"], v["coverage"], v["errors"], recorded, strict=True):
        near(found, error, expected, expected_error, f"coverage at {value} m")
    check(v["coverage"] == sorted(v["coverage"]), "the clearer the more is seen")
    if "pyplot" not in v:
        print("skipped: no matplotlib, the example draws no picture")
        return
    with open(picture, "rb") as file:
        check(file.read(8) == b"\x89PNG\r\n\x1a\n", "a picture")
    image = v["pyplot"].imread(picture)
    check(image.shape[:2] == (600, 900) and image[:, :, :3].std() > 0.05, "a picture that is not empty")


def scenario_loop():
    v = run("scenario_loop.py")
    # Sun and sky follow closed models: a thousandth is for other rounding.
    for hour, found, error, expected in zip(v["hours"], v["irradiance"], v["irradiance_errors"], RECORDED_DAY, strict=True):
        check(abs(found - expected) <= SIGMA * error + 1e-3 * expected + 1e-3, f"{hour}:00: {found}, not {expected} W/m2")
    check(v["brightest_x_m"] == v["lamp_x_m"], "the brightest cell is that of the lamp")
    seen, errors = v["seen"], v["seen_errors"]
    near(seen[0], errors[0], seen[-1], errors[-1], "a hall and sensors that are their mirror image")
    check(min(seen) == seen[2], "the lamp in the middle is far from both sensors")


def numpy_grid():
    v = run("numpy_grid.py")
    near(v["transmittance"], v["transmittance_error"], v["expected"], 0, "transmittance of the array")
    check(abs(v["transmittance"] - 1.05 * v["expected"]) > SIGMA * v["transmittance_error"], "5 % more is refused")
    for name, (expected, expected_error) in RECORDED_PLUME.items():
        near(v["coverage"][name], v["errors"][name], expected, expected_error, f"coverage, {name}")


def fit_csv():
    """Readings that were planted with an extinction of .22 and a mean cosine of .87."""
    v = run("fit_csv.py")
    for parameter, planted in zip(v["fit"].parameters, (0.22, 0.87), strict=True):
        near(parameter.value, parameter.standard_error, planted, 0, parameter.key)
    check(v["fit"].accepted and v["fit"].degrees_of_freedom == v["readings"] - 2, "a fit that is accepted")


def moving_load():
    """The last plan is that of a fresh trace of the last place, which begins at the plan before."""
    v = run("moving_load.py")
    fresh = v["hall"].world().move("load", [18, 6, 2]).trace()
    check((fresh.surface == v["light"].surface).all() and (fresh.volume == v["light"].volume).all(), "the same photons")
    sensors = [{"type": "node", "position_m": place} for place in v["places"][-1]]
    check(fresh.sense(sensors).coverage.in_sample == v["plan"].coverage.in_sample, "the same coverage")
    check(len(v["places"]) == 5 and all(len(places) == 4 for places in v["places"]), "four sensors at each of five places")
    try:
        v["world"].move("load", [1, 1])
        check(False, "a place of two numbers")
    except murk.Error as error:
        check("translate_m" in error.where and "2 numbers" in error.text, str(error))


def parallel():
    """Processes by spawn and by forkserver, and the results of one process."""
    path = os.path.join(folder, "parallel.py")
    outputs = []
    for way in ("serial", "spawn", "forkserver", "futures"):
        made = subprocess.run([sys.executable, "-B", "-W", "ignore", path, way], capture_output=True, text=True)
        check(made.returncode == 0, made.stdout + made.stderr)
        outputs.append(made.stdout)
    check(len(outputs[0].splitlines()) == 4 and all(output == outputs[0] for output in outputs),
          f"equal results: {outputs}")


def notebook():
    """The cells without Jupyter, and with it where Debian's nbconvert and ipykernel are installed."""
    path = os.path.join(folder, "first_plan.ipynb")
    with open(path, encoding="utf-8") as file:
        book = json.load(file)
    check((book["nbformat"], book["metadata"]["kernelspec"]["name"]) == (4, "python3"), "a notebook of Python")
    cells = ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code"]
    lines = [line for cell in cells for line in cell.splitlines() if line.strip()]
    check(len(lines) <= 20, f"{len(lines)} lines of code, at most 20")
    check(not any(cell.get("outputs") for cell in book["cells"]), "a notebook without outputs")
    with tempfile.TemporaryDirectory() as work:
        here = os.getcwd()  # the notebook writes into the folder that it runs in
        os.chdir(work)
        try:
            names = {"__name__": "__main__"}
            for cell in cells:
                exec(compile(cell, path, "exec"), names)  # noqa: S102
            check(os.path.getsize("first_plan.html") > 100000, "the page of the plan")
        finally:
            os.chdir(here)
        plan = names["plan"]
        near(plan.coverage.held_out, plan.coverage.held_out_standard_error, *RECORDED_NOTEBOOK, "the plan of the notebook")
        if subprocess.run([sys.executable, "-c", "import nbconvert, ipykernel"], capture_output=True).returncode:
            print("skipped: no nbconvert or ipykernel, the notebook was run without Jupyter")
            return
        shutil.copy(path, work)
        made = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output", "ran.ipynb",
                               os.path.join(work, "first_plan.ipynb")], cwd=work, capture_output=True, text=True,
                              env={**os.environ, "HOME": work, "IPYTHONDIR": work, "JUPYTER_DATA_DIR": work})
        check(made.returncode == 0, made.stderr)
        with open(os.path.join(work, "ran.ipynb"), encoding="utf-8") as file:
            outputs = [output for cell in json.load(file)["cells"] for output in cell.get("outputs", [])]
        shown = "".join("".join(output.get("text", "")) for output in outputs)
        check(f"{plan.coverage.held_out:.3f}" in shown, f"the notebook prints the coverage: {shown}")
        # a line for each step, redrawn: Jupyter obeys the carriage returns
        lines = shown.splitlines()
        check(sum(line.startswith("trace        100 %") for line in lines) >= 2 and "\r" not in shown, f"progress: {shown!r}")
        check(any(line.startswith("coverage ") for line in lines), f"a line of progress has an end: {shown!r}")


RECORDED_SWEEP = [(0.3152, 0.0078), (0.5414, 0.0073), (0.7248, 0.0045), (0.8466, 0.0036), (0.9164, 0.0033),
                  (0.9580, 0.0011)]
RECORDED_DAY = [8.46798e-06, 0.393704, 128.515, 319.699, 385.581, 286.619, 83.7963, 0.00696113]
RECORDED_PLUME = {"no smoke": (1, 0), "smoke": (0.8789, 0.0014), "thick smoke": (0.6735, 0.0020)}
RECORDED_NOTEBOOK = (0.693, 0.001)


def main():
    with tempfile.TemporaryDirectory() as work:
        kept = sys.argv[3] if len(sys.argv) > 3 else work
        os.makedirs(kept, exist_ok=True)
        only = os.environ.get("EXAMPLE")
        for example, arguments in ((photon_cube, ()), (visibility_sweep, (kept,)), (scenario_loop, ()), (numpy_grid, ()),
                                   (fit_csv, ()), (moving_load, ()), (parallel, ()), (notebook, ())):
            if only in (None, example.__name__):
                example(*arguments)
    check(murk.version(), "a version")
    done()


main()
