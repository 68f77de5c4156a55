"""A channel of a PNG or an EXR, read and written with Python's own library alone: width, height, values row by row from
the top."""
import itertools, os, re, zlib
from struct import calcsize, pack, unpack, unpack_from

def unpacked(data, size):
    found = zlib.decompressobj().decompress(data, size)
    if len(found) < size: raise ValueError('is cut off')
    return found

def png(data):
    """Grey of 16 bits, as numbers in [0,1]."""
    wide, high, *kind = unpack_from('>IIBBBBB', data, 16)
    if kind != [16, 0, 0, 0, 0]: raise ValueError('must be grey, of 16 bits, not interlaced')
    at, packed = 8, b''
    while at < len(data):
        size, name = unpack_from('>I4s', data, at)
        if name == b'IDAT': packed += data[at + 8:at + 8 + size]
        at += size + 12
    row, values = 2 * wide + 1, []
    raw, above = unpacked(packed, high * row), bytes(row + 1)
    for start in range(0, high * row, row):
        line = bytearray(2) + raw[start + 1:start + row]
        for i in range(2, len(line) if raw[start] else 0):
            a, b, c = line[i - 2], above[i], above[i - 2]
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[i] = line[i] + (0, a, b, (a + b) // 2, paeth)[raw[start]] & 255
        values += [value / 65535 for value in unpack_from(f'>{wide}H', line, 2)]
        above = line
    return wide, high, values

def exr(data, wanted):
    """Halves or floats in rows, uncompressed or ZIP: the channel of that name; None: Z, D, R, or the only one."""
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
    wide, high, values = right - left + 1, bottom - top + 1, []
    channels = re.findall(rb'(?s)([^\0]+)\0(.).{15}', head['channels'])
    names = [name.decode('latin1') for name, _ in channels]
    row = '<' + ''.join(f'{wide}{"Ief"[kind[0]]}' for _, kind in channels)
    which = wanted or next((name for name in 'ZDR' if name in names), names[0])
    if which not in names: raise ValueError(f'has no channel {which}')
    first = wide * names.index(which)
    for k, start in enumerate(unpack_from(f'<{-(-high // rows)}Q', data, at + 1)):
        size, whole = unpack_from('<I', data, start + 4)[0], calcsize(row) * min(rows, high - k * rows)
        chunk = data[start + 8:start + 8 + size]
        if size < whole:                   # differences of all even bytes, then of all odd ones
            sums = enumerate(itertools.accumulate(unpacked(chunk, whole)))
            chunk = bytes((byte - 128 * i) & 255 for i, byte in sums)
            chunk = bytes(byte for pair in zip(chunk[:whole // 2], chunk[whole // 2:]) for byte in pair)
        for line in range(0, whole, calcsize(row)): values += unpack_from(row, chunk, line)[first:first + wide]
    return wide, high, values

def write_exr(path, wide, high, values, *more):
    """Channel Z, uncompressed. more: attributes of the header as (name, type, format, numbers ..)."""
    box = 0, 0, wide - 1, high - 1
    header = b''
    for name, kind, code, *numbers in (('channels', 'chlist', '2s4IB', b'Z', 2, 0, 1, 1, 0),
                                       ('compression', 'compression', 'B', 0), ('lineOrder', 'lineOrder', 'B', 0),
                                       ('dataWindow', 'box2i', '4i', *box), ('displayWindow', 'box2i', '4i', *box),
                                       *more):
        header += f'{name}\0{kind}\0'.encode() + pack('<I' + code, calcsize('<' + code), *numbers)
    first, row = 8 + len(header) + 1 + 8 * high, 8 + 4 * wide
    with open(path + '.part', 'wb') as file:
        file.write(pack('<2I', 20000630, 2) + header + b'\0')
        file.write(pack(f'<{high}Q', *range(first, first + row * high, row)))
        for y in range(high): file.write(pack(f'<2I{wide}f', y, 4 * wide, *values[y * wide:(y + 1) * wide]))
    os.replace(path + '.part', path)
