"""The solids everything is made of. All are closed unless said otherwise, and no edge is sharp."""

from itertools import product
from math import cos, pi, sin

from mathutils import Vector

from mesh import Mesh
from texturing import Grain, tile_of


def millimetres(text):
    """Points in metres: "38.5 0, 40.5 2.5" is [(0.0385, 0), (0.0405, 0.0025)]."""
    return [tuple(float(f"{n}e-3") for n in point.split()) for point in text.split(",")]


def add_mapped(mesh, corners, mapping):
    points = [mesh.points[corner] for corner in corners]
    normal = (points[1] - points[0]).cross(points[2] - points[0])
    if len(points) == 4:
        normal += (points[2] - points[0]).cross(points[3] - points[0])
    texcoords = [mapping.texcoord(point, normal) for point in points]
    mesh.add_face(corners, texcoords, mapping.material)


def add_grid(mesh, rows, mapping):
    """A skin over rows of equally many points, and returns the mesh."""
    for lower, upper in zip(rows, rows[1:]):
        for k in range(len(lower) - 1):
            add_mapped(mesh, [lower[k], lower[k + 1], upper[k + 1], upper[k]], mapping)
    return mesh


def box(size, bevel, mapping):
    """A box round the origin with one-step bevels: 44 triangles."""
    mesh = Mesh()
    half = [length / 2 for length in size]
    index = {}
    octants = list(product((-1, 1), repeat=3))
    for signs in octants:
        for face in range(3):
            point = [signs[k] * (half[k] - (0 if k == face else bevel)) for k in range(3)]
            index[signs, face] = mesh.add_point(point)

    def facing(corners, outwards):
        a, b, c = (mesh.points[corner] for corner in corners[:3])
        wrong = (b - a).cross(c - a).dot(Vector(outwards)) < 0
        add_mapped(mesh, corners[::-1] if wrong else corners, mapping)

    def signs_of(axis_signs):
        return tuple(axis_signs[k] for k in range(3))

    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        for s in (-1, 1):
            quad = [
                index[signs_of({axis: s, b: sb, c: sc}), axis]
                for sb, sc in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ]
            facing(quad, signs_of({axis: s, b: 0, c: 0}))
        for sb, sc in product((-1, 1), repeat=2):
            low, high = signs_of({axis: -1, b: sb, c: sc}), signs_of({axis: 1, b: sb, c: sc})
            outwards = signs_of({axis: 0, b: sb, c: sc})
            facing([index[low, b], index[high, b], index[high, c], index[low, c]], outwards)
    for signs in octants:
        facing([index[signs, face] for face in range(3)], signs)
    return mesh


def chamfered(width, height, bevel):
    """The outline of a bevelled board, counter-clockwise: eight points."""
    w, h = width / 2, height / 2
    return [
        (w - bevel, -h),
        (w, -h + bevel),
        (w, h - bevel),
        (w - bevel, h),
        (-w + bevel, h),
        (-w, h - bevel),
        (-w, -h + bevel),
        (-w + bevel, -h),
    ]


def loft(rings, mapping, capped=True):
    """A skin over rings of equally many points, each counter-clockwise seen from the last ring."""
    mesh = Mesh()
    indices = [mesh.add_ring(ring) for ring in rings]
    count = len(indices[0])
    for below, above in zip(indices, indices[1:]):
        for k in range(count):
            after = (k + 1) % count
            corners = [below[k], below[after], above[after], above[k]]
            add_mapped(mesh, corners, mapping)
    if capped:
        add_mapped(mesh, indices[0][::-1], mapping)
        add_mapped(mesh, indices[-1], mapping)
    return mesh


def timber(length, width, height, bevel, material, chance, pieces=1, shift=None):
    """
    A board along X with bevelled edges and ends, cut across into equal pieces; `shift(x)` moves
    each cut by (y, z).
    """
    grain = Grain(material, chance, 0)
    outline = chamfered(width, height, bevel)
    inset = chamfered(width - 2 * bevel, height - 2 * bevel, bevel * 0.6)
    half = length / 2
    rings = []

    def ring(shape, x):
        dy, dz = shift(x) if shift else (0, 0)
        # Width runs along Z and height along Y, so that the outline turns about +X.
        return [(x, y + dy, -z + dz) for z, y in shape]

    rings.append(ring(inset, -half))
    for cut in range(pieces + 1):
        x = -half + bevel + cut / pieces * (length - 2 * bevel)
        rings.append(ring(outline, x))
    rings.append(ring(inset, half))
    return loft(rings, grain)


