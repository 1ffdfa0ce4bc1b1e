"""Floor boards with gaps between them, and a ceiling of boards over hewn beams."""

from math import pi

from chance import Chance, wander
from mesh import Mesh, moved, turned
from room import BEAM_HEIGHT, BEAMS, DEPTH, HEIGHT, LENGTH
from shapes import timber
from texturing import TILE

BOARD = 0.2
ROWS = 8
MARGIN = 0.08


def build_floor():
    mesh = Mesh()
    count = round(DEPTH / BOARD) + 1
    for k in range(count):
        middle = (k - (count - 1) / 2) * BOARD
        add_board(mesh, Chance("floor", k), middle, 0.0, 1, 11)
    return mesh


def add_board(mesh, chance, middle, level, facing, cuts):
    """
    One board along X with its face at `level`, drawn by one whole row of the `planks` texture:
    face, two eased edges and two sides. The texture's own gaps lie over those of the mesh.
    """
    row, start = chance.index(ROWS), chance.fraction()
    gap = chance.between(0.0012, 0.0025)
    lift = chance.between(-0.0008, 0.0008)
    tilt = chance.between(-0.001, 0.001)
    half = BOARD / 2 - gap
    outline = [
        (-half, -0.02),
        (-half, -0.003),
        (-half + 0.004, 0.0),
        (half - 0.004, 0.0),
        (half, -0.003),
        (half, -0.02),
    ]
    if facing < 0:
        outline = outline[::-1]
    tile = TILE["planks"]
    columns = []
    for cut in range(cuts + 1):
        x = (cut / cuts - 0.5) * (LENGTH + MARGIN)
        sag = 0.0006 * wander(x / 0.8, chance.key)
        column = []
        for z, drop in outline:
            y = level + facing * (lift + sag + tilt * z / half + drop)
            v = (row + 0.5 + z / BOARD) / ROWS
            column.append((mesh.add_point(x, y, middle + z), (x / tile + start, v)))
        columns.append(column)
    for here, there in zip(columns, columns[1:]):
        for k in range(len(outline) - 1):
            corners = [here[k], here[k + 1], there[k + 1], there[k]]
            mesh.add_face([c for c, _ in corners], [t for _, t in corners], "planks")


def build_ceiling():
    mesh = Mesh()
    count = round(DEPTH / BOARD) + 1
    for k in range(count):
        middle = (k - (count - 1) / 2) * BOARD
        add_board(mesh, Chance("ceiling", k), middle, HEIGHT, -1, 6)
    for k, x in enumerate(BEAMS):
        chance = Chance("beam", k)

        def hewn(along, key=chance.key):
            return 0.008 * wander(along / 0.9, key, 1), 0.012 * wander(along / 1.1, key, 2)

        beam = timber(
            DEPTH + MARGIN, chance.between(0.15, 0.17), BEAM_HEIGHT, 0.02, "trim", chance, 6, hewn
        )
        mesh.include(beam, moved(x, HEIGHT - BEAM_HEIGHT / 2 + 0.012, 0) @ turned(pi / 2))
    return mesh


def build_dark():
    """What lies under the gaps of the floor, and over those of the ceiling: nothing."""
    mesh = Mesh()
    x, z = LENGTH / 2 + 0.1, DEPTH / 2 + 0.1
    for y, facing in ((-0.022, 1), (HEIGHT + 0.022, -1)):
        corners = [(-x, y, z), (x, y, z), (x, y, -z), (-x, y, -z)][::facing]
        ring = mesh.add_ring(corners)
        mesh.add_face(ring, [(0, 0), (1, 0), (1, 1), (0, 1)], "night")
    return mesh
