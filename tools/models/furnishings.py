"""What makes the room lived in: a chest with a blanket, a rug, a stool, a coat on a peg, a mirror."""

from math import cos, pi, sin

from chance import Chance, wander, wander_over
from mesh import Mesh, moved, turned
from room import EAST, SOUTH, WEST
from shapes import box, lathe, loft, slab, smooth_path, timber, tube
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
        end = timber(body, depth - 0.03, 0.022, 0.003, "pine", Grain("pine", chance, 0))
        place = moved(side * (length / 2 - 0.03), body / 2, 0) @ turned(pi / 2, "Z")
        mesh.include(end, place)
        face = timber(length - 0.02, body - 0.07, 0.022, 0.004, "pine", Grain("pine", chance, 0), [k / 4 for k in range(5)])
        z = side * (depth / 2 - 0.012)
        mesh.include(face, moved(0, 0.07 + (body - 0.07) / 2, z) @ turned(pi / 2, "X"))
    floor = box((length - 0.07, 0.02, depth - 0.04), 0.002, "pine", Grain("pine", chance, 0))
    mesh.include(floor, moved(0, 0.1, 0))
    lid = timber(length + 0.02, depth + 0.025, LID, 0.007, "pine", Grain("pine", chance, 0), [k / 4 for k in range(5)])
    mesh.include(lid, moved(0, height - LID / 2, 0))
    return mesh.placed(CHEST)


def build_chest_irons():
    chance = Chance("chest irons")
    mesh = Mesh()
    iron = Projection("iron", chance)
    front = CHEST_DEPTH / 2 - 0.001
    mesh.include(box((0.075, 0.095, 0.004), 0.0016, "iron", iron), moved(0, CHEST_HEIGHT - 0.1, front + 0.0015))
    hasp = box((0.03, 0.085, 0.005), 0.0018, "iron", iron)
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
    return loft(rings, "wool", Projection("wool", chance))


def build_blanket():
    mesh = Mesh()
    y = CHEST_HEIGHT - 0.0015
    for number, (width, turn) in enumerate(((0.4, 0.0), (0.395, 0.012), (0.385, -0.02))):
        layer = folded_layer(width, 0.3, 0.026, number)
        mesh.include(layer, moved(0.24, y + 0.0245 * number, 0.01) @ turned(turn))
    return mesh.placed(CHEST)


class Coils:
    """The stripes of the `wool` texture run round, so V is the distance from the rug's spine."""

    def __init__(self, half_width):
        self.half_width = half_width

    def texcoord(self, point, _normal):
        core = max(-0.26, min(0.26, point.x))
        radius = ((point.x - core) ** 2 + point.z**2) ** 0.5
        return point.x * 0.9, 0.2 + 1.4 * (self.half_width - radius)


def build_rug():
    """A braided wool rug before the hearth, an oval of flat coils, each its own colour."""
    mesh = Mesh()
    sides, coils = 36, 4
    half_length, half_width, thickness = 0.66, 0.4, 0.011
    rings = []

    def place(k, coil_share):
        angle = 2 * pi * k / sides
        c, s = cos(angle), sin(angle)
        wobble = 1 + 0.012 * wander(k * 0.5, "rug")
        core = half_length - half_width
        x = (half_width * coil_share * c + core * (1 if c > 0 else -1) * min(1, abs(c) * 4)) * wobble
        return x, half_width * coil_share * s * wobble

    for coil in range(coils):
        outer = 1 - coil / (coils + 1.2)
        inner = 1 - (coil + 1) / (coils + 1.2)
        if coil == 0:
            rings.append([(x, 0.0, -z) for x, z in (place(k, 1.0) for k in range(sides))])
            rings.append([(x, thickness * 0.6, -z) for x, z in (place(k, 1.004) for k in range(sides))])
        for share, lift in ((outer - 0.2 * (outer - inner), 1.0), (outer - 0.75 * (outer - inner), 1.0), (inner, 0.72)):
            ripple = [0.0012 * wander(k * 0.7, "ripple", coil) for k in range(sides)]
            rings.append(
                [(*p[:1], thickness * lift + ripple[k], -p[1]) for k, p in enumerate(place(k, share) for k in range(sides))]
            )
    grown = loft(rings, "wool", Coils(half_width), capped=False)
    hub = [len(grown.points) - sides + k for k in range(sides)]
    heights = sum(grown.points[k].y for k in hub) / sides
    tip = grown.add_point(0, heights, 0)
    for k in range(sides):
        corners = [hub[k], hub[(k + 1) % sides], tip]
        texcoords = [Coils(half_width).texcoord(grown.points[c], None) for c in corners]
        grown.add_face(corners, texcoords, "wool")
    mesh.include(grown)
    return mesh.placed(moved(-0.72, 0.0008, -0.62) @ turned(0.06))


def build_stool():
    """A milking stool: a thick round seat on three splayed legs."""
    mesh = Mesh()
    seat = [(0, 0.3), (0.12, 0.3), (0.142, 0.303), (0.148, 0.312), (0.148, 0.326), (0.142, 0.335)]
    seat += [(0.12, 0.337), (0.06, 0.333), (0, 0.331)]
    mesh.include(lathe(seat, 20, "pine", along_grain=True))
    for k in range(3):
        angle = 2 * pi * k / 3 + 0.5
        c, s = cos(angle), sin(angle)
        leg = [(0.155 * c, 0.008, 0.155 * s), (0.125 * c, 0.15, 0.125 * s), (0.09 * c, 0.312, 0.09 * s)]
        mesh.include(tube(leg, lambda share: 0.0135 + 0.004 * sin(pi * share), 8, "pine"))
    return mesh.placed(moved(-1.72, 0, -0.72))


