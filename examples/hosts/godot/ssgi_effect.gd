# ssgi_effect.gd - ambient occlusion as a CompositorEffect of Godot 4.3 or later, in the Forward+ renderer.
#
# NOT RUN IN GODOT: it is written from Godot's manual, class reference and source. tests/examples/godot.py translates it
# to Python and runs it with stand-ins for Godot's classes: the uniform block is the library's, bindings and groups the
# shaders'.
#
#     build/glsl-text --chain hsao,normal=unsigned,compute=all --vulkan PROJECT/ssgi
#
# Then add an SsgiEffect to the Compositor of a WorldEnvironment or a Camera3D. Leave MSAA off. An exported project must
# include *.comp and *.json. Everything about the steps is read from manifest.json, and so is the arithmetic of the
# uniform block. Sky and transparent things are drawn later; direct light is dimmed, too, because the picture has it.
@tool
class_name SsgiEffect
extends CompositorEffect

const MULTIPLY := """#version 450
#extension GL_EXT_samplerless_texture_functions : require
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba16f) uniform image2D picture;
layout(set = 0, binding = 1) uniform texture2D visibility;
void main() {
	ivec2 at = ivec2(gl_GlobalInvocationID.xy);
	if (any(greaterThanEqual(at, imageSize(picture)))) return;
	vec4 color = imageLoad(picture, at);
	imageStore(picture, at, vec4(color.rgb * texelFetch(visibility, at, 0).x, color.a));
}
"""
const SCALES := {"FULL": 1, "HALF": 2, "QUARTER": 4, "TILES": 8}

@export var folder := "res://ssgi"
@export var radius := 0.5 # the distance of the farthest occluders, in metres

var rd: RenderingDevice
var manifest := {}
var chain := {}
var shaders := [] # of each step, then MULTIPLY's
var pipelines := []
var block: RID # the uniform block
var block_binding := 0
var names := [] # the variables of the manifest's formulas
var parsed := {} # Expressions by formula
var bracket := RegEx.new()


func _init() -> void:
	effect_callback_type = EFFECT_CALLBACK_TYPE_POST_OPAQUE
	needs_normal_roughness = true
	rd = RenderingServer.get_rendering_device()


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and rd:
		for id in shaders + [block]: # a pipeline is freed with its shader
			if id.is_valid():
				rd.free_rid(id)


func add_shader(text: String) -> void:
	var source := RDShaderSource.new()
	source.source_compute = text
	var spirv := rd.shader_compile_spirv_from_source(source)
	if spirv.compile_error_compute != "":
		push_error(spirv.compile_error_compute)
	shaders += [rd.shader_create_from_spirv(spirv)]
	pipelines += [rd.compute_pipeline_create(shaders[-1])]


func load_chain() -> void:
	manifest = JSON.parse_string(FileAccess.get_file_as_string(folder + "/manifest.json"))
	chain = manifest["chains"][0]
	for step in chain["steps"]:
		add_shader(FileAccess.get_file_as_string(folder + "/" + step["files"]["comp"]))
	add_shader(MULTIPLY)
	names = ["m", "width", "height", "zero", "down"]
	for value in manifest["values"]:
		names += [value["name"]]
	for row in manifest["rows"]:
		if row["kind"] == "PARAM":
			block_binding = int(row["binding"])
	bracket.compile("(?<![a-z])\\(")
	block = rd.uniform_buffer_create(int(manifest["frame"]["size"]))


# Computes a formula. In Godot a comparison is a bool, with which nothing can be multiplied, and comparisons stand in
# brackets: each bracket that is not a function's becomes float(..).
func number(formula: String, inputs: Array) -> float:
	if formula not in parsed:
		parsed[formula] = Expression.new()
		parsed[formula].parse(bracket.sub(formula, "float(", true), PackedStringArray(names))
	return float(parsed[formula].execute(inputs))


# Returns the bytes of the uniform block. m: the 16 floats of Godot's projection, which is Vulkan's own: y points down.
func block_of(m: Array, size: Vector2i) -> PackedByteArray:
	var inputs := [m, float(size.x), float(size.y), 1.0, 0.0]
	for value in manifest["values"]:
		inputs += [0.0]
	for i in range(5, len(names)):
		var value = manifest["values"][i - 5]
		inputs[i] = number(value["perspective" if m[11] != 0.0 else "orthographic"], inputs)
		if value["rounded"]:
			inputs[i] = PackedFloat32Array([inputs[i]])[0]
	var bytes := PackedByteArray()
	bytes.resize(int(manifest["frame"]["size"]))
	for member in manifest["frame"]["members"]:
		var given = member["default"]
		if "formula" in member:
			given = member["formula"]
		elif typeof(given) != TYPE_ARRAY:
			given = [given]
		for k in range(len(given)):
			var value: float = number(given[k], inputs) if "formula" in member else given[k]
			if "times" in member:
				value *= radius
			if member["type"][0] == "i":
				bytes.encode_s32(int(member["offset"]) + 4 * k, int(value))
			else:
				bytes.encode_float(int(member["offset"]) + 4 * k, value)
	return bytes


