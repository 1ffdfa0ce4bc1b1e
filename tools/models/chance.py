"""Seeded chance: the same integers give the same room on every machine."""

from math import floor

MASK = 0xFFFFFFFF


def hashed(*keys):
    """32 bits that depend on every key (Wellons 2018, "Prospecting for Hash Functions")."""
    state = 0x9E3779B9
    for key in keys:
        if isinstance(key, str):
            key = int.from_bytes(key.encode(), "little") % 0xFFFFFFFB
        state = (state ^ (int(key) & MASK)) & MASK
        state = ((state ^ (state >> 16)) * 0x21F0AAAD) & MASK
        state = ((state ^ (state >> 15)) * 0xD35A2D97) & MASK
        state ^= state >> 15
    return state


class Chance:
    """A stream of random numbers, named by its keys."""

    def __init__(self, *keys):
        self.key = hashed(*keys)
        self.count = 0

    def fraction(self):
        """From 0 up to, not including, 1."""
        self.count += 1
        return hashed(self.key, self.count) / 2**32

    def between(self, low, high):
        return low + (high - low) * self.fraction()

    def index(self, count):
        return int(self.fraction() * count)


def wander(place, *keys):
    """Smooth noise along a line, about -1 to 1, with one bump to a unit of `place`."""
    first = floor(place)
    offset = place - first
    eased = offset * offset * (3 - 2 * offset)
    before = hashed(*keys, first) / 2**31 - 1
    after = hashed(*keys, first + 1) / 2**31 - 1
    return before + (after - before) * eased


def wander_over(x, y, *keys):
    """Smooth noise over a plane, about -1 to 1."""
    first = floor(y)
    offset = y - first
    eased = offset * offset * (3 - 2 * offset)
    before = wander(x, *keys, first)
    after = wander(x, *keys, first + 1)
    return before + (after - before) * eased
