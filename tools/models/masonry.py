"""The hearth's masonry: rubble in lime, flags before it, a sooty firebox."""

from math import pi

from mathutils import Vector

from chance import Chance, wander_over
from mesh import Mesh, moved, turned
from room import HEIGHT
from shapes import add_grid, add_mapped, box, loft
from texturing import Projection

HALF_WIDTH = 0.75
FRONT = 0.55
OPENING = 0.45
SLAB = 0.055
BRESSUMMER_BOTTOM = 0.86
BRESSUMMER_TOP = 1.08
BREAST_FRONT = 0.4
MORTAR_INSET = 0.016


def stone_block(size, chance, rounding, whole=False):
    """A rough stone facing +Z. Unless it is whole, it ends where the mortar hides it."""
    mapping = Projection("stone", chance)
    half = Vector(size) / 2
    inner = [max(h - rounding, 0.3 * h) for h in half]
    # Dressed roughly: every corner a little off, the face a little proud.
    bulge = chance.between(0.002, 0.01)
    key = chance.key

    def shaped(lines):
        core = Vector(max(-inner[k], min(inner[k], line * half[k])) for k, line in enumerate(lines))
        raw = Vector(line * half[k] for k, line in enumerate(lines))
        off = raw - core
        point = core + (off.normalized() * rounding if off.length > 1e-6 else off)
        for k in range(3):
            point[k] += 0.009 * wander_over(
                9 * point[(k + 1) % 3] + 3 * k, 9 * point[(k + 2) % 3], key, k
            )
        if lines[2] > 0.99 and abs(lines[0]) < 0.99 and abs(lines[1]) < 0.99:
            point.z += bulge
        return point

    mesh = Mesh()
    known = {}

    def at(lines):
        if lines not in known:
            known[lines] = mesh.add_point(shaped(lines))
        return known[lines]

    def steps(axis, deep):
        near = inner[axis] / half[axis]
        if deep:
            return (-1, near, 1) if whole else (near, 1)
        return (-1, -near, near, 1)

    for axis, sign in ((0, -1), (0, 1), (1, -1), (1, 1), (2, 1)):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        b_lines = steps(b, b == 2)
        c_lines = steps(c, c == 2)
        for b0, b1 in zip(b_lines, b_lines[1:]):
            for c0, c1 in zip(c_lines, c_lines[1:]):
                quad = []
                for vb, vc in ((b0, c0), (b1, c0), (b1, c1), (b0, c1)):
                    lines = [0, 0, 0]
                    lines[axis], lines[b], lines[c] = sign, vb, vc
                    quad.append(at(tuple(lines)))
                add_mapped(mesh, quad[:: 1 if sign > 0 else -1], mapping)
    return mesh


def split(start, end, low, high, chance):
    """Cuts a run into pieces of random width."""
    pieces, place = [], start
    while end - place > high:
        width = chance.between(low, min(high, end - place - low))
        pieces.append((place, place + width))
        place += width
    pieces.append((place, end))
    return pieces


def masonry():
    mesh = Mesh()
    chance = Chance("masonry")
    courses = split(SLAB, BRESSUMMER_BOTTOM, 0.11, 0.24, chance)
    for low, high in courses:
        for side in (-1, 1):
            lay_pier(mesh, side, low, high, chance)
    for side in (-1, 1):
        lay_return(mesh, side, HALF_WIDTH, BRESSUMMER_BOTTOM, BRESSUMMER_TOP, -0.05, 0.34, chance)
    courses = split(BRESSUMMER_TOP, HEIGHT, 0.1, 0.25, chance)
    for low, high in courses:
        lay_breast(mesh, low, high, chance)
    return mesh


def set_stone(mesh, left, right, low, high, back, front, chance):
    joint = chance.between(0.007, 0.013)
    size = (right - left - joint, high - low - joint, front - back)
    rounding = min(0.024, 0.3 * min(size))
    proud = chance.between(-0.004, 0.005)
    stone = stone_block(size, chance, rounding)
    middle = ((left + right) / 2, (low + high) / 2, (front + back) / 2 + proud)
    mesh.include(
        stone,
        moved(*middle)
        @ turned(chance.between(-0.03, 0.03))
        @ turned(chance.between(-0.025, 0.025), "Z"),
    )


