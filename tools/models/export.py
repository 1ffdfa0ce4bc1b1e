"""Hands meshes to Blender's glTF exporter: node by node, with our normals and occlusion."""

import bpy
from mathutils import Matrix, Vector

# Blender's up is +Z.
BLENDER_FROM_ROOM = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def start():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.threads_mode = "FIXED"
    bpy.context.scene.render.threads = 2


def material_named(name):
    return bpy.data.materials.get(name) or bpy.data.materials.new(name)


def add_node(name, mesh, normals, shades=None):
    data = bpy.data.meshes.new(name)
    points = [BLENDER_FROM_ROOM @ point for point in mesh.points]
    data.from_pydata(points, [], [face.corners for face in mesh.faces])
    materials = mesh.materials()
    for material in materials:
        data.materials.append(material_named(material))
    data.polygons.foreach_set("material_index", [materials.index(f.material) for f in mesh.faces])
    data.polygons.foreach_set("use_smooth", [True] * len(mesh.faces))
    layer = data.uv_layers.new(name="UVMap")
    texcoords = [t for face in mesh.faces for t in face.texcoords]
    # Blender's V runs up the picture, and its exporter turns it over again.
    layer.data.foreach_set("uv", [number for u, v in texcoords for number in (u, 1 - v)])
    if shades:
        colors = data.color_attributes.new("occlusion", "FLOAT_COLOR", "CORNER")
        flat = [shade for face in shades for shade in face]
        colors.data.foreach_set("color", [n for s in flat for n in (s, s, s, 1.0)])
    data.normals_split_custom_set(
        [BLENDER_FROM_ROOM.to_3x3() @ Vector(normal) for own in normals for normal in own]
    )
    node = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(node)
    return node


def add_anchor(name, place, turn=0.0):
    """An empty node; `turn` is about +Y in the room."""
    node = bpy.data.objects.new(name, None)
    node.location = BLENDER_FROM_ROOM @ Vector(place)
    node.rotation_euler = (0, 0, turn)
    bpy.context.scene.collection.objects.link(node)


def write(path):
    bpy.ops.export_scene.gltf(
        filepath=str(path),
        export_format="GLB",
        export_yup=True,
        export_normals=True,
        export_texcoords=True,
        export_vertex_color="ACTIVE",
        export_materials="EXPORT",
        export_animations=False,
    )
