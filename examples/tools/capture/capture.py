#!/usr/bin/env python3
"""Makes a frame for build/render --gbuffer from a captured depth buffer and its projection.

  capture.py DEPTH FRAME.exr --projection=M0,M1,..,M15 [--gl]
  capture.py DEPTH FRAME.exr --fovy=DEGREES --near=N [--far=F] [--reversed]
  capture.py DEPTH FRAME.exr --linear --fovy=DEGREES
  build/render --gbuffer FRAME.exr --radius 0.5 --out ao.png

DEPTH is a PNG, an EXR or, with --size=WxH, a file of raw floats. It has the buffer's values, in [0,1], with the
picture's top row first (--bottom-up: last, as from glReadPixels). The clear value is background. --linear: the values
are view depths; values of 0 or less, or from 1e9 on, are background. The 16 numbers are in the order of memory: the
12th is -1 or 1, or, for an orthographic camera, 0 with a 16th of 1. --gl: clip space as in OpenGL, -1 to 1. Without
--far the far plane is at infinity. --radius=R is stored in the frame; --channel=NAME selects a channel of an EXR.

--normals=FILE: an RGB PNG of n/2 + 1/2, an EXR (X Y Z or R G B), or raw floats, three a pixel; in view space, y is up
and z points to the eye. --view=M0,M1,..,M15 (world to view, in the order of memory) places the camera; with --world
normals are in world space and are rotated by it. Only Python is needed."""
import argparse, math, struct, sys, zlib
sys.dont_write_bytecode = True
import pictures

def projection_of(a, aspect):
    """Uses 1/depth, which is linear in window depth."""
    y = 1 / math.tan(math.radians(a.fovy) / 2)
    if a.linear: return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0]
    first, last = (1 / a.far, 1 / a.near) if a.reversed else (1 / a.near, 1 / a.far)
    scale = 1 / (last - first)
    return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, first * scale, -1, 0, 0, scale, 0]

def view_depth(m, clip):
    below = clip * m[11] - m[10]
    depth = m[11] * (m[14] - clip * m[15]) / below if below and m[11] else math.inf
    return depth if 0 < depth < 1e30 else 0                         # 0: background or infinitely far

def depths_of(values, m, a):
    """View depths, and the amount by which they exceed those in view space. An orthographic camera's depths begin at
    the near
        plane if the eye is behind it or far away, because a frame's depths must be above 0 and fit floats."""
    if a.linear: return [depth if 0 < depth < 1e9 else 0 for depth in values], 0
    clip_of = lambda depth: 2 * depth - 1 if a.gl and a.projection else depth
    if m[11]:
        ends = [view_depth(m, clip_of(depth)) or math.inf for depth in (0, 1)]
        cleared = ends.index(max(ends))
        return [0 if depth == cleared else view_depth(m, clip_of(depth)) for depth in values], 0
    ends = [(m[14] - clip_of(depth)) / m[10] for depth in (0, 1)]
    if max(ends) <= 0: ends = [-depth for depth in ends]            # a left-handed projection
    near, deep, cleared = min(ends), max(ends) - min(ends), ends.index(max(ends))
    more = 0 if 0 < near <= deep else 1e-3 * deep - near
    along = lambda depth: ends[0] + depth * (ends[1] - ends[0]) + more
    return [0 if depth == cleared or not 0 <= depth <= 1 else along(depth) for depth in values], more

def turned(normals, view):
    """World-space normals, as three channels, to view space."""
    x, y, z = normals
    return [[view[k] * a + view[4 + k] * b + view[8 + k] * c for a, b, c in zip(x, y, z)] for k in range(3)]

