"""What would look wrong in a room: things inside out, floating, or sunk into one another."""

from collections import defaultdict
from math import cos, isfinite, pi, sin, sqrt

from mathutils import Vector
from mathutils.bvhtree import BVHTree

from chance import Chance
from mesh import Mesh
from occlusion import tree_of

# Metres that things may be apart, or inside one another, before it shows.
TOUCH = 0.0025
SUNK = 0.004


def assert_finite(name, mesh):
    for face in mesh.faces:
        numbers = [number for texcoord in face.texcoords for number in texcoord]
        numbers += [number for corner in face.corners for number in mesh.points[corner]]
        if not all(isfinite(number) for number in numbers):
            raise ValueError(f"{name}: a coordinate is not a number")


def inside_out(meshes, eyes, rays=3000):
    """Back faces that a visitor inside can see, counted by name, and the rays that hit nothing."""
    names, points, polygons = [], [], []
    for name, mesh in meshes.items():
        base = len(points)
        points += mesh.points
        polygons += [[base + corner for corner in face.corners] for face in mesh.faces]
        names += [f"{name}:{face.material}" for face in mesh.faces]
    tree = BVHTree.FromPolygons(points, polygons)
    backs = defaultdict(int)
    escaped = []
    for number, eye in enumerate(eyes):
        chance = Chance("eye", number)
        for _ in range(rays):
            height = chance.between(-1, 1)
            angle = chance.between(0, 2 * pi)
            flat = sqrt(1 - height * height)
            direction = Vector((flat * cos(angle), height, flat * sin(angle)))
            place, normal, index, _ = tree.ray_cast(Vector(eye), direction)
            if place is None:
                escaped.append((tuple(eye), tuple(direction)))
            elif normal.dot(direction) > 0.02:
                backs[names[index]] += 1
    return dict(backs), escaped


def shells(mesh):
    """The connected parts of a mesh, joined also where points coincide."""
    parent = {}

    def root(key):
        while parent.setdefault(key, key) != key:
            parent[key] = parent[parent[key]]
            key = parent[key]
        return key

    def at(corner):
        return tuple(round(component * 1e5) for component in mesh.points[corner])

    for face in mesh.faces:
        first = root(at(face.corners[0]))
        for corner in face.corners[1:]:
            parent[root(at(corner))] = first
    parts = defaultdict(list)
    for face in mesh.faces:
        parts[root(at(face.corners[0]))].append(face)
    return list(parts.values())


def volume_of(mesh, faces):
    """The volume that faces enclose, negative if they are inside out; None if they do not close."""
    edges = defaultdict(int)
    volume = 0.0
    # Blender's vectors are of single precision: volumes are summed near the faces.
    origin = mesh.points[faces[0].corners[0]]
    for face in faces:
        points = [mesh.points[corner] for corner in face.corners]
        keys = [tuple(round(c * 1e5) for c in point) for point in points]
        for a, b in zip(keys, keys[1:] + keys[:1]):
            edges[min(a, b), max(a, b)] += 1 if a < b else -1
        for k in range(1, len(points) - 1):
            a, b, c = (point - origin for point in (points[0], points[k], points[k + 1]))
            volume += a.cross(b).dot(c) / 6
    return volume if all(count == 0 for count in edges.values()) else None


def inside_out_shells(mesh):
    """Closed parts that enclose less than nothing: a face of each, and its volume."""
    found = []
    for faces in shells(mesh):
        volume = volume_of(mesh, faces)
        if volume is not None and volume <= 0:
            found.append((faces[0].material, len(faces), volume))
    return found


def closed_part(mesh):
    """The parts of a mesh that enclose a volume."""
    part = Mesh()
    part.points = mesh.points
    for faces in shells(mesh):
        if volume_of(mesh, faces) is not None:
            part.faces += faces
    return part


def gap(mesh, other):
    """The distance between two things, zero where they meet."""
    own, others = tree_of([mesh]), tree_of([other])
    if own.overlap(others):
        return 0.0
    outward = min(others.find_nearest(point)[3] for point in mesh.points)
    return min(outward, *(own.find_nearest(point)[3] for point in other.points))


def depth_inside(mesh, solid):
    """How deep the points of one thing lie within another, closed one, and where."""
    if not solid.faces:
        return 0.0, None
    tree = BVHTree.FromPolygons(solid.points, [face.corners for face in solid.faces])
    used = [solid.points[corner] for face in solid.faces for corner in face.corners]
    low = Vector(min(point[k] for point in used) for k in range(3))
    high = Vector(max(point[k] for point in used) for k in range(3))
    deepest, where = 0.0, None
    # Off every axis, so that no ray runs along an edge.
    direction = Vector((0.3, 0.9, 0.31)).normalized()
    for point in mesh.points:
        if not all(low[k] < point[k] < high[k] for k in range(3)):
            continue
        crossings, start = 0, point
        for _ in range(60):
            place, normal, _, _ = tree.ray_cast(start, direction)
            if place is None:
                break
            crossings += 1 if normal.dot(direction) > 0 else -1
            start = place + direction * 1e-5
        if crossings > 0:
            depth = tree.find_nearest(point)[3]
            if depth > deepest:
                deepest, where = depth, point
    return deepest, where
