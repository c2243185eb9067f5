"""What stands in the harbour: ground, warehouse, office, crane, ship, breakwater."""

from showcase.mesh import Mesh

WATER_M = -2.5  # below the quay
PARKING = ((72.0, -52.0), (112.0, -8.0))
YARD = ((20.0, -118.0), (62.0, -70.0))
LAWN = ((20.0, -62.0), (64.0, -16.0))


def ground() -> Mesh:
    """Land, quay, lawn, parking lot and yard."""
    mesh = Mesh()
    mesh.box("asphalt", (0.4, -900.0, -12.0), (1500.0, 900.0, 0.0), bottom=False)
    mesh.box("quay", (0.0, -900.0, -12.0), (17.0, 900.0, 0.05), bottom=False)
    mesh.rectangle("parking", *PARKING, 0.04)
    mesh.rectangle("lawn", *LAWN, 0.06)
    mesh.rectangle("yard", *YARD, 0.05)
    mesh.box("quay", (-46.0, -64.0, -12.0), (0.0, -58.0, -0.3), bottom=False)  # jetty
    for k in range(-9, 10):
        mesh.box("steel", (0.5, 20.0 * k - 0.3, 0.05), (1.1, 20.0 * k + 0.3, 0.6))  # bollards
    return mesh


def warehouse() -> Mesh:
    """A warehouse 30 x 76 m with a metal roof, and a boiler house behind it."""
    mesh, (x0, y0, x1, y1), wall, ridge = Mesh(), (24.0, 2.0, 54.0, 78.0), 8.0, 12.0
    mesh.box("walls", (x0, y0, 0.0), (x1, y1, wall), bottom=False)
    middle = (x0 + x1) / 2
    for y, order in ((y0, 1), (y1, -1)):
        mesh.add("walls", [(x0, y, wall), (x1, y, wall), (middle, y, ridge)][::order])
    e, z = 0.7, wall - 0.19
    top = ((middle, y0 - e, ridge), (middle, y1 + e, ridge))
    mesh.quad("roof", (x1 + e, y0 - e, z), (x1 + e, y1 + e, z), top[1], top[0])
    mesh.quad("roof", (x0 - e, y1 + e, z), (x0 - e, y0 - e, z), top[0], top[1])
    for y in (14.0, 32.0, 50.0, 68.0):
        mesh.box("doors", (x0 - 0.1, y - 3, 0.0), (x0 + 0.1, y + 3, 5.5))
        mesh.box("doors", (x1 - 0.1, y - 3, 0.0), (x1 + 0.1, y + 3, 5.5))
    mesh.box("brick", (25.0, 84.0, 0.0), (47.0, 104.0, 9.0), bottom=False)
    return mesh


def office() -> Mesh:
    """Floors, core and bars of an office 26 x 15 m; its panes are a mesh of their own."""
    mesh, (x0, y0, x1, y1) = Mesh(), (76.0, 6.0, 102.0, 21.0)
    for floor in range(5):
        z = 3.6 * floor
        mesh.box("floors", (x0, y0, z + 0.05), (x1, y1, z + 0.4))
        if floor:  # bars stand just outside the glass
            for y in (y0 - 0.25, y1 + 0.13):
                mesh.box("steel", (x0 - 0.2, y, z), (x1 + 0.2, y + 0.12, z + 0.45))
            for x in (x0 - 0.25, x1 + 0.13):
                mesh.box("steel", (x, y0 - 0.1, z), (x + 0.12, y1 + 0.1, z + 0.45))
    mesh.box("core", (x0 + 10, y0 + 5, 0.4), (x0 + 16, y0 + 10, 14.44), bottom=False)
    for k in range(14):
        for y in (y0 - 0.25, y1 + 0.13):
            mesh.box("steel", (x0 + 2 * k - 0.06, y, 0.0), (x0 + 2 * k + 0.06, y + 0.12, 14.9))
    for k in range(8):
        for x in (x0 - 0.25, x1 + 0.13):
            y = y0 + 2.14 * k
            mesh.box("steel", (x, y - 0.06, 0.0), (x + 0.12, y + 0.06, 14.9))
    mesh.box("core", (x0 + 3, y0 + 3, 14.8), (x0 + 8, y0 + 7, 16.8))
    for floor in range(4):  # desks
        for k in range(6):
            x, z = x0 + 1.5 + 4 * k, 3.6 * floor + 0.4
            mesh.box("desks", (x, y0 + 1.5, z + 0.7), (x + 2.2, y0 + 2.6, z + 0.78))
    return mesh


