"""
Two candles for a page of one's own: an advent wreath, and a candle in a jar. Run like the cabin:

    python tools/models/wreath.py && node tools/models/wreath.mjs
"""

import sys
from math import cos, pi, sin
from pathlib import Path

import bpy  # noqa: F401  mathutils comes with it
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))

from candle import FLAME_ROOT, candle, flame_root, pool, wick
from chance import Chance, wander
from export import add_anchor, add_node, start, write
from mesh import Mesh, moved, turned
from occlusion import bake, tree_of
from shapes import arc, lathe, millimetres, tube
from soundness import assert_finite

# Of the wreath's ring: from its centre, and of its cross-section. Metres.
RING, CORE = 0.145, 0.028
SPRIGS = 310
NEEDLES = 30
CANDLES = 4
CANDLE_RADIUS = 0.027
# Advent candles are lit one after another, a week each: the first is the shortest.
HEIGHTS = (0.058, 0.074, 0.088, 0.098)
SEAT = 0.034


def sprig(chance):
    """A twig of fir along +X, 50 to 75 mm: a stem, and needles on both sides of it, a triangle each."""
    length = chance.between(0.05, 0.075)
    bend = chance.between(-0.012, 0.012)
    path = [(0, 0, 0), (length * 0.5, 0.002, bend * 0.3), (length, 0.004, bend)]
    mesh = tube(path, lambda t: 0.0013 - 0.0008 * t, 4, "bark", rounded=False)
    for k in range(NEEDLES):
        along = 0.06 + 0.94 * k / (NEEDLES - 1)
        root = Vector((length * along, 0.002 + 0.002 * along, bend * along * along))
        side = 1 if k % 2 else -1
        reach = chance.between(0.015, 0.022) * (1 - 0.35 * along**4)
        lift = chance.between(-0.15, 0.55)
        way = Vector((0.75, lift, side * chance.between(0.75, 1.05))).normalized() * reach
        across = way.cross(Vector((0, 1, 0))).normalized() * 0.0011
        corners = mesh.add_ring([root - across, root + across, root + way])
        mesh.add_face(corners, [(0, 0), (1, 0), (0.5, 1)], "needles")
    return mesh


def greenery():
    chance = Chance("wreath")
    ring = [
        (RING * cos(2 * pi * k / 40), 0.02, RING * sin(2 * pi * k / 40))
        for k in range(40)
    ]
    mesh = tube(ring, 0.019, 10, "moss", closed=True)
    for k in range(SPRIGS):
        around = 2 * pi * (k + chance.between(-0.4, 0.4)) / SPRIGS
        # Round the ring's cross-section, from the table outside over the top to the table inside.
        up = pi * (0.06 + 0.88 * ((k * 0.618) % 1))
        place = Vector((RING + CORE * cos(up), CORE * sin(up) + 0.012, 0))
        placement = turned(around) @ moved(*place)
        tilt = 0.35 + 0.4 * sin(up) * chance.fraction()
        lean = chance.between(-0.5, 0.5) + 0.5 * cos(up)
        along = turned(pi / 2 + lean) @ turned(tilt * 0.5, "Z") @ turned(chance.between(-0.6, 0.6), "X")
        mesh.include(sprig(chance), placement @ along)
    for point in mesh.points:
        point.y = max(point.y, 0.0004)
    return mesh


def berries():
    chance = Chance("berries")
    mesh = Mesh()
    for k in range(26):
        around = 2 * pi * (k + chance.between(-0.45, 0.45)) / 26
        up = chance.between(0.2, 0.85) * pi
        radius = chance.between(0.0042, 0.006)
        place = Vector((RING + (CORE + 0.012) * cos(up), (CORE + 0.012) * sin(up) + 0.012, 0))
        ball = lathe(
            [(0, -radius), *arc((0, 0), radius, -1.1, 1.1, 4), (0, radius)], 9, "berry"
        )
        mesh.include(ball, turned(around) @ moved(*place) @ turned(chance.between(0, 3), "X"))
    return mesh


def dish():
    """A brass dish with a rim, on which a candle of the wreath stands."""
    profile = millimetres("30 0, 36 1.2, 38.6 4.4, 37.6 5.2, 35 2.6, 29 1.4")
    return lathe([*profile, (0, 0.0014)], 28, "brass")


