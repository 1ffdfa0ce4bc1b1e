"""A view by Cycles: linear Rec. 709 whose luma is luminance, cd/m², as half floats."""

import json
import math
import os
import struct
import sys
import tempfile

import bpy
import numpy
import OpenEXR
import bmesh  # comes with bpy
from mathutils import Matrix, Vector

ROOM_TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
SAMPLES = int(os.environ.get("SAMPLES", "512"))
# Spheres in the column that stands for the flame, which is optically thin: as bright from above as
# from the side. An opaque ellipsoid would be four times too dim from above.
LAMPS = 8
LUMA = (0.2126729, 0.7151522, 0.072175)
# Width of the moon, degrees.
MOON_WIDTH = 0.52
# The wood's luminance as a share of the sky's, its height as a slope, and what is seen through a pane.
WOOD = 0.06
TREES = -0.01
PANE = 0.86
SKY_ROWS = 4096
# Materials of its window.
PANES = {"pane", "night"}
# Wax within this distance of the middle of a flame, metres, lies open to it: the pool, and the dish around the pool.
DISH = 0.03
WAX = {"reference-pool", "reference-wax"}
# Name of its irradiance in a mesh.
IRRADIANCE = "irradiance"
# Share of light that wax mirrors at normal incidence.
SPECULAR = 0.04
# Pixels around candle and flame that are not compared: half of a filter's width, and a little.
MARGIN = 2
# Standard deviation of the blur over which denoised light is brought to the mean of the samples, pixels.
SPREAD = 30
# Luminance below which nothing is scaled to the mean of the samples by its own: black, cd/m².
LEAST = 1e-7
# From a surface to where a ray from it begins, metres.
NEAR = 1e-5


def divided(view, white):
    """The view with colours of its lights as multiples of a colour."""

    def shares(color):
        return [channel / part for channel, part in zip(color, white)]

    made = {**view, "lamp": {**view["lamp"], "intensity": shares(view["lamp"]["intensity"])}}
    if "moon" in view:
        made["moon"] = {**view["moon"], **{key: shares(view["moon"][key]) for key in ("color", "sky")}}
    return made


def white_of(view):
    """Colour of the light in a view: all flames' intensity, cd, and the moon's illuminance, lx, of luminance one.

    Flames have almost no blue in Rec. 709. A denoiser looks for edges in what is bright, and takes the rest for noise.
    """
    color = len(view["flames"]) * numpy.array(view["lamp"]["intensity"])
    if "moon" in view:
        color = color + view["moon"]["color"]
    return color / (color @ LUMA)


def start():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.threads_mode = "FIXED"
    scene.render.threads = 2
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.seed = 1
    scene.cycles.max_bounces = 64
    scene.cycles.diffuse_bounces = 64
    scene.cycles.glossy_bounces = 64
    scene.cycles.sample_clamp_direct = 0
    scene.cycles.sample_clamp_indirect = 0
    scene.cycles.blur_glossy = 0.5
    scene.cycles.caustics_reflective = True
    scene.cycles.use_denoising = True
    scene.cycles.denoiser = "OPENIMAGEDENOISE"
    scene.cycles.denoising_input_passes = "RGB_ALBEDO_NORMAL"
    scene.cycles.denoising_prefilter = "ACCURATE"
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    layer = bpy.context.view_layer
    layer.use_pass_object_index = True
    return scene


def load(path, place=Matrix()):
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path)
    added = [node for node in bpy.data.objects if node not in before]
    for node in added:
        node.matrix_world = place @ node.matrix_world
        for slot in getattr(node, "material_slots", ()):
            slot.material = material(path, slot.material.name.split(".")[0])
    return added


known = {}


