"""A ladder-back chair with a rush seat, pushed back from the book by whoever left."""

from math import cos, pi, sin

from chance import Chance, wander
from mesh import Mesh, moved, turned
from shapes import loft, smooth_path, tube
from table import PLACEMENT as TABLE
from texturing import Grain, Projection

SEAT = 0.45
# In the table's own axes: the sitter faces -Z, towards the book.
PLACEMENT = TABLE @ moved(0.4, 0, 0.74) @ turned(0.42)


def post(path, thickness):
    """A turned post, thickest in the middle of its length, ending in a finial if it is tall."""

    def radius(t):
        return thickness * (0.78 + 0.22 * sin(pi * min(1, t * 1.1)))

    return tube(smooth_path(path, 3), radius, 10, "trim")


def slat(height, depth, half, bow, tall, chance):
    """A back slat, bowed to the sitter's back, higher in the middle."""
    rings = []
    for k in range(9):
        t = k / 8 * 2 - 1
        x, z = t * half, depth + bow * (1 - t * t)
        rise = 0.5 * tall * (0.78 + 0.22 * cos(t * pi / 2))
        slope = -2 * bow * t / half
        nx, nz = -slope * 0.0045, 0.0045
        low, high = height - 0.42 * tall, height + rise
        rings.append(
            [
                (x + nx, low + 0.003, z + nz),
                (x + nx, high - 0.003, z + nz),
                (x, high, z),
                (x - nx, high - 0.003, z - nz),
                (x - nx, low + 0.003, z - nz),
                (x, low, z),
            ]
        )
    return loft(rings[::-1], Grain("trim", chance, 0))


def rush_seat(front, back, depth, chance):
    """Rush wound round four rails: it rises to the rails and dips where the four windings meet."""
    mesh = Mesh()
    mapping = Projection("rush", chance)
    steps = 8
    top, bottom = [], []
    for r in range(steps + 1):
        t = r / steps * 2 - 1
        half = (front + back) / 2 - (front - back) / 2 * t
        row_top, row_bottom = [], []
        for c in range(steps + 1):
            s = c / steps * 2 - 1
            edge = max(abs(s), abs(t))
            seam = min(abs(abs(s) - abs(t)) * 4, 1)
            height = SEAT + 0.013 * edge**3 - 0.004 * (1 - seam) - (0.014 if edge > 0.99 else 0)
            height += 0.0012 * wander(7 * s + 3 * t, chance.key)
            grow = 1.0 if edge < 0.99 else 1.012
            x, z = s * half * grow, t * depth / 2 * grow
            row_top.append(mesh.add_point(x, height, z))
            under = SEAT - 0.02 - 0.006 * (1 - edge)
            row_bottom.append(mesh.add_point(x, height if edge > 0.99 else under, z))
        top.append(row_top)
        bottom.append(row_bottom)

    # The strands run along the nearest rail.
    def add(corners, flipped):
        points = [mesh.points[corner] for corner in corners]
        middle = sum((p for p in points), points[0] * 0) / 4
        sideways = abs(middle.x) / (front / 2) > abs(middle.z) / (depth / 2)
        texcoords = [(p.z, p.x) if sideways else (p.x, p.z) for p in points]
        texcoords = [(u / mapping.tile, v / mapping.tile) for u, v in texcoords]
        order = -1 if flipped else 1
        mesh.add_face(corners[::order], texcoords[::order], "rush")

    for r in range(steps):
        for c in range(steps):
            cells = [(r, c), (r, c + 1), (r + 1, c + 1), (r + 1, c)]
            add([top[i][j] for i, j in cells], True)
            add([bottom[i][j] for i, j in cells], False)
    return mesh


def build_chair():
    chance = Chance("chair")
    mesh = Mesh()
    front, back, depth = 0.2, 0.165, 0.37
    z_front, z_back = -depth / 2, depth / 2
    for side in (-1, 1):
        leg = [(side * front * 1.03, 0.008, z_front - 0.006), (side * front, 0.2, z_front)]
        mesh.include(post([*leg, (side * front, SEAT + 0.022, z_front)], 0.0195))
        rear = [(side * back * 1.02, 0.008, z_back + 0.03), (side * back, 0.24, z_back)]
        rear += [(side * back, SEAT, z_back), (side * back * 0.98, 0.72, z_back + 0.028)]
        rear += [(side * back * 0.96, 0.97, z_back + 0.075)]
        mesh.include(tube(smooth_path(rear, 3), lambda t: 0.0185 - 0.005 * t**3, 10, "trim"))
        finial = [
            (side * back * 0.96, 0.97, z_back + 0.075),
            (side * back * 0.957, 0.985, z_back + 0.078),
        ]
        finial += [
            (side * back * 0.955, 1.0, z_back + 0.081),
            (side * back * 0.952, 1.018, z_back + 0.085),
        ]
        widths = (0.0115, 0.0165, 0.0155, 0.006)
        mesh.include(tube(finial, lambda s: widths[min(3, round(3 * s))], 10, "trim"))
        for height, thick in ((0.15, 0.0105), (0.29, 0.0115), (SEAT - 0.004, 0.013)):
            rail = [(side * front, height, z_front), (side * (front + back) / 2, height, 0)]
            rail += [(side * back, height, z_back + 0.004)]
            mesh.include(tube(rail, lambda s, r=thick: r * (0.7 + 0.3 * sin(pi * s)), 6, "trim"))
    for height, z, half, thick in (
        (0.2, z_front, front, 0.0115),
        (0.33, z_front, front, 0.0115),
        (SEAT - 0.004, z_front, front, 0.013),
        (0.22, z_back + 0.002, back, 0.0105),
        (SEAT - 0.004, z_back, back, 0.013),
    ):
        rail = [(-half, height, z), (0, height, z), (half, height, z)]
        mesh.include(tube(rail, lambda s, r=thick: r * (0.7 + 0.3 * sin(pi * s)), 6, "trim"))
    for height, lean, tall in ((0.585, 0.008, 0.06), (0.715, 0.026, 0.068), (0.86, 0.052, 0.078)):
        mesh.include(slat(height, z_back + lean, back * 0.985, 0.022, tall, chance))
    mesh.include(rush_seat(front, back, depth, chance))
    return mesh.placed(PLACEMENT)
