"""Polygons with a texture coordinate at every corner: metres, +Y up, texture V down the picture."""

from collections import defaultdict, namedtuple
from math import cos, radians

from mathutils import Matrix, Vector

Face = namedtuple("Face", "corners texcoords material")

# A one-step bevel turns the surface by 45 degrees twice, and is meant to look round.
CREASE = radians(52)


class Mesh:
    """Points and faces. Faces that share a point are shaded as one unless they meet in a crease."""

    def __init__(self):
        self.points = []
        self.faces = []

    def add_point(self, *coordinates):
        self.points.append(Vector(coordinates[0] if len(coordinates) == 1 else coordinates))
        return len(self.points) - 1

    def add_ring(self, points):
        return [self.add_point(point) for point in points]

    def add_face(self, corners, texcoords, material):
        self.faces.append(Face(tuple(corners), tuple(tuple(t) for t in texcoords), material))

    def include(self, other, placement=None):
        """Adds a copy of another mesh, and returns self."""
        base = len(self.points)
        mirrored = placement is not None and placement.determinant() < 0
        self.points += [placement @ p if placement else p.copy() for p in other.points]
        for face in other.faces:
            corners = [base + corner for corner in face.corners]
            texcoords = face.texcoords
            if mirrored:
                corners, texcoords = corners[::-1], texcoords[::-1]
            self.add_face(corners, texcoords, face.material)
        return self

    def placed(self, placement):
        return Mesh().include(self, placement)

    def of_material(self, material):
        """The faces of one material, with the points they use."""
        part = Mesh()
        moved = {}
        for face in self.faces:
            if face.material != material:
                continue
            for corner in face.corners:
                if corner not in moved:
                    moved[corner] = part.add_point(self.points[corner])
            part.add_face([moved[c] for c in face.corners], face.texcoords, material)
        return part

    def materials(self):
        return sorted({face.material for face in self.faces})

    def triangulated(self):
        """Triangles only, quads cut along their shorter diagonal, those without area left out."""
        result = Mesh()
        result.points = [point.copy() for point in self.points]
        for face in self.faces:
            for triple in self._triples(face):
                corners = [face.corners[k] for k in triple]
                a, b, c = (self.points[corner] for corner in corners)
                if (b - a).cross(c - a).length > 2e-9:
                    result.add_face(corners, [face.texcoords[k] for k in triple], face.material)
        return result

    def _triples(self, face):
        count = len(face.corners)
        if count == 4:
            a, b, c, d = (self.points[corner] for corner in face.corners)
            if (b - d).length < (a - c).length:
                return [(0, 1, 3), (1, 2, 3)]
            return [(0, 1, 2), (0, 2, 3)]
        return [(0, k, k + 1) for k in range(1, count - 1)]

    def face_vectors(self):
        """The normal of each face, as long as its area."""
        vectors = []
        for face in self.faces:
            points = [self.points[corner] for corner in face.corners]
            total = Vector((0, 0, 0))
            for k in range(1, len(points) - 1):
                total += (points[k] - points[0]).cross(points[k + 1] - points[0])
            vectors.append(total / 2)
        return vectors

    def corner_normals(self):
        """A normal for each corner of each face: the mean by area of the faces round it."""
        vectors = self.face_vectors()
        units = [vector.normalized() for vector in vectors]
        around = defaultdict(list)
        for index, face in enumerate(self.faces):
            for corner in set(face.corners):
                around[corner].append(index)
        limit = cos(CREASE)
        normals = []
        for index, face in enumerate(self.faces):
            own = []
            for corner in face.corners:
                total = Vector((0, 0, 0))
                for other in around[corner]:
                    if units[index].dot(units[other]) > limit:
                        total += vectors[other]
                own.append(total.normalized())
            normals.append(own)
        return normals


def moved(x, y, z):
    return Matrix.Translation((x, y, z))


def turned(angle, axis="Y"):
    return Matrix.Rotation(angle, 4, axis)
