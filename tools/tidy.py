#!/usr/bin/env python3
"""Runs clang-tidy over the sources of a build, several at once, and remembers what was clean.

    tools/tidy.py --build build-check [--jobs 2] [--all] [FILE...]

A file that was clean is not linted again until it, one of the project's headers that it includes,
its compile command, a .clang-tidy file or clang-tidy itself changes. Exit status 1 if there is any
finding. --all forgets what is remembered. Without FILE, every source of the build is linted.
"""
import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLANG_TIDY = "clang-tidy-14"


def compile_commands(build: pathlib.Path) -> dict[pathlib.Path, dict]:
    """The command for each of our own sources; generated files lie in the build and are not ours."""
    with open(build / "compile_commands.json", encoding="utf-8") as file:
        entries = json.load(file)
    return {
        path: entry
        for entry in entries
        if (path := pathlib.Path(entry["file"])).is_relative_to(ROOT)
        and not path.is_relative_to(build)
    }


def project_headers(build: pathlib.Path) -> dict[str, list[pathlib.Path]]:
    """For each object file, the files of ours that the compiler read, as ninja recorded them."""
    text = subprocess.run(
        ["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=True
    ).stdout
    deps: dict[str, list[pathlib.Path]] = {}
    current: list[pathlib.Path] = []
    for line in text.splitlines():
        if line.startswith("    "):
            path = (build / line.strip()).resolve()
            if path.is_relative_to(ROOT):
                current.append(path)
        elif ": #deps" in line:
            current = deps.setdefault(line.split(":", 1)[0], [])
    return deps


def digest(paths: list[pathlib.Path], texts: list[str]) -> str:
    """A name for the contents of all of these."""
    total = hashlib.sha256()
    for text in texts:
        total.update(text.encode() + b"\0")
    for path in sorted(set(paths)):
        total.update(str(path.relative_to(ROOT)).encode() + b"\0")
        total.update(hashlib.sha256(path.read_bytes()).digest() if path.exists() else b"gone")
    return total.hexdigest()


def lint(build: pathlib.Path, path: pathlib.Path) -> tuple[bool, str]:
    """Whether the file is clean, and what clang-tidy says."""
    result = subprocess.run(
        [CLANG_TIDY, "--quiet", "-p", str(build), str(path)], capture_output=True, text=True
    )
    # stderr only counts the warnings of other people's headers, unless something went wrong
    text = result.stdout if result.stdout.strip() else result.stderr
    return result.returncode == 0, "" if result.returncode == 0 else text


def findings(text: str) -> list[str]:
    """The output of clang-tidy, cut before each finding; its notes stay with it."""
    return re.split(r"(?m)^(?=\S+:\d+:\d+: (?:warning|error):)", text)


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a finished build folder")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--all", action="store_true", help="also files known to be clean")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    return parser.parse_args()


def main() -> int:
    options = parse_arguments()
    build = options.build.resolve()
    commands = compile_commands(build)
    headers = project_headers(build)
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, text=True).stdout
    configs = [path for path in ROOT.glob("**/.clang-tidy") if not path.is_relative_to(build)]
    wanted = [path.resolve() for path in options.files] or sorted(commands)
    cache = build / "tidy-cache"
    cache.mkdir(exist_ok=True)

    keys = {}
    for path in wanted:
        entry = commands[path]
        key = digest([path, *headers.get(entry.get("output", ""), []), *configs],
                     [version, entry["command"]])
        if options.all or not (cache / key).exists():
            keys[path] = key


    seen: set[str] = set()
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = {pool.submit(lint, build, path): path for path in keys}
        for future in concurrent.futures.as_completed(results):
            path = results[future]
            clean, text = future.result()
            if clean:
                (cache / keys[path]).touch()
                continue
            bad += 1
            for finding in findings(text):
                if finding not in seen:
                    seen.add(finding)
                    print(finding, end="", flush=True)
    print(f"clang-tidy: {len(wanted)} files, {len(keys)} linted, {bad} with findings")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
