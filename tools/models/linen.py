"""Linen: a cloth folded once and left over the table's edge, and a curtain half drawn."""

from math import cos, pi, sin

from chance import wander, wander_over
from shapes import slab, tile_of

FOLDED = 0.006


def hanging_cloth(width, on_table, drop):
    """
    Lies towards -X from the table's edge at x = 0, its surface at y = 0, and hangs beyond.
    """
    turn = 0.012
    bend = turn * pi / 2
    # Columns are narrow where it bends: its shading is smooth there, and so is the edge of its shadow.
    parts = (8, on_table), (6, bend), (8, drop)
    columns = sum(count for count, _ in parts)

    def place_along(s):
        """Distance along the cloth of a share of its columns."""
        column, along = s * columns, 0
        for count, part in parts:
            along += part * max(0, min(1, column / count))
            column -= count
        return along

    def fold(along, across):
        """How far the hanging part stands off: two soft flutes that grow downwards."""
        depth = max(0.0, along - on_table - bend) / drop
        flute = 0.5 + 0.5 * cos(2 * pi * (across * 1.6 + 0.15))
        return depth * (0.026 * flute + 0.006 * wander(across * 5, "flute")) + 0.002 * depth

    def surface(s, t):
        along = place_along(s)
        across = t * width
        crease = 0.006 * max(0, wander_over(along / 0.11 + 0.3 * t, across / 0.09, "crease") - 0.15)
        crease += 0.0022 * max(0, 1 - abs(across / width - 0.5) * 16)
        slant = 0.035 * (t - 0.5)
        if along < on_table:
            lift = FOLDED + crease * min(1, along / 0.03) * min(1, (on_table - along) / 0.03 + 0.2)
            x, y = along - on_table, lift
            z = across + slant * (on_table - along) / on_table
        elif along < on_table + bend:
            angle = (along - on_table) / turn
            reach = turn + FOLDED
            x, y, z = reach * sin(angle), FOLDED - reach + reach * cos(angle), across
        else:
            down = along - on_table - bend
            x, y = turn + FOLDED + fold(along, t), -turn - down - 0.012 * t * down / drop
            z = across + 0.02 * (t - 0.5) * down / drop
        return x, y, -z

    def printed(s, t):
        return place_along(s) / tile_of("linen"), -t * width / tile_of("linen")

    return slab(surface, columns, 14, FOLDED * 0.92, "linen", None, printed)


def curtain(width, height):
    """Hangs from y = 0 to -height over x = 0 to width, gathered in round pleats that deepen downwards."""
    pleats = 5.5

    def surface(s, t):
        down = 1 - t
        phase = 2 * pi * pleats * s + 0.9 * wander_over(s * pleats, down * 2.2, "pleat")
        swing = (0.35 + 0.65 * down) * (1 + 0.35 * wander_over(s * pleats, down * 1.1, "depth"))
        z = 0.017 * swing * sin(phase) + 0.012 * wander_over(s * 3, down * 2, "curtain")
        # Slower across the sides than over the crowns, which are round so.
        x = width * (s - 0.01 * swing * sin(2 * phase)) * (0.93 + 0.1 * down * down)
        return x, -height * down - 0.008 * sin(phase * 0.5) * down, z

    return slab(surface, 50, 5, 0.0016, "linen", (width * 2.1, height))