def panes() -> Mesh:
    """The office's glass walls."""
    mesh, (x0, y0, x1, y1) = Mesh(), (75.95, 5.95, 102.05, 21.05)
    for floor in range(4):
        lo, hi = 3.6 * floor + 0.42, 3.6 * floor + 3.63
        outline = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        for a, b in zip(outline, outline[1:] + outline[:1]):
            mesh.quad("glass", (*a, lo), (*b, lo), (*b, hi), (*a, hi))
    return mesh


def crane() -> Mesh:
    """A gantry crane over quay and ship."""
    mesh = Mesh()
    for x in (3.0, 15.0):
        for y in (-6.0, 6.0):
            mesh.strut("crane", ((x, y, 0.05), (x, 0.45 * y, 24.0)), 0.45)
        mesh.strut("crane", ((x, -4.6, 12.0), (x, 4.6, 12.0)), 0.3)
    for y in (-2.7, 2.7):
        mesh.strut("crane", ((-26.0, y, 24.5), (20.0, y, 24.5)), 0.6)
        mesh.strut("crane", ((3.0, y, 24.5), (7.0, 0.0, 34.0)), 0.35)
        mesh.strut("crane", ((15.0, y, 24.5), (7.0, 0.0, 34.0)), 0.35)
        mesh.strut("crane", ((7.0, 0.0, 34.0), (-25.0, y, 25.0)), 0.15)
    for x in range(-26, 21, 4):
        mesh.strut("crane", ((x, -2.7, 24.5), (x, 2.7, 24.5)), 0.25)
    mesh.box("cabin", (-9.0, -1.5, 21.0), (-6.0, 1.5, 23.7))
    return mesh


def ship() -> Mesh:
    """A coaster 78 m long, bow to the north, and its containers."""
    mesh = Mesh()
    hull = [(-17.0, -2.0), (-3.0, -2.0), (-2.0, 10.0), (-2.0, 60.0), (-5.0, 70.0), (-10.0, 76.0),
            (-15.0, 70.0), (-18.0, 60.0), (-18.0, 10.0)]
    mesh.prism("hull", hull, -8.0, 1.2)
    mesh.rectangle("deck", (-17.0, 10.0), (-3.0, 60.0), 1.22)
    mesh.box("bridge", (-16.0, 0.0, 1.2), (-4.0, 7.0, 10.0))
    mesh.box("bridge", (-18.0, 1.0, 10.0), (-2.0, 5.5, 12.5))
    mesh.box("windows", (-16.2, 5.4, 10.8), (-3.8, 5.6, 12.0))
    mesh.box("hull", (-11.5, -1.0, 10.0), (-8.5, 1.0, 15.5))
    colours = ("red", "blue", "orange", "white", "green")
    for row in range(7):
        for column in range(5):
            for layer in range((2, 3, 1, 2, 3, 2, 1)[(row + 2 * column) % 7]):
                x, y, z = -16.3 + 2.6 * column, 12.0 + 6.6 * row, 1.22 + 2.6 * layer
                colour = colours[(3 * row + 2 * column + layer) % 5]
                mesh.box(colour, (x, y, z), (x + 2.44, y + 6.06, z + 2.59))
    return mesh


def breakwater() -> Mesh:
    """A rubble wall far out, with a lighthouse at its end."""
    mesh = Mesh()
    wall = [(-330.0, -40.0), (-318.0, -40.0), (-250.0, 700.0), (-262.0, 700.0)]
    tower = [(-326.4, -35.6), (-321.6, -35.6), (-321.6, -30.8), (-326.4, -30.8)]
    cap = [(-325.4, -34.6), (-322.6, -34.6), (-322.6, -31.8), (-325.4, -31.8)]
    mesh.prism("rock", wall, -12.0, 1.5)
    mesh.prism("tower", tower, 1.5, 22.0)
    mesh.prism("red", cap, 22.0, 23.5)
    return mesh