def write_frame(path, wide, high, z, normals, m, view, radius):
    """Writes the frame. Without a view the camera is at the origin of a right-handed world and looks down -z. The
    file's
        camera looks down +z, so its z is negated."""
    if not any(z): raise ValueError('shows nothing by this projection')
    width, height = 2 / abs(m[0]), 2 / abs(m[5])
    centre = [-(m[8 + i] * m[11] if m[11] else m[12 + i]) / m[5 * i] for i in (0, 1)]
    more = [('ssgi.orthoHeight', 'float', 'f', height)] if not m[11] else []
    if radius: more.append(('ssgi.radius', 'float', 'f', radius))
    rows = [number * (-1 if i % 4 == 2 else 1) for i, number in enumerate(view)]
    channels = dict(zip(('N.X', 'N.Y', 'N.Z'), normals or ())) | {'Z': z}
    pictures.write_exr(path, wide, high, channels, ('pixelAspectRatio', 'float', 'f', width / wide * high / height),
                       ('screenWindowCenter', 'v2f', '2f', *centre), ('screenWindowWidth', 'float', 'f', width),
                       ('worldToCamera', 'm44f', '16f', *rows), *more)

def numbers(text): return [float(number) for number in text.replace(',', ' ').split()]

def read(path, a, channels):
    """Reads width, height and each channel's values, the top row first; a single channel of an EXR is a.channel."""
    with open(path, 'rb') as file: data = file.read()
    if a.size: wide, high, found = pictures.raw(data, *a.size, channels)
    elif data[:4] == b'\x89PNG': wide, high, found = pictures.png(data, channels)
    else: wide, high, found = pictures.exr(data, channels, a.channel)
    if a.bottom_up: found = [[v for y in reversed(range(high)) for v in c[y * wide:(y + 1) * wide]] for c in found]
    return wide, high, found

ask = argparse.ArgumentParser(None, argparse.SUPPRESS, __doc__, formatter_class=argparse.RawTextHelpFormatter)
for name in ('projection', 'view'): ask.add_argument('--' + name, type=numbers)
for name in ('fovy', 'near', 'far', 'radius'):
    ask.add_argument('--' + name, type=float, default=math.inf if name == 'far' else 0)
for name in ('gl', 'reversed', 'linear', 'bottom-up', 'world'): ask.add_argument('--' + name, action='store_true')
ask.add_argument('--size', type=lambda text: [int(number) for number in text.split('x')])
for name in ('--channel', '--normals', 'depth', 'frame'): ask.add_argument(name)
a = ask.parse_args()
path = a.depth
try:
    if a.size and (len(a.size) != 2 or min(a.size) < 1): ask.error('--size: must be WIDTHxHEIGHT')
    wide, high, (values,) = read(a.depth, a, 1)
    if not a.projection and not (0 < a.fovy < 180 and (a.linear or 0 < a.near < a.far)):
        ask.error('needs --projection, or --fovy below 180 and --near below --far, or with --linear --fovy alone')
    m = a.projection or projection_of(a, wide / high)
    if len(m) != 16 or not ((abs(m[11]) == 1 and not m[15]) or (not m[11] and m[15] == 1)) or not m[0] * m[5]:
        ask.error('--projection: must be 16 numbers, the 12th -1 or 1, or 0 with 1 for the 16th')
    if a.view and (len(a.view) != 16 or a.view[3::4] != [0, 0, 0, 1]):
        ask.error('--view: must be 16 numbers, the 4th, 8th and 12th 0, the 16th 1')
    if a.world and not (a.normals and a.view): ask.error('--world: needs --normals and --view')
    (z, more), normals = depths_of(values, m, a), None
    if a.normals:
        path = a.normals
        *size, normals = read(a.normals, a, 3)
        if size != [wide, high]: raise ValueError(f'has {size[0]}x{size[1]} pixels, the depth {wide}x{high}')
        normals = turned(normals, a.view) if a.world else normals
    path = a.depth
    view = a.view or [float(i % 5 == 0) for i in range(16)]
    view[14] -= more                                                # the eye from which depths are measured
    write_frame(a.frame, wide, high, z, normals, m, view, a.radius)
except OSError as why: ask.error(str(why))
except ValueError as why: ask.error(f'{path}: {why}')
except (ArithmeticError, LookupError, struct.error, zlib.error): ask.error(f'{path}: is damaged, or the camera is')
