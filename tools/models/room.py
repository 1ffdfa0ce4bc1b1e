"""The room's measures, and what is where. Metres, +Y up, the origin on the floor at the centre."""

from math import pi

from mathutils import Matrix, Vector

LENGTH = 5.0
DEPTH = 4.0
HEIGHT = 2.6
PITCH = 0.2


class Wall:
    """A wall's own axes: along it to the right as one faces it, up, and into the room."""

    def __init__(self, name, origin, along, inwards, length, lowest_crown):
        self.name = name
        self.length = length
        self.lowest_crown = lowest_crown
        along, inwards, origin = Vector(along), Vector(inwards), Vector(origin)
        self.placement = Matrix.Identity(4)
        for row in range(3):
            self.placement[row][0] = along[row]
            self.placement[row][1] = (0, 1, 0)[row]
            self.placement[row][2] = inwards[row]
            self.placement[row][3] = origin[row]


# Courses of neighbouring walls are half a log apart: each lies in the other's notches.
NORTH = Wall("north", (0, 0, -DEPTH / 2), (1, 0, 0), (0, 0, 1), LENGTH, PITCH / 2)
SOUTH = Wall("south", (0, 0, DEPTH / 2), (-1, 0, 0), (0, 0, -1), LENGTH, PITCH / 2)
EAST = Wall("east", (LENGTH / 2, 0, 0), (0, 0, 1), (-1, 0, 0), DEPTH, 0)
WEST = Wall("west", (-LENGTH / 2, 0, 0), (0, 0, -1), (1, 0, 0), DEPTH, 0)
WALLS = (NORTH, EAST, SOUTH, WEST)


class Opening:
    """A hole in a wall, measured along and up that wall, from joint to joint of the courses."""

    def __init__(self, wall, left, right, bottom, top):
        self.wall, self.left, self.right = wall, left, right
        self.bottom, self.top = bottom, top
        self.middle = (left + right) / 2
        self.width = right - left
        self.height = top - bottom


WINDOW = Opening(EAST, -0.95, 0.0, 0.9, 1.9)
DOOR = Opening(SOUTH, 1.05, 1.95, 0.0, 2.0)
# Nobody sees the logs behind the masonry.
CHIMNEY = Opening(NORTH, -1.22, -0.28, 0.0, 2.6)
OPENINGS = (WINDOW, DOOR, CHIMNEY)

HEARTH_MIDDLE = -0.75
BEAMS = (-1.9, -0.63, 0.63, 1.9)
BEAM_HEIGHT = 0.19

# Where the visitor starts, just inside the door, and which way they look (turned from -Z about +Y).
SPAWN = Vector((-1.55, 0.0, 1.3))
SPAWN_TURN = -0.3 * pi
