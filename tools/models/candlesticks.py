"""Three candles that stand in the cabin, to be lit from the carried one."""

from candle import candle, flame_root
from hearth import MANTEL_TOP
from hearth import PLACEMENT as HEARTH
from masonry import BREAST_FRONT
from mesh import Mesh, moved, turned
from shapes import lathe, millimetres
from window import PLACEMENT as WINDOW

RADIUS = 0.0105
SIDES = 18


def tall_stick():
    """A brass candlestick, 164 mm: a stepped foot, a baluster, a drip pan. Open below."""
    profile = millimetres(
        "42 0, 47 0, 48 5, 43 8, 35 10.5, 31 15, 15 21, 10 31, 9.5 36, 12.8 40, 12.8 43, 8.2 47, "
        "7.4 64, 11.8 101, 12.4 110, 7.6 124, 11.2 129, 11.2 132, 8 136, 12 146, 12.4 158, 23 162, "
        "23.6 164.4, 12 162, 10.8 150"
    )
    return lathe(profile, SIDES, "brass")


def short_stick():
    """A pewter candlestick, 72 mm: a wide foot, a single knop. Open below."""
    profile = millimetres(
        "46 0, 51.5 0, 51.5 6, 44 9, 30 12.5, 16 18, 11.5 24, 15.4 33, 15 37, 10.6 45, 12.4 54, "
        "12.8 66, 20.5 69.6, 20.8 72, 12 70.5, 10.8 56"
    )
    return lathe(profile, SIDES, "pewter")


def saucer():
    """A shallow pewter dish with a socket, 30 mm. Open below."""
    profile = millimetres(
        "36 0, 42 0, 52 7.5, 55.6 10.4, 55 12, 50 9.6, 42 5, 17 3.6, 13.2 6, 12.8 26, 13.8 28, "
        "13.2 30, 11 29.2, 10.8 13"
    )
    return lathe(profile, SIDES, "pewter")


# Each wick's node, where its stick stands and how it is turned, its stick, its top, its candle.
STANDING = (
    (
        "wick-mantel-left",
        HEARTH @ moved(-0.3, MANTEL_TOP, BREAST_FRONT + 0.085) @ turned(0.4),
        tall_stick,
        0.1495,
        0.148,
        ((1.2, 0.09, 0.002, 0.0016), (4.4, 0.12, 0.0016, 0.0013)),
    ),
    (
        "wick-mantel-right",
        HEARTH @ moved(0.36, MANTEL_TOP, BREAST_FRONT + 0.085) @ turned(2.1),
        short_stick,
        0.0555,
        0.082,
        ((0.4, 0.024, 0.0024, 0.0021), (2.7, 0.05, 0.0017, 0.0015), (5.0, 0.036, 0.002, 0.0018)),
    ),
    (
        "wick-window",
        WINDOW @ moved(-0.18, 0.013, -0.02) @ turned(1.1),
        saucer,
        0.0125,
        0.112,
        ((3.6, 0.06, 0.002, 0.0016),),
    ),
)


def build_sticks(place):
    mesh = Mesh()
    for name, placement, stick, seat, height, runs in STANDING:
        if place not in name:
            continue
        mesh.include(stick(), placement)
        mesh.include(candle(RADIUS, height, name, 14, runs), placement @ moved(0, seat, 0))
    return mesh


def build_mantel_candles():
    return build_sticks("mantel")


def build_window_candle():
    return build_sticks("window")


def wicks():
    """Name and place of each flame's foot."""
    return [
        (name, placement @ moved(0, seat, 0) @ flame_root(height))
        for name, placement, _, seat, height, _ in STANDING
    ]
