#!/usr/bin/env python3
"""Plants each kind of breach in a small tree and sees that tools/check_includes.py finds it."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_includes.py"


def check(files: dict[str, str]) -> tuple[int, str]:
    """Exit status and output for a tree of these files."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        result = subprocess.run([sys.executable, str(TOOL), folder], capture_output=True, text=True)
        return result.returncode, result.stdout


class CheckIncludes(unittest.TestCase):
    def accepts(self, name: str, text: str) -> None:
        status, output = check({name: text})
        self.assertEqual(status, 0, output)

    def refuses(self, name: str, text: str, expected: str) -> None:
        status, output = check({name: text})
        self.assertEqual(status, 1, output)
        self.assertIn(f"{name}:{expected}", output)

    def test_an_include_along_the_arrows_is_fine(self):
        self.accepts("thermal/a.cpp", '#include "geometry/mesh.hpp"\n#include <vector>\n')
        self.accepts("sim/run/a.cpp", '#include "radiometry/solver.hpp"\n')
        self.accepts("tests/core/a_test.cpp", '#include "support/catch.hpp"\n#include "sim/a.hpp"\n')

    def test_an_include_against_the_arrows_is_refused(self):
        self.refuses("core/a.cpp", '\n#include "sim/scenario/scenario.hpp"\n', "2: ")
        self.refuses("geometry/a.cpp", '#include "spectral/curve.hpp"\n', "1: ")
        self.refuses("sensor/a.cpp", '#  include "radiometry/solver.hpp"\n', "1: ")
        self.refuses("spectral/a.cpp", '#include "support/catch.hpp"\n', "1: ")
        self.refuses("sim/run/a.cpp", '#include "sim/cli/commands.hpp"\n', "1: ")

    def test_includes_are_written_from_the_root(self):
        self.refuses("core/a.cpp", '#include "vec.hpp"\n', "1: ")
        self.refuses("core/a.cpp", '#include "core/../sim/a.hpp"\n', "1: ")
        self.refuses("sim/a.cpp", "#include <core/vec.hpp>\n", "1: ")

    def test_tests_and_modules_may_name_their_neighbours(self):
        for folder in ("tests/sim", "sim/modules/images", "core"):
            status, output = check({f"{folder}/a.cpp": '#include "b.hpp"\n',
                                    f"{folder}/b.hpp": "#pragma once\n"})
            self.assertEqual(status, 1 if folder == "core" else 0, output)

    def test_libraries_stay_in_the_sources_that_wrap_them(self):
        self.accepts("geometry/a.cpp", "#include <embree3/rtcore.h>\n")
        self.refuses("geometry/a.hpp", "#pragma once\n#include <embree3/rtcore.h>\n", "2: ")
        self.refuses("radiometry/a.cpp", "#include <embree3/rtcore.h>\n", "1: ")
        self.accepts("sim/modules/rasters/a.cpp", "#include <gdal_priv.h>\n")
        self.refuses("sim/files/a.cpp", "#include <gdal_priv.h>\n", "1: ")
        self.refuses("sim/run/a.cpp", "#include <CLI/CLI.hpp>\n", "1: ")

    def test_a_private_header_is_for_the_sources_beside_it(self):
        private = "#pragma once\n// Private to this folder: Embree.\n#include <embree3/rtcore.h>\n"
        use = '#include "geometry/embree.hpp"\n'
        users = {"geometry/a.cpp": (use, 0), "sim/run/a.cpp": (use, 1),
                 "geometry/a.hpp": ("#pragma once\n" + use, 1),
                 "geometry/b.hpp": ("#pragma once\n// Private to this folder: b.\n" + use, 0)}
        for name, (text, expected) in users.items():
            status, output = check({"geometry/embree.hpp": private, name: text})
            self.assertEqual(status, expected, output)

    def test_physics_does_no_input_or_output(self):
        self.refuses("core/a.cpp", "#include <fstream>\n", "1: ")
        self.accepts("sim/files/a.cpp", "#include <fstream>\n")
        self.refuses("core/a.cpp", 'auto a = std::getenv("A");\n', "1: ")
        self.refuses("core/a.cpp", "auto t = std::chrono::steady_clock::now();\n", "1: ")
        self.refuses("core/a.cpp", 'printf("a");\n', "1: ")
        self.accepts("core/a.cpp", '// no printf() here\nauto a = "exit(1)";\n')
        self.accepts("core/a.cpp", "#include <cstdio>\nauto n = std::snprintf(a, 1, b);\n")

    def test_a_comment_is_not_an_include(self):
        self.accepts("core/a.cpp", '// #include "sim/a.hpp"\n/*\n#include "sim/a.hpp"\n*/\n')

    def test_long_files_and_unguarded_headers_are_refused(self):
        self.refuses("core/a.cpp", "\n" * 401, "401: ")
        self.accepts("core/a_table.cpp", "\n" * 401)
        self.refuses("core/a.hpp", "int a();\n", "1: ")

    def test_paths_of_a_machine_are_refused(self):
        # Taken apart, or this file would be a breach itself.
        self.refuses("docs/a.md", "see /" + "root/data\n", "1: ")
        self.refuses("docs/a.md", "see .." + "/shared\n", "1: ")
        self.accepts("tools/a.md", "see .." + "/shared\n")


if __name__ == "__main__":
    unittest.main()