def lathe(profile, sides, material, along_grain=False, radius_at=None, repeats=None):
    """
    A profile of (radius, height), turned about Y. Going up the profile the outside is on the
    right; a radius of zero closes an end. `radius_at(angle, radius, height)` makes it less round.
    """
    mesh = Mesh()
    tile = tile_of(material)
    widest = max(radius for radius, _ in profile)
    around = repeats or max(1, round(2 * pi * widest / tile))
    if along_grain:
        around = 2 * pi * widest / tile
    run = [0.0]
    for (r0, h0), (r1, h1) in zip(profile, profile[1:]):
        run.append(run[-1] + ((r1 - r0) ** 2 + (h1 - h0) ** 2) ** 0.5)

    rings = []
    for radius, height in profile:
        if radius == 0:
            rings.append([mesh.add_point(0, height, 0)] * sides)
            continue
        ring = []
        for k in range(sides):
            angle = 2 * pi * k / sides
            r = radius_at(angle, radius, height) if radius_at else radius
            ring.append(mesh.add_point(r * cos(angle), height, -r * sin(angle)))
        rings.append(ring)

    def texcoord(row, k):
        turn, distance = around * k / sides, run[row] / tile
        return (distance, turn) if along_grain else (turn, -distance)

    for row in range(len(profile) - 1):
        below, above = rings[row], rings[row + 1]
        for k in range(sides):
            after = (k + 1) % sides
            corners = [(below[k], row, k), (below[after], row, k + 1)]
            corners += [(above[after], row + 1, k + 1), (above[k], row + 1, k)]
            kept = []
            for corner in corners:
                if corner[0] not in [other[0] for other in kept]:
                    kept.append(corner)
            if len(kept) >= 3:
                texcoords = [texcoord(r, c) for _, r, c in kept]
                mesh.add_face([index for index, _, _ in kept], texcoords, material)
    return mesh


def arc(centre, radius, start, end, count):
    """Points of a circle in the plane of a profile; angles in radians from the radius axis."""
    return [
        (
            centre[0] + radius * cos(start + (end - start) * k / (count - 1)),
            centre[1] + radius * sin(start + (end - start) * k / (count - 1)),
        )
        for k in range(count)
    ]


def tube(path, radius, sides, material, closed=False, squash=1.0, along_grain=True, rounded=True):
    """
    A round bar along a path. `radius` is a number or a function of the fraction of the path; `squash`
    flattens it across the direction it first bends away from.
    """
    path = [Vector(point) for point in path]
    count = len(path)
    radius_at = radius if callable(radius) else lambda t: radius
    tangents = []
    for k in range(count):
        before = path[(k - 1) % count] if closed else path[max(0, k - 1)]
        after = path[(k + 1) % count] if closed else path[min(count - 1, k + 1)]
        tangents.append((after - before).normalized())
    side = tangents[0].orthogonal().normalized()
    bend = next((t for t in tangents if tangents[0].cross(t).length > 0.05), None)
    if bend is not None:
        side = tangents[0].cross(bend).normalized()

    tile = tile_of(material)
    mesh = Mesh()
    rings, run, distance = [], [], 0.0
    for k in range(count):
        if k:
            distance += (path[k] - path[k - 1]).length
        run.append(distance / tile)
        side = (side - tangents[k] * side.dot(tangents[k])).normalized()
        other = tangents[k].cross(side)
        r = radius_at(k / (count - 1))
        rings.append(
            mesh.add_ring(
                path[k]
                + side * (r * squash * cos(2 * pi * i / sides))
                + other * (r * sin(2 * pi * i / sides))
                for i in range(sides)
            )
        )
    girth = 2 * pi * radius_at(0.5) / tile
    pairs = [(k, k + 1) for k in range(count - 1)] + ([(count - 1, 0)] if closed else [])
    for k, n in pairs:
        far = run[n] if n > k else run[k] + (path[n] - path[k]).length / tile
        for i in range(sides):
            j = (i + 1) % sides
            coordinates = [(run[k], i), (run[k], i + 1), (far, i + 1), (far, i)]
            texcoords = [(u, girth * v / sides) for u, v in coordinates]
            if not along_grain:
                texcoords = [(v, u) for u, v in texcoords]
            mesh.add_face([rings[k][i], rings[k][j], rings[n][j], rings[n][i]], texcoords, material)
    if not closed:
        for ring, place, way, t in (
            (rings[0], path[0], -tangents[0], 0),
            (rings[-1], path[-1], tangents[-1], 1),
        ):
            bulge = radius_at(t) * (0.5 if rounded else 0.05)
            tip = mesh.add_point(place + way * bulge)
            for i in range(sides):
                j = (i + 1) % sides
                a, b = (ring[j], ring[i]) if t == 0 else (ring[i], ring[j])
                spokes = [(girth * i / sides, 0), (girth * (i + 1) / sides, 0)]
                middle = (girth * (i + 0.5) / sides, bulge / tile)
                mesh.add_face([a, b, tip], [*spokes, middle], material)
    return mesh