def material(path, name):
    """Principled BSDF of a glTF material. The importer's own would not read AVIF, nor our occlusion."""
    if (path, name) in known:
        return known[path, name]
    with open(path, "rb") as file:
        (length,) = struct.unpack("<12xI", file.read(16))
        document = json.loads(file.read(4 + length)[4:])
    entry = next(m for m in document["materials"] if m["name"] == name)
    surface = entry.get("pbrMetallicRoughness", {})
    made = bpy.data.materials.new(f"reference-{name}")
    made.use_nodes = True
    nodes, link = made.node_tree.nodes, made.node_tree.links.new
    shader = nodes["Principled BSDF"]
    factor = surface.get("baseColorFactor", [1, 1, 1, 1])
    roughness, metallic = surface.get("roughnessFactor", 1), surface.get("metallicFactor", 1)

    def picture(use, is_color):
        texture = document["textures"][use["index"]]
        uri = document["images"][texture["source"]]["uri"]
        node = nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(os.path.join(os.path.dirname(path), uri), check_existing=True)
        node.image.colorspace_settings.name = "sRGB" if is_color else "Non-Color"
        return node.outputs["Color"]

    def times(value, number):
        node = nodes.new("ShaderNodeMath")
        node.operation = "MULTIPLY"
        link(value, node.inputs[0])
        node.inputs[1].default_value = number
        return node.outputs[0]

    shader.inputs["Base Color"].default_value = factor
    if "baseColorTexture" in surface:
        tint = nodes.new("ShaderNodeVectorMath")
        tint.operation = "MULTIPLY"
        link(picture(surface["baseColorTexture"], True), tint.inputs[0])
        tint.inputs[1].default_value = factor[:3]
        link(tint.outputs[0], shader.inputs["Base Color"])
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    if "metallicRoughnessTexture" in surface:
        parts = nodes.new("ShaderNodeSeparateColor")
        link(picture(surface["metallicRoughnessTexture"], False), parts.inputs[0])
        link(times(parts.outputs["Green"], roughness), shader.inputs["Roughness"])
        link(times(parts.outputs["Blue"], metallic), shader.inputs["Metallic"])
    if "normalTexture" in entry:
        relief = nodes.new("ShaderNodeNormalMap")
        relief.inputs["Strength"].default_value = entry["normalTexture"].get("scale", 1)
        link(picture(entry["normalTexture"], False), relief.inputs["Color"])
        link(relief.outputs["Normal"], shader.inputs["Normal"])
    known[path, name] = made
    return made


def add_moon(scene, moon):
    """A full moon, and the sky of its night. Directions in the room, lux and cd/m²."""
    light = bpy.data.lights.new("moon", "SUN")
    light.color = [channel / max(moon["color"]) for channel in moon["color"]]
    light.energy = max(moon["color"])
    light.angle = math.radians(MOON_WIDTH)
    node = bpy.data.objects.new("moon", light)
    way = ROOM_TO_BLENDER.to_3x3() @ Vector(moon["direction"])
    node.rotation_euler = way.to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(node)
    add_sky(scene, moon["sky"])


