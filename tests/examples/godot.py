"""godot.py - runs examples/hosts/godot/ssgi_effect.gd in Python, with stand-ins for the classes of Godot. Checks that
its uniform block is the library's, and that its bindings, images and groups are those of the shaders. For hosts.sh,
from the repository's root, after make shared.
      python3 tests/examples/godot.py FOLDER    FOLDER: of build/glsl-text --chain hsao,normal=unsigned,compute=all"""
import ast, json, math, re, struct, sys
from types import SimpleNamespace
import cffi

WIDTH, HEIGHT, calls = 955, 537, []


class Made(SimpleNamespace):  # made by Godot, or by the effect, which sets members
    is_valid = lambda self: True
    add_id = lambda self, made: setattr(self, 'id', made)


class Expression:  # refuses arithmetic with a bool, as Godot does, and whole numbers divided by whole numbers
    def parse(self, text, names):
        tree = ast.parse(text, mode='eval')
        for node in ast.walk(tree):
            parts = [node.left, node.right] if isinstance(node, ast.BinOp) else []
            assert not any(isinstance(part, ast.Compare) for part in parts), text
            divides = parts and isinstance(node.op, ast.Div)
            assert not (divides and all(isinstance(part, ast.Constant) for part in parts)), text
        self.code, self.names = compile(tree, text, 'eval'), names

    def execute(self, inputs): return eval(self.code, dict(zip(self.names, inputs, strict=True)))


class Bytes(bytearray):
    def resize(self, size): self[:] = bytes(size)
    def encode_float(self, at, value): struct.pack_into('<f', self, at, value)
    def encode_s32(self, at, value): struct.pack_into('<i', self, at, value)


class Device:
    def shader_compile_spirv_from_source(self, of): return Made(text=of.source_compute, compile_error_compute='')
    def shader_create_from_spirv(self, spirv): return spirv
    def compute_pipeline_create(self, shader): return shader
    def uniform_buffer_create(self, size): return Made(size=size)
    def buffer_update(self, block, at, size, data): block.data = bytes(data)[:size]
    def compute_list_begin(self): calls.append(Made())
    def compute_list_bind_compute_pipeline(self, _, pipeline): calls[-1].text = pipeline.text
    def compute_list_bind_uniform_set(self, _, uniforms, number): calls[-1].uniforms = uniforms
    def compute_list_dispatch(self, _, *groups): calls[-1].groups = groups
    def compute_list_end(self): pass


# reversed depth, off-centre, oblique
columns = [[1.2, 0, 0, 0], [0, -2.1, 0, 0], [0.1, 0.05, 0.001, -1], [0, 0, 0.1, 0]]  # y down
buffers = Made(get_internal_size=lambda: Made(x=WIDTH, y=HEIGHT), get_view_count=lambda: 1,
               get_depth_layer=lambda view: 'depth', get_texture_slice=lambda *name: name[1],
               get_color_layer=lambda view: Made(format='DATA_FORMAT_R16G16B16A16_SFLOAT', width=WIDTH, height=HEIGHT),
               create_texture_from_format=lambda context, name, format, view, unique: format)
scene = Made(get_view_projection=lambda view: [Made(**dict(zip('xyzw', column))) for column in columns])
stages = {'TEXTURE_USAGE_SAMPLING_BIT': 1, 'TEXTURE_USAGE_STORAGE_BIT': 2, 'UNIFORM_TYPE_UNIFORM_BUFFER': 'uniform',
          'UNIFORM_TYPE_TEXTURE': 'texture', 'UNIFORM_TYPE_IMAGE': 'image'}
regex = Made(compile=lambda text: setattr(regex, 'text', text),
             sub=lambda text, by, every: re.sub(regex.text, by, text))
godot = dict(true=True, ceili=math.ceil, TYPE_ARRAY=list, typeof=type, PackedByteArray=Bytes, PackedStringArray=list,
             PackedFloat32Array=lambda values: struct.unpack('<f', struct.pack('<f', *values)),
             JSON=Made(parse_string=json.loads), FileAccess=Made(get_file_as_string=lambda path: open(path).read()),
             RegEx=Made(new=lambda: regex), Expression=Made(new=Expression), RenderingDevice=Made(**stages),
             RenderingServer=Made(get_rendering_device=Device), EFFECT_CALLBACK_TYPE_POST_OPAQUE=1,
             ClassDB=Made(class_get_integer_constant=lambda of, name: name),
             Vector2i=lambda x, y: Made(x=int(x), y=int(y)),
             UniformSetCacheRD=Made(get_cache=lambda shader, number, uniforms: uniforms),
             **{name: Made(new=Made) for name in ('RDShaderSource', 'RDTextureFormat', 'RDTextureView', 'RDUniform')})

