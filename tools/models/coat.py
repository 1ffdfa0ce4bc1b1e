"""A rail of pegs beside the door, a heavy coat on one and a felt hat on another."""

from math import cos, pi, sin

from chance import Chance, wander
from mesh import Mesh, moved, turned
from room import SOUTH
from shapes import lathe, loft, millimetres, smooth_path, timber, tube
from texturing import Projection

PEGS = SOUTH.placement @ moved(0.35, 1.68, 0)


def build_peg_rail():
    chance = Chance("pegs")
    mesh = Mesh()
    rail = timber(0.9, 0.085, 0.022, 0.005, "trim", chance, 3)
    mesh.include(rail, moved(0, 0, 0.013) @ turned(pi / 2, "X"))
    for x in (-0.3, 0.0, 0.3):
        peg = [(x, -0.002, 0.016), (x, 0.006, 0.055), (x, 0.018, 0.095), (x, 0.022, 0.107)]
        widths = (0.011, 0.0085, 0.008, 0.0125)
        mesh.include(tube(peg, lambda s: widths[min(3, round(3 * s))], 8, "trim"))
    return mesh.placed(PEGS)


def build_coat():
    """A heavy coat hung by its collar: narrow at the peg, shoulders fallen, hem flared in folds."""
    mesh = Mesh()
    sections = [
        (0.012, 0.03, 0.02, 0.055),
        (0.0, 0.055, 0.035, 0.055),
        (-0.05, 0.1, 0.05, 0.058),
        (-0.1, 0.155, 0.062, 0.062),
        (-0.16, 0.185, 0.07, 0.066),
        (-0.3, 0.19, 0.075, 0.068),
        (-0.48, 0.188, 0.078, 0.07),
        (-0.66, 0.205, 0.085, 0.074),
        (-0.84, 0.228, 0.092, 0.078),
        (-1.0, 0.245, 0.098, 0.082),
        (-1.05, 0.246, 0.099, 0.083),
    ]
    sides = 24
    rings = []
    for y, half, deep, middle in sections[::-1]:
        ring = []
        for k in range(sides):
            angle = 2 * pi * k / sides
            c, s = cos(angle), sin(angle)
            loose = min(1, max(0, -y / 0.9))
            fold = 0.16 * loose * sin(5 * angle + 1.5 * wander(y * 2, "coat")) * (0.6 + 0.4 * s)
            fold += 0.05 * wander(angle * 3, "coat creases", round(y * 6))
            x = half * c * (1 + 0.4 * fold) + 0.01 * wander(y * 3, "hang")
            z = middle + deep * s * (0.75 if s < 0 else 1 + fold)
            ring.append((x, y, max(z, 0.012)))
        # The loft wants them to turn about the upward direction.
        rings.append(ring[::-1])
    mesh.include(loft(rings, Projection("broadcloth", Chance("coat"))))
    for side in (-1, 1):
        sleeve = [
            (side * 0.1, -0.075, 0.075),
            (side * 0.185, -0.2, 0.085),
            (side * 0.212, -0.4, 0.1),
            (side * 0.2, -0.6, 0.118),
            (side * 0.19, -0.66, 0.122),
        ]
        path = smooth_path(sleeve, 2)
        arm = tube(
            path,
            lambda s: 0.064 - 0.016 * s + 0.004 * wander(s * 9, "sleeve"),
            10,
            "broadcloth",
            rounded=False,
        )
        mesh.include(arm)
    return mesh.placed(PEGS @ moved(-0.3, 0.01, 0.012))


def build_hat():
    """A felt hat on the far peg, seen from its crown."""
    profile = millimetres(
        "0 4, 88 2, 120 1, 165 6, 168 9, 165 11.5, 120 7, 96 10, 91 30, 87 70, 79 100, 60 112, "
        "0 108"
    )
    hat = lathe(profile, 18, "broadcloth", radius_at=lambda a, r, h: r * (1 + 0.06 * cos(2 * a)))
    return hat.placed(PEGS @ moved(0.3, -0.068, 0.05) @ turned(pi / 2 + 0.2, "X"))