def add_sky(scene, color):
    """The night's sky over a wood, cd/m²: `nightShare` of shaders/lib/moon.glsl. What the camera sees, it sees through panes."""
    slopes = numpy.tan((numpy.arange(SKY_ROWS) + 0.5) / SKY_ROWS * math.pi - math.pi / 2)
    shares = numpy.where(slopes > TREES, 1 + 0.5 * numpy.exp(-4 * slopes.clip(0)), WOOD)
    image = bpy.data.images.new("sky", 2, SKY_ROWS, float_buffer=True, is_data=True)
    image.pixels = numpy.repeat([[*(share * channel for channel in color), 1] for share in shares], 2, axis=0).ravel()
    scene.world = bpy.data.worlds.new("night")
    scene.world.use_nodes = True
    nodes, link = scene.world.node_tree.nodes, scene.world.node_tree.links.new
    sky = nodes.new("ShaderNodeTexEnvironment")
    sky.image = image
    link(sky.outputs["Color"], nodes["Background"].inputs["Color"])
    strength = nodes.new("ShaderNodeMapRange")
    link(nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"], strength.inputs["Value"])
    strength.inputs["To Min"].default_value = 1
    strength.inputs["To Max"].default_value = PANE
    link(strength.outputs["Result"], nodes["Background"].inputs["Strength"])


def open_window(scene, nodes, window):
    """Takes out panes and the night behind them: faces of these materials within a box of the room, metres.

    Light comes in where the panes were: joints between frame and wall are closed, as the night behind them closed them.
    """
    low, high = window
    glass = []
    for node in nodes:
        if node.type != "MESH":
            continue
        names = [slot.material.name.split(".")[0].removeprefix("reference-") for slot in node.material_slots]
        if not PANES & set(names):
            continue
        mesh = bmesh.new()
        mesh.from_mesh(node.data)
        to_room = ROOM_TO_BLENDER.inverted() @ node.matrix_world
        gone = []
        for face in mesh.faces:
            corners = [to_room @ vertex.co for vertex in face.verts]
            is_inside = all(low[k] <= corner[k] <= high[k] for corner in corners for k in range(3))
            if names[face.material_index] in PANES and is_inside:
                gone.append(face)
                if names[face.material_index] == "pane":
                    glass.extend(corners)
        bmesh.ops.delete(mesh, geom=gone, context="FACES")
        mesh.to_mesh(node.data)
        mesh.free()
    add_surround(scene, glass)


def add_surround(scene, glass):
    """A black wall around an opening whose panes, corners of which these are, face along x."""
    at = sum(corner.x for corner in glass) / len(glass)
    edges = [[choose(corner[k] for corner in glass) for choose in (min, max)] for k in (1, 2)]
    points = [(at, y, z) for y in edges[0] for z in edges[1]]
    points += [(at, y + side, z + turn) for y, side in zip(edges[0], (-1, 1)) for z, turn in zip(edges[1], (-1, 1))]
    mesh = bpy.data.meshes.new("surround")
    mesh.from_pydata(points, [], [(0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)])
    black = bpy.data.materials.new("reference-surround")
    black.use_nodes = True
    black.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0, 0, 0, 1)
    black.node_tree.nodes["Principled BSDF"].inputs["Specular IOR Level"].default_value = 0
    mesh.materials.append(black)
    node = bpy.data.objects.new("surround", mesh)
    node.matrix_world = ROOM_TO_BLENDER
    scene.collection.objects.link(node)


def add_lamps(scene, position, lamp):
    peak = max(lamp["intensity"])
    for up in lamp_heights(lamp):
        light = bpy.data.lights.new("flame", "POINT")
        light.color = [channel / peak for channel in lamp["intensity"]]
        light.energy = 4 * math.pi * peak / LAMPS
        light.shadow_soft_size = lamp["radius"]
        light.use_soft_falloff = False
        node = bpy.data.objects.new("flame", light)
        node.visible_camera = False
        node.location = ROOM_TO_BLENDER @ Vector((position[0], position[1] + up, position[2]))
        scene.collection.objects.link(node)


def add_dishes(scene, flames, lamp):
    """Dishes of wax as lamps: paths seldom find one by chance, and a denoiser takes those that do for noise.

    A dish emits what it reflects of its flame, and no flame lights it.
    """
    unlit = bpy.data.collections.new("dishes")
    for node in [node for node in scene.objects if node.type == "MESH"]:
        for flame in flames:
            dish = cut_dish(node, ROOM_TO_BLENDER @ Vector(flame), lamp)
            if dish:
                scene.collection.objects.link(dish)
                unlit.objects.link(dish)
    for entry in unlit.collection_objects:
        entry.light_linking.link_state = "EXCLUDE"
    for node in scene.objects:
        if node.type == "LIGHT" and node.data.type == "POINT":
            node.light_linking.receiver_collection = unlit


def cut_dish(node, flame, lamp):
    """Takes the wax around a flame's foot out of a node: a node of its own, or None where there is none."""
    wax = {i for i, slot in enumerate(node.material_slots) if slot.material.name.split(".")[0] in WAX}

    def is_dish(face):
        return face.material_index in wax and (node.matrix_world @ face.calc_center_median() - flame).length < DISH

    dish = node.copy()
    dish.data = node.data.copy()
    keep_faces(dish.data, is_dish)
    if not dish.data.polygons:
        bpy.data.objects.remove(dish)
        return None
    lamps = [flame + Vector((0, 0, up)) for up in lamp_heights(lamp)]
    shares = [irradiance(node.matrix_world, face, lamps) for face in dish.data.polygons]
    dish.data.attributes.new(IRRADIANCE, "FLOAT", "FACE").data.foreach_set("value", shares)
    keep_faces(node.data, lambda face: not is_dish(face))
    for i in wax:
        dish.data.materials[i] = emitting(dish.data.materials[i], lamp)
    return dish


