"""
A brass chamberstick with a lit candle in it, to be carried. Run like the cabin:

    python tools/models/chamberstick.py && node tools/models/cabin.mjs
"""

import sys
from math import cos, exp, pi, sin
from pathlib import Path

import bpy  # noqa: F401  mathutils comes with it
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))

from candle import FLAME_ROOT, wick
from chance import wander, wander_over
from export import add_anchor, add_node, start, write
from mesh import moved
from occlusion import bake, tree_of
from shapes import arc, lathe, millimetres, smooth_path, tube
from soundness import assert_finite, inside_out_shells

CANDLE_RADIUS = 0.011
SEAT = 0.031
COLLAR = 0.0525
TOP = COLLAR + 0.15
POOL = TOP - 0.0032
# Runs of wax: where round the candle, how far down they got, how wide, how thick.
DRIPS = (
    (2.2, 0.164, 0.0019, 0.0018),
    (2.55, COLLAR + 0.002, 0.0027, 0.0033),
    (2.93, 0.129, 0.0021, 0.0025),
    (3.3, 0.18, 0.0017, 0.0013),
    (5.2, 0.11, 0.0023, 0.0026),
    (5.58, 0.169, 0.0018, 0.0016),
    (0.55, 0.186, 0.0019, 0.0013),
)


def holder():
    pan = [(0, 0.0014), (0.036, 0.0014), (0.041, 0.0004), (0.043, 0), (0.046, 0), (0.048, 0.001)]
    pan += [(0.0535, 0.0032), (0.0585, 0.0072), (0.0618, 0.0122), (0.0632, 0.0155)]
    pan += arc((0.0646, 0.0172), 0.0019, -0.9, 3.5, 9)
    pan += millimetres("61.2 14.2, 58.2 9.4, 53.5 6, 47 4.6, 34 4.2, 22.5 4.4")
    foot = millimetres("20.5 5.2, 19.8 6.8, 18.5 7.8, 15 9.5, 12.8 12.5, 11.8 15.5")
    knop = arc((0.0118, 0.0198), 0.0036, -1.2, 1.2, 6)
    socket = millimetres(
        "12.4 24.2, 13.2 26.2, 13.6 27.5, 13.2 28.8, 12.7 29.6, 12.6 41.5, 13.2 42.3, 13.2 43.6, "
        "12.6 44.4, 12.7 47"
    )
    collar = [(0.0142, 0.0488), (0.0178, 0.0503), (0.0212, 0.0518)]
    collar += arc((0.0217, 0.0529), 0.0011, -1.1, 2.4, 6)
    collar += [
        (0.0185, 0.0528),
        (0.0145, 0.0518),
        (0.012, 0.0512),
        (0.0115, 0.0504),
        (0.0114, 0.047),
        (0.0114, SEAT - 0.001),
    ]
    mesh = lathe([*pan, *foot, *knop, *socket, *collar, (0, SEAT - 0.001)], 40, "brass")

    ring = []
    for k in range(26):
        angle = 2 * pi * k / 26
        ring.append((0.0806 + 0.0168 * cos(angle), 0.0178 + 0.0158 * sin(angle), 0))
    mesh.include(tube(ring, 0.0019, 10, "brass", closed=True, squash=2.6))
    # A leaf for the thumb, cast on top of the ring.
    leaf = smooth_path(
        [(0.0655, 0.0325, 0), (0.076, 0.0352, 0), (0.087, 0.0364, 0), (0.0955, 0.0392, 0)], 4
    )
    thumb = tube(leaf, lambda t: 0.00135 * (1 - 0.35 * t), 12, "brass")
    for point in thumb.points:
        t = min(1, max(0, (point.x - 0.0645) / 0.032))
        point.z *= 2.6 + 3.6 * sin(pi * t**0.8) ** 1.5
    return mesh.include(thumb)


