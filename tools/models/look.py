"""
Renders the models by candlelight with Cycles, to be judged before they are kept:

    python tools/models/look.py spawn table ... [--out FOLDER] [--samples N]
"""

import argparse
from math import atan2, hypot, pi, radians
from pathlib import Path

import bpy
from mathutils import Euler, Matrix, Vector

ROOT = Path(__file__).parents[2]
MODELS = ROOT / "public" / "models"
BLENDER_FROM_ROOM = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))

# Eye, what it looks at, vertical field of view in degrees, and the flame (None: in the hand).
VIEWS = {
    "spawn": ((-1.55, 1.6, 1.3), (-0.74, 1.42, 0.71), 50, None),
    "arrival": ((-1.55, 1.6, 1.3), (-0.3, 1.2, 0.25), 55, (0.28, 0.95, 0.0)),
    "table": ((-0.55, 1.5, 1.15), (0.55, 0.72, -0.1), 50, (0.28, 0.95, 0.0)),
    "stick": ((0.02, 1.02, 0.3), (0.28, 0.855, 0.0), 38, (0.28, 0.95, 0.0)),
    "candle": ((0.16, 1.02, 0.13), (0.28, 0.915, 0.0), 30, (0.28, 0.95, 0.0)),
    "cloth": ((-0.75, 1.25, 0.75), (-0.05, 0.66, 0.05), 40, (-0.3, 1.05, 0.55)),
    "pan": ((0.2, 1.08, 0.17), (0.28, 0.83, 0.0), 40, (0.28, 0.95, 0.0)),
    "reader": ((0.95, 1.2, 0.62), (0.68, 0.76, -0.05), 42, (0.28, 0.95, 0.0)),
    "hearth": ((-0.3, 1.3, 0.6), (-0.7, 0.8, -1.8), 55, (0.05, 1.1, -0.55)),
    "window": ((0.9, 1.5, -0.3), (2.4, 1.1, -0.5), 55, (1.5, 1.25, -0.1)),
    "shelf": ((0.8, 1.6, -0.6), (1.3, 1.45, -1.9), 50, (0.9, 1.5, -1.2)),
    "door": ((-0.3, 1.5, 0.2), (-1.2, 1.0, 2.0), 60, (-0.7, 1.2, 0.9)),
    "west": ((0.2, 1.5, 1.0), (-2.4, 1.1, -0.8), 60, (-1.2, 1.3, 0.1)),
    "corner": ((0.6, 1.5, -0.6), (2.4, 2.0, -1.9), 60, (1.3, 1.4, -1.1)),
    "rug": ((-0.4, 1.5, 0.7), (-0.72, 0, -0.6), 55, (0.1, 1.0, -0.3)),
    "top": ((0.2, 1.75, 0.55), (0.5, 0.745, -0.05), 60, (0.28, 0.95, 0.0)),
}


def light_candle(flame):
    """A column of small lamps: a flame is thin, and so equally intense from all sides."""
    count = 5
    for k in range(count):
        lamp = bpy.data.lights.new("flame", "POINT")
        lamp.energy = 4 * pi * 1.0 / count
        lamp.shadow_soft_size = 0.004
        # Candlelight as an adapted eye sees it: CIE illuminant A.
        lamp.color = (1, 0.448, 0.126)
        node = bpy.data.objects.new("flame", lamp)
        node.location = BLENDER_FROM_ROOM @ (Vector(flame) + Vector((0, 0.028 * (k / 4 - 0.5), 0)))
        bpy.context.scene.collection.objects.link(node)


def in_hand(eye, target):
    """0.55 m ahead, 0.25 to the right, 0.3 below the eye."""
    ahead = (Vector(target) - Vector(eye)) * Vector((1, 0, 1))
    ahead.normalize()
    right = Vector((-ahead.z, 0, ahead.x))
    return Vector(eye) + 0.55 * ahead + 0.25 * right + Vector((0, -0.3, 0))


def aim(eye, target, fov):
    camera = bpy.data.cameras.new("eye")
    node = bpy.data.objects.new("eye", camera)
    bpy.context.scene.collection.objects.link(node)
    way = BLENDER_FROM_ROOM @ Vector(target) - BLENDER_FROM_ROOM @ Vector(eye)
    node.location = BLENDER_FROM_ROOM @ Vector(eye)
    tilt = pi / 2 + atan2(way.z, hypot(way.x, way.y))
    node.rotation_euler = Euler((tilt, 0, atan2(-way.x, way.y)))
    camera.sensor_fit = "VERTICAL"
    camera.angle = radians(fov)
    camera.clip_start = 0.01
    bpy.context.scene.camera = node


def look(view, arguments):
    eye, target, fov, flame = VIEWS[view]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(MODELS / "cabin.glb"))
    flame = Vector(flame) if flame else in_hand(eye, target)
    bpy.ops.import_scene.gltf(filepath=str(MODELS / "chamberstick.glb"))
    anchor = next(o for o in bpy.context.selected_objects if o.name.startswith("flame"))
    offset = BLENDER_FROM_ROOM @ flame - anchor.matrix_world.translation
    for node in bpy.context.selected_objects:
        if node.parent is None:
            node.location += offset
    light_candle(flame + Vector((0, 0.012, 0)))
    aim(eye, target, fov)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = arguments.samples
    scene.cycles.seed = 1
    scene.cycles.use_denoising = True
    scene.cycles.max_bounces = 6
    scene.render.threads_mode = "FIXED"
    scene.render.threads = 2
    scene.render.resolution_x, scene.render.resolution_y = arguments.size
    scene.view_settings.view_transform = "AgX"
    scene.view_settings.exposure = arguments.exposure
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = f"{arguments.out}/{view}.png"
    bpy.ops.render.render(write_still=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("views", nargs="+", choices=sorted(VIEWS))
    parser.add_argument("--out", default=str(ROOT / "work" / "models"))
    parser.add_argument("--samples", type=int, default=24)
    parser.add_argument("--size", type=int, nargs=2, default=(640, 360))
    parser.add_argument("--exposure", type=float, default=3.0)
    arguments = parser.parse_args()
    for view in arguments.views:
        look(view, arguments)


if __name__ == "__main__":
    main()
