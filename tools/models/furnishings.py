"""What makes the room lived in: a rug, a stool, a bench, a looking-glass."""

from math import cos, pi, sin

from chance import Chance, wander
from mesh import Mesh, moved, turned
from room import WEST
from shapes import box, lathe, loft, millimetres, slab, timber, tube
from texturing import Grain


class Coils:
    """The stripes of the `wool` texture run round, so V is the distance from the rug's spine."""

    material = "wool"

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
        x = (
            half_width * coil_share * c + core * (1 if c > 0 else -1) * min(1, abs(c) * 4)
        ) * wobble
        return x, half_width * coil_share * s * wobble

    for coil in range(coils):
        outer = 1 - coil / (coils + 1.2)
        inner = 1 - (coil + 1) / (coils + 1.2)
        if coil == 0:
            rings.append([(x, 0.0, -z) for x, z in (place(k, 1.0) for k in range(sides))])
            rings.append(
                [(x, thickness * 0.6, -z) for x, z in (place(k, 1.004) for k in range(sides))]
            )
        for t, lift in (
            (outer - 0.2 * (outer - inner), 1.0),
            (outer - 0.75 * (outer - inner), 1.0),
            (inner, 0.72),
        ):
            ripple = [0.0012 * wander(k * 0.7, "ripple", coil) for k in range(sides)]
            rings.append(
                [
                    (*p[:1], thickness * lift + ripple[k], -p[1])
                    for k, p in enumerate(place(k, t) for k in range(sides))
                ]
            )
    grown = loft(rings, Coils(half_width), capped=False)
    hub = [len(grown.points) - sides + k for k in range(sides)]
    core = half_length - half_width
    spine = []
    for corner in hub:
        x, y, _ = grown.points[corner]
        spine.append(grown.add_point(max(-core, min(core, x)), y, 0))
    coil = Coils(half_width)
    for k in range(sides):
        following = (k + 1) % sides
        for corners in (hub[k], hub[following], spine[k]), (hub[following], spine[following], spine[k]):
            points = [grown.points[corner] for corner in corners]
            if (points[1] - points[0]).cross(points[2] - points[0]).length > 1e-9:
                grown.add_face(corners, [coil.texcoord(p, None) for p in points], "wool")
    mesh.include(grown)
    return mesh.placed(moved(-0.72, 0.0008, -0.62) @ turned(0.06))


def build_stool():
    """A milking stool: a thick round seat on three splayed legs."""
    mesh = Mesh()
    seat = millimetres("0 300, 120 300, 142 303, 148 312, 148 326, 142 335, 120 337, 60 333, 0 331")
    mesh.include(lathe(seat, 20, "pine", along_grain=True))
    for k in range(3):
        angle = 2 * pi * k / 3 + 0.5
        c, s = cos(angle), sin(angle)
        leg = [
            (0.155 * c, 0.008, 0.155 * s),
            (0.125 * c, 0.15, 0.125 * s),
            (0.09 * c, 0.312, 0.09 * s),
        ]
        mesh.include(tube(leg, lambda t: 0.0135 + 0.004 * sin(pi * t), 8, "pine"))
    return mesh.placed(moved(-1.72, 0, -0.72))


def build_mirror():
    """A small spotted looking-glass in an oak frame, leaning out from its nail as they were hung."""
    chance = Chance("mirror")
    mesh = Mesh()
    width, height, frame = 0.34, 0.46, 0.05
    for side in (-1, 1):
        rail = timber(width, frame, 0.024, 0.007, "trim", chance)
        mesh.include(rail, moved(0, side * (height - frame) / 2, 0) @ turned(pi / 2, "X"))
        stile = timber(height - 2 * frame + 0.002, frame, 0.024, 0.007, "trim", chance)
        upright = turned(pi / 2, "Z") @ turned(pi / 2, "X")
        mesh.include(stile, moved(side * (width - frame) / 2, 0, 0) @ upright)
    half_width, half_height = width / 2 - frame + 0.004, height / 2 - frame + 0.004

    def glass(s, t):
        return (2 * s - 1) * half_width, (2 * t - 1) * half_height, 0.002

    # The picture of a glass is all of it.
    sheet = slab(glass, 1, 1, 0.006, "looking-glass", (1, 1), lambda s, t: (s, 1 - t))
    mesh.include(sheet)
    return mesh.placed(WEST.placement @ moved(-0.75, 1.432, 0.0255) @ turned(0.05, "X"))


def build_bench():
    """A plank bench along the west wall."""
    chance = Chance("bench")
    mesh = Mesh()
    length, depth, height, thickness = 1.25, 0.27, 0.44, 0.036
    seat = timber(length, depth, thickness, 0.006, "pine", chance, 4)
    mesh.include(seat, moved(0, height - thickness / 2, 0))
    for side in (-1, 1):
        end = box((0.034, height - thickness, depth - 0.03), 0.005, Grain("pine", chance, 1))
        mesh.include(end, moved(side * (length / 2 - 0.15), (height - thickness) / 2, 0))
    rail = box((length - 0.32, 0.085, 0.026), 0.004, Grain("pine", chance, 0))
    mesh.include(rail, moved(0, height - thickness - 0.05, 0))
    return mesh.placed(WEST.placement @ moved(-0.2, 0, 0.21) @ turned(-0.02))
