#!/usr/bin/env python3
"""Compares docs/hard-cases.md with the suite: every test that the page names must exist, and every
test of the suite must be on the page.

    check_hard_cases.py PAGE TEST_PROGRAM
"""
import re
import subprocess
import sys


def named(page: str) -> set[str]:
    """Names of tests in a page: list items that hold nothing but a name in back quotes."""
    items = re.findall(r"^- `([^`]+)`$", page, flags=re.MULTILINE)
    return {" ".join(item.split()) for item in items}


def existing(program: str) -> set[str]:
    """Names of the tests that a program of Catch2 runs by default."""
    run = subprocess.run([program, "--list-test-names-only"], capture_output=True, text=True,
                         check=False)  # Catch2 2 gives the number of tests as its status
    return {" ".join(line.split()) for line in run.stdout.splitlines() if line.strip()}


def main(page_name: str, program: str) -> int:
    with open(page_name, encoding="utf-8") as file:
        on_page = named(file.read())
    tests = existing(program)
    if not tests:
        print(f"{program} lists no tests")
        return 1
    for name in sorted(on_page - tests):
        print(f"{page_name} names a test that does not exist: {name}")
    for name in sorted(tests - on_page):
        print(f"{page_name} does not name the test: {name}")
    print(f"{len(tests)} tests, {len(on_page)} on the page")
    return 0 if on_page == tests else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