def keep_faces(data, chosen):
    mesh = bmesh.new()
    mesh.from_mesh(data)
    bmesh.ops.delete(mesh, geom=[face for face in mesh.faces if not chosen(face)], context="FACES")
    mesh.to_mesh(data)
    mesh.free()


def irradiance(to_world, face, lamps):
    """Of a face's middle, by lamps that share one candela: lux. Wick and lip hide some of them."""
    at, normal = to_world @ face.center, (to_world.to_3x3() @ face.normal).normalized()
    total = 0
    for lamp in lamps:
        way = lamp - at
        cosine = way.normalized().dot(normal)
        if cosine > 0 and not is_hidden(at + NEAR * normal, lamp):
            total += cosine / way.length_squared / LAMPS
    return total


def is_hidden(position, lamp):
    scene, way = bpy.context.scene, lamp - position
    return scene.ray_cast(bpy.context.evaluated_depsgraph_get(), position, way, distance=way.length)[0]


def emitting(surface, lamp):
    """The material, with an emission of what it reflects of a flame."""
    made = surface.copy()
    nodes, link = made.node_tree.nodes, made.node_tree.links.new

    def times(value, factors, added=(0, 0, 0)):
        node = nodes.new("ShaderNodeVectorMath")
        node.operation = "MULTIPLY_ADD"
        link(value, node.inputs[0])
        node.inputs[1].default_value, node.inputs[2].default_value = factors, added
        return node.outputs["Vector"]

    shader = nodes["Principled BSDF"]
    base = shader.inputs["Base Color"]
    if base.links:
        color = base.links[0].from_socket
    else:
        color = nodes.new("ShaderNodeRGB").outputs["Color"]
        color.default_value = base.default_value
    reflected = times(color, [1 - SPECULAR] * 3, [SPECULAR] * 3)
    link(times(reflected, [x / math.pi for x in lamp["intensity"]]), shader.inputs["Emission Color"])
    share = nodes.new("ShaderNodeAttribute")
    share.attribute_name = IRRADIANCE
    link(share.outputs["Fac"], shader.inputs["Emission Strength"])
    made.cycles.emission_sampling = "FRONT"
    return made


def lamp_heights(lamp):
    """Of a flame's lamps above its middle, metres."""
    return [((i + 0.5) / LAMPS * 2 - 1) * lamp["halfHeight"] for i in range(LAMPS)]


def add_camera(scene, view):
    camera = bpy.data.cameras.new("eye")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = math.radians(view["fieldOfView"])
    camera.clip_start = 0.01
    node = bpy.data.objects.new("eye", camera)
    eye = view["camera"]
    node.matrix_world = (
        ROOM_TO_BLENDER
        @ Matrix.Translation(eye["position"])
        @ Matrix.Rotation(eye["yaw"], 4, "Y")
        @ Matrix.Rotation(eye["pitch"], 4, "X")
    )
    scene.collection.objects.link(node)
    scene.camera = node
    scene.render.resolution_x, scene.render.resolution_y = view["width"], view["height"]
    return node


def render(scene):
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "MULTI_LAYER_IMAGE"
    settings.file_format = "OPEN_EXR_MULTILAYER"
    settings.color_depth = "32"
    settings.exr_codec = "NONE"
    settings.use_exr_interleave = True
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "view.exr")
        bpy.ops.render.render(write_still=True)
        with OpenEXR.File(scene.render.filepath, separate_channels=True) as file:
            return {name: channel.pixels for name, channel in file.channels().items()}


def colour(images, name, channels="RGB"):
    found = {key.rsplit(".", 2)[1] + "." + key[-1]: image for key, image in images.items()}
    return numpy.stack([found[f"{name}.{channel}"] for channel in channels], axis=-1)


def blurred(image):
    kernel = numpy.exp(-((numpy.arange(-3 * SPREAD, 3 * SPREAD + 1) / SPREAD) ** 2) / 2)
    for axis in (0, 1):
        rows = numpy.pad(image, [(3 * SPREAD, 3 * SPREAD) if axis == k else (0, 0) for k in (0, 1)])
        image = numpy.apply_along_axis(numpy.convolve, axis, rows, kernel, "valid")
    return image


