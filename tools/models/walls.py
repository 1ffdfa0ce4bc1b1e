"""
Log walls, one course to a row of the `logs` texture. The texture draws 0.55 of a log's roundness
into its normals; the mesh carries the rest, and sinks the lime between the logs.
"""

from math import sqrt

from chance import Chance, wander
from mesh import Mesh
from room import HEIGHT, OPENINGS, PITCH, WALLS
from texturing import TILE

RADIUS = PITCH / 2
ROUNDNESS = 0.6
# Heights across the face of a log, measured from its crown.
FACE = (-0.081, -0.062, -0.033, 0.0, 0.033, 0.062, 0.081)
LIME_INSET = 0.005
LIME_DEPTH = 0.036
# Far enough past the corner to fill the grooves of the other wall.
OVERLAP = 0.06
STEP = 0.72
ROWS = 8


class Log:
    def __init__(self, wall, course):
        chance = Chance("log", wall.name, course)
        self.key = chance.key
        self.crown = wall.lowest_crown + course * PITCH
        self.row = chance.index(ROWS)
        self.start = chance.fraction()
        self.flip = -1 if chance.fraction() < 0.5 else 1
        self.girth = chance.between(0.92, 1.08)

    def point(self, s, offset):
        """The place on the log's face at `s` along the wall, `offset` above its crown."""
        swell = 0.006 * wander(s / 1.1, self.key, 1) + 0.003 * wander(s / 0.4, self.key, 2)
        sway = 0.004 * wander(s / 1.3, self.key, 3)
        sagitta = RADIUS - sqrt(RADIUS**2 - offset**2)
        return s, self.crown + offset + sway, swell - sagitta * ROUNDNESS * self.girth

    def lime(self, s, offset):
        """The mortar beside the log."""
        _, y, _ = self.point(s, offset)
        belly = 0.003 * wander(s / 0.35, self.key, 4)
        return s, y, belly - LIME_DEPTH

    def texcoord(self, s, offset):
        u = (self.flip * s) / TILE["logs"] + self.start
        return u, (self.row + 0.5) / ROWS - offset / TILE["logs"]


def stations(wall, left, right):
    """Places to cut a log: finer towards the corners, where the light falls off."""
    half = wall.length / 2
    corner = [half + OVERLAP, half - 0.06, half - 0.3]
    count = round((2 * corner[-1]) / STEP)
    inner = [-corner[-1] + 2 * corner[-1] * k / count for k in range(1, count)]
    cuts = [-s for s in corner] + inner + corner[::-1]
    return [left] + [s for s in cuts if left + 0.08 < s < right - 0.08] + [right]


def spans(wall, height):
    """The parts of a course that no opening takes."""
    half = wall.length / 2 + OVERLAP
    parts = [(-half, half)]
    for opening in OPENINGS:
        if opening.wall is not wall or not opening.bottom < height < opening.top:
            continue
        cut = []
        for left, right in parts:
            cut += [(left, min(right, opening.left)), (max(left, opening.right), right)]
        parts = [(left, right) for left, right in cut if right - left > 0.01]
    return parts


def build_wall(wall):
    mesh = Mesh()
    courses = round((HEIGHT - wall.lowest_crown) / PITCH + 0.5)
    logs = [Log(wall, course) for course in range(courses + 1)]
    for log, upper in zip(logs, logs[1:]):
        for left, right in spans(wall, log.crown + 0.01):
            add_course(mesh, log, upper, stations(wall, left, right))
    return mesh.placed(wall.placement)


def add_course(mesh, log, upper, cuts):
    """A log, and the lime up to the log above it."""
    top = FACE[-1] + LIME_INSET
    columns = []
    for s in cuts:
        strip = [(log.point(s, offset), log.texcoord(s, offset)) for offset in FACE]
        if 0 < log.crown < PITCH:
            # The lowest log stands on a sill of lime, below the floor.
            strip.insert(0, ((s, -0.03, -LIME_DEPTH), log.texcoord(s, -0.03 - log.crown)))
        strip.append((log.lime(s, top), log.texcoord(s, top)))
        # The lime runs on into the next row of the texture.
        strip.append((upper.lime(s, -top), log.texcoord(s, PITCH - top)))
        strip.append((upper.point(s, FACE[0]), log.texcoord(s, PITCH + FACE[0])))
        columns.append([(mesh.add_point(point), texcoord) for point, texcoord in strip])
    for here, there in zip(columns, columns[1:]):
        for k in range(len(here) - 1):
            corners = [here[k], there[k], there[k + 1], here[k + 1]]
            mesh.add_face([c for c, _ in corners], [t for _, t in corners], "logs")


def build_walls():
    mesh = Mesh()
    for wall in WALLS:
        mesh.include(build_wall(wall))
    return mesh
