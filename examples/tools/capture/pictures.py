"""Reads and writes channels of a PNG, an EXR or raw floats, with only Python's own library: width, height, each
channel's values row by row from the top."""
import itertools, os, re, zlib
from struct import calcsize, pack, unpack, unpack_from

def unpacked(data, size):
    found = zlib.decompressobj().decompress(data, size)
    if len(found) < size: raise ValueError('is cut off')
    return found

def raw(data, wide, high, channels):
    """Reads floats in the machine's byte order, channels interleaved."""
    count = wide * high * channels
    if len(data) != 4 * count: raise ValueError(f'must have {4 * count} bytes, has {len(data)}')
    values = unpack(f'={count}f', data)
    return wide, high, [values[c::channels] for c in range(channels)]

def png(data, channels):
    """Reads grey of 16 bits as numbers in [0,1]; or three channels, RGB of 8 or 16 bits, as normals in [-1,1]."""
    wide, high, *kind = unpack_from('>IIBBBBB', data, 16)
    if kind[1:] != [2 * (channels == 3), 0, 0, 0] or kind[0] not in ((8, 16) if channels == 3 else (16,)):
        raise ValueError(f'must be {"RGB of 8 or" if channels == 3 else "grey, of"} 16 bits, not interlaced')
    at, packed, each = 8, b'', kind[0] // 8
    while at < len(data):
        size, name = unpack_from('>I4s', data, at)
        if name == b'IDAT': packed += data[at + 8:at + 8 + size]
        at += size + 12
    step = each * channels
    row, values, most = wide * step + 1, [], 256 ** each - 1
    pixels, above = unpacked(packed, high * row), bytes(row + step - 1)
    for start in range(0, high * row, row):
        line = bytearray(step) + pixels[start + 1:start + row]
        for i in range(step, len(line) if pixels[start] else 0):
            a, b, c = line[i - step], above[i], above[i - step]
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[i] = line[i] + (0, a, b, (a + b) // 2, paeth)[pixels[start]] & 255
        values += [value / most for value in unpack_from(f'>{wide * channels}{"BH"[each - 1]}', line, step)]
        above = line
    return wide, high, [[2 * v - 1 for v in values[c::3]] for c in range(3)] if channels == 3 else [values]

def exr(data, channels, wanted):
    """Reads halves or floats in scanlines, uncompressed or ZIP. One channel: by its name; None: Z, D, R, or the first
    one.
        Three: those whose names end in X Y Z, or in R G B."""
    if data[:4] != b'v/1\1': raise ValueError('is neither PNG nor EXR')
    at, head = 8, {}
    while data[at]:
        name, kind = data[at:at + 512].split(b'\0')[:2]
        start = at + len(name) + len(kind) + 6
        at = start + unpack_from('<I', data, start - 4)[0]
        head[name.decode('latin1')] = data[start:at]
    rows = {0: 1, 2: 1, 3: 16}.get(head['compression'][0])
    if data[5] & 26 or not rows: raise ValueError('must be one part of rows, uncompressed or ZIP')
    left, top, right, bottom = unpack('<4i', head['dataWindow'])
    wide, high = right - left + 1, bottom - top + 1
    there = re.findall(rb'(?s)([^\0]+)\0(.).{15}', head['channels'])
    names = [name.decode('latin1') for name, _ in there]
    row = '<' + ''.join(f'{wide}{"Ief"[kind[0]]}' for _, kind in there)
    if channels == 3:
        ends = next((ends for ends in ('XYZ', 'RGB') if all(any(n.endswith(e) for n in names) for e in ends)), None)
        if not ends: raise ValueError(f'has no channels X Y Z or R G B, but {", ".join(names)}')
        which = [next(n for n in names if n.endswith(e)) for e in ends]
    else: which = [wanted or next((name for name in 'ZDR' if name in names), names[0])]
    if which[0] not in names: raise ValueError(f'has no channel {which[0]}')
    found = [(wide * names.index(name), []) for name in which]
    for k, start in enumerate(unpack_from(f'<{-(-high // rows)}Q', data, at + 1)):
        size, whole = unpack_from('<I', data, start + 4)[0], calcsize(row) * min(rows, high - k * rows)
        chunk = data[start + 8:start + 8 + size]
        if size < whole:                   # first the differences of even bytes, then of odd ones
            sums = enumerate(itertools.accumulate(unpacked(chunk, whole)))
            chunk = bytes((byte - 128 * i) & 255 for i, byte in sums)
            chunk = bytes(byte for pair in zip(chunk[:whole // 2], chunk[whole // 2:]) for byte in pair)
        for line in range(0, whole, calcsize(row)):
            all_of = unpack_from(row, chunk, line)
            for first, values in found: values += all_of[first:first + wide]
    return wide, high, [values for _, values in found]

def write_exr(path, wide, high, channels, *more):
    """Writes channels by name, uncompressed. more: attributes of the header as (name, type, format, numbers ..)."""
    box, names = (0, 0, wide - 1, high - 1), sorted(channels)
    listed = b''.join(name.encode() + b'\0' + pack('<4I', 2, 0, 1, 1) for name in names) + b'\0'
    header = b'channels\0chlist\0' + pack('<I', len(listed)) + listed
    for name, kind, code, *numbers in (('compression', 'compression', 'B', 0), ('lineOrder', 'lineOrder', 'B', 0),
                                       ('dataWindow', 'box2i', '4i', *box), ('displayWindow', 'box2i', '4i', *box),
                                       *more):
        header += f'{name}\0{kind}\0'.encode() + pack('<I' + code, calcsize('<' + code), *numbers)
    size = 4 * wide * len(names)
    first, row = 8 + len(header) + 1 + 8 * high, 8 + size
    with open(path + '.part', 'wb') as file:
        file.write(pack('<2I', 20000630, 2) + header + b'\0')
        file.write(pack(f'<{high}Q', *range(first, first + row * high, row)))
        for y in range(high):
            file.write(pack('<2I', y, size))
            for name in names: file.write(pack(f'<{wide}f', *channels[name][y * wide:(y + 1) * wide]))
    os.replace(path + '.part', path)
