"""A wall shelf on the north wall with books and bottles, and what stands on the mantel."""

from math import pi

from book import row_of_books
from chance import Chance
from hearth import MANTEL_TOP
from hearth import PLACEMENT as HEARTH
from masonry import BREAST_FRONT
from mesh import Mesh, moved, turned
from room import NORTH
from shapes import loft, timber
from tableware import bowl, leaning_plate, phial, standing_on, wine_bottle
from texturing import Grain

LENGTH, DEPTH, THICKNESS = 1.06, 0.205, 0.024
LEVELS = (1.3, 1.62)
PLACEMENT = NORTH.placement @ moved(1.3, 0, 0)


def bracket(chance):
    """A sawn bracket under a board, its underside an ogee that drops towards the wall."""
    underside = [(0.0, -0.168), (0.016, -0.162), (0.027, -0.13), (0.05, -0.112), (0.083, -0.1)]
    underside += [(0.11, -0.075), (0.128, -0.045), (0.15, -0.028), (DEPTH - 0.03, -0.02)]
    half, eased = 0.012, 0.003
    rings = []
    for z, low in underside:
        side = [(half, 0.0), (half, low + eased), (half - eased, low)]
        ring = side + [(-x, y) for x, y in side[::-1]]
        rings.append([(x, y, z) for x, y in ring[::-1]])
    return loft(rings, Grain("trim", chance, 1))


def build_shelf():
    chance = Chance("shelf")
    mesh = Mesh()
    for level in LEVELS:
        board = timber(LENGTH, DEPTH, THICKNESS, 0.003, "trim", chance, 4)
        mesh.include(board, moved(0, level - THICKNESS / 2, DEPTH / 2 + 0.002))
        for side in (-1, 1):
            mesh.include(
                bracket(chance), moved(side * (LENGTH / 2 - 0.14), level - THICKNESS + 0.001, 0.002)
            )
    return mesh.placed(PLACEMENT)


def build_shelf_books():
    """Mostly old cloth and calf gone grey-green; one red among them."""
    blue, red, calf = "cloth-blue", "cloth-red", "leather"
    lower = [
        (0.15, 0.226, 0.034, calf, 0),
        (0.15, 0.226, 0.036, calf, 0),
        (0.148, 0.222, 0.033, calf, 0),
        (0.125, 0.186, 0.024, blue, 0),
        (0.13, 0.2, 0.041, blue, 0),
        (0.12, 0.178, 0.019, calf, 0),
        (0.14, 0.214, 0.029, red, 0),
        (0.125, 0.19, 0.022, blue, 0.0),
        (0.132, 0.2, 0.03, blue, 0.13),
    ]
    upper = [
        (0.16, 0.245, 0.045, calf, 0),
        (0.125, 0.192, 0.026, blue, 0),
        (0.125, 0.188, 0.027, blue, 0),
        (0.118, 0.17, 0.018, calf, 0),
        (0.128, 0.196, 0.03, blue, 0.17),
    ]
    mesh = Mesh()
    left = -LENGTH / 2
    mesh.include(row_of_books(lower, "lower"), moved(left + 0.157, LEVELS[0], 0.105))
    mesh.include(row_of_books(upper, "upper"), moved(left + 0.34, LEVELS[1], 0.105))
    # Two lie flat, the smaller on the larger.
    for thickness, size, y, turn, key in (
        (0.036, (0.15, 0.22), LEVELS[0], 0.1, "flat"),
        (0.026, (0.125, 0.185), LEVELS[0] + 0.0362, -0.16, "flat above"),
    ):
        lying = row_of_books(
            [(*size, thickness, "leather" if key == "flat" else "cloth-blue", 0)], key
        )
        place = moved(left + 0.65, y, 0.105) @ turned(turn) @ turned(-pi / 2, "Z")
        mesh.include(lying, place @ moved(-thickness, 0, 0))
    return mesh.placed(PLACEMENT)


def build_shelf_ware():
    mesh = Mesh()
    left = -LENGTH / 2
    mesh.include(standing_on(phial(), left + 0.055, LEVELS[1], 0.11, 0.3))
    mesh.include(standing_on(wine_bottle(13), left + 0.14, LEVELS[1], 0.1, 1.0))
    mesh.include(standing_on(phial(), left + 0.225, LEVELS[1], 0.13, 2.3))
    mesh.include(standing_on(bowl(), left + 0.93, LEVELS[0], 0.115, 1.0))
    return mesh.placed(PLACEMENT)


def build_mantel_ware():
    mesh = Mesh()
    ledge = BREAST_FRONT + 0.012
    mesh.include(leaning_plate(0.06, MANTEL_TOP, ledge, 0.2))
    mesh.include(standing_on(wine_bottle(14), -0.5, MANTEL_TOP, ledge + 0.07, 2.0))
    mesh.include(standing_on(phial(), 0.62, MANTEL_TOP, ledge + 0.06, 0.9))
    return mesh.placed(HEARTH)
