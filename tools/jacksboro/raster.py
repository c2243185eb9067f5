"""Heights on a geographic grid: reading, refining, and writing them as GeoTIFF.

Written with the standard library so that the tool needs nothing installed. Only what this raster
needs is understood: little-endian, one band, strips, deflate, WGS84 longitudes and latitudes.
"""

import dataclasses
import math
import pathlib
import struct
import zlib

SHORT, LONG, DOUBLE, ASCII = 3, 4, 12, 2
SIZES = {ASCII: 1, SHORT: 2, LONG: 4, DOUBLE: 8}
CODES = {SHORT: "H", LONG: "I", DOUBLE: "d"}

# Geographic WGS84 (EPSG:4326); a value is the height at its pixel's centre (RasterPixelIsArea).
GEO_KEYS = [1, 1, 0, 4, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, 4326, 2054, 0, 1, 9102]


@dataclasses.dataclass
class Grid:
    """Heights in m, rows from north to south; `west` and `north` are the outer edge, degrees."""

    west_deg: float
    north_deg: float
    step_deg: float
    columns: int
    rows: int
    heights: list

    def longitude(self, column: float) -> float:
        return self.west_deg + (column + 0.5) * self.step_deg

    def latitude(self, row: float) -> float:
        return self.north_deg - (row + 0.5) * self.step_deg


def read_geotiff(path: pathlib.Path) -> Grid:
    """Reads 16-bit heights that are deflated with horizontal differences."""
    data = path.read_bytes()
    tags = _tags(data)
    columns, rows = tags[256][0], tags[257][0]
    if data[:4] != b"II*\0" or tags[258] != (16,) or tags[259] != (8,) or tags[317] != (2,):
        raise SystemExit(f"{path}: expected 16-bit deflated strips with predictor 2")
    raw = b"".join(
        zlib.decompress(data[at : at + size]) for at, size in zip(tags[273], tags[279]))
    heights = []
    for row in range(rows):
        value, line = 0, []
        for difference in struct.unpack_from(f"<{columns}H", raw, 2 * row * columns):
            value = (value + difference) & 0xFFFF
            line.append(float(value - 0x10000 if value & 0x8000 else value))
        heights.append(line)
    step, tie = tags[33550][0], tags[33922]
    return Grid(tie[3], tie[4], step, columns, rows, heights)


def _tags(data: bytes) -> dict:
    at = struct.unpack_from("<I", data, 4)[0]
    tags = {}
    for entry in range(struct.unpack_from("<H", data, at)[0]):
        tag, kind, count, value = struct.unpack_from("<HHII", data, at + 2 + 12 * entry)
        if kind not in CODES:
            continue
        place = value if SIZES[kind] * count > 4 else at + 10 + 12 * entry
        tags[tag] = struct.unpack_from(f"<{count}{CODES[kind]}", data, place)
    return tags


# ---- refining ---------------------------------------------------------------------------------


def _spline(t: float) -> list:
    """Weights of the uniform cubic B-spline: smooth to the second derivative, levels out noise."""
    return [(1 - t) ** 3 / 6, (3 * t**3 - 6 * t**2 + 4) / 6,
            (-3 * t**3 + 3 * t**2 + 3 * t + 1) / 6, t**3 / 6]


def _catmull_rom(t: float) -> list:
    """Weights of the Catmull-Rom cubic: passes through the posts and so keeps crests sharp."""
    return [(-t + 2 * t**2 - t**3) / 2, (2 - 5 * t**2 + 3 * t**3) / 2,
            (t + 4 * t**2 - 3 * t**3) / 2, (-t**2 + t**3) / 2]


def refine(source: Grid, west_deg: float, north_deg: float, columns: int, rows: int,
           factor: int) -> Grid:
    """A part of `source` on a grid that is `factor` times finer.

    Level ground gets the B-spline, because the source's whole metres would show there as terraces;
    steep ground gets Catmull-Rom. In between, by the slope of the source, the two are mixed.
    """
    step = source.step_deg / factor
    out = Grid(west_deg, north_deg, step, columns, rows, [])
    for row in range(rows):
        y = (source.north_deg - out.latitude(row)) / source.step_deg - 0.5
        line = []
        for column in range(columns):
            x = (out.longitude(column) - source.west_deg) / source.step_deg - 0.5
            line.append(_refined_height(source, x, y))
        out.heights.append(line)
    return out


