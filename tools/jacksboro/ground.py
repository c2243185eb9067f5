"""The terrain as the simulator builds it, and meshes that lie on it.

The raster's posts go through earth-centred coordinates into the scene's east, north and up axes;
every cell is cut into two triangles from its north-west to its south-east corner. Patches are
clipped against those triangles, so that they follow the ground exactly.
"""

import math

from jacksboro import polygons
from jacksboro.mesh import Mesh
from jacksboro.raster import Grid

SEMI_MAJOR_M, FLATTENING = 6378137.0, 1.0 / 298.257223563  # WGS84
ECCENTRICITY_2 = FLATTENING * (2.0 - FLATTENING)


def ecef(latitude_deg: float, longitude_deg: float, height_m: float) -> tuple:
    """Earth-centred, earth-fixed coordinates of a geodetic place, m."""
    phi, lam = math.radians(latitude_deg), math.radians(longitude_deg)
    normal = SEMI_MAJOR_M / math.sqrt(1.0 - ECCENTRICITY_2 * math.sin(phi) ** 2)
    return ((normal + height_m) * math.cos(phi) * math.cos(lam),
            (normal + height_m) * math.cos(phi) * math.sin(lam),
            (normal * (1.0 - ECCENTRICITY_2) + height_m) * math.sin(phi))


class Ground:
    """The triangulated terrain in the axes of a site (latitude, longitude, height)."""

    def __init__(self, grid: Grid, site: tuple):
        self.grid = grid
        self._origin = ecef(*site)
        self._phi, self._lam = math.radians(site[0]), math.radians(site[1])
        self.posts = [[self._enu(grid.latitude(row), grid.longitude(column), height)
                       for column, height in enumerate(line)]
                      for row, line in enumerate(grid.heights)]

    def _enu(self, latitude_deg: float, longitude_deg: float, height_m: float) -> tuple:
        x, y, z = (a - b for a, b in zip(ecef(latitude_deg, longitude_deg, height_m), self._origin))
        sp, cp, sl, cl = (math.sin(self._phi), math.cos(self._phi),
                          math.sin(self._lam), math.cos(self._lam))
        return (-sl * x + cl * y, -sp * cl * x - sp * sl * y + cp * z,
                cp * cl * x + cp * sl * y + sp * z)

    def _cell(self, east: float, north: float) -> tuple:
        """Column and row of the cell below a place; meridians converge, so refine a first guess."""
        columns, rows = self.grid.columns, self.grid.rows
        column, row = columns / 2.0, rows / 2.0
        for _ in range(4):
            i = min(columns - 2, max(0, int(column)))
            j = min(rows - 2, max(0, int(row)))
            a, b, c = self.posts[j][i], self.posts[j][i + 1], self.posts[j + 1][i]
            ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]
            determinant = ux * vy - uy * vx
            dx, dy = east - a[0], north - a[1]
            column = i + (dx * vy - dy * vx) / determinant
            row = j + (ux * dy - uy * dx) / determinant
        return math.floor(column), math.floor(row)

    def inside(self, east: float, north: float) -> bool:
        column, row = self._cell(east, north)
        return 0 <= column < self.grid.columns - 1 and 0 <= row < self.grid.rows - 1

    def _triangles(self, column: int, row: int) -> list:
        nw, ne = self.posts[row][column], self.posts[row][column + 1]
        sw, se = self.posts[row + 1][column], self.posts[row + 1][column + 1]
        return [(nw, sw, se), (nw, se, ne)]

    def height(self, east: float, north: float) -> float:
        """Up coordinate of the terrain's surface, m."""
        for triangle in self._triangles(*self._cell(east, north)):
            if all(w >= -1e-6 for w in _barycentric(triangle, east, north)):
                return _on_plane(triangle, east, north)
        return _on_plane(self._triangles(*self._cell(east, north))[0], east, north)

    def slope(self, east: float, north: float) -> float:
        """Tangent of the ground's inclination over 20 m."""
        d = 10.0
        gx = self.height(east + d, north) - self.height(east - d, north)
        gy = self.height(east, north + d) - self.height(east, north - d)
        return math.hypot(gx, gy) / (2 * d)

    def drape(self, mesh: Mesh, part: str, outline: list, lift_m: float) -> None:
        """Adds the area within `outline` (counter-clockwise), `lift_m` above the ground."""
        cells = [self._cell(x, y) for x in _range(outline, 0) for y in _range(outline, 1)]
        columns, rows = [c for c, _ in cells], [r for _, r in cells]
        for row in range(max(0, min(rows) - 1), min(self.grid.rows - 1, max(rows) + 2)):
            for column in range(max(0, min(columns) - 1),
                                min(self.grid.columns - 1, max(columns) + 2)):
                for triangle in self._triangles(column, row):
                    self._drape_one(mesh, part, outline, triangle, lift_m)

    @staticmethod
    def _drape_one(mesh: Mesh, part: str, outline: list, triangle: tuple, lift_m: float) -> None:
        piece = polygons.clip(outline, [corner[:2] for corner in triangle])
        for corners in polygons.triangulate(piece):
            mesh.add(part, [(x, y, _on_plane(triangle, x, y) + lift_m) for x, y in corners])


def _range(outline: list, axis: int) -> tuple:
    values = [point[axis] for point in outline]
    return min(values), max(values)


def _barycentric(triangle: tuple, x: float, y: float) -> tuple:
    (ax, ay, _), (bx, by, _), (cx, cy, _) = triangle
    determinant = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy)
    u = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / determinant
    v = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / determinant
    return u, v, 1.0 - u - v


def _on_plane(triangle: tuple, x: float, y: float) -> float:
    return sum(w * corner[2] for w, corner in zip(_barycentric(triangle, x, y), triangle))
