"""Small grey rasters as PNG: parking lot's markings, yard's furrows, lawn's contrast."""

import math
import pathlib
import random
import struct
import zlib


def write_png(path: pathlib.Path, rows: list) -> None:
    """8-bit grey, rows from north to south (W3C PNG, third edition)."""
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", head)
                     + _chunk(b"IDAT", zlib.compress(raw, 9)) + _chunk(b"IEND", b""))


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


STEP_M = 0.1
BAYS, BAY_M = 13, 2.8


def markings(size_m: tuple) -> list:
    """0 asphalt, 1 white paint, 2 green bay for electric cars, 3 repaired asphalt."""
    columns, lines = (round(v / STEP_M) for v in size_m)
    rows = [[0] * columns for _ in range(lines)]

    def fill(lo, hi, value):
        for y in range(round(lo[1] / STEP_M), round(hi[1] / STEP_M)):
            for x in range(round(lo[0] / STEP_M), round(hi[0] / STEP_M)):
                rows[lines - 1 - y][x] = value
    fill((17.0, 17.0), (29.0, 21.0), 3)
    for south in (2.0, 12.4, 26.0, 36.4):  # rows of bays 5.2 m deep
        fill((1.8, south), (1.8 + 2 * BAY_M, south + 5.2), 2)
        for k in range(BAYS + 1):
            fill((1.7 + BAY_M * k, south), (1.9 + BAY_M * k, south + 5.2), 1)
    for y in (9.6, 33.8):  # arrows of the lanes: dashes
        for k in range(9):
            fill((3.0 + 4 * k, y), (5.0 + 4 * k, y + 0.2), 1)
    return rows


def furrows(size_m: tuple) -> list:
    """Heights in cm: ruts every 2.4 m that wander, and heaps of gravel."""
    step = 0.25
    columns, lines = (round(v / step) for v in size_m)
    rng = random.Random(2)
    heaps = [(rng.uniform(4, size_m[0] - 4), rng.uniform(4, size_m[1] - 4), rng.uniform(1.5, 3.5))
             for _ in range(16)]
    rows = []
    for line in range(lines):
        row, y = [], (lines - line - 0.5) * step
        for column in range(columns):
            x = (column + 0.5) * step
            value = 40 + 12 * math.sin(2 * math.pi * (x + 1.5 * math.sin(0.15 * y)) / 2.4)
            value += sum(70 * math.exp(-((x - a) ** 2 + (y - b) ** 2) / r**2) for a, b, r in heaps)
            row.append(min(255, max(0, round(value + rng.uniform(-2, 2)))))
        rows.append(row)
    return rows


def patches() -> list:
    """A grey picture of a lawn: clouds of random waves."""
    rng = random.Random(3)
    waves = [(rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), rng.uniform(0, 6.283))
             for _ in range(12)]
    rows = []
    for y in range(64):
        row = [sum(math.sin(a * x + b * y + c) for a, b, c in waves) for x in range(64)]
        rows.append([min(255, max(0, round(128 + 30 * v + rng.gauss(0, 14)))) for v in row])
    return rows
