"""A chest under the window, with a blanket folded on it."""

from math import cos, pi, sin

from chance import Chance, wander_over
from mesh import Mesh, moved, turned
from room import EAST
from shapes import box, loft, timber
from texturing import Grain, Projection

CHEST_LENGTH, CHEST_DEPTH, CHEST_HEIGHT = 0.98, 0.42, 0.46
CHEST = EAST.placement @ moved(-0.42, 0, 0.26) @ turned(0.015)
LID = 0.024


def build_chest():
    """A six-board chest with a moulded lid, its length along X and its front to +Z."""
    chance = Chance("chest")
    mesh = Mesh()
    length, depth, height = CHEST_LENGTH, CHEST_DEPTH, CHEST_HEIGHT
    body = height - LID
    for side in (-1, 1):
        end = timber(body, depth - 0.03, 0.022, 0.003, "pine", chance)
        place = moved(side * (length / 2 - 0.03), body / 2, 0) @ turned(pi / 2, "Z")
        mesh.include(end, place)
        face = timber(length - 0.02, body - 0.07, 0.022, 0.004, "pine", chance, 4)
        z = side * (depth / 2 - 0.012)
        mesh.include(face, moved(0, 0.07 + (body - 0.07) / 2, z) @ turned(pi / 2, "X"))
    floor = box((length - 0.07, 0.02, depth - 0.04), 0.002, Grain("pine", chance, 0))
    mesh.include(floor, moved(0, 0.1, 0))
    lid = timber(length + 0.02, depth + 0.025, LID, 0.007, "pine", chance, 4)
    mesh.include(lid, moved(0, height - LID / 2, 0))
    return mesh.placed(CHEST)


def build_chest_irons():
    chance = Chance("chest irons")
    mesh = Mesh()
    iron = Projection("iron", chance)
    front = CHEST_DEPTH / 2 - 0.001
    mesh.include(
        box((0.075, 0.095, 0.004), 0.0016, iron),
        moved(0, CHEST_HEIGHT - 0.1, front + 0.0015),
    )
    hasp = box((0.03, 0.085, 0.005), 0.0018, iron)
    mesh.include(hasp, moved(0, CHEST_HEIGHT - 0.075, front + 0.006))
    return mesh.placed(CHEST)


def folded_layer(width, depth, thickness, key):
    """One fold of a blanket: soft edges, a surface that never quite lies flat."""
    chance = Chance("blanket", key)
    rings = []
    steps = 8
    for k in range(steps + 1):
        t = k / steps
        x = (t - 0.5) * width
        end = min(1, 0.35 + 6 * min(t, 1 - t))
        ring = []
        for j in range(12):
            angle = 2 * pi * j / 12
            c, s = cos(angle), sin(angle)
            z = depth / 2 * abs(c) ** 0.28 * (1 if c > 0 else -1)
            y = thickness / 2 * end * abs(s) ** 0.6 * (1 if s > 0 else -1)
            sag = 0.003 * wander_over(x * 9, z * 9, chance.key) * (1 if s > 0 else 0)
            ring.append((x, y + sag + thickness / 2, -z))
        rings.append(ring)
    return loft(rings, Projection("wool", chance))


def build_blanket():
    mesh = Mesh()
    y = CHEST_HEIGHT - 0.0015
    for number, (width, turn) in enumerate(((0.4, 0.0), (0.395, 0.012), (0.385, -0.02))):
        layer = folded_layer(width, 0.3, 0.026, number)
        mesh.include(layer, moved(0.24, y + 0.0245 * number, 0.01) @ turned(turn))
    return mesh.placed(CHEST)
