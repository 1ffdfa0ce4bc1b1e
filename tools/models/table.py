"""A scrubbed pine table on turned legs."""

from math import pi, sin

from chance import Chance
from mesh import Mesh, moved, turned
from shapes import arc, box, lathe, timber
from texturing import Grain

LENGTH, DEPTH, HEIGHT = 1.28, 0.74, 0.745
THICKNESS = 0.03
APRON = 0.1
LEG_INSET = 0.085
BLOCK = 0.066
MATERIAL = "pine"
PLACEMENT = moved(0.5, 0, -0.05) @ turned(0.05)


def leg_profile():
    """Foot, a long vase, a ring between two coves, and the neck below the square block."""
    profile = [(0, 0), (0.014, 0), (0.0185, 0.005), (0.021, 0.022), (0.0185, 0.04), (0.0145, 0.05)]
    profile += [
        (0.019 + 0.016 * sin(pi * 0.55 * k / 6) ** 1.3, 0.06 + 0.36 * k / 6) for k in range(7)
    ]
    profile += [(0.034, 0.43), (0.025, 0.438), (0.025, 0.444)]
    profile += arc((0.025, 0.458), 0.013, -pi / 2, pi / 2, 5)
    profile += [(0.022, 0.478), (0.023, 0.497), (0.029, 0.522), (0.034, 0.55), (0.031, 0.566)]
    return [*profile, (0.027, 0.572), (0.027, 0.586), (0, 0.586)]


def build_table():
    chance = Chance("table")
    mesh = Mesh()
    boards = 5
    width = DEPTH / boards
    for k in range(boards):
        size = LENGTH + chance.between(-0.003, 0.003)
        board = timber(size, width - 0.0022, THICKNESS, 0.0028, MATERIAL, chance, 6)
        lift = chance.between(-0.0005, 0.0005)
        z = (k - (boards - 1) / 2) * width
        mesh.include(board, moved(chance.between(-0.001, 0.001), HEIGHT - THICKNESS / 2 + lift, z))

    x, z = LENGTH / 2 - LEG_INSET, DEPTH / 2 - LEG_INSET
    under = HEIGHT - THICKNESS
    for side in (-1, 1):
        long = box((2 * x - BLOCK, APRON, 0.022), 0.002, Grain(MATERIAL, chance, 0))
        mesh.include(long, moved(0, under - APRON / 2, side * z))
        short = box((0.022, APRON, 2 * z - BLOCK), 0.002, Grain(MATERIAL, chance, 2))
        mesh.include(short, moved(side * x, under - APRON / 2, 0))
    block_height = under - 0.585
    profile = leg_profile()
    for sx in (-1, 1):
        for sz in (-1, 1):
            block = box((BLOCK, block_height, BLOCK), 0.004, Grain(MATERIAL, chance, 1))
            mesh.include(block, moved(sx * x, 0.585 + block_height / 2, sz * z))
            leg = lathe(profile, 12, MATERIAL, along_grain=True)
            mesh.include(leg, moved(sx * x, 0, sz * z) @ turned(chance.between(0, 6)))
    return mesh.placed(PLACEMENT)
