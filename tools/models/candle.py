"""Candles that stand: wax, the pool in its dish, and the wick; their foot at the origin."""

from math import pi, sin

from mathutils import Vector

from chance import wander
from mesh import Mesh, moved
from shapes import arc, lathe, smooth_path, tube

# From the level of the pool: the wick leans as it burns.
WICK = [(0, -0.003, 0), (0.0001, 0, 0), (0.0003, 0.0024, 0.0001), (0.0011, 0.0046, 0.0003)]
WICK += [(0.0024, 0.0062, 0.0005), (0.0037, 0.0069, 0.0006)]
# Foot of the flame from the level of the pool: where the wick leaves the wax, below its upper third.
FLAME_ROOT = Vector((0.0011, 0.0007, 0.0003))
POOL_DEPTH = 0.0026


def flame_root(height):
    """Foot of the flame of a candle so high."""
    return FLAME_ROOT + Vector((0, height - POOL_DEPTH, 0))


def wick(level, steps=1, sides=6):
    """`steps` between the points of its curve; `sides` round it."""

    def radius(t):
        return 0.00105 - 0.0001 * sin(pi * t) + 0.0001 * wander(12 * t, "ply")

    return tube(smooth_path(WICK, steps), radius, sides, "wick").placed(moved(0, level, 0))


def wax(radius, height, key, sides, runs):
    """
    A candle's body with a worn lip, open below. `runs` are wax that ran over it: angle, height of its end,
    width along the circumference, thickness.
    """
    level = height - POOL_DEPTH
    bank = min(0.0035, radius * 0.3)
    outside = [(radius * 0.97, 0.0), (radius, 0.0012)]
    rows = max(2, round(height / 0.011)) if runs else 2
    outside += [
        (radius - 0.0004 * k / rows, 0.0012 + (height - 0.005) * k / rows)
        for k in range(1, rows + 1)
    ]
    lip = arc((radius - bank * 0.5, height - 0.0018), bank * 0.38, 0.1, 2.6, 4)
    dish = [(radius - bank, level - 0.0002), (radius * 0.6, level - 0.003), (0, level - 0.004)]

    def radius_at(angle, own, at):
        if own < radius - bank * 0.9:
            return own
        swell = 0.00012 * wander(angle * 2.2, key, round(at * 900))
        for place, end, width, thickness in runs:
            away = (angle - place - 0.08 * wander(at * 34, key, "run") + pi) % (2 * pi) - pi
            down = min(1.0, max(0.0, (at - end) / 0.004 + 0.5))
            swell += thickness * down * max(0.0, 1 - (away * radius / width) ** 2)
        return own + swell

    mesh = lathe([*outside, *lip, *dish], sides, "wax", radius_at=radius_at)
    for point in mesh.points:
        if point.y > height - 0.0035 and Vector((point.x, point.z)).length > radius - bank * 0.9:
            point.y += 0.0006 * wander(2.2 * (1 + point.x / radius), key, "lip")
    return mesh


def pool(radius, level, sides):
    """Liquid wax: level, creeping up its bank and up the wick. Open below."""
    profile = [(radius, level + 0.0005), (radius * 0.92, level + 0.0001), (radius * 0.5, level)]
    profile += [(0.0014, level + 0.0003), (0.0009, level + 0.001)]
    return lathe(profile, sides, "pool")


def candle(radius, height, key, sides=20, runs=()):
    level = height - POOL_DEPTH
    bank = min(0.0035, radius * 0.3)
    mesh = Mesh().include(wax(radius, height, key, sides, runs))
    mesh.include(pool(radius - bank * 0.85, level, sides))
    return mesh.include(wick(level))
