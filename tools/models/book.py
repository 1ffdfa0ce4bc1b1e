"""Books: one left open on the table, and closed ones for the shelf."""

from math import cos, pi, radians, sin

from chance import Chance
from mesh import Mesh, moved, turned
from shapes import add_mapped, box, slab
from texturing import PAGE_TILE, Leaves, Projection

PAGE_WIDTH = 0.128
PAGE_HEIGHT = 0.196
BOARD = 0.0028


def page_curve(thickness, steps):
    """Half of an open text block, from the gutter outwards: (x, y) of the upper page."""
    curve = []
    for k in range(steps + 1):
        t = k / steps
        swell = thickness * (1 - (1 - min(1, t * 4.5)) ** 2) * (1 - 0.16 * t**2)
        curve.append((t * PAGE_WIDTH, BOARD + 0.0007 + swell))
    return curve


def text_block():
    """Two printed pages, and the edges of the leaves below them, open underneath."""
    left = [(-x, y) for x, y in page_curve(0.021, 9)]
    right = page_curve(0.012, 9)
    gutter = len(left) - 1
    top = left[::-1] + right[1:]
    half = PAGE_HEIGHT / 2
    leaves = Leaves(1, (PAGE_WIDTH, half))
    mesh = Mesh()
    depths = (-half, -0.04, 0.04, half)
    columns = [[mesh.add_point(x, y, z) for z in depths] for x, y in top]
    for k, (here, there) in enumerate(zip(columns, columns[1:])):
        start = -PAGE_WIDTH if k < gutter else 0.0
        for r in range(len(depths) - 1):
            corners = [here[r], here[r + 1], there[r + 1], there[r]]
            points = [mesh.points[corner] for corner in corners]
            texcoords = [((p.x - start) / PAGE_TILE, (p.z + half) / PAGE_TILE) for p in points]
            mesh.add_face(corners, texcoords, "paper")
    # Fore-edges slant because each leaf is bent round the ones below.
    for edge, slant, order in ((0, -0.005, 1), (-1, 0.003, -1)):
        x, y = top[edge]
        high = [mesh.add_point(x, y, z) for z in depths]
        low = [mesh.add_point(x + slant, BOARD, z) for z in depths]
        for r in range(len(depths) - 1):
            corners = [low[r], low[r + 1], high[r + 1], high[r]][::order]
            add_mapped(mesh, corners, leaves)
    for row, order in ((0, -1), (-1, 1)):
        z = depths[row]
        high = [mesh.add_point(x, y, z) for x, y in top]
        low = [mesh.add_point(x, BOARD, z) for x, _ in top]
        for k in range(len(top) - 1):
            corners = [low[k], low[k + 1], high[k + 1], high[k]][::order]
            add_mapped(mesh, corners, leaves)
    return mesh


def lifted_leaf():
    """One leaf that has not settled: it springs from the gutter and bends over to the left."""
    steps = 10
    curve = [(0.0, 0.006)]
    for k in range(steps):
        t = (k + 0.5) / steps
        angle = radians(95 + 300 * t if t < 0.15 else 140 + 42 * (t - 0.15) / 0.85)
        x, y = curve[-1]
        length = PAGE_WIDTH * 0.985 / steps
        curve.append((x + length * cos(angle), y + length * sin(angle)))

    def leaf(s, t):
        x, y = curve[round(s * steps)]
        return x, y * (1 + 0.25 * s * (t - 0.5)), (t - 0.5) * PAGE_HEIGHT * 0.996

    def printed(s, t):
        return (1 - s) * PAGE_WIDTH / PAGE_TILE, t * PAGE_HEIGHT / PAGE_TILE

    return slab(leaf, steps, 3, 0.0004, "paper", (PAGE_WIDTH, PAGE_HEIGHT), printed)


def open_book():
    """An octavo lying open on its back, nearer its end than its beginning."""
    chance = Chance("open book")
    mesh = text_block().include(lifted_leaf())
    cloth = Projection("cloth-blue", chance)
    width = PAGE_WIDTH + 0.009
    for side in (-1, 1):
        cover = box((width, BOARD, PAGE_HEIGHT + 0.01), 0.0011, cloth)
        mesh.include(cover, moved(side * (width / 2 + 0.005), BOARD / 2, 0))
    spine = box((0.012, 0.0022, PAGE_HEIGHT + 0.01), 0.0009, cloth)
    return mesh.include(spine, moved(0, 0.0011, 0))


def closed_book(width, height, thickness, cover, key):
    """Standing upright, spine towards +Z, its middle over the origin."""
    chance = Chance("book", key)
    mesh = Mesh()
    cloth = Projection(cover, chance)
    half, bow = thickness / 2, min(0.007, 0.25 * thickness)
    joint = width / 2 - 0.005
    outer, inner = [(-half, -width / 2), (-half, joint)], [(BOARD - half, -width / 2)]
    inner.append((BOARD - half, joint))
    for k in range(5):
        angle = pi - pi * k / 4
        outer.append((half * 0.98 * cos(angle), width / 2 - 0.002 + bow * sin(angle)))
        inner.append(((half - BOARD) * cos(angle), width / 2 - 0.004))
    outer += [(half, joint), (half, -width / 2)]
    inner += [(half - BOARD, joint), (half - BOARD, -width / 2)]

    rings = [
        [mesh.add_point(x, y, z) for x, z in line] for y in (0, height) for line in (outer, inner)
    ]
    out_low, in_low, out_high, in_high = rings
    for k in range(len(outer) - 1):
        n = k + 1
        for corners in (
            [out_low[k], out_low[n], out_high[n], out_high[k]],
            [in_low[n], in_low[k], in_high[k], in_high[n]],
            [out_high[k], out_high[n], in_high[n], in_high[k]],
            [out_low[n], out_low[k], in_low[k], in_low[n]],
        ):
            add_mapped(mesh, corners, cloth)
    add_mapped(mesh, [in_low[0], out_low[0], out_high[0], in_high[0]], cloth)
    add_mapped(mesh, [out_low[-1], in_low[-1], in_high[-1], out_high[-1]], cloth)

    block = (thickness - 1.6 * BOARD, height - 0.006, width - 0.007)
    pages = box(block, 0.0008, Leaves(0, (height / 2, width / 2)))
    return mesh.include(pages, moved(0, height / 2, -0.0005))


def row_of_books(sizes, key):
    """Books side by side from x = 0, each (width, height, thickness, cover, lean in radians)."""
    mesh = Mesh()
    x = 0.0
    for number, (width, height, thickness, cover, lean) in enumerate(sizes):
        book = closed_book(width, height, thickness, cover, f"{key} {number}")
        depth = moved(0, 0, Chance(key, number).between(-0.006, 0.004))
        if lean:
            # Leaning back on the row: lower left edge away from it, upper left edge against it.
            x += height * sin(lean)
            tilt = turned(lean, "Z") @ moved(thickness / 2, 0, 0)
            mesh.include(book, depth @ moved(x, 0, 0) @ tilt)
            x += thickness * cos(lean)
        else:
            mesh.include(book, depth @ moved(x + thickness / 2, 0, 0))
            x += thickness
        x += Chance(key, number, 1).between(0.0006, 0.0016)
    return mesh