text = open('examples/hosts/godot/ssgi_effect.gd').read()
members = ', '.join(re.findall(r'^var (\w+)', text, re.M))
for was, becomes in (('^(@tool|class_name .*|extends .*)$', ''), (r'(@export |\bvar |\bconst )', ''), (' := ', ' = '),
                     ('^func (.*)', 'def \\1\n\tglobal ' + members)):
    text = re.sub(was, becomes, text, flags=re.M)
exec('from __future__ import annotations\n' + text, godot)
godot['folder'] = sys.argv[1]
godot['_init']()
godot['_render_callback'](1, Made(get_render_scene_buffers=lambda: buffers, get_render_scene_data=lambda: scene))

# The uniform block, beside the library's.
c = cffi.FFI()
c.cdef(open('build/libssgi.h').read())
ssgi, view, frame = c.dlopen('build/libssgi.so'), c.new('ssgi_view *'), c.new('ssgi_gl_frame *')
flat = [number for column in columns for number in column]
for m in [*flat[:8], 0, 0, 0.01, 0, 0.1, 0.05, 1, 1], flat:    # orthographic, then as drawn
    assert not ssgi.ssgi_view_from_projection(view, m, ssgi.SSGI_CLIP_ZERO, WIDTH, HEIGHT, c.NULL)
    assert not ssgi.ssgi_gl_frame_init(frame, view, godot['radius'], c.NULL)
    block = godot['block_of'](m, Made(x=WIDTH, y=HEIGHT))
    for member in godot['manifest']['frame']['members']:
        form = f"<{member['bytes'] // 4}{'i' if member['type'][0] == 'i' else 'f'}"
        ours, theirs = (struct.unpack_from(form, of, member['offset']) for of in (c.buffer(frame), block))
        assert all(abs(a - b) <= 3e-7 * abs(a) for a, b in zip(ours, theirs)), (member, ours, theirs)
assert godot['block'].data == block

# Each dispatch, beside its shader and the library's step: a declaration for each uniform, and groups that cover what is
# written.
steps = c.new('ssgi_gl_step[3]')
assert ssgi.ssgi_gl_steps_of(steps, 3, frame, b'hsao,normal=unsigned', view, 1, c.NULL) == 3 and len(calls) == 4
for call, wanted in zip(calls, [*((step.width, step.height) for step in steps), (WIDTH, HEIGHT)]):
    declared = re.findall(r'^layout\((?:std140, )?set = 0, binding = (\d+)(?:, (\w+))?\) uniform (.*)', call.text, re.M)
    found = sorted((int(binding), next(k for k in ('image', 'texture', 'ssgi_frame') if k in rest))
                   for binding, layout, rest in declared)
    given = sorted((u.binding, {'uniform': 'ssgi_frame'}.get(u.uniform_type, u.uniform_type)) for u in call.uniforms)
    assert found == given, (found, given)
    image, = (u for u in call.uniforms if u.uniform_type == 'image')
    layout, = (layout for binding, layout, rest in declared if int(binding) == image.binding)
    bits = {'rgba32ui': 'R32G32B32A32_UINT', 'rg16f': 'R16G16_SFLOAT', 'r8': 'R8_UNORM',
            'rgba16f': 'R16G16B16A16_SFLOAT'}
    assert image.id.format == 'DATA_FORMAT_' + bits[layout], (image.id.format, layout)
    local = [int(n) for n in re.search(r'local_size_x = (\d+), local_size_y = (\d+)', call.text).groups()]
    size = image.id.width, image.id.height
    assert size == wanted, (size, wanted)
    assert call.groups == (*(-(-pixels // n) for pixels, n in zip(size, local)), 1), (call.groups, size, local)
open(sys.argv[1] + '/multiply.comp', 'w').write(calls[-1].text)
print(len(calls), 'dispatches')
