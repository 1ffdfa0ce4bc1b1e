"""A plank door in the south wall, behind the visitor: ledges, iron straps and a thumb latch."""

from math import pi

from chance import Chance
from mesh import Mesh, moved, turned
from room import DOOR
from shapes import box, lathe, smooth_path, timber, tube
from texturing import Grain, Projection

PLACEMENT = DOOR.wall.placement @ moved(DOOR.middle, 0, 0)
CASING = 0.11
CASING_DEPTH = 0.028
SEAT = 0.003
FACE = -0.035
PLANKS = 5
THICKNESS = 0.034
LEDGES = (0.32, 1.62)
LEDGE = 0.022


def upright(length, width, thickness, chance, bevel=0.004):
    board = timber(length, width, thickness, bevel, "trim", chance, 5)
    return board.placed(turned(pi / 2, "Z") @ turned(pi / 2, "X"))


def build_door():
    """In the wall's own axes: x along, y up, z into the room."""
    chance = Chance("door")
    mesh = Mesh()
    half, height = DOOR.width / 2, DOOR.height
    clear = half - 0.012
    width = 2 * clear / PLANKS
    for k in range(PLANKS):
        board = upright(height - 0.02, width - 0.002, THICKNESS, chance)
        x = (k - (PLANKS - 1) / 2) * width
        mesh.include(
            board, moved(x, height / 2, FACE - THICKNESS / 2 + chance.between(-0.001, 0.001))
        )
    for y in LEDGES:
        ledge = timber(2 * clear - 0.06, 0.13, LEDGE, 0.006, "trim", chance)
        mesh.include(ledge, moved(0, y, FACE + LEDGE / 2 - 0.001) @ turned(pi / 2, "X"))
    for side in (-1, 1):
        jamb = upright(height + 0.05, CASING, CASING_DEPTH, chance)
        place = moved(
            side * (half + CASING / 2 - 0.014), (height + 0.05) / 2, SEAT + CASING_DEPTH / 2
        )
        mesh.include(jamb, place)
        lining = box((0.02, height, 0.15), 0.003, Grain("trim", chance, 1))
        mesh.include(lining, moved(side * (half - 0.001), height / 2, SEAT + 0.004 - 0.075))
    head = timber(2 * half + 2 * CASING + 0.02, CASING, CASING_DEPTH, 0.004, "trim", chance)
    place = moved(0, height + CASING / 2 - 0.014, SEAT + CASING_DEPTH / 2 + 0.003)
    mesh.include(head, place @ turned(pi / 2, "X"))
    lining = box((2 * half, 0.02, 0.15), 0.003, Grain("trim", chance, 0))
    mesh.include(lining, moved(0, height - 0.002, SEAT + 0.004 - 0.075))
    step = box((2 * half, 0.03, 0.2), 0.006, Grain("trim", chance, 0))
    mesh.include(step, moved(0, 0.0, -0.06))
    return mesh.placed(PLACEMENT)


def build_door_irons():
    chance = Chance("door irons")
    mesh = Mesh()
    iron = Projection("iron", chance)
    half = DOOR.width / 2
    surface = FACE + LEDGE
    for y in LEDGES:
        # A strap that tapers from the pintle to a flattened round.
        path = [(half - 0.03 - 0.14 * k, y, surface + 0.0015) for k in range(5)]
        strap = tube(path, lambda s: 0.021 - 0.009 * s, 8, "iron", rounded=False)
        flattened = Mesh().include(strap)
        for point in flattened.points:
            point.z = surface + 0.001 + 0.17 * (point.z - surface - 0.001)
        mesh.include(flattened)
        tip = lathe(
            [(0, -0.002), (0.024, -0.002), (0.025, 0.001), (0.022, 0.0035), (0, 0.004)], 12, "iron"
        )
        mesh.include(tip, moved(half - 0.6, y, surface) @ turned(pi / 2, "X"))
        pintle = [(0, -0.038), (0.009, -0.036), (0.0095, 0.036), (0, 0.038)]
        mesh.include(lathe(pintle, 8, "iron"), moved(half - 0.02, y, surface + 0.006))
        for k in range(4):
            nail = lathe([(0, -0.001), (0.006, 0.0), (0.0045, 0.0028), (0, 0.0036)], 7, "iron")
            place = moved(half - 0.07 - 0.14 * k, y, surface + 0.0035) @ turned(pi / 2, "X")
            mesh.include(nail, place)
    x, y = -half + 0.085, 1.02
    plate = box((0.045, 0.2, 0.004), 0.0015, iron)
    mesh.include(plate, moved(x, y, FACE + 0.0015))
    handle = [
        (x, y - 0.082, FACE + 0.001),
        (x, y - 0.07, FACE + 0.03),
        (x, y, FACE + 0.044),
        (x, y + 0.05, FACE + 0.03),
        (x, y + 0.062, FACE + 0.001),
    ]
    mesh.include(tube(smooth_path(handle, 3), 0.0065, 7, "iron"))
    bar = box((0.17, 0.022, 0.007), 0.002, iron)
    mesh.include(bar, moved(x - 0.005, y + 0.14, FACE + 0.0065) @ turned(-0.03, "Z"))
    staple = [
        (x + 0.02, y + 0.118, FACE - 0.002),
        (x + 0.02, y + 0.118, FACE + 0.014),
        (x + 0.02, y + 0.162, FACE + 0.014),
        (x + 0.02, y + 0.162, FACE - 0.002),
    ]
    mesh.include(tube(staple, 0.0035, 6, "iron"))
    return mesh.placed(PLACEMENT)


def build_night():
    """Behind the planks, which have gaps between them."""
    mesh = Mesh()
    half, height = DOOR.width / 2 + 0.1, DOOR.height + 0.1
    ring = mesh.add_ring([(-half, -0.1, 0), (half, -0.1, 0), (half, height, 0), (-half, height, 0)])
    mesh.add_face(ring, [(0, 0), (1, 0), (1, 1), (0, 1)], "night")
    return mesh.placed(PLACEMENT @ moved(0, 0, FACE - THICKNESS - 0.003))
