"""A hearth on the north wall, cold: masonry, an oak bressummer, irons, half-burnt logs, ash."""

from math import cos, pi, sin

from mathutils import Vector

from chance import Chance, wander_over
from masonry import (
    BRESSUMMER_BOTTOM,
    BRESSUMMER_TOP,
    SLAB,
    firebox,
    hearthstone,
    masonry,
    mortar,
)
from mesh import Mesh, moved
from room import HEARTH_MIDDLE, NORTH
from shapes import add_grid, arc, lathe, smooth_path, timber, tube
from texturing import Projection, tile_of

PLACEMENT = NORTH.placement @ moved(HEARTH_MIDDLE, 0, 0)
MANTEL_TOP = BRESSUMMER_TOP


def bressummer():
    chance = Chance("bressummer")
    beam = timber(
        1.72,
        0.3,
        BRESSUMMER_TOP - BRESSUMMER_BOTTOM,
        0.016,
        "trim",
        chance,
        7,
        lambda x: (0.0, 0.008 * wander_over(x * 2.2, 0.5, chance.key)),
    )
    return beam.placed(moved(0, (BRESSUMMER_TOP + BRESSUMMER_BOTTOM) / 2, 0.48))


def andiron(x):
    """A firedog: a turned post in front, splayed feet, and a bar back into the fire."""
    mesh = Mesh()
    profile = [(0, 0.095), (0.012, 0.1), (0.016, 0.112), (0.011, 0.125), (0.011, 0.2)]
    profile += [(0.018, 0.21), (0.018, 0.22), (0.01, 0.232), (0.009, 0.33), (0.014, 0.34)]
    profile += [(0.011, 0.35), *arc((0, 0.376), 0.024, -1.1, 1.2, 6), (0, 0.4015)]
    mesh.include(lathe(profile, 8, "iron"), moved(x, SLAB, 0.46))
    foot = smooth_path(
        [
            (x - 0.1, SLAB + 0.012, 0.5),
            (x - 0.06, SLAB + 0.07, 0.47),
            (x, SLAB + 0.105, 0.46),
            (x + 0.06, SLAB + 0.07, 0.47),
            (x + 0.1, SLAB + 0.012, 0.5),
        ],
        2,
    )
    mesh.include(tube(foot, 0.012, 6, "iron"))
    bar = smooth_path(
        [
            (x, SLAB + 0.115, 0.46),
            (x, SLAB + 0.125, 0.3),
            (x, SLAB + 0.118, 0.19),
            (x, SLAB + 0.012, 0.17),
        ],
        3,
    )
    return mesh.include(tube(bar, 0.012, 6, "iron"))


def crane_and_pot():
    """A swinging crane, hinged on the left cheek, and the pot that hangs from it."""
    mesh = Mesh()
    pivot, reach, level = Vector((-0.37, 0, 0.3)), Vector((0.05, 0, 0.38)), 0.83
    post = [pivot + Vector((0, 0.2, 0)), pivot + Vector((0, 0.5, 0)), pivot + Vector((0, 0.87, 0))]
    mesh.include(tube(post, 0.011, 6, "iron"))
    arm = [
        pivot + Vector((0, level, 0)),
        (pivot + reach) / 2 + Vector((0, level, 0)),
        reach + Vector((0, level, 0)),
        reach + Vector((0.02, level + 0.012, 0.004)),
        reach + Vector((0.03, level + 0.03, 0.006)),
    ]
    mesh.include(tube(arm, 0.009, 6, "iron"))
    brace = smooth_path(
        [
            pivot + Vector((0, 0.5, 0)),
            pivot + Vector((0.12, 0.63, 0.02)),
            pivot + Vector((0.28, level, 0.053)),
        ],
        3,
    )
    mesh.include(tube(brace, 0.008, 6, "iron"))
    hang = reach + Vector((-0.02, level, -0.004))
    hook = [
        hang + Vector(p)
        for p in (
            (0.012, 0.004, 0),
            (0.006, 0.014, 0),
            (-0.004, 0.012, 0),
            (-0.006, 0, 0),
            (0, -0.03, 0),
            (0, -0.11, 0),
            (0.004, -0.125, 0),
            (-0.006, -0.135, 0),
        )
    ]
    mesh.include(tube(smooth_path(hook, 2), 0.004, 5, "iron"))

    base = hang + Vector((0, -0.42, 0))
    profile = [(0, 0), (0.05, 0.002), (0.09, 0.018), (0.117, 0.055), (0.12, 0.09), (0.108, 0.13)]
    profile += [(0.1, 0.152), (0.111, 0.165), (0.115, 0.172), (0.109, 0.176), (0.098, 0.16)]
    profile += [(0.1, 0.12), (0.08, 0.04), (0, 0.02)]
    mesh.include(lathe(profile, 16, "iron"), moved(*base))
    bail = [
        base + Vector((0.112 * cos(pi * k / 8), 0.165 + 0.125 * sin(pi * k / 8), 0))
        for k in range(9)
    ]
    return mesh.include(tube(bail, 0.004, 5, "iron"))


