"""What was left on the table: a reader's place, a drink behind it, a cloth at the other end."""

from math import pi

from book import open_book
from linen import hanging_cloth
from mesh import Mesh, moved, turned
from table import HEIGHT, LENGTH, PLACEMENT
from tableware import hand_bell, spectacles, standing_on, tankard, wine_bottle

TOP = HEIGHT + 0.0004


def on_table(thing, x, z, turn=0.0):
    return standing_on(thing, x, TOP, z, turn).placed(PLACEMENT)


def build_open_book():
    return on_table(open_book(), 0.33, 0.12, 0.2)


def build_spectacles():
    return on_table(spectacles(), 0.06, 0.2, 0.75)


def build_tankard():
    return on_table(tankard(), 0.42, -0.15, 2.4)


def build_wine_bottle():
    return on_table(wine_bottle(), 0.27, -0.25, 0.4)


def build_hand_bell():
    return on_table(hand_bell(), 0.0, -0.2)


def build_cloth():
    cloth = hanging_cloth(0.3, 0.27, 0.24)
    return Mesh().include(cloth, PLACEMENT @ moved(-LENGTH / 2, TOP, -0.02) @ turned(pi))
