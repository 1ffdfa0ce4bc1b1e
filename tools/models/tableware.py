"""What stands on table and shelves: turned, blown and cast things, each from its profile."""

from math import cos, pi, sin

from mathutils import Vector
from mesh import Mesh, moved, turned
from shapes import arc, lathe, smooth_path, tube


def tankard():
    """A pewter cup with a handle, 95 mm tall."""
    profile = [(0, 0.0015), (0.03, 0.0015), (0.0385, 0), (0.0405, 0.0025), (0.0395, 0.006)]
    profile += [(0.037, 0.01), (0.0365, 0.014), (0.0355, 0.03), (0.0345, 0.05), (0.0338, 0.062)]
    profile += [
        (0.0348, 0.0635),
        (0.0348, 0.066),
        (0.0336, 0.0675),
        (0.0332, 0.085),
        (0.0342, 0.0925),
    ]
    profile += arc((0.0335, 0.0935), 0.0013, 0, pi, 5)
    profile += [
        (0.0315, 0.088),
        (0.0315, 0.06),
        (0.0325, 0.03),
        (0.033, 0.012),
        (0.025, 0.007),
        (0, 0.006),
    ]
    mesh = lathe(profile, 26, "pewter")
    handle = [(0.0335, 0.08, 0), (0.045, 0.085, 0), (0.061, 0.079, 0), (0.066, 0.06, 0)]
    handle += [(0.059, 0.038, 0), (0.045, 0.026, 0), (0.037, 0.02, 0), (0.0385, 0.0125, 0)]
    bar = tube(smooth_path(handle, 3), lambda s: 0.0047 - 0.0017 * s, 8, "pewter", squash=1.35)
    return mesh.include(bar)


def wine_bottle(sides=24):
    """Blown dark glass, an onion shape grown tall: about 1780, 235 mm."""
    profile = [(0, 0.014), (0.026, 0.005), (0.036, 0.0), (0.0435, 0.003)]
    profile += [(0.047, 0.01), (0.0478, 0.03), (0.0465, 0.07), (0.0455, 0.1), (0.043, 0.118)]
    profile += [
        (0.036, 0.134),
        (0.027, 0.147),
        (0.0205, 0.16),
        (0.0172, 0.178),
        (0.0152, 0.2),
        (0.0145, 0.218),
    ]
    profile += [
        (0.0172, 0.2195),
        (0.018, 0.2225),
        (0.0168, 0.2255),
        (0.0145, 0.2265),
        (0.0145, 0.233),
    ]
    profile += [(0.0135, 0.235), (0.011, 0.2345), (0.0105, 0.2), (0, 0.198)]

    def lopsided(angle, radius, height):
        return radius * (1 + 0.012 * cos(angle + 20 * height))

    return lathe(profile, sides, "glass", radius_at=lopsided)


def phial():
    """A small square-shouldered medicine bottle, 110 mm, stoppered with cork-brown leather."""
    profile = [
        (0, 0.004),
        (0.018, 0.001),
        (0.0235, 0.0),
        (0.0255, 0.003),
        (0.026, 0.01),
        (0.026, 0.062),
    ]
    profile += [(0.0245, 0.07), (0.018, 0.077), (0.0115, 0.081), (0.0105, 0.092), (0.0108, 0.1)]
    profile += [
        (0.0148, 0.1015),
        (0.015, 0.105),
        (0.0135, 0.1065),
        (0.009, 0.1065),
        (0.008, 0.1),
        (0, 0.099),
    ]
    return lathe(profile, 10, "glass")


def hand_bell():
    """A brass table bell, 95 mm, its handle turned in one piece with it."""
    profile = [
        (0, 0.034),
        (0.012, 0.033),
        (0.0165, 0.026),
        (0.019, 0.016),
        (0.0235, 0.006),
        (0.0285, 0.0012),
    ]
    profile += [(0.0295, 0.0), (0.0308, 0.0008), (0.0303, 0.003), (0.027, 0.008), (0.0228, 0.017)]
    profile += [
        (0.0208, 0.027),
        (0.0188, 0.0345),
        (0.0145, 0.039),
        (0.0075, 0.041),
        (0.006, 0.0435),
    ]
    profile += [(0.0082, 0.046), (0.0082, 0.0475), (0.0048, 0.05), (0.0045, 0.053), (0.0068, 0.06)]
    profile += [(0.0075, 0.067), (0.0058, 0.075), (0.0038, 0.079), (0.0055, 0.082)]
    profile += [*arc((0, 0.0885), 0.0068, -0.55, 1.1, 5), (0, 0.0955)]
    return lathe(profile, 20, "brass")


def plate():
    """A pewter plate, 230 mm, its back down."""
    profile = [
        (0, 0.0015),
        (0.06, 0.0015),
        (0.072, 0.0),
        (0.076, 0.002),
        (0.086, 0.011),
        (0.112, 0.014),
    ]
    profile += [
        (0.1145, 0.0135),
        (0.1155, 0.0155),
        (0.1145, 0.0175),
        (0.111, 0.017),
        (0.086, 0.014),
    ]
    profile += [(0.074, 0.0055), (0.06, 0.004), (0, 0.004)]
    return lathe(profile, 30, "pewter")


def bowl():
    """A turned wooden bowl, 170 mm."""
    profile = [
        (0, 0.001),
        (0.033, 0.0),
        (0.037, 0.002),
        (0.037, 0.006),
        (0.05, 0.014),
        (0.068, 0.032),
    ]
    profile += [(0.08, 0.056), (0.0848, 0.068), (0.084, 0.0715), (0.0805, 0.071), (0.074, 0.054)]
    profile += [(0.06, 0.032), (0.035, 0.016), (0, 0.013)]
    return lathe(profile, 18, "trim", along_grain=True)


def spectacles():
    """Round wire spectacles lying on the table, lenses up, temples folded out and down behind."""
    mesh = Mesh()
    wire, rim = 0.0011, 0.0205
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
        mesh.include(tube(smooth_path(arm, 3), 0.00095, 5, "brass"))
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