def charred_log(start, end, radius, key, eaten=0.0):
    """A log burnt unevenly: thick where the fire did not reach, `eaten` to a point at its end."""
    chance = Chance("charred", key)
    thickest = chance.between(0.0, 0.35)
    start, end = Vector(start), Vector(end)
    path = [
        start.lerp(end, k / 5) + Vector((0, 0.006 * wander_over(k * 1.1, 0, key), 0))
        for k in range(6)
    ]

    def radius_at(t):
        return radius * (1 - 0.35 * abs(t - thickest) ** 2) * (1 - eaten * max(0, 2 * t - 1) ** 1.5)

    mesh = tube(path, radius_at, 8, "charcoal")
    for point in mesh.points:
        along = (point - start).dot((end - start).normalized())
        axis = start + (end - start).normalized() * along
        out = point - axis
        if out.length > 1e-4:
            angle = out.y * 40 + out.x * 31 + out.z * 17
            point += out * 0.16 * wander_over(along * 22, angle, chance.key)
    # The picture goes round a whole number of times.
    girth = 2 * pi * radius_at(0.5) / tile_of("charcoal")
    around = max(1, round(girth)) / girth
    shift = chance.fraction(), chance.fraction()
    mesh.faces = [
        face._replace(texcoords=[(u + shift[0], v * around + shift[1]) for u, v in face.texcoords])
        for face in mesh.faces
    ]
    return mesh


def ash_height(x, z):
    """Above the flags, negative beside the heap; the hearth's own axes."""
    s, t = x / 0.36, (z - 0.31) / 0.19
    falling = max(0, 1 - (s * s + t * t) * (1 + 0.3 * wander_over(2.5 * s, 2.5 * t, "outline")))
    return 0.05 * falling**0.7 + 0.018 * falling**0.5 * wander_over(4 * s, 3 * t, "ash") - 0.006


def ash_heap():
    mesh = Mesh()
    columns, rows = 12, 7
    grid = []
    for r in range(rows + 1):
        line = []
        for c in range(columns + 1):
            x, z = 0.76 * (c / columns - 0.5), 0.5 - 0.38 * r / rows
            line.append(mesh.add_point(x, SLAB + ash_height(x, z), z))
        grid.append(line)
    return add_grid(mesh, grid, Projection("ash", Chance("ash")))


def embers():
    """Lumps of charcoal in the ash."""
    mesh = Mesh()
    for key in range(8):
        chance = Chance("ember", key)
        x, z = chance.between(-0.26, 0.26), chance.between(0.2, 0.44)
        half = Vector((chance.between(-0.02, 0.02), 0, chance.between(-0.02, 0.02)))
        middle = Vector((x, SLAB + max(0, ash_height(x, z)) + 0.004, z))
        radius = chance.between(0.007, 0.013)
        mesh.include(tube([middle - half, middle + half], radius, 4, "charcoal"))
    return mesh


def fire_logs():
    level = SLAB + 0.125 + 0.012
    mesh = Mesh()
    mesh.include(charred_log((-0.3, level + 0.04, 0.26), (0.28, level + 0.035, 0.235), 0.045, 1))
    # Burnt through, its halves on the firedogs.
    mesh.include(charred_log((-0.33, level + 0.05, 0.37), (-0.03, level, 0.38), 0.048, 2, 0.7))
    mesh.include(charred_log((0.33, level + 0.055, 0.385), (0.05, level - 0.005, 0.37), 0.046, 5, 0.6))
    mesh.include(charred_log((-0.2, level + 0.115, 0.33), (0.2, level + 0.117, 0.29), 0.037, 3))
    mesh.include(charred_log((0.12, SLAB + 0.05, 0.3), (0.27, SLAB + 0.03, 0.44), 0.022, 4))
    return mesh


def build_hearth():
    parts = [masonry(), mortar(), firebox(), hearthstone(), bressummer(), crane_and_pot()]
    parts += [andiron(-0.2), andiron(0.2), fire_logs(), ash_heap(), embers()]
    mesh = Mesh()
    for part in parts:
        mesh.include(part, PLACEMENT)
    return mesh
