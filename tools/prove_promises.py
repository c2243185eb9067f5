#!/usr/bin/env python3
"""Measures the promises on eight small scenes, and writes the tables of docs/promises.md.

    tools/prove_promises.py --nadir build/nadir --work FOLDER [--only NAME ...] [--tables auto,accuracy,time]

For each scene: `auto` against every effect on (same seed, same samples), the picture of
`--accuracy 1%` against a converged one, and `--time`. Runs one program at a time; the figures of
time need a machine with nothing else to do. Needs numpy. Scenes are copied to FOLDER and changed
there: fewer pixels, other bands and hours.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
EFFECTS = """solar_reflection lunar_reflection lamps sky_scattering surface_emission sky_emission
path_scattering path_emission path_transmittance interreflection leaf_transmission volumes shadows
refraction eclipse motion_blur psf detector_noise thermal_solve""".split()
OLI = "library:responses/landsat8_oli.csv"


def array(name: str, samples: int, lines: int, pitch_um: float, bands: str) -> str:
    return (f'<array name="{name}" samples="{samples}" lines="{lines}" pitch_um="{pitch_um:g}">'
            f'{bands}</array>')


def replaced(text: str, pattern: str, by: str) -> str:
    changed, count = re.subn(pattern, lambda _: by, text, flags=re.S)
    if count == 0:
        sys.exit(f"nothing matches {pattern}")
    return changed


def with_arrays(text: str, arrays: str) -> str:
    text = replaced(text, r"<array .*</array>", arrays)
    return re.sub(r' quick_look_bands="[^"]*"', "", text)


def village(text: str, utc: str, arrays: str) -> str:
    """The village with its heat balance, at another hour and in other bands."""
    return with_arrays(replaced(text, r'<time utc="[^"]*"/>', f'<time utc="{utc}"/>'), arrays)


VISIBLE = "".join(f'<band name="{b}" response="{OLI}#{b}"/>' for b in ("Blue", "Green", "Red", "NIR"))
RGB = ('<band_gaussian name="Blue" centre_um="0.455" fwhm_um="0.05"/>'
       '<band_gaussian name="Green" centre_um="0.545" fwhm_um="0.06"/>'
       '<band_gaussian name="Red" centre_um="0.605" fwhm_um="0.06"/>')
LAMPLIGHT = ('<band_box name="Blue" lo_um="0.44" hi_um="0.5"/>'
             '<band_box name="Green" lo_um="0.52" hi_um="0.6"/>'
             '<band_box name="Red" lo_um="0.6" hi_um="0.69"/>')
MID_WAVE = '<band_box name="MWIR" lo_um="3.5" hi_um="4.1"/>'

# name -> folder, file it is made from, how it is changed, what it is, paths a replicate of the reference
SCENES = {
    "day": ("jacksboro", "night.xml",
            lambda t: village(t, "2026-06-21T13:00:00Z", array("visible", 48, 32, 400, VISIBLE)),
            "village by day, 0.45 to 0.88 um; heat balance at hand", 1024),
    "night": ("trials", "town.xml", lambda t: t, "town at night, 10.4 to 11 um, default solver", 512),
    "midwave": ("jacksboro", "night.xml",
                lambda t: village(t, "2026-06-21T17:30:00Z", array("midwave", 48, 32, 400, MID_WAVE)),
                "village at noon, 3.5 to 4.1 um; heat balance", 512),
    "moonlit": ("showcase", "harbour_night.xml",
                lambda t: with_arrays(t, array("visible", 60, 38, 336, LAMPLIGHT)),
                "harbour by moon and lamps, visible", 8192),
    "furnace": ("trials", "furnace.xml", lambda t: t, "furnace with an opening, 8 to 12 um", 4096),
    "canyon": ("trials", "canyon.xml", lambda t: t, "street between walls, visible and NIR", 2048),
    "forest": ("trials", "forest.xml", lambda t: t, "broad-leaved wood, green to NIR", 4096),
    "hazy": ("jacksboro", "hazy.xml",
             lambda t: with_arrays(t, array("rgb", 48, 32, 400, RGB)),
             "village through haze of 5 km, oblique, visible", 2048),
}


def made(work: pathlib.Path, name: str, label: str, extra: str, sampling: str,
         solver: str = "") -> pathlib.Path:
    """Writes a variant of a scene beside the files it needs."""
    folder, file, change, _, _ = SCENES[name]
    text = change((work / "scenes" / folder / file).read_text(encoding="utf-8"))
    text = replaced(text, r"<sampling [^>]*/>", extra + sampling)
    if solver:
        text = re.sub(r"  <solver [^>]*/>\n", "", text)
        text = replaced(text, r"  <materials", f"  {solver}\n  <materials")
    path = work / "scenes" / folder / f"made_{name}_{label}.xml"
    path.write_text(text, encoding="utf-8")
    return path


class Run:
    """One finished run: its report and its images."""

    def __init__(self, folder: pathlib.Path, seconds: float, code: int) -> None:
        self.folder, self.seconds, self.code = folder, seconds, code
        self.report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        self.arrays = [a["name"] for a in self.report["arrays"]]

    def cpu(self, *, without: tuple = ()) -> float:
        return sum(s["cpu_s"] for s in self.report["stages"] if s["name"] not in without)

    def planes(self, ending: str) -> np.ndarray:
        """Of all arrays: [band, pixel]."""
        found = []
        for name in self.arrays:
            header = (self.folder / f"{name}_{ending}.hdr").read_text(encoding="utf-8")
            value = {k: int(re.search(rf"^{k} = (\d+)", header, re.M)[1])
                     for k in ("samples", "lines", "bands")}
            data = np.fromfile(self.folder / f"{name}_{ending}.img", dtype="<f4")
            found.append(data.reshape(value["bands"], -1).astype(float))
        return np.concatenate(found)


def run(nadir: str, scenario: pathlib.Path, out: pathlib.Path, *options: str) -> Run:
    shutil.rmtree(out, ignore_errors=True)
    cache = out.parent / "air-cache"  # every run pays for its own air
    shutil.rmtree(cache, ignore_errors=True)
    start = time.monotonic()
    done = subprocess.run([nadir, "run", str(scenario), "-o", str(out), "-q", *options],
                          env={**os.environ, "NADIR_CACHE": str(cache)}, check=False)
    seconds = time.monotonic() - start
    if done.returncode not in (0, 3):
        sys.exit(f"{scenario}: exit code {done.returncode}")
    return Run(out, seconds, done.returncode)


def floors_of(nadir: str, scenario: pathlib.Path) -> np.ndarray:
    done = subprocess.run([nadir, "plan", str(scenario), "--format", "json", "--no-pilot"],
                          check=True, capture_output=True, text=True)
    plan = json.loads(done.stdout)
    floors = plan["budget"]["floor_radiance_w_m2_sr_um"]
    return np.array([floor for bands in floors.values() for floor in bands.values()])


def all_on() -> str:
    return "<effects " + " ".join(f'{e}="on"' for e in EFFECTS) + "/>"



def sampling(replicates: int, samples: int, wavelengths: str = "4") -> str:
    return (f'<sampling replicates="{replicates}" samples_per_replicate="{samples}" '
            f'wavelengths_per_band="{wavelengths}"/>')


def auto_row(options, name: str) -> str:
    work, spp = options.work, sampling(16, 16)
    automatic = made(work, name, "auto", "", spp)
    everything = made(work, name, "on", all_on(), spp)
    floors = floors_of(options.nadir, automatic)[:, None]
    a = run(options.nadir, automatic, work / "out" / f"{name}_auto", "--audit", "0")
    b = run(options.nadir, everything, work / "out" / f"{name}_on", "--audit", "0")
    la, lb = a.planes("radiance"), b.planes("radiance")
    ea, eb = a.planes("error"), b.planes("error")
    ea, eb = ea[: len(la)], eb[: len(lb)]
    level = np.maximum(lb, floors)
    difference = np.abs(la - lb)
    budget = 0.01 * level
    clear = difference > budget + 2.0 * np.hypot(ea, eb)
    mean = np.abs(la.mean(axis=1) / lb.mean(axis=1) - 1.0).max()
    plan = json.loads(subprocess.run([options.nadir, "plan", str(automatic), "--format", "json",
                                      "--no-pilot"], check=True, capture_output=True,
                                     text=True).stdout)
    dropped = [e["name"] for e in plan["effects"]
               if e["state"].startswith("off") and "absent" not in e["state"]]
    return (f"| {name}: {SCENES[name][3]} | {', '.join(dropped) or 'none'} | {100 * mean:.3f} | "
            f"{100 * (difference > budget).mean():.2f} | {100 * clear.mean():.2f} | "
            f"{b.cpu():.1f} | {a.cpu():.1f} | {b.cpu() / a.cpu():.1f} |")


def accuracy_row(options, name: str) -> str:
    work, paths = options.work, SCENES[name][4]
    wanted = made(work, name, "wanted", "", sampling(4, 2))
    exact = made(work, name, "reference", all_on(), sampling(16, paths // options.quicker, "12"),
                 '<solver method="path"/>')
    floors = floors_of(options.nadir, wanted)[:, None]
    a = run(options.nadir, wanted, work / "out" / f"{name}_1pc", "--accuracy", "1%")
    b = run(options.nadir, exact, work / "out" / f"{name}_reference", "--audit", "0", "--seed", "1")
    la, lb = a.planes("radiance"), b.planes("radiance")
    ea, eb = a.planes("error")[: len(la)], b.planes("error")[: len(lb)]
    bias = a.planes("bias")[: len(la)]
    level = np.maximum(lb, floors)
    off = np.abs(la - lb)
    strictly = (off <= 2.0 * ea + bias).mean()
    fairly = (off <= 2.0 * np.hypot(ea, eb) + bias).mean()
    return (f"| {name} | {100 * np.percentile(ea / level, 95):.2f} | {100 * np.median(bias / level):.2f} | "
            f"{100 * np.median(eb / level):.2f} | {100 * strictly:.1f} | {100 * fairly:.1f} | "
            f"{100 * abs(la.mean() / lb.mean() - 1.0):.2f} | {a.cpu():.0f} | {b.cpu():.0f} | {a.code} |")


def time_row(options, name: str, seconds: float) -> str:
    folder, file = {"day": ("jacksboro", "day.xml"), "night": ("jacksboro", "night.xml"),
                    "harbour": ("showcase", "harbour_night.xml")}[name]
    scenario = options.work / "scenes" / folder / file
    done = run(options.nadir, scenario, options.work / "out" / f"{name}_time", "--time", f"{seconds:g}s")
    return f"| {folder}/{file} | {seconds:g} | {done.seconds:.2f} | {100 * (done.seconds / seconds - 1):+.1f} | {done.code} |"


TABLES = {
    "auto": ("| scene | dropped | mean difference, % | pixels beyond 1 %, % | beyond 1 % + 2 se, % | "
             "all on, CPU s | auto, CPU s | ratio |\n|---|---|---|---|---|---|---|---|", auto_row),
    "accuracy": ("| scene | reached (95 % of pixels), % | stated bias, % | error of the reference, % | "
                 "within 2 se + bias, % | with the reference's error, % | mean difference, % | CPU s | "
                 "reference, CPU s | exit code |\n|---|---|---|---|---|---|---|---|---|---|", accuracy_row),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--nadir", required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--only", nargs="*", default=list(SCENES), choices=list(SCENES))
    parser.add_argument("--tables", default="auto,accuracy,time")
    parser.add_argument("--quicker", type=int, default=1, help="paths of references are divided by this")
    options = parser.parse_args()
    options.nadir = str(pathlib.Path(options.nadir).resolve())
    shutil.rmtree(options.work / "scenes", ignore_errors=True)
    shutil.copytree(ROOT / "scenes", options.work / "scenes")
    for table in options.tables.split(","):
        if table == "time":
            print("\n| scenario | budget, s | took, s | off by, % | exit code |\n|---|---|---|---|---|")
            for name, seconds in (("day", 30.0), ("day", 90.0), ("night", 90.0), ("harbour", 60.0)):
                print(time_row(options, name, seconds), flush=True)
            continue
        head, row = TABLES[table]
        print("\n" + head)
        for name in options.only:
            print(row(options, name), flush=True)


if __name__ == "__main__":
    main()
