"""What stands on table and shelves: turned, blown and cast things, each from its profile."""

from math import cos, pi, sin

from mathutils import Vector

from mesh import Mesh, moved, turned
from shapes import arc, lathe, millimetres, smooth_path, tube


def tankard():
    """A pewter cup with a handle, 95 mm tall."""
    profile = millimetres(
        "0 1.5, 30 1.5, 38.5 0, 40.5 2.5, 39.5 6, 37 10, 36.5 14, 35.5 30, 34.5 50, 33.8 62, "
        "34.8 63.5, 34.8 66, 33.6 67.5, 33.2 85, 34.2 92.5"
    )
    profile += arc((0.0335, 0.0935), 0.0013, 0, pi, 5)
    profile += millimetres("31.5 88, 31.5 60, 32.5 30, 33 12, 25 7, 0 6")
    mesh = lathe(profile, 26, "pewter")
    handle = [(0.0335, 0.08, 0), (0.045, 0.085, 0), (0.061, 0.079, 0), (0.066, 0.06, 0)]
    handle += [(0.059, 0.038, 0), (0.045, 0.026, 0), (0.037, 0.02, 0), (0.0385, 0.0125, 0)]
    bar = tube(smooth_path(handle, 3), lambda s: 0.0047 - 0.0017 * s, 8, "pewter", squash=1.35)
    return mesh.include(bar)


def wine_bottle(sides=24):
    """Blown dark glass, an onion shape grown tall: about 1780, 235 mm."""
    profile = millimetres(
        "0 14, 26 5, 36 0, 43.5 3, 47 10, 47.8 30, 46.5 70, 45.5 100, 43 118, 36 134, 27 147, "
        "20.5 160, 17.2 178, 15.2 200, 14.5 218, 17.2 219.5, 18 222.5, 16.8 225.5, 14.5 226.5, "
        "14.5 233, 13.5 235, 11 234.5, 10.5 200, 0 198"
    )

    def lopsided(angle, radius, height):
        return radius * (1 + 0.012 * cos(angle + 20 * height))

    return lathe(profile, sides, "glass", radius_at=lopsided)


def phial():
    """A small square-shouldered medicine bottle, 110 mm, stoppered with cork-brown leather."""
    profile = millimetres(
        "0 4, 18 1, 23.5 0, 25.5 3, 26 10, 26 62, 24.5 70, 18 77, 11.5 81, 10.5 92, 10.8 100, "
        "14.8 101.5, 15 105, 13.5 106.5, 9 106.5, 8 100, 0 99"
    )
    return lathe(profile, 10, "glass")


def hand_bell():
    """A brass table bell, 95 mm, its handle turned in one piece with it."""
    profile = millimetres(
        "0 34, 12 33, 16.5 26, 19 16, 23.5 6, 28.5 1.2, 29.5 0, 30.8 0.8, 30.3 3, 27 8, 22.8 17, "
        "20.8 27, 18.8 34.5, 14.5 39, 7.5 41, 6 43.5, 8.2 46, 8.2 47.5, 4.8 50, 4.5 53, 6.8 60, "
        "7.5 67, 5.8 75, 3.8 79, 5.5 82"
    )
    profile += [*arc((0, 0.0885), 0.0068, -0.55, 1.1, 5), (0, 0.0955)]
    return lathe(profile, 20, "brass")


def plate():
    """A pewter plate, 230 mm, its back down."""
    profile = millimetres(
        "0 1.5, 60 1.5, 72 0, 76 2, 86 11, 112 14, 114.5 13.5, 115.5 15.5, 114.5 17.5, 111 17, "
        "86 14, 74 5.5, 60 4, 0 4"
    )
    return lathe(profile, 30, "pewter")


def bowl():
    """A turned wooden bowl, 170 mm."""
    profile = millimetres(
        "0 1, 33 0, 37 2, 37 6, 50 14, 68 32, 80 56, 84.8 68, 84 71.5, 80.5 71, 74 54, 60 32, "
        "35 16, 0 13"
    )
    return lathe(profile, 18, "trim", along_grain=True)


def spectacles():
    """Round wire spectacles lying on the table, lenses up, temples folded out and down behind."""
    mesh = Mesh()
    wire, rim = 0.0017, 0.0205
    tilt = 0.0155
    apart = 0.0285

    def raised(x, z):
        """Standing on the lower rims and the temples' ends: the front leans back."""
        return Vector((x, wire + tilt * (z + rim) / rim, z * 0.86))

    for side in (-1, 1):
        ring = [
            raised(side * apart + rim * cos(2 * pi * k / 18), -rim * sin(2 * pi * k / 18))
            for k in range(18)
        ]
        mesh.include(tube(ring, wire, 6, "brass", closed=True))
        hinge_x = side * (apart + rim)
        arm = [raised(hinge_x - side * 0.0003, -0.001), raised(hinge_x + side * 0.005, -0.002)]
        arm += [
            Vector((hinge_x + side * 0.007, 0.016, -0.012)),
            Vector((hinge_x + side * 0.006, 0.012, -0.06)),
        ]
        arm += [
            Vector((hinge_x + side * 0.002, 0.006, -0.1)),
            Vector((hinge_x - side * 0.002, wire * 0.9, -0.125)),
        ]
        mesh.include(tube(smooth_path(arm, 3), 0.0016, 5, "brass"))
    bridge = [
        raised(-apart + rim, -0.004),
        raised(-0.004, -0.0115),
        raised(0.004, -0.0115),
        raised(apart - rim, -0.004),
    ]
    return mesh.include(tube(smooth_path(bridge, 3), wire, 6, "brass"))


def standing_on(thing, x, y, z, turn=0.0):
    return thing.placed(moved(x, y, z) @ turned(turn))


def leaning_plate(x, y, wall_z, lean):
    """A plate on its rim, leaning back against an upright surface at `wall_z`."""
    upright = turned(pi / 2 - lean, "X")
    leant = plate().placed(upright)
    lowest = min(point.y for point in leant.points)
    backmost = min(point.z for point in leant.points)
    return leant.placed(moved(x, y - lowest, wall_z - backmost))
