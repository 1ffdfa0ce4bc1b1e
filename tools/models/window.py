"""A small window of four panes in the east wall: deep reveal, sill, old glass, and night behind."""

from math import pi

from chance import Chance, wander_over
from linen import curtain
from mesh import Mesh, moved, turned
from room import WINDOW
from shapes import add_grid, box, timber, tube
from texturing import Grain, Projection

REVEAL = 0.15
CASING = 0.095
CASING_DEPTH = 0.026
SASH_DEPTH = 0.03
BAR = 0.02
FRAME = 0.045
# A little proud of the logs' crowns, so that the casing lies on them.
SEAT = 0.003
# The lime of the log below stands this much higher than the joint.
LIME = 0.02
PLACEMENT = WINDOW.wall.placement @ moved(WINDOW.middle, WINDOW.bottom + LIME, 0)
ROD_HEIGHT = WINDOW.height + 0.095
ROD_OUT = 0.125


def plank(length, width, thickness, axis, chance):
    board = timber(length, width, thickness, 0.003, "trim", chance)
    return board if axis == 0 else board.placed(turned(pi / 2, "Z"))


def build_window():
    """In the wall's own axes: x along, y up from the opening's foot, z into the room."""
    chance = Chance("window")
    mesh = Mesh()
    half, height = WINDOW.width / 2, WINDOW.height
    front = SEAT + CASING_DEPTH / 2
    flat = turned(pi / 2, "X")
    for side in (-1, 1):
        jamb = plank(height + 2 * CASING - 0.06, CASING, CASING_DEPTH, 1, chance)
        place = moved(side * (half + CASING / 2 - 0.012), height / 2, front)
        mesh.include(jamb, place @ turned(pi / 2))
        lining = plank(height + 0.02, REVEAL + SEAT, 0.022, 1, chance)
        mesh.include(lining, moved(side * (half - 0.002), height / 2, (SEAT - REVEAL) / 2))
    head = plank(2 * half + 2 * CASING + 0.02, CASING, CASING_DEPTH, 0, chance)
    mesh.include(head, moved(0, height + CASING / 2 - 0.012, front + 0.003) @ flat)
    lining = plank(2 * half, REVEAL + SEAT, 0.022, 0, chance)
    mesh.include(lining, moved(0, height - 0.004, (SEAT - REVEAL) / 2))
    sill = timber(2 * half + 2 * CASING + 0.05, REVEAL + 0.08, 0.034, 0.006, "trim", chance)
    mesh.include(sill, moved(0, -0.004, (0.08 - REVEAL) / 2))

    sash_back = -REVEAL + 0.035
    bottom, top = 0.013, height - 0.015
    inner = half - 0.013
    middle = (bottom + top) / 2
    for side in (-1, 1):
        stile = box((FRAME, top - bottom, SASH_DEPTH), 0.004, Grain("trim", chance, 1))
        mesh.include(stile, moved(side * (inner - FRAME / 2), middle, sash_back))
    for y in (bottom + FRAME / 2, top - FRAME / 2):
        rail = box((2 * (inner - FRAME), FRAME, SASH_DEPTH), 0.004, Grain("trim", chance, 0))
        mesh.include(rail, moved(0, y, sash_back))
    upright = box(
        (BAR, top - bottom - 2 * FRAME, SASH_DEPTH - 0.006), 0.006, Grain("trim", chance, 1)
    )
    mesh.include(upright, moved(0, middle, sash_back))
    for side in (-1, 1):
        width = inner - FRAME - BAR / 2
        bar = box((width, BAR, SASH_DEPTH - 0.006), 0.006, Grain("trim", chance, 0))
        mesh.include(bar, moved(side * (width / 2 + BAR / 2), middle, sash_back))
        for low, high in ((bottom + FRAME, middle - BAR / 2), (middle + BAR / 2, top - FRAME)):
            edges = sorted((side * BAR / 2, side * (inner - FRAME)))
            mesh.include(pane(*edges, low, high, chance), moved(0, 0, sash_back - 0.002))
    return mesh.placed(PLACEMENT)


def pane(left, right, low, high, chance):
    """Crown glass is never flat, which is why a flame wanders as it crosses a pane."""
    mesh = Mesh()
    steps, key = 4, chance.index(1 << 20)
    mapping = Projection("pane", chance)
    grid = []
    for r in range(steps + 1):
        row = []
        for c in range(steps + 1):
            z = 0.0007 * wander_over(1.7 * c / steps, 2.1 * r / steps, key)
            x = left - 0.004 + (right - left + 0.008) * c / steps
            row.append(mesh.add_point(x, low - 0.004 + (high - low + 0.008) * r / steps, z))
        grid.append(row)
    return add_grid(mesh, grid, mapping)


def build_curtain():
    half = WINDOW.width / 2
    cloth = curtain(0.42, ROD_HEIGHT + 0.12)
    return cloth.placed(PLACEMENT @ moved(half - 0.28, ROD_HEIGHT - 0.004, ROD_OUT))


def build_curtain_rod():
    half = WINDOW.width / 2 + 0.16
    mesh = Mesh()
    rod = [(-half, ROD_HEIGHT, ROD_OUT), (0, ROD_HEIGHT, ROD_OUT), (half, ROD_HEIGHT, ROD_OUT)]
    mesh.include(tube(rod, 0.007, 8, "iron"))
    for side in (-1, 1):
        x = side * (half - 0.03)
        hook = [(x, ROD_HEIGHT - 0.012, -0.02), (x, ROD_HEIGHT - 0.012, ROD_OUT - 0.004)]
        hook += [(x, ROD_HEIGHT - 0.008, ROD_OUT + 0.011), (x, ROD_HEIGHT + 0.008, ROD_OUT + 0.012)]
        mesh.include(tube(hook, 0.004, 6, "iron"))
    return mesh.placed(PLACEMENT)


def build_night():
    """Behind the glass, so that no joint lets a wall of the world show."""
    mesh = Mesh()
    half, height = WINDOW.width / 2 + 0.15, WINDOW.height
    ring = mesh.add_ring(
        [(-half, -0.15, 0), (half, -0.15, 0), (half, height + 0.15, 0), (-half, height + 0.15, 0)]
    )
    mesh.add_face(ring, [(0, 0), (1, 0), (1, 1), (0, 1)], "night")
    return mesh.placed(PLACEMENT @ moved(0, 0, -REVEAL - 0.01))