def with_mean_of(samples, denoised, is_compared):
    """Denoised radiance, scaled to the mean of the samples: what a denoiser takes for noise is light, too.

    Each pixel counts by its ratio to the denoised one, so that a bright one does not light its neighbours.
    """
    is_lit = is_compared & (denoised @ LUMA > LEAST)
    ratio = numpy.where(is_lit, samples @ LUMA / numpy.maximum(denoised @ LUMA, LEAST), 0)
    means = blurred(ratio) / numpy.maximum(blurred(is_lit.astype(float)), 1e-3)
    return denoised * means[..., None]


def left_out(view, index):
    """Pixels of candles, holder and flames."""
    mask = index > 0.5
    for flame in view["flames"]:
        hide_flame(mask, view, flame)
    for _ in range(MARGIN):
        wider = mask.copy()
        wider[1:] |= mask[:-1]
        wider[:-1] |= mask[1:]
        wider[:, 1:] |= mask[:, :-1]
        wider[:, :-1] |= mask[:, 1:]
        mask = wider
    return mask


def hide_flame(mask, view, flame):
    """Marks the pixels of a box around a flame."""
    eye, lamp = view["camera"], view["lamp"]
    from_room = (
        Matrix.Rotation(-eye["pitch"], 4, "X")
        @ Matrix.Rotation(-eye["yaw"], 4, "Y")
        @ Matrix.Translation([-x for x in eye["position"]])
    )
    x, y, z = flame
    reach = lamp["reach"] * 1.3
    scale = view["height"] / 2 / math.tan(math.radians(view["fieldOfView"]) / 2)
    corners = []
    for i in range(8):
        up = lamp["base"] + lamp["height"] * (i & 1)
        corner = Vector((x + reach * ((i & 2) - 1), y + up, z + reach * ((i & 4) / 2 - 1)))
        seen = from_room @ corner
        if seen.z < -0.05:
            corners.append(
                (view["width"] / 2 + scale * seen.x / -seen.z, view["height"] / 2 - scale * seen.y / -seen.z)
            )
    if corners:
        columns, rows = zip(*corners)
        low = [max(0, int(min(values))) for values in (rows, columns)]
        high = [max(0, int(max(values)) + 1) for values in (rows, columns)]
        mask[low[0] : high[0], low[1] : high[1]] = True


def main(view_path, folder):
    with open(view_path) as file:
        given = json.load(file)
    white = white_of(given)
    view = divided(given, white)
    scene = start()
    models = os.path.dirname(view_path)
    room = load(os.path.join(models, view.get("room", "cabin") + ".glb"))
    # Wax that light enters is not compared.
    for node in room:
        node.pass_index = 1 if node.name.startswith("candles") else 0
    if "moon" in view:
        open_window(scene, room, view["moon"]["window"])
        add_moon(scene, view["moon"])
    x, y, z = view["candle"]["foot"]
    place = ROOM_TO_BLENDER @ Matrix.Translation((x, y, z)) @ Matrix.Rotation(view["candle"]["turn"], 4, "Y") @ ROOM_TO_BLENDER.inverted()
    for node in load(os.path.join(models, "chamberstick.glb"), place):
        node.pass_index = 1
    for flame in view["flames"]:
        add_lamps(scene, flame, view["lamp"])
    add_dishes(scene, view["flames"], view["lamp"])
    add_camera(scene, view)
    images = render(scene)
    radiance = colour(images, "Combined")
    if "REFERENCE_PASSES" in os.environ:
        numpy.savez(
            os.path.join(os.environ["REFERENCE_PASSES"], view["name"] + ".npz"),
            **{key.split(".", 1)[1]: image for key, image in images.items()},
        )
    index = next(image for key, image in images.items() if "Index" in key)
    is_left_out = left_out(view, index)
    radiance = with_mean_of(colour(images, "Noisy Image") * white, radiance * white, ~is_left_out)
    halves = radiance.clip(0, 65504).astype("<f2")
    # A negative sign of red marks what is not compared: candle, holder and flame.
    halves[..., 0] = numpy.copysign(halves[..., 0], numpy.where(is_left_out, -1, 1))
    halves.tofile(os.path.join(folder, view["name"] + ".bin"))
    with open(os.path.join(folder, view["name"] + ".json"), "w") as file:
        file.write(json.dumps(given, indent=2) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