PEGS = SOUTH.placement @ moved(0.35, 1.68, 0)


def build_peg_rail():
    chance = Chance("pegs")
    mesh = Mesh()
    rail = timber(0.9, 0.085, 0.022, 0.005, "trim", Grain("trim", chance, 0), [k / 3 for k in range(4)])
    mesh.include(rail, moved(0, 0, 0.013) @ turned(pi / 2, "X"))
    for x in (-0.3, 0.0, 0.3):
        peg = [(x, -0.002, 0.016), (x, 0.006, 0.055), (x, 0.018, 0.095), (x, 0.022, 0.107)]
        widths = (0.011, 0.0085, 0.008, 0.0125)
        mesh.include(tube(peg, lambda s: widths[min(3, round(3 * s))], 8, "trim"))
    return mesh.placed(PEGS)


def build_coat():
    """A heavy coat hung by its collar: narrow at the peg, shoulders fallen, hem flared in folds."""
    mesh = Mesh()
    sections = [
        (0.012, 0.03, 0.02, 0.055), (0.0, 0.055, 0.035, 0.055), (-0.05, 0.1, 0.05, 0.058),
        (-0.1, 0.155, 0.062, 0.062), (-0.16, 0.185, 0.07, 0.066), (-0.3, 0.19, 0.075, 0.068),
        (-0.48, 0.188, 0.078, 0.07), (-0.66, 0.205, 0.085, 0.074), (-0.84, 0.228, 0.092, 0.078),
        (-1.0, 0.245, 0.098, 0.082), (-1.05, 0.246, 0.099, 0.083),
    ]  # fmt: skip
    sides = 24
    rings = []
    for y, half, deep, middle in sections[::-1]:
        ring = []
        for k in range(sides):
            angle = 2 * pi * k / sides
            c, s = cos(angle), sin(angle)
            loose = min(1, max(0, -y / 0.9))
            fold = 0.16 * loose * sin(5 * angle + 1.5 * wander(y * 2, "coat")) * (0.6 + 0.4 * s)
            fold += 0.05 * wander(angle * 3, "coat creases", round(y * 6))
            x = half * c * (1 + 0.4 * fold) + 0.01 * wander(y * 3, "hang")
            z = middle + deep * s * (0.75 if s < 0 else 1 + fold)
            ring.append((x, y, max(z, 0.012)))
        # The loft wants them to turn about the upward direction.
        rings.append(ring[::-1])
    mesh.include(loft(rings, "broadcloth", Projection("broadcloth", Chance("coat"))))
    for side in (-1, 1):
        sleeve = [(side * 0.1, -0.075, 0.075), (side * 0.185, -0.2, 0.085), (side * 0.212, -0.4, 0.1), (side * 0.2, -0.6, 0.118), (side * 0.19, -0.66, 0.122)]  # fmt: skip
        path = smooth_path(sleeve, 2)
        arm = tube(path, lambda s: 0.064 - 0.016 * s + 0.004 * wander(s * 9, "sleeve"), 10, "broadcloth", rounded=False)
        mesh.include(arm)
    return mesh.placed(PEGS @ moved(-0.3, 0.01, 0.012))


def build_hat():
    """A felt hat on the far peg, seen from its crown."""
    profile = [(0, 0.004), (0.088, 0.002), (0.12, 0.001), (0.165, 0.006), (0.168, 0.009), (0.165, 0.0115)]
    profile += [(0.12, 0.007), (0.096, 0.01), (0.091, 0.03), (0.087, 0.07), (0.079, 0.1), (0.06, 0.112), (0, 0.108)]
    hat = lathe(profile, 18, "broadcloth", radius_at=lambda a, r, h: r * (1 + 0.06 * cos(2 * a)))
    return hat.placed(PEGS @ moved(0.3, -0.068, 0.05) @ turned(pi / 2 + 0.2, "X"))


def build_mirror():
    """A small dark looking-glass in an oak frame, leaning out from its nail as they were hung."""
    chance = Chance("mirror")
    mesh = Mesh()
    width, height, frame = 0.34, 0.46, 0.05
    for side in (-1, 1):
        rail = timber(width, frame, 0.024, 0.007, "trim", Grain("trim", chance, 0))
        mesh.include(rail, moved(0, side * (height - frame) / 2, 0) @ turned(pi / 2, "X"))
        stile = timber(height - 2 * frame + 0.002, frame, 0.024, 0.007, "trim", Grain("trim", chance, 0))
        upright = turned(pi / 2, "Z") @ turned(pi / 2, "X")
        mesh.include(stile, moved(side * (width - frame) / 2, 0, 0) @ upright)
    half_width, half_height = width / 2 - frame + 0.004, height / 2 - frame + 0.004

    def glass(s, t):
        return (2 * s - 1) * half_width, (2 * t - 1) * half_height, 0.002

    mesh.include(slab(glass, 2, 2, 0.006, "glass", (width, height)))
    return mesh.placed(WEST.placement @ moved(-0.75, 1.432, 0.0255) @ turned(0.05, "X"))