def lay_pier(mesh, side, low, high, chance):
    """One course of a pier: a quoin in front, and one behind it that reaches the wall."""
    middle = chance.between(0.2, 0.34)
    inner, outer = sorted((side * OPENING, side * HALF_WIDTH))
    pieces = split(inner, outer, 0.11, chance.between(0.2, 0.4), chance)
    for left, right in pieces:
        set_stone(mesh, left, right, low, high, FRONT - 0.22, FRONT, chance)
    for back, front in ((-0.05, middle), (middle, FRONT - 0.2)):
        lay_return(mesh, side, HALF_WIDTH, low, high, back, front, chance)


def lay_return(mesh, side, half, low, high, back, front, chance):
    """A stone in the side of the masonry."""
    block = Mesh()
    set_stone(block, (back - front) / 2, (front - back) / 2, low, high, -0.1, 0.1, chance)
    place = moved(side * (half - 0.1), 0, (back + front) / 2) @ turned(side * pi / 2)
    mesh.include(block, place)


def breast_half(height):
    """The breast draws in as it rises."""
    t = (height - BRESSUMMER_TOP) / (HEIGHT - BRESSUMMER_TOP)
    return HALF_WIDTH - 0.02 - 0.15 * min(1, 1.3 * t)


def lay_breast(mesh, low, high, chance):
    half = breast_half((low + high) / 2)
    for left, right in split(-half, half, 0.13, 0.45, chance):
        set_stone(mesh, left, right, low, high, BREAST_FRONT - 0.2, BREAST_FRONT, chance)
    for side in (-1, 1):
        lay_return(mesh, side, half, low, high, -0.05, BREAST_FRONT - 0.2, chance)


def mortar():
    """What shows in the joints: a core a finger's breadth behind the stones."""
    mesh = Mesh()
    mapping = Projection("mortar", Chance("mortar"))
    inset = MORTAR_INSET
    for side in (-1, 1):
        width = HALF_WIDTH - OPENING - 2 * inset
        core = box((width, BRESSUMMER_BOTTOM, FRONT + 0.05 - inset), 0.01, mapping)
        behind = box((width, 0.3, 0.36), 0.01, mapping)
        mesh.include(behind, moved(side * (OPENING + HALF_WIDTH) / 2, BRESSUMMER_TOP - 0.14, 0.13))
        middle = side * (OPENING + HALF_WIDTH) / 2
        height = BRESSUMMER_BOTTOM / 2
        mesh.include(core, moved(middle, height, (FRONT - inset - 0.05) / 2))
    rings = []
    for k in range(5):
        height = BRESSUMMER_TOP + (HEIGHT + 0.01 - BRESSUMMER_TOP) * k / 4
        half = breast_half(height) - inset
        front = BREAST_FRONT - inset
        rings.append(
            [
                (-half, height, -0.05),
                (-half, height, front),
                (half, height, front),
                (half, height, -0.05),
            ]
        )
    return mesh.include(loft(rings, mapping))


def firebox():
    """Back, cheeks and throat in one skin, black with soot; open towards the room."""
    mapping = Projection("stone-sooty", Chance("firebox"))
    mesh = Mesh()
    # Half-width and depth of the back at each height: the throat leans forward to the bressummer.
    levels = [(0.04, 0.1), (0.3, 0.1), (0.55, 0.12), (0.8, 0.22), (1.02, 0.36)]
    columns = []
    for height, back in levels:
        half_back = 0.34
        front = FRONT - 0.03
        outline = [(-OPENING - 0.005, front), (-0.4, (front + back) / 2), (-half_back, back)]
        outline += [(0, back - 0.01), (half_back, back), (0.4, (front + back) / 2)]
        outline += [(OPENING + 0.005, front)]
        columns.append([mesh.add_point(x, height, z) for x, z in outline])
    return add_grid(mesh, columns, mapping)


def hearthstone():
    mesh = Mesh()
    chance = Chance("hearthstone")
    for left, right in ((-0.86, -0.3), (-0.3, 0.24), (0.24, 0.86)):
        set_slab(mesh, left, right, 0.5, 0.98, chance)
    set_slab(mesh, -0.47, 0.47, 0.03, 0.5, chance)
    return mesh


def set_slab(mesh, left, right, back, front, chance):
    size = (right - left - 0.006, front - back - 0.006, SLAB + 0.02)
    slab = stone_block(size, chance, 0.014, whole=True)
    lift = SLAB - size[2] / 2 - 0.012 + chance.between(-0.002, 0.002)
    place = moved((left + right) / 2, lift, (back + front) / 2) @ turned(-pi / 2, "X")
    mesh.include(slab, place)
