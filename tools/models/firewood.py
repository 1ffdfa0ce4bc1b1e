"""Round billets stacked beside the hearth, weathered on their sides, rings on their ends."""

from math import cos, pi, sin

from chance import Chance, wander
from mesh import Mesh, moved
from room import NORTH
from texturing import BOARDS, TILE

LENGTH = 0.36
PLACEMENT = NORTH.placement @ moved(0.36, 0, 0.03)
SIDES = 12


def billet(radius, key):
    """A round of wood along Z, its end grain towards +Z, from z = 0."""
    chance = Chance("billet", key)
    mesh = Mesh()
    row, start = (chance.index(BOARDS["logs"]) + 0.5) / BOARDS["logs"], chance.fraction()
    length = LENGTH + chance.between(-0.02, 0.02)
    rings = []
    for z, grow in (
        (0, 0.96),
        (0.006, 1),
        (length * 0.5, 0.985),
        (length - 0.006, 1),
        (length, 0.965),
    ):
        ring = []
        for k in range(SIDES):
            angle = 2 * pi * k / SIDES
            r = (
                radius
                * grow
                * (1 + 0.07 * wander(k * 0.9, chance.key) + 0.02 * wander(z * 9, chance.key, k))
            )
            ring.append(mesh.add_point(r * cos(angle), r * sin(angle), z))
        rings.append((z, ring))
    for (z0, below), (z1, above) in zip(rings, rings[1:]):
        for k in range(SIDES):
            n = (k + 1) % SIDES
            # Up and down one row, so that the bark never runs into the lime of the picture.
            across = [abs(((j / SIDES * 2 + 0.5) % 2) - 1) - 0.5 for j in (k, k + 1)]
            v = [row + a * 0.09 for a in across]
            texcoords = [(z0, v[0]), (z0, v[1]), (z1, v[1]), (z1, v[0])]
            texcoords = [(z / TILE["logs"] + start, w) for z, w in texcoords]
            mesh.add_face([below[k], below[n], above[n], above[k]], texcoords, "logs")
    turn = chance.between(0, 2 * pi)
    for ring, order in ((rings[0][1], -1), (rings[-1][1], 1)):
        z = mesh.points[ring[0]].z
        own = [mesh.add_point(mesh.points[k]) for k in ring]
        tip = mesh.add_point(0, 0, z)
        for k in range(SIDES):
            corners = [own[k], own[(k + 1) % SIDES], tip][::order]
            texcoords = []
            for corner in corners:
                x, y = mesh.points[corner].x, mesh.points[corner].y
                # One end fills the picture of an end, whatever its size.
                u, v = x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn)
                texcoords.append((0.5 + 0.47 * u / radius, 0.5 - 0.47 * v / radius))
            mesh.add_face(corners, texcoords, "logends")
    return mesh


def build_firewood():
    """Stacked against the wall, each billet lying on two others or on the floor."""
    mesh = Mesh()
    radii = [0.058, 0.05, 0.062, 0.054, 0.047, 0.055, 0.049, 0.056, 0.043]
    lying = []
    x = 0.0
    for radius in radii[:4]:
        x += radius if not lying else radius + lying[-1][2] - (lying[-1][2] - radius) ** 2 * 2
        lying.append((x, radius, radius))
    row = lying
    number = 4
    placed = list(lying)
    while len(row) > 1 and number < len(radii):
        upper = []
        for (x0, y0, r0), (x1, y1, r1) in zip(row, row[1:]):
            if number == len(radii):
                break
            radius = radii[number]
            number += 1
            upper.append(resting((x0, y0, r0), (x1, y1, r1), radius))
        placed += upper
        row = upper
    for key, (x, y, radius) in enumerate(placed):
        out = Chance("stack", key).between(-0.02, 0.02)
        mesh.include(billet(radius, key), moved(x, y * 0.985, 0.03 + out))
    return mesh.placed(PLACEMENT)


def resting(left, right, radius):
    """The middle of a circle that lies on two others."""
    (x0, y0, r0), (x1, y1, r1) = left, right
    a, b = r0 + radius, r1 + radius
    distance = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
    along = (a * a - b * b + distance * distance) / (2 * distance)
    up = max(a * a - along * along, 0) ** 0.5
    dx, dy = (x1 - x0) / distance, (y1 - y0) / distance
    return x0 + along * dx - up * dy, y0 + along * dy + up * dx, radius
