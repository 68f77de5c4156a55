"""blender.py - saves a frame of Blender for build/render, and Cycles' own ambient occlusion of it. Debian: blender.

  blender --background --factory-startup --python-exit-code 1 --python examples/hosts/blender.py -- MESH.obj FOLDER
  build/render --gbuffer FOLDER/frame.exr --camera 0,6,8,0,0,0 --fovy 45 --radius 1 --set falloff=none --out ao.png

FOLDER/frame.exr is a multilayer EXR with the passes that build/render reads: Depth, Normal (in world space) and
DiffCol. FOLDER/ao0001.exr is Cycles' AO pass: SAMPLES rays within DISTANCE, all with full weight, as by falloff=none.
The mesh keeps its y up, so the camera is that of the other hosts. For your own scene, in which z is up, add --up 0,0,1.
--fovy is the vertical angle; camera.data.angle is by default that of the longer side."""
import os, sys
import bpy
from mathutils import Matrix, Vector

SAMPLES, DISTANCE = 64, 1.0
mesh, folder = sys.argv[sys.argv.index('--') + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
if hasattr(bpy.ops.wm, 'obj_import'): bpy.ops.wm.obj_import(filepath=mesh, forward_axis='Y', up_axis='Z')
else: bpy.ops.import_scene.obj(filepath=mesh, axis_forward='Y', axis_up='Z')
scene = bpy.context.scene
camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
scene.collection.objects.link(camera)
scene.camera = camera
eye, up = Vector((0, 6, 8)), Vector((0, 1, 0))
back = eye.normalized()
right = up.cross(back).normalized()
camera.matrix_world = Matrix((right, back.cross(right), back)).transposed().to_4x4()
camera.matrix_world.translation = eye
camera.data.sensor_fit, camera.data.angle = 'VERTICAL', 0.25 * 3.141592653589793
camera.data.clip_start, camera.data.clip_end = 0.1, 100
scene.world = bpy.data.worlds.new('world')
scene.world.light_settings.distance = DISTANCE
scene.render.engine = 'CYCLES'
scene.cycles.samples, scene.cycles.use_denoising = SAMPLES, False
scene.cycles.pixel_filter_type = 'BOX'                                      # as with one sample a pixel, at its centre
scene.cycles.filter_width = 0.01
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 960, 540, 100
layer = scene.view_layers[0]
layer.use_pass_z = layer.use_pass_normal = layer.use_pass_diffuse_color = layer.use_pass_ambient_occlusion = True
scene.use_nodes = True
nodes = scene.node_tree.nodes
file = nodes.new('CompositorNodeOutputFile')
file.base_path, file.file_slots[0].path = os.path.abspath(folder), 'ao'
file.format.file_format, file.format.color_depth, file.format.color_mode = 'OPEN_EXR', '32', 'RGB'
scene.node_tree.links.new(nodes['Render Layers'].outputs['AO'], file.inputs[0])
scene.render.image_settings.file_format = 'OPEN_EXR_MULTILAYER'
scene.render.image_settings.color_depth = '32'
scene.render.filepath = os.path.join(os.path.abspath(folder), 'frame.exr')
bpy.ops.render.render(write_still=True)
