"""Triangle meshes with named parts (x east, y north, z up, metres) and their OBJ files."""

import pathlib


class Mesh:
    """Polygons by part; corners run counter-clockwise seen from outside."""

    def __init__(self):
        self.faces = {}  # part -> list of lists of corners

    def add(self, part: str, corners: list) -> None:
        self.faces.setdefault(part, []).append(corners)

    def quad(self, part: str, a: tuple, b: tuple, c: tuple, d: tuple) -> None:
        self.add(part, [a, b, c, d])

    def box(self, part: str, lo: tuple, hi: tuple, bottom: bool = True) -> None:
        """Sides along the axes; a bottom that nobody sees may be left out."""
        (x0, y0, z0), (x1, y1, z1) = lo, hi
        self.quad(part, (x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1))
        self.quad(part, (x1, y1, z0), (x0, y1, z0), (x0, y1, z1), (x1, y1, z1))
        self.quad(part, (x0, y1, z0), (x0, y0, z0), (x0, y0, z1), (x0, y1, z1))
        self.quad(part, (x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1))
        self.quad(part, (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1))
        if bottom:
            self.quad(part, (x0, y1, z0), (x1, y1, z0), (x1, y0, z0), (x0, y0, z0))

    def triangles(self) -> int:
        return sum(len(face) - 2 for faces in self.faces.values() for face in faces)

    def write(self, path: pathlib.Path, what: str) -> None:
        """Writes OBJ: equal corners once, rounded to centimetres."""
        numbers, lines = {}, []
        for part, faces in self.faces.items():
            lines.append(f"usemtl {part}")
            for face in faces:
                indices = []
                for corner in face:
                    key = " ".join(_short(value) for value in corner)
                    indices.append(numbers.setdefault(key, len(numbers) + 1))
                if len(set(indices)) == len(indices):
                    lines.append("f " + " ".join(map(str, indices)))
        head = [f"# {what}", "# Made by tools/make_jacksboro.py. x east, y north, z up, metres."]
        vertices = [f"v {key}" for key in numbers]
        path.write_text("\n".join(head + vertices + lines) + "\n", encoding="ascii")


def _short(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
