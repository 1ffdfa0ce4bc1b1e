"""
The built-in room. Run with Python 3.11 and requirements.txt:

    python tools/models/cabin.py && node tools/models/cabin.mjs
"""

import sys
from pathlib import Path

import bpy  # noqa: F401  mathutils comes with it

sys.path.insert(0, str(Path(__file__).parent))

import candlesticks
import chair
import chest
import coat
import door
import firewood
import floor_and_ceiling as boards
import furnishings
import hearth
import shelf
import table
import table_setting as setting
import walls
import window
from export import add_anchor, add_node, start, write
from mesh import Mesh
from occlusion import bake, tree_of
from room import SPAWN, SPAWN_TURN
from soundness import (
    SUNK,
    TOUCH,
    assert_finite,
    closed_part,
    depth_inside,
    gap,
    inside_out,
    inside_out_shells,
)

# Each thing, the node it belongs to, and what it stands on, leans on or hangs from.
THINGS = (
    ("walls", "walls", walls.build_walls, ()),
    ("floor", "floor", boards.build_floor, ()),
    ("ceiling", "ceiling", boards.build_ceiling, ()),
    ("dark", "night", boards.build_dark, ()),
    ("night at the window", "night", window.build_night, ()),
    ("night at the door", "night", door.build_night, ()),
    ("hearth", "hearth", hearth.build_hearth, ("walls", "floor")),
    ("firewood", "firewood", firewood.build_firewood, ("floor",)),
    ("table", "table", table.build_table, ("floor",)),
    ("chair", "chair", chair.build_chair, ("floor",)),
    ("shelf", "shelf", shelf.build_shelf, ("walls",)),
    ("shelf books", "shelf", shelf.build_shelf_books, ("shelf",)),
    ("shelf ware", "shelf", shelf.build_shelf_ware, ("shelf",)),
    ("mantel ware", "shelf", shelf.build_mantel_ware, ("hearth",)),
    ("mantel candles", "candles", candlesticks.build_mantel_candles, ("hearth",)),
    ("window", "window", window.build_window, ("walls",)),
    ("window candle", "candles", candlesticks.build_window_candle, ("window",)),
    ("curtain rod", "window", window.build_curtain_rod, ("walls",)),
    ("curtain", "window", window.build_curtain, ("curtain rod",)),
    ("door", "door", door.build_door, ("walls", "floor")),
    ("door irons", "door", door.build_door_irons, ("door",)),
    ("chest", "chest", chest.build_chest, ("floor",)),
    ("chest irons", "chest", chest.build_chest_irons, ("chest",)),
    ("blanket", "chest", chest.build_blanket, ("chest",)),
    ("rug", "rug", furnishings.build_rug, ("floor",)),
    ("stool", "seats", furnishings.build_stool, ("floor",)),
    ("bench", "seats", furnishings.build_bench, ("floor",)),
    ("peg rail", "fittings", coat.build_peg_rail, ("walls",)),
    ("coat", "fittings", coat.build_coat, ("peg rail",)),
    ("hat", "fittings", coat.build_hat, ("peg rail",)),
    ("mirror", "fittings", furnishings.build_mirror, ("walls",)),
    ("book", "table", setting.build_open_book, ("table",)),
    ("spectacles", "table", setting.build_spectacles, ("table",)),
    ("tankard", "table", setting.build_tankard, ("table",)),
    ("wine bottle", "table", setting.build_wine_bottle, ("table",)),
    ("bell", "table", setting.build_hand_bell, ("table",)),
    ("cloth", "table", setting.build_cloth, ("table",)),
)

# A draw call costs more than a name: small things of one material share a node, wherever they are.
SHARED = {
    "brass": "brass",
    "cloth-blue": "bindings",
    "cloth-red": "bindings",
    "glass": "glass",
    "iron": "ironwork",
    "leather": "bindings",
    "linen": "linen",
    "pane": "pane",
    "paper": "paper",
    "pewter": "pewter",
    "broadcloth": "woollens",
    "wool": "woollens",
}

# Things that are built into others, and those let into one another on purpose.
FIXTURES = {"walls", "floor", "ceiling", "dark", "hearth", "window", "door", "peg rail"}
JOINED = {("door irons", "door"), ("chest irons", "chest"), ("curtain rod", "window")}
JOINED |= {("hat", "peg rail"), ("coat", "peg rail")}

EYES = ((-1.55, 1.6, 1.3), (1.6, 1.2, -1.4), (-0.3, 0.5, 0.9), (1.9, 2.1, 1.6), (-2.1, 0.9, -0.4))


def build_things():
    things = {}
    for name, _, build, _ in THINGS:
        things[name] = build().triangulated()
        assert_finite(name, things[name])
    return things


def check(things):
    """Everything wrong with the room, a line each."""
    faults = []
    for name, mesh in things.items():
        faults += [f"{name} is inside out: {fault}" for fault in inside_out_shells(mesh)]
    backs, escaped = inside_out(things, EYES)
    faults += [f"the back of {name} is seen {count} times" for name, count in sorted(backs.items())]
    faults += [f"a ray leaves the room: {ray}" for ray in escaped]
    for name, _, _, supports in THINGS:
        for support in supports:
            distance = gap(things[name], things[support])
            if distance > TOUCH:
                faults.append(f"{name} floats {1000 * distance:.1f} mm off {support}")
    solids = {name: closed_part(mesh) for name, mesh in things.items()}
    for name in things:
        for other, solid in solids.items():
            if name == other or name in FIXTURES or (name, other) in JOINED:
                continue
            depth, where = depth_inside(things[name], solid)
            if depth > SUNK:
                faults.append(f"{name} sinks {1000 * depth:.1f} mm into {other} at {tuple(where)}")
    return faults


def nodes_of(things):
    nodes = {}
    for name, node, _, _ in THINGS:
        mesh = things[name]
        for material in mesh.materials():
            home = SHARED.get(material, node)
            nodes.setdefault(home, Mesh()).include(mesh.of_material(material))
    return nodes


def main():
    output = Path(__file__).parents[2] / "work" / "models"
    output.mkdir(parents=True, exist_ok=True)
    things = build_things()
    faults = check(things)
    start()
    tree = tree_of(things.values())
    for name, mesh in nodes_of(things).items():
        normals = mesh.corner_normals()
        add_node(name, mesh, normals, bake(mesh, normals, tree))
        print(f"{name}: {len(mesh.faces)} triangles, {', '.join(mesh.materials())}")
    add_anchor("spawn", SPAWN, SPAWN_TURN)
    for name, place in candlesticks.wicks():
        add_anchor(name, place)
    write(output / "cabin.glb")
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
