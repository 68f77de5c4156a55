#!/usr/bin/env python3
"""Makes a frame for build/render --gbuffer, with its camera, of a captured depth buffer and its projection.

  capture.py DEPTH.png|DEPTH.exr FRAME.exr --projection=M0,M1,..,M15 [--gl]
  capture.py DEPTH.png|DEPTH.exr FRAME.exr --fovy=DEGREES --near=N [--far=F] [--reversed]
  build/render --gbuffer FRAME.exr --radius 0.5 --out ao.png

Depth is what the buffer holds, in [0,1], the picture's top row first; cleared is nothing. The 16 numbers lie as in
memory: the 12th is -1 or 1; or it is 0, and the 16th 1 (orthographic). --gl: clip space as OpenGL has it, -1 to 1.
Without --far it is infinite. --radius=R is kept in the frame; --channel=NAME: of an EXR. Python alone is needed."""
import argparse, math, struct, sys, zlib
sys.dont_write_bytecode = True
import pictures

def projection_of(a, aspect):
    """By 1/depth, which is linear in what the buffer holds."""
    first, last = (1 / a.far, 1 / a.near) if a.reversed else (1 / a.near, 1 / a.far)
    y, scale = 1 / math.tan(math.radians(a.fovy) / 2), 1 / (last - first)
    return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, first * scale, -1, 0, 0, scale, 0]

def view_depth(m, clip):
    below = clip * m[11] - m[10]
    along = (m[14] - clip * m[15]) / below if below else math.inf
    depth = along * m[11] if m[11] else abs(along)
    return depth if 0 < depth < 1e30 else 0                         # 0: nothing, or infinitely far

def write_frame(path, wide, high, depths, m, gl, radius):
    """The camera is at the origin of a right-handed world and looks down -z."""
    clip_of = lambda depth: 2 * depth - 1 if gl else depth
    ends = [view_depth(m, clip_of(depth)) or math.inf for depth in (0, 1)]
    cleared = ends.index(max(ends))
    z = [0 if depth == cleared else view_depth(m, clip_of(depth)) for depth in depths]
    if not any(z): raise ValueError('shows nothing by this projection')
    width, height = 2 / abs(m[0]), 2 / abs(m[5])
    centre = [-(m[8 + i] * m[11] if m[11] else m[12 + i]) / m[5 * i] for i in (0, 1)]
    more = [('ssgi.orthoHeight', 'float', 'f', height)] if not m[11] else []
    if radius: more.append(('ssgi.radius', 'float', 'f', radius))
    pictures.write_exr(path, wide, high, z, ('pixelAspectRatio', 'float', 'f', width / wide * high / height),
                       ('screenWindowCenter', 'v2f', '2f', *centre), ('screenWindowWidth', 'float', 'f', width),
                       ('worldToCamera', 'm44f', '16f', 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1), *more)

ask = argparse.ArgumentParser(None, argparse.SUPPRESS, __doc__, formatter_class=argparse.RawTextHelpFormatter)
ask.add_argument('--projection', type=lambda text: [float(number) for number in text.replace(',', ' ').split()])
for name in ('fovy', 'near', 'far', 'radius'):
    ask.add_argument('--' + name, type=float, default=math.inf if name == 'far' else 0)
for name in ('gl', 'reversed'): ask.add_argument('--' + name, action='store_true')
for name in ('--channel', 'depth', 'frame'): ask.add_argument(name)
a = ask.parse_args()
try:
    with open(a.depth, 'rb') as file: data = file.read()
    wide, high, depths = pictures.png(data) if data[:4] == b'\x89PNG' else pictures.exr(data, a.channel)
    if not a.projection and not (0 < a.fovy < 180 and 0 < a.near < a.far):
        ask.error('needs --projection, or --fovy below 180 and --near below --far')
    m = a.projection or projection_of(a, wide / high)
    if len(m) != 16 or not ((abs(m[11]) == 1 and not m[15]) or (not m[11] and m[15] == 1)) or not m[0] * m[5]:
        ask.error('--projection: must be 16 numbers, the 12th -1 or 1, or 0 with 1 for the 16th')
    write_frame(a.frame, wide, high, depths, m, a.gl and a.projection, a.radius)
except OSError as why: ask.error(str(why))
except ValueError as why: ask.error(f'{a.depth}: {why}')
except (ArithmeticError, LookupError, struct.error, zlib.error): ask.error(f'{a.depth}: is damaged, or the camera is')
