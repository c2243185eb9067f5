#!/usr/bin/env python3
"""Checks what the folders of the tree may include and say: see docs/architecture.md.

    tools/check_includes.py [TREE]

 1. includes between folders follow the arrows, are written from the root of the tree and start
    with one of its folders;
 2. other libraries appear only in the .cpp files of the folder that wraps them;
 3. the physics below sim/ does no input or output: no stream, file, clock, environment or exit;
 4. files stay below 400 lines, headers begin with #pragma once;
 5. no file names a folder of somebody's machine.

Prints `file:line: message` for each breach; exit status 1 if there is any.
"""
import collections.abc
import os
import pathlib
import re
import subprocess
import sys

# The arrows: what each folder may include besides itself.
MAY_INCLUDE = {
    "core": "",
    "spectral": "core",
    "ephemeris": "core spectral",
    "materials": "core spectral",
    "geometry": "core",
    "atmosphere": "core spectral ephemeris",
    "thermal": "core spectral ephemeris materials geometry atmosphere",
    "radiometry": "core spectral ephemeris materials geometry atmosphere thermal",
    "sensor": "core spectral ephemeris geometry",
}
PHYSICS = tuple(MAY_INCLUDE)
EVERYTHING = {*PHYSICS, "sim"}
ARROWS = {folder: set(names.split()) | {folder} for folder, names in MAY_INCLUDE.items()}
ARROWS |= {"sim": EVERYTHING, "tests": EVERYTHING | {"support"}, "bench": EVERYTHING | {"support"},
           "python": EVERYTHING}

# Other libraries, by the start of the header's name, and the folders whose .cpp files may use them.
LIBRARIES = {
    "atmosphere": r"Eigen/|(tbb|oneapi)/",
    "thermal": r"(tbb|oneapi)/",
    "geometry": r"embree[34]/|GeographicLib/",
    "ephemeris": r"erfam?\.h$|GeographicLib/",
    "sensor": r"erfam?\.h$|GeographicLib/|fmt/|math\.h$",
    "sim": r"(tbb|oneapi)/|tinyxml2\.h$|Imf|Imath|Iex|OpenEXR/|fmt/|nlohmann/|openssl/"
           r"|zlib\.h$|dlfcn\.h$|unistd\.h$|fcntl\.h$|sys/",
    "sim/cli": r"CLI/|fmt/|nlohmann/|unistd\.h$|sys/",
    "sim/modules/rasters": r"(gdal|ogr|cpl)\w*\.h$|sys/|unistd\.h$",
    "sim/modules/images": r"OpenImageIO/|sys/|unistd\.h$",
    "tests": r".",
    "bench": r".",
    "python": r".",
}
# What a header says that only the files beside it may include: it may use a library, and
# cmake/NadirInstall.cmake does not install it.
PRIVATE = re.compile(r"^// Private to this folder\b")
# Where a file may name a header beside it, or below tests/, without its folder: the tests, which
# share the folders' names, the benchmarks, and the modules, which see nothing of the program but
# their own folder.
SIBLINGS = ("tests/", "bench/", "sim/modules/")
# Never installed, so that their headers may wrap a library, or look into a folder's private ones.
NEVER_INSTALLED = ("tests", "bench")

STANDARD = set("""
algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv chrono
cinttypes climits clocale cmath codecvt compare complex concepts condition_variable coroutine
csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cuchar cwchar cwctype deque
exception execution filesystem format forward_list fstream functional future initializer_list
iomanip ios iosfwd iostream istream iterator latch limits list locale map memory memory_resource
mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator
semaphore set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string
string_view strstream syncstream system_error thread tuple type_traits typeindex typeinfo
unordered_map unordered_set utility valarray variant vector version
""".split())

# <cstdio> is not among them: snprintf into a buffer is no output.
INPUT_OUTPUT_HEADERS = set("ctime filesystem fstream iostream syncstream".split())
INPUT_OUTPUT_CALLS = re.compile(
    r"\b(?:std::)?(getenv|setenv|exit|_Exit|quick_exit|abort|f?printf|puts|fopen|system)\s*\("
    r"|\bstd::(cout|cerr|clog|cin)\b|\b\w+_clock::now\b|\bstd::random_device\b")

LONGEST_FILE = 400  # lines; tables are kept apart from code, in files named ..._table or ..._data
TABLE_NAME = re.compile(r"_(table|data)\.[ch]pp$")

# Written so that this file does not match itself.
MACHINE_PATH = re.compile(r"/(?:work|root)/|/tmp/[b]ash")
OUTSIDE_PATH = re.compile(r"\.\./shared")

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:<([^>]+)>|"([^"]+)")')
SKIPPED_FOLDERS = re.compile(r"^(build.*|out|\.git|\.cache|__pycache__)$")

Breach = tuple[int, str]


