"""How a texture lies on a surface: its size, and where each piece was cut from its sheet."""

# Metres that one tile of each texture set covers.
TILE = {
    "logs": 1.6,
    "logends": 0.2,
    "trim": 1.6,
    "planks": 1.6,
    "mortar": 0.3,
    "ash": 0.16,
    "char": 0.3,
    "stone": 1.6,
    "brass": 0.3,
    "iron": 0.5,
    "pewter": 0.3,
    "wax": 0.2,
    "linen": 0.4,
    "wool": 1.0,
    "leather": 0.4,
    "paper": 0.3,
}

# Tints of a texture set, as materials of their own.
TINTS = {
    "charcoal": "char",
    "rush": "linen",
    "pine": "trim",
    "cloth-blue": "leather",
    "cloth-red": "leather",
    "broadcloth": "linen",
    "stone-sooty": "stone",
}

# Boards side by side in one tile of wood; grain runs along U.
BOARDS = {"trim": 4, "planks": 8, "logs": 8}


def tile_of(material):
    return TILE.get(TINTS.get(material, material), 1.0)


class Projection:
    """Texture laid flat on each face along the axis it faces, from a random place."""

    def __init__(self, material, chance):
        self.material = material
        self.tile = tile_of(material)
        self.offset = (chance.fraction(), chance.fraction())

    def texcoord(self, point, normal):
        axis = dominant(normal)
        across, up = {0: (2, 1), 1: (0, 2), 2: (0, 1)}[axis]
        return (
            point[across] / self.tile + self.offset[0],
            self.offset[1] - point[up] / self.tile,
        )


class Grain:
    """One piece of wood: grain along an axis, kept inside one board of the sheet."""

    def __init__(self, material, chance, axis):
        self.material = material
        self.tile = tile_of(material)
        self.axis = axis
        boards = BOARDS[TINTS.get(material, material)]
        self.middle = (chance.index(boards) + 0.5) / boards + chance.between(-0.02, 0.02)
        self.start = chance.fraction()

    def texcoord(self, point, normal):
        axis = dominant(normal)
        others = [k for k in (0, 1, 2) if k != axis]
        along = self.axis if axis != self.axis else others[0]
        across = next(k for k in others if k != along)
        return point[along] / self.tile + self.start, self.middle + point[across] / self.tile


# `paper` holds a printed page in its upper left corner, and leaves on edge in its right half.
PAGE_TILE = TILE["paper"]


class Leaves:
    """Leaves of a book seen on edge, stacked along one axis."""

    material = "paper"

    def __init__(self, stacked, half_size):
        self.stacked = stacked
        self.reach = max(half_size)

    def texcoord(self, point, normal):
        axis = dominant(normal)
        along = next(k for k in (1, 2, 0) if k not in (axis, self.stacked))
        across = next(k for k in (0, 1, 2) if k not in (axis, along))
        return 0.75 + 0.24 * point[along] / self.reach, point[across] / PAGE_TILE


def dominant(vector):
    sizes = [abs(component) + 1e-6 * k for k, component in enumerate(vector)]
    return sizes.index(max(sizes))