func scaled(size: Vector2i, divisor: int) -> Vector2i:
	return Vector2i(ceili(float(size.x) / divisor), ceili(float(size.y) / divisor))


# Returns a texture of the chain. Godot frees it when the size changes.
func texture_of(buffers: RenderSceneBuffersRD, k: int, view: int) -> RID:
	var texture = chain["textures"][k]
	var format := RDTextureFormat.new()
	var name: String = manifest["formats"][int(texture["format"])]["vulkan"]
	format.format = ClassDB.class_get_integer_constant("RenderingDevice", name.replace("VK_", "DATA_"))
	var size := scaled(buffers.get_internal_size(), SCALES[texture["scale"]])
	format.width = size.x
	format.height = size.y
	format.usage_bits = RenderingDevice.TEXTURE_USAGE_SAMPLING_BIT | RenderingDevice.TEXTURE_USAGE_STORAGE_BIT
	return buffers.create_texture_from_format("ssgi", str(k) + " of view " + str(view), format, RDTextureView.new(), true)


func uniform(type: int, binding: int, id: RID) -> RDUniform:
	var made := RDUniform.new()
	made.uniform_type = type
	made.binding = binding
	made.add_id(id)
	return made


func dispatch(i: int, uniforms: Array[RDUniform], groups: Vector2i) -> void:
	var list := rd.compute_list_begin()
	rd.compute_list_bind_compute_pipeline(list, pipelines[i])
	rd.compute_list_bind_uniform_set(list, UniformSetCacheRD.get_cache(shaders[i], 0, uniforms), 0)
	rd.compute_list_dispatch(list, groups.x, groups.y, 1)
	rd.compute_list_end() # Godot waits for this list's images before the next list reads them


func _render_callback(_type: int, data: RenderData) -> void:
	var buffers: RenderSceneBuffersRD = data.get_render_scene_buffers()
	if not rd or not buffers or buffers.get_internal_size().x == 0:
		return
	if not pipelines:
		load_chain()
	var size := buffers.get_internal_size()
	for view in range(buffers.get_view_count()):
		var projection := data.get_render_scene_data().get_view_projection(view)
		var m := []
		for k in range(4):
			m += [projection[k].x, projection[k].y, projection[k].z, projection[k].w]
		rd.buffer_update(block, 0, int(manifest["frame"]["size"]), block_of(m, size))
		var yours := {
			"DEPTH": buffers.get_depth_layer(view),
			"NORMAL": buffers.get_texture_slice("forward_clustered", "normal_roughness", view, 0, 1, 1),
		}
		for i in range(len(chain["steps"])):
			var step = chain["steps"][i]
			var uniforms: Array[RDUniform] = []
			uniforms.append(uniform(RenderingDevice.UNIFORM_TYPE_UNIFORM_BUFFER, block_binding, block))
			for input in step["inputs"]:
				var id: RID = yours[input["yours"]] if "yours" in input else texture_of(buffers, int(input["texture"]), view)
				uniforms.append(uniform(RenderingDevice.UNIFORM_TYPE_TEXTURE, int(input["binding"]), id))
			for output in step["outputs"]:
				var id: RID = texture_of(buffers, int(output["texture"]), view)
				uniforms.append(uniform(RenderingDevice.UNIFORM_TYPE_IMAGE, int(output["binding"]), id))
			var target := scaled(size, SCALES[step["scale"]])
			dispatch(i, uniforms, Vector2i(ceili(target.x / step["group"][0]), ceili(target.y / step["group"][1])))
		for k in range(len(chain["textures"])):
			if chain["textures"][k]["result"] == "LIGHT":
				dispatch(len(chain["steps"]), [
					uniform(RenderingDevice.UNIFORM_TYPE_IMAGE, 0, buffers.get_color_layer(view)),
					uniform(RenderingDevice.UNIFORM_TYPE_TEXTURE, 1, texture_of(buffers, k, view)),
				], scaled(size, 8))
