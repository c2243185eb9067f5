#!/usr/bin/env python3
"""Times whole runs of the scenes that ship: render time, rays, rays a second, memory.

    bench/whole_scenes.py build/nadir [--threads N] [SCENARIO ...]

Prints a Markdown table from the runs' own reports; the pictures go to a temporary folder.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes"
SHIPPED = ["jacksboro/day.xml", "jacksboro/night.xml", "showcase/harbour.xml",
           "showcase/harbour_night.xml"]


def run(nadir, scenario, threads):
    """The report of one run."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([nadir, "run", scenario, "--output", folder, "--quiet",
                        "--threads", str(threads)], check=True, stdout=subprocess.DEVNULL)
        return json.loads((pathlib.Path(folder) / "report.json").read_text(encoding="utf-8"))


def row(scenario, report):
    render = next(stage for stage in report["stages"] if stage["name"] == "render")
    rays = report["counters"]["rays"]
    errors = [band["relative_standard_error"]["median"]
              for array in report["arrays"] for band in array["bands"]]
    return (f"| {scenario} | {report['settings']['solver']} | {render['wall_s']:.1f} | "
            f"{render['cpu_s']:.1f} | {rays / 1e6:.1f} | {rays / render['wall_s'] / 1e6:.2f} | "
            f"{report['peak_memory_bytes'] / 1e6:.0f} | "
            f"{100 * min(errors):.1f} - {100 * max(errors):.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("nadir")
    parser.add_argument("scenarios", nargs="*")
    parser.add_argument("--threads", type=int, default=0)
    options = parser.parse_args()
    print("| scene | solver | render, s | processor, s | rays, M | M rays/s | MB | median error, % |")
    print("|---|---|---|---|---|---|---|---|")
    for scenario in options.scenarios or [str(SCENES / name) for name in SHIPPED]:
        name = pathlib.Path(scenario).stem
        print(row(name, run(options.nadir, scenario, options.threads)), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