def _refined_height(source: Grid, x: float, y: float) -> float:
    column, row = math.floor(x), math.floor(y)
    patch = [source.heights[row + j][column - 1 : column + 3] for j in range(-1, 3)]
    smooth = _weigh(patch, _spline(x - column), _spline(y - row))
    sharp = _weigh(patch, _catmull_rom(x - column), _catmull_rom(y - row))
    inner = [patch[j][i] for j in (1, 2) for i in (1, 2)]
    # 3 m within one source cell of 75 to 93 m is a slope of about 2 degrees, 15 m one of 10
    steep = min(1.0, max(0.0, (max(inner) - min(inner) - 3.0) / 12.0))
    steep = steep * steep * (3.0 - 2.0 * steep)
    return smooth + steep * (sharp - smooth)


def _weigh(patch: list, across: list, down: list) -> float:
    return sum(d * sum(a * h for a, h in zip(across, line)) for d, line in zip(down, patch))


# ---- writing ----------------------------------------------------------------------------------


def round_heights(grid: Grid, quantum_m: float) -> None:
    """To multiples of a power of two: exact in float32, and they deflate well."""
    for line in grid.heights:
        line[:] = [round(height / quantum_m) * quantum_m for height in line]


def write_geotiff(path: pathlib.Path, grid: Grid, description: str, metadata: dict) -> None:
    """32-bit floats, deflated with the floating-point predictor (TIFF technical note 3)."""
    packed = zlib.compress(b"".join(_predicted(line) for line in grid.heights), 9)
    items = "".join(f'  <Item name="{key}">{value}</Item>\n' for key, value in metadata.items())
    entries = [
        (256, LONG, [grid.columns]), (257, LONG, [grid.rows]), (258, SHORT, [32]),
        (259, SHORT, [8]), (262, SHORT, [1]), (270, ASCII, description),
        (273, LONG, [0]), (277, SHORT, [1]), (278, LONG, [grid.rows]),
        (279, LONG, [len(packed)]), (284, SHORT, [1]), (317, SHORT, [3]), (339, SHORT, [3]),
        (33550, DOUBLE, [grid.step_deg, grid.step_deg, 0.0]),
        (33922, DOUBLE, [0.0, 0.0, 0.0, grid.west_deg, grid.north_deg, 0.0]),
        (34735, SHORT, GEO_KEYS),
        (42112, ASCII, f"<GDALMetadata>\n{items}</GDALMetadata>\n"),
    ]
    path.write_bytes(_tiff(entries, packed))


def _predicted(line: list) -> bytes:
    """Bytes of a row, the most significant of all values first, each less the one before."""
    raw = struct.pack(f">{len(line)}f", *line)
    planes = b"".join(raw[plane::4] for plane in range(4))
    return planes[:1] + bytes((b - a) & 0xFF for a, b in zip(planes, planes[1:]))


def _tiff(entries: list, strip: bytes) -> bytes:
    values = []
    for _, kind, content in entries:
        text = kind == ASCII
        values.append(content.encode() + b"\0" if text
                      else struct.pack(f"<{len(content)}{CODES[kind]}", *content))
    after = 8 + 2 + 12 * len(entries) + 4
    places, extra = [], b""
    for value in values:
        places.append(after + len(extra))
        if len(value) > 4:
            extra += value + b"\0" * (len(value) % 2)
    strip_at = after + len(extra)
    directory = struct.pack("<H", len(entries))
    for (tag, kind, _), value, place in zip(entries, values, places):
        if tag == 273:
            value = struct.pack("<I", strip_at)
        field = value.ljust(4, b"\0") if len(value) <= 4 else struct.pack("<I", place)
        directory += struct.pack("<HHI", tag, kind, len(value) // SIZES[kind]) + field
    return struct.pack("<2sHI", b"II", 42, 8) + directory + b"\0\0\0\0" + extra + strip