def run_of_wax(angle, height):
    """How far wax stands off the candle's side at a place."""
    off = 0.00012 * wander_over(angle * 2.2, height * 60, "wax") + 0.0001 * wander(
        height * 110, "dip"
    )
    for number, (place, bottom, width, thickness) in enumerate(DRIPS):
        path = place + 0.10 * wander(height * 34, "run", number)
        away = (angle - path + pi) % (2 * pi) - pi
        arc_away = away * CANDLE_RADIUS
        above = (height - bottom) / 0.0045
        end = 1 / (1 + exp(-4 * (above - 0.3)))
        bead = 0.7 * exp(-((above - 0.9) ** 2) * 0.8)
        beads = 0.18 * wander(height * 75, "beads", number)
        # Near the flame the wax is still thin; it thickens as it cools on its way.
        body = 0.4 + 0.3 * min(1, (TOP - height) / 0.03) + beads + bead
        off = max(off, thickness * body * end * exp(-((arc_away / width) ** 2) * 1.8))
    return off


def candle():
    sides = 40
    outside = [(CANDLE_RADIUS - 0.0004, SEAT)]
    height = SEAT + 0.008
    while height < TOP - 0.004:
        taper = 0.0004 * (height - SEAT) / (TOP - SEAT)
        outside.append((CANDLE_RADIUS - 0.0003 - taper, height))
        height += 0.0095 if height < COLLAR - 0.008 else 0.0029
    lip = arc((CANDLE_RADIUS - 0.0019, TOP - 0.0016), 0.0012, 0.1, 2.6, 6)
    dish = [
        (0.0079, TOP - 0.0022),
        (0.0075, POOL - 0.0004),
        (0.006, POOL - 0.0035),
        (0, POOL - 0.005),
    ]

    def radius_at(angle, radius, height):
        turn = angle % (2 * pi)
        if radius < 0.0086:
            return radius * (1 + 0.015 * wander(3 * turn, "dish"))
        swell = run_of_wax(turn, min(height, TOP - 0.0012))
        # The lip is worn lower and wider where wax has run over it.
        return radius + swell * min(1, (radius - 0.0086) / 0.0018)

    mesh = lathe([*outside, *lip, *dish], sides, "wax", radius_at=radius_at)
    for point in mesh.points:
        radius = Vector((point.x, point.z)).length
        if point.y > TOP - 0.0035 and radius > 0.0086:
            point.y += 0.0009 * wander(2.2 * (1 + point.x / radius), "lip") - 0.25 * max(
                0, radius - 0.0112
            )
    for number, (angle, distance, size, level) in enumerate(
        (
            (2.52, 0.0155, 0.0042, COLLAR - 0.0006),
            (2.95, 0.0175, 0.0026, COLLAR + 0.0001),
            (0.7, 0.043, 0.0055, 0.0044),
        )
    ):
        drop = [
            (0, -0.0006),
            (size, -0.0004),
            (size * 0.97, size * 0.16),
            (size * 0.75, size * 0.34),
            (size * 0.4, size * 0.43),
            (0, size * 0.45),
        ]

        def uneven(angle, radius, _height, number=number):
            return radius * (1 + 0.16 * wander(angle * 1.3, "drop", number) * sin(angle / 2))

        blob = lathe(drop, 14, "wax", radius_at=uneven)
        mesh.include(blob, moved(distance * cos(angle), level, -distance * sin(angle)))
    return mesh


def pool():
    """Liquid wax: level, creeping up its bank and up the wick. Open below."""
    profile = [(0.0081, POOL + 0.0006), (0.0076, POOL + 0.0001), (0.0068, POOL), (0.0045, POOL)]
    profile += [(0.0022, POOL + 0.0001), (0.0014, POOL + 0.0004), (0.0009, POOL + 0.0011)]
    return lathe(profile, 24, "pool")


def main():
    output = Path(__file__).parents[2] / "work" / "models"
    output.mkdir(parents=True, exist_ok=True)
    parts = {"holder": holder(), "candle": candle(), "pool": pool(), "wick": wick(POOL, 3, 7)}
    parts = {name: mesh.triangulated() for name, mesh in parts.items()}
    start()
    tree = tree_of(parts.values())
    for name, mesh in parts.items():
        assert_finite(name, mesh)
        for fault in inside_out_shells(mesh):
            sys.exit(f"{name} is inside out: {fault}")
        normals = mesh.corner_normals()
        add_node(name, mesh, normals, bake(mesh, normals, tree, reach=0.04))
        print(f"{name}: {len(mesh.faces)} triangles")
    add_anchor("flame", FLAME_ROOT + Vector((0, POOL, 0)))
    write(output / "chamberstick.glb")


if __name__ == "__main__":
    main()