def tree_files(tree: pathlib.Path) -> list[str]:
    """What git tracks or would track; without git, everything outside build and output folders."""
    git = subprocess.run(
        ["git", "-C", str(tree), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, text=True)
    if git.returncode == 0:
        return sorted(name for name in git.stdout.split("\0") if (tree / name).is_file())
    names = []
    for folder, subfolders, files in os.walk(tree):
        subfolders[:] = [name for name in subfolders if not SKIPPED_FOLDERS.match(name)]
        names += [os.path.relpath(os.path.join(folder, name), tree) for name in files]
    return sorted(names)


def without_comments(lines: list[str]) -> list[str]:
    """The lines without comments and string literals, so that prose may name what code may not."""
    text = "\n".join(lines)
    token = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/', re.S)
    return token.sub(lambda m: "\n" * m.group().count("\n") or " ", text).split("\n")


def library_allowed(tree: pathlib.Path, name: str, header: str) -> bool:
    """Whether the file may use the library; the innermost folder with a row of its own decides."""
    for folder in map(str, pathlib.PurePosixPath(name).parents):
        if folder in LIBRARIES:
            in_place = (name.endswith(".cpp") or is_private(tree / name)
                        or folder.split("/")[0] in NEVER_INSTALLED)
            return in_place and re.match(LIBRARIES[folder], header) is not None
    return False


def is_private(path: pathlib.Path) -> bool:
    """Whether the file is a header for its own folder only, by its first lines."""
    if path.suffix != ".hpp" or not path.is_file():
        return False
    with open(path, encoding="utf-8") as file:
        return any(PRIVATE.match(line) for _, line in zip(range(3), file))


def may_use_private(tree: pathlib.Path, name: str, header: str) -> bool:
    """Whether the file may include a private header; a public one would pass it on."""
    if name.split("/")[0] in NEVER_INSTALLED:
        return True
    beside = pathlib.PurePosixPath(name).parent == pathlib.PurePosixPath(header).parent
    return beside and (name.endswith(".cpp") or is_private(tree / name))


def stands_beside(tree: pathlib.Path, name: str, header: str) -> bool:
    """Whether the header lies in the file's own folder, or under its full name in tests/."""
    beside = (tree / name).parent / header
    return ".." not in header and (beside.is_file() or (tree / "tests" / header).is_file())


def own_include_breach(tree: pathlib.Path, name: str, header: str) -> str | None:
    """What is wrong with an #include "header" in the file, if anything."""
    folder, target = name.split("/")[0], header.split("/")[0]
    if name.startswith(SIBLINGS) and stands_beside(tree, name, header):
        return None
    if target not in EVERYTHING | {"support"} or ".." in header:
        return f'"{header}": write includes from the root of the tree, libraries in <>'
    if target not in ARROWS.get(folder, set()):
        allowed = ", ".join(sorted(ARROWS.get(folder, set()) - {folder})) or "nothing of ours"
        return f'"{header}": {folder}/ may include {allowed}'
    if is_private(tree / header) and not may_use_private(tree, name, header):
        return f'"{header}": only for the .cpp files and private headers beside it'
    if header.startswith("sim/cli/") and not name.startswith(("sim/cli/", "tests/")):
        return f'"{header}": only the command itself includes sim/cli/'
    return None


def library_include_breach(tree: pathlib.Path, name: str, header: str) -> str | None:
    """What is wrong with an #include <header> in the file, if anything."""
    if header in STANDARD:
        if header in INPUT_OUTPUT_HEADERS and name.split("/")[0] in PHYSICS:
            return f"<{header}>: nothing below sim/ does input or output"
        return None
    if header.split("/")[0] in EVERYTHING:
        return f'<{header}>: our own headers are included with ""'
    if not library_allowed(tree, name, header):
        where = "this folder does not wrap that library" if name.endswith(".cpp") else (
            "other libraries appear in .cpp files and private headers only")
        return f"<{header}>: {where}"
    return None


def code_breaches(tree: pathlib.Path, name: str,
                  lines: list[str]) -> collections.abc.Iterator[Breach]:
    """Rules 1 to 4 for one C++ file."""
    physics = name.split("/")[0] in PHYSICS
    for number, (line, code) in enumerate(zip(lines, without_comments(lines)), start=1):
        # `line`, for the header's name is a literal; `code`, so that a comment is none
        if include := "#" in code and INCLUDE.match(line):
            library, own = include.groups()
            message = (own_include_breach(tree, name, own) if own
                       else library_include_breach(tree, name, library))
            if message:
                yield number, message
        elif physics and (call := INPUT_OUTPUT_CALLS.search(code)):
            yield number, (f"{call.group().rstrip(' (')}: nothing below sim/ prints, exits, or "
                           "reads the clock or the environment")
    if len(lines) > LONGEST_FILE and not TABLE_NAME.search(name):
        yield LONGEST_FILE + 1, f"{len(lines)} lines; a file holds one concept in {LONGEST_FILE}"
    if name.endswith(".hpp") and "#pragma once" not in lines:
        yield 1, "a header begins with #pragma once"


def text_breaches(name: str, lines: list[str]) -> collections.abc.Iterator[Breach]:
    """Rule 5 for any text file."""
    for number, line in enumerate(lines, start=1):
        if found := MACHINE_PATH.search(line):
            yield number, f"{found.group()}: a path of one machine"
        if not name.startswith("tools/") and (found := OUTSIDE_PATH.search(line)):
            yield number, f"{found.group()}: a path outside the tree"


def breaches(tree: pathlib.Path, name: str) -> list[Breach]:
    """Everything wrong with one file of the tree."""
    content = (tree / name).read_bytes()
    if b"\0" in content:
        return []  # not text
    lines = content.decode("utf-8", errors="replace").splitlines()
    found = list(text_breaches(name, lines))
    if name.endswith((".hpp", ".cpp")):
        found += code_breaches(tree, name, lines)
    return sorted(found)


def main() -> int:
    tree = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if len(sys.argv) == 1:
        tree = tree.parent.parent
    names = tree_files(tree)
    total = 0
    for name in names:
        for line, message in breaches(tree, name):
            print(f"{name}:{line}: {message}")
            total += 1
    print(f"check_includes: {len(names)} files, {total} breaches")
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
