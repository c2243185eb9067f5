#!/usr/bin/env python3
"""No two files define a type of one name in one namespace: programs in which two sources each see
another of them still link, and mix up their members (the one-definition rule asks for no report).

    check_names.py [FOLDER...]     the tree's folders by default
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("core spectral ephemeris materials geometry atmosphere thermal radiometry sensor sim "
           "tests/support").split()
SPACE = re.compile(r"namespace(?: ([\w:]+))? \{")
# Formatted sources: what stands in a namespace begins its line.
TYPE = re.compile(r"(?:struct|class|enum class|union) (\w+)(?: final)?(?= \{| :)")


def types(text: str):
    """Namespace and name of every type that other files could meet under this name."""
    spaces: list[str] = []
    for line in text.splitlines():
        space = SPACE.match(line)
        if space and line.rstrip().endswith("{"):
            spaces.append(space.group(1) or "")
        elif line.startswith("}  // namespace") and spaces:
            spaces.pop()
        elif (found := TYPE.match(line)) and "" not in spaces:
            yield "::".join([*spaces, found.group(1)])


def main(folders: list[Path]) -> int:
    places = defaultdict(set)
    for folder in folders:
        for file in sorted([*folder.rglob("*.hpp"), *folder.rglob("*.cpp")]):
            for name in types(file.read_text(encoding="utf-8")):
                places[name].add(file)
    twice = {name: files for name, files in places.items() if len(files) > 1}
    for name, files in sorted(twice.items()):
        print(f"{name} is defined in " + " and ".join(str(f) for f in sorted(files)))
    if not twice:
        print(f"{len(places)} types, each defined once")
    return 1 if twice or not places else 0


if __name__ == "__main__":
    sys.exit(main([Path(a) for a in sys.argv[1:]] or [ROOT / f for f in FOLDERS]))