def places():
    for number, height in enumerate(HEIGHTS):
        angle = 2 * pi * (number + 0.5) / CANDLES
        yield number, height, turned(angle) @ moved(RING, SEAT, 0) @ turned(1.7 * number)


def build_wreath():
    parts = {"greenery": greenery(), "berries": berries()}
    candles, dishes = Mesh(), Mesh()
    for number, height, placement in places():
        runs = ((0.7 + number, height * 0.45, 0.003, 0.0022), (3.9, height * 0.6, 0.0024, 0.0018))
        dishes.include(dish(), placement)
        candles.include(
            candle(CANDLE_RADIUS, height, f"advent {number}", 32, runs[: 2 - number // 2]),
            placement @ moved(0, 0.0014, 0),
        )
    anchors = {
        f"wick.{number:03}" if number else "wick": placement
        @ moved(0, 0.0014, 0)
        @ flame_root(height)
        for number, height, placement in places()
    }
    return {**parts, "candles": candles, "dishes": dishes}, anchors


# Of the jar: inside and outside of its glass, its height, and the level of its wax. Metres.
INNER, OUTER, RIM, BASE, LEVEL = 0.0345, 0.0375, 0.088, 0.007, 0.05


def front_of(low, high, thickness, cosine, material):
    """Paper around the front of the jar, between two heights, to an angle with this cosine."""
    inner, outer = OUTER + 0.00005, OUTER + thickness
    ring = lathe([(inner, low), (outer, low), (outer, high), (inner, high)], 48, material)
    front = Mesh().include(ring)
    front.faces = [
        face for face in ring.faces if min(front.points[corner].x for corner in face.corners) > OUTER * cosine
    ]
    return front


def build_jar():
    glass = [(0, 0.0012), (OUTER - 0.006, 0.0012), (OUTER - 0.004, 0), (OUTER - 0.001, 0.001)]
    glass += [(OUTER, 0.004), (OUTER, RIM - 0.0015)]
    glass += [*arc(((INNER + OUTER) / 2, RIM - 0.0015), (OUTER - INNER) / 2, 0, pi, 6)]
    glass += [(INNER, BASE + 0.004), (INNER - 0.004, BASE), (0, BASE)]
    # The wax touches the glass, and stands a little higher there.
    gap = 0.0002
    fill = [(0, BASE + gap), (INNER - 0.004, BASE + gap), (INNER - gap, BASE + 0.0045)]
    fill += [(INNER - gap, LEVEL + 0.0018), (INNER - 0.0012, LEVEL + 0.0006)]
    fill += [(INNER - 0.005, LEVEL), (0.0225, LEVEL - 0.0004), (0.02, LEVEL - 0.0024), (0, LEVEL - 0.003)]

    def uneven(angle, radius, height):
        if not 0.018 < radius < 0.024:
            return radius
        return radius * (1 + 0.05 * wander(3 * angle / pi, "pool"))

    melted = LEVEL - 0.0009
    label = front_of(0.013, 0.033, 0.00025, 0.78, "label")
    # A printed line near each of its long edges.
    for low in (0.0148, 0.0306):
        label.include(front_of(low, low + 0.0006, 0.0003, 0.85, "print"))
    parts = {
        "glass": lathe(glass, 64, "glass"),
        "candle": lathe(fill, 48, "wax", radius_at=uneven)
        .include(pool(0.0215, melted, 32))
        .include(wick(melted)),
        # Towards the page.
        "label": label.placed(turned(-pi / 2)),
    }
    return parts, {"wick": Vector((0, melted, 0)) + FLAME_ROOT}


def build(name, parts, anchors):
    parts = {key: mesh.triangulated() for key, mesh in parts.items()}
    start()
    tree = tree_of([mesh for key, mesh in parts.items() if key != "glass"])
    for key, mesh in parts.items():
        assert_finite(key, mesh)
        normals = mesh.corner_normals()
        shades = None if key == "glass" else bake(mesh, normals, tree, reach=0.05)
        add_node(key, mesh, normals, shades)
        print(f"{key}: {len(mesh.faces)} triangles")
    for key, place in anchors.items():
        add_anchor(key, place)
    write(Path(__file__).parents[2] / "work" / "models" / f"{name}.glb")


def main():
    (Path(__file__).parents[2] / "work" / "models").mkdir(parents=True, exist_ok=True)
    build("wreath", *build_wreath())
    build("jar", *build_jar())


if __name__ == "__main__":
    main()
