#!/usr/bin/python3
"""python.py - ambient occlusion without a window: moderngl on EGL, and the library of make shared.
      make shared && python3 examples/hosts/python.py [FILE.pgm]      (Debian: python3-moderngl python3-cffi libegl1)
Depth of boxes on a slab is drawn; between the lines of "====" ssgi computes ambient visibility from it. make shared
writes build/libssgi.so and build/libssgi.h, the declarations of both headers without a directive. cffi reads these, so
that structs, constants and functions have the names of ssgi_gl.h, and this program needs no compiler."""
import array, os, sys
import cffi, moderngl

WIDTH, HEIGHT, RADIUS = 960, 540, 1.0  # radius: the distance of the farthest occluders
LIBRARY = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'build', 'libssgi')


def boxes():
    """The corners of the boxes' triangles: x, y, z, x, .."""
    for i in range(25):
        size = (0.35 + 0.05 * (i * 3 % 8), 0.2 + 0.2 * (i * 7 % 5), 0.35 + 0.05 * (i * 5 % 7)) if i else (4.5, 0.1, 4.5)
        at = (1.5 * (i % 5 - 2), size[1], 1.5 * (i // 5 - 2)) if i else (0, -0.1, 0)
        for axis in range(3):
            for side in -1, 1:
                for u, v in (-1, -1), (1, -1), (-1, 1), (1, -1), (-1, 1), (1, 1):
                    p = (side, u, v)
                    yield from (at[k] + size[k] * p[(k - axis) % 3] for k in range(3))


gl = moderngl.create_standalone_context(require=330, backend='egl')
scene = gl.program(fragment_shader='#version 330\nvoid main() {}', vertex_shader='''#version 330
    uniform mat4 projection; in vec3 p;
    const mat3 view = mat3(1, 0, 0, 0, 0.8, 0.6, 0, -0.6, 0.8);
    void main() { gl_Position = projection * vec4(view * p - vec3(0, 0, 10), 1); }''')
f = 2.41421356  # vertical angle of 45 degrees, near and far planes at 0.1 and 100; column-major
projection = f * HEIGHT / WIDTH, 0, 0, 0, 0, f, 0, 0, 0, 0, -1.002002, -1, 0, 0, -0.2002002, 0
scene['projection'].value = projection
depth = gl.depth_texture((WIDTH, HEIGHT))
depth.filter, depth.compare_func = (gl.NEAREST, gl.NEAREST), ''  # moderngl's default compares depths
gl.framebuffer(depth_attachment=depth).use()
gl.clear(depth=1.0)
gl.enable_only(gl.DEPTH_TEST)
gl.vertex_array(scene, gl.buffer(array.array('f', boxes())), 'p').render()

# ==== ssgi ============================================================================================================
c = cffi.FFI()
try:
    with open(LIBRARY + '.h') as declarations: c.cdef(declarations.read())
    ssgi = c.dlopen(LIBRARY + '.so')
except OSError as error: sys.exit(f'python.py: make shared is missing: {error}')
why = c.new('const char **')


def right(result):
    if not result: sys.exit('python.py: ' + c.string(why[0]).decode())
    return result


def text(desc, stage):
    out = c.new('char[]', ssgi.ssgi_gl_emit(c.NULL, 0, desc, stage) + 1)
    ssgi.ssgi_gl_emit(out, len(out), desc, stage)
    return c.string(out).decode()


view, frame = c.new('ssgi_view *'), c.new('ssgi_gl_frame *')
right(ssgi.ssgi_view_from_projection(view, projection, ssgi.SSGI_CLIP_GL, WIDTH, HEIGHT, why) == ssgi.SSGI_OK)
method = frame, b'hsao,normal=from_depth', view, RADIUS, why
steps = c.new('ssgi_gl_step[]', right(ssgi.ssgi_gl_steps_of(c.NULL, 0, *method)))
ssgi.ssgi_gl_steps_of(steps, len(steps), *method)

yours, textures = {ssgi.SSGI_GL_YOUR_DEPTH: depth}, {}
gl.buffer(c.buffer(frame)).bind_to_uniform_block(0)
gl.enable_only(gl.NOTHING)
for step in steps:
    desc = c.addressof(step.desc)
    program = gl.program(vertex_shader=text(desc, ssgi.SSGI_GL_STAGE_VERTEX),
                         fragment_shader=text(desc, ssgi.SSGI_GL_STAGE_FRAGMENT))
    program['ssgi_frame'].binding = 0
    for to in step.output[0:step.outputs]:
        name = c.string(to.format.name).decode()  # RG16F: two of f2; RGBA32UI: four of u4; R8: one of f1
        bits = ''.join(filter(str.isdigit, name))
        kind = ('u' if name.endswith('UI') else 'f') + str(int(bits) // 8)
        textures[to.texture] = gl.texture((step.width, step.height), name.index(bits), dtype=kind)
        textures[to.texture].filter = gl.NEAREST, gl.NEAREST
    for of in step.input[0:step.inputs]:
        program[c.string(of.name).decode()].value = of.unit
        (yours[of.meaning] if of.texture < 0 else textures[of.texture]).use(of.unit)
    target = gl.framebuffer([textures[to.texture] for to in step.output[0:step.outputs]])
    target.use()  # its viewport is the whole target
    gl.vertex_array(program, []).render(step.primitive, vertices=step.vertices, instances=step.instances)
# ======================================================================================================================

path = sys.argv[1] if len(sys.argv) > 1 else 'ao.pgm'
rows = target.read(components=1)
try:
    with open(path, 'wb') as file:
        file.write(b'P5 %d %d 255\n' % (WIDTH, HEIGHT))
        for y in reversed(range(HEIGHT)): file.write(rows[y * WIDTH:(y + 1) * WIDTH])
except OSError as error: sys.exit(f'python.py: {error}')
