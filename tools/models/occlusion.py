"""Ambient occlusion at the corners of triangles, by casting rays at everything in the room."""

from math import cos, pi, sin, sqrt

from mathutils import Vector
from mathutils.bvhtree import BVHTree

from chance import hashed

RAYS = 64
# The renderer's irradiance volume knows what lies further away.
ROOM_REACH = 0.5
UNLIT = {"night", "glass", "pane"}


def directions():
    """A cosine-weighted hemisphere about +Z (Hammersley's points)."""
    result = []
    for k in range(RAYS):
        reversed_bits = int(f"{k:032b}"[::-1], 2) / 2**32
        t = (k + 0.5) / RAYS
        angle = 2 * pi * reversed_bits
        radius = sqrt(t)
        result.append((radius * cos(angle), radius * sin(angle), sqrt(1 - t)))
    return result


def tree_of(meshes):
    points, polygons = [], []
    for mesh in meshes:
        base = len(points)
        points += mesh.points
        polygons += [[base + corner for corner in face.corners] for face in mesh.faces]
    return BVHTree.FromPolygons(points, polygons)


def openness(tree, place, normal, turn, hemisphere, reach):
    """The share of the sky above a point, near things counting more than far ones."""
    tangent = normal.orthogonal().normalized()
    bitangent = normal.cross(tangent)
    c, s = cos(turn), sin(turn)
    along = tangent * c + bitangent * s
    across = bitangent * c - tangent * s
    start = place + normal * (0.003 * reach)
    blocked = 0.0
    cast = tree.ray_cast
    for x, y, z in hemisphere:
        distance = cast(start, along * x + across * y + normal * z, reach)[3]
        if distance is not None:
            blocked += (1 - distance / reach) ** 2
    return 1 - blocked / RAYS


def bake(mesh, normals, tree, reach=ROOM_REACH):
    """Openness for each corner of each face of a mesh."""
    hemisphere = directions()
    known = {}
    result = []
    for face, own in zip(mesh.faces, normals):
        shades = []
        for corner, normal in zip(face.corners, own):
            if face.material in UNLIT:
                shades.append(1.0)
                continue
            key = (corner, *(round(50 * component) for component in normal))
            if key not in known:
                turn = 2 * pi * hashed(*(round(4096 * c) for c in mesh.points[corner])) / 2**32
                shade = openness(tree, Vector(mesh.points[corner]), normal, turn, hemisphere, reach)
                known[key] = shade
            shades.append(known[key])
        result.append(shades)
    return result