def smooth_path(points, steps):
    """A curve through points (Catmull and Rom 1974, "A class of local interpolating splines")."""
    points = [Vector(point) for point in points]
    padded = [2 * points[0] - points[1], *points, 2 * points[-1] - points[-2]]
    curve = []
    for k in range(1, len(padded) - 2):
        p0, p1, p2, p3 = padded[k - 1 : k + 3]
        for step in range(steps):
            t = step / steps
            curve.append(
                0.5
                * (
                    2 * p1
                    + (p2 - p0) * t
                    + (2 * p0 - 5 * p1 + 4 * p2 - p3) * t**2
                    + (3 * p1 - p0 - 3 * p2 + p3) * t**3
                )
            )
    return [*curve, points[-1]]


def slab(surface, columns, rows, thickness, material, size, printed=None):
    """
    A sheet with thickness. `surface(s, t)`, both 0 to 1, is its outside, which faces dP/ds x dP/dt;
    `size` is its width and height in metres, for the texture, unless `printed(s, t)` says where a
    place is in the picture.
    """
    mesh = Mesh()
    tile = tile_of(material)
    grid = [
        [Vector(surface(c / columns, r / rows)) for c in range(columns + 1)]
        for r in range(rows + 1)
    ]

    def normal(r, c):
        du = grid[r][min(c + 1, columns)] - grid[r][max(c - 1, 0)]
        dv = grid[min(r + 1, rows)][c] - grid[max(r - 1, 0)][c]
        return du.cross(dv).normalized()

    front = [[mesh.add_point(point) for point in row] for row in grid]
    back = [
        [mesh.add_point(grid[r][c] - normal(r, c) * thickness) for c in range(columns + 1)]
        for r in range(rows + 1)
    ]

    def texcoord(r, c):
        if printed:
            return printed(c / columns, r / rows)
        return c / columns * size[0] / tile, -r / rows * size[1] / tile

    for r in range(rows):
        for c in range(columns):
            cells = [(r, c), (r, c + 1), (r + 1, c + 1), (r + 1, c)]
            texcoords = [texcoord(*cell) for cell in cells]
            mesh.add_face([front[i][j] for i, j in cells], texcoords, material)
            mesh.add_face([back[i][j] for i, j in cells[::-1]], texcoords[::-1], material)
    rim = [(0, c) for c in range(columns)] + [(r, columns) for r in range(rows)]
    rim += [(rows, c) for c in range(columns, 0, -1)] + [(r, 0) for r in range(rows, 0, -1)]
    for here, there in zip(rim, rim[1:] + rim[:1]):
        (r0, c0), (r1, c1) = here, there
        (u0, v0), (u1, v1) = texcoord(r0, c0), texcoord(r1, c1)
        deep = thickness / tile
        mesh.add_face(
            [back[r0][c0], back[r1][c1], front[r1][c1], front[r0][c0]],
            [(u0 + deep, v0 + deep), (u1 + deep, v1 + deep), (u1, v1), (u0, v0)],
            material,
        )
    return mesh
