"""failures.py - measures each fault in README's table of failures, without and with the remedies named there.

    make failures                 writes examples/docs/FAILURES.md, in four minutes on two cores
    make failures ONLY=word       only prints the rows with that word in their name

Figures are RMSE against truth unless stated otherwise. Scenes are drawn small."""
import csv
import math
import os
import random
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, ROOT + "/examples/tools/capture")
sys.dont_write_bytecode = True
import pictures

RENDER, STABILITY = ROOT + "/build/render", ROOT + "/build/stability"
SIZE = "--size 480x270"


def said(program, line):
    at = ROOT if program == STABILITY else None  # causes.csv is read from there
    return subprocess.run([program] + line.split(), check=True, capture_output=True, text=True, cwd=at).stdout


def table(text):
    return list(csv.DictReader(text.splitlines()))


def channel(path, name):
    wide, high, (values,) = pictures.exr(open(path, "rb").read(), 1, name)
    return wide, high, list(values)


def boxes(name, solids):
    """Writes a mesh of closed boxes. If the second corner is below the first, the box is a room, seen from inside."""
    quads = (1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (4, 8, 7, 3), (2, 3, 7, 6), (1, 5, 8, 4)
    with open(name, "w") as f:
        for k, (a, b) in enumerate(solids):
            for z in (a[2], b[2]):
                for x, y in ((a[0], a[1]), (b[0], a[1]), (b[0], b[1]), (a[0], b[1])):
                    f.write("v %g %g %g\n" % (x, y, z))
            for q in quads:
                f.write("f %d %d %d %d\n" % tuple(8 * k + i for i in q))


def scored(scene, ways, truth=""):
    """Yields the RMSE of each way to draw a scene, each against one truth that is traced once."""
    said(RENDER, "%s %s --truth 128 --out truth.exr" % (scene, truth))
    for way in ways:
        found = re.search(r"RMSE ([\d.]+)", said(RENDER, "%s %s --score truth.exr" % (scene, way)))
        yield way, "%.3f" % float(found.group(1))


def swept(cause, *methods):
    """Returns the figure that build/stability prints for each method, or for what stands beside them."""
    asked = "".join(" --method " + m for m in methods if m != "beside")
    rows = table(said(STABILITY, "--quick --out build/failures/stability --cause %s%s" % (cause, asked)))
    figures = {row["method"]: row["number"] for row in rows}
    if methods:
        return [("%s: %s" % (cause, m), figures[m]) for m in methods]
    return [(cause, rows[0]["what"] + ": " + "; ".join(" ".join(f) for f in figures.items()))]


def slabs(count):
    boxes("slabs.obj", [((-3, -0.1, -3), (3, 0, 3))]
          + [((-0.5, 0.1 * k, -0.5), (0.5, 0.1 * k + 0.02, 0.5)) for k in range(1, 1 + count)])
    return scored("slabs.obj --camera 2,2,3,0,0.3,0 --fovy 40 --radius 2 " + SIZE,
                  ("", "--set thickness=back", "--method hsao-best", "--method dss"))


def far_corner():
    """Yields the mean and the deviation of visibility along the lowest row of pixels of the far wall."""
    boxes("within.obj", [((7.5, 14.5, 7.5), (-7.5, -0.5, -7.5))])
    room = "within.obj --camera 0,0,5,0,0,0 --fovy 45 --size 800x600 --radius 0.5 "
    for way in ("--truth 64", "", "--method hsao-best", "--method hsao-best --set samples=12",
                "--method hsao-history --still 16"):
        said(RENDER, room + way + " --out corner.exr")
        wide, _, y = channel("corner.exr", "Y")
        row = y[327 * wide + 330:327 * wide + 470]
        mean = sum(row) / len(row)
        yield way, "%.2f +- %.2f" % (mean, (sum((v - mean) ** 2 for v in row) / len(row)) ** 0.5)


def cloud():
    """Draws 40,000 splats of 3x3 pixels, each with one depth. Pixels without a splat are background."""
    boxes("boxes.obj", [((-8, -1, -12), (8, 0, 4)), ((-1, 0, -5), (1, 2, -3)), ((1.5, 0, -3), (3, 1, -1.5))])
    scene = "boxes.obj --camera 6,5,9,0,1,-4 --fovy 50 --radius 2 " + SIZE
    said(RENDER, scene + " --save-gbuffer frame.exr --truth 64 --out truth.exr")
    wide, high, z = channel("frame.exr", "Z")
    splats, dice = [0.0] * len(z), random.Random(1)
    seen = [i for i, v in enumerate(z) if v > 0]
    for i in (dice.choice(seen) for _ in range(40000)):
        for y in range(max(i // wide - 1, 0), min(i // wide + 2, high)):
            for x in range(max(i % wide - 1, 0), min(i % wide + 2, wide)):
                k = y * wide + x
                splats[k] = min(splats[k], z[i]) if splats[k] > 0 else z[i]
    pictures.write_exr("cloud.exr", wide, high, {"Z": splats})
    for way in ("", "--set lift=1,offset=8", "--method ssao --set blur=3"):
        found = re.search(r"RMSE ([\d.]+)", said(
            RENDER, "--gbuffer cloud.exr --fovy 50 --radius 2 --score truth.exr " + way))
        yield way, "%.3f" % float(found.group(1))


def facets():
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    with open("cube.obj", "w") as f:
        for kind in ("v", "vn"):
            for c in corners:
                f.write("%s %d %d %d\n" % ((kind,) + c))
        for q in ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)):
            f.write("f " + " ".join("%d//%d" % (i, i) for i in q) + "\n")
    return scored("cube.obj --camera 2.5,2,4,0,0,0 --fovy 40 --radius 1 " + SIZE,
                  ("", "--set facets=1", "--set normal=depth"), "--flat")


def shining(spark, ways):
    """Yields the brightest bounce on the floor: before a lit wall with a spark in it, or behind one without."""
    boxes("wall.obj", [((-1, -0.1, -6), (9, 0, 6)), ((-0.02, 0, -2), (0, 2, 2))])
    camera = "wall.obj --camera 9,6,3,1.8,0.3,0 --fovy 45 --radius 5 " + SIZE
    said(RENDER, camera + " --save-gbuffer frame.exr --out o.exr")
    wide, high, z = channel("frame.exr", "Z")
    ahead = [v / math.hypot(7.2, 5.7, 3) for v in (-7.2, -5.7, -3)]
    level, half = math.hypot(ahead[0], ahead[2]), math.tan(math.radians(22.5)) / (high / 2)
    place = []
    for i, depth in enumerate(z):
        across, up = half * (i % wide + 0.5 - wide / 2), half * (high / 2 - i // wide - 0.5)
        place.append((9 + depth * (ahead[0] - across * ahead[2] / level - up * ahead[0] * ahead[1] / level),
                      6 + depth * (ahead[1] + up * level)))
    face = [v > 0 and x < 0.05 and y > 0.05 for (x, y), v in zip(place, z)]
    floor = [v > 0 and abs(y) < 0.01 for (x, y), v in zip(place, z)]
    light = [(0.05 if spark else 1.0) if f else 0.0 for f in face]
    if spark:
        on = [i for i, f in enumerate(face) if f]
        light[on[len(on) * 3 // 4]] = 1000.0
    same = {c: light for c in ("direct.R", "direct.G", "direct.B")}
    grey = {c: [0.5] * len(z) for c in ("albedo.R", "albedo.G", "albedo.B")}
    pictures.write_exr("shining.exr", wide, high, {"Z": z, **same, **grey})
    for way in ways:
        said(RENDER, "--gbuffer shining.exr --fovy 45 --radius %d --out o.exr %s" % (2 if spark else 5, way))
        bounce = channel("o.exr", "bounce.R")[2]
        yield way, "%.3f" % max(b for b, f, (x, _) in zip(bounce, floor, place)
                                if f and (spark or x < -0.1))


def moving():
    ways = "".join(" --method hsao" + w for w in ("", "-best", "-history"))
    digits = {"filling": 5, "filled": 5, "error": 4, "over alone": 3}
    for row in table(said(STABILITY, "--moves --scene room" + ways)):
        yield row["method"], ", ".join("%.*f" % (n, float(row[key])) for key, n in digits.items())


ROWS = [
    ("off screen, within a radius of the border", lambda: scored(
        "casters --fovy 18 " + SIZE, ("", "--set margin=1", "--set thickness=slabs",
                                      "--set margin=1,thickness=slabs", "--method dss"))),
    ("off screen, an object", lambda: swept("off-screen", "hsao", "dss", "aof")),
    ("hidden", lambda: swept("hidden", "hsao", "dss", "aof")),
    ("wide plates: a slot between two", lambda: swept("slot", "hsao", "hsao-back", "dss")),
    ("wide plates", lambda: scored("plates " + SIZE, ("", "--set thickness=back", "--set thickness=slabs",
                                                      "--method dss --set thickness=back"))),
    ("a lone thin slab over a floor", lambda: slabs(1)),
    ("eight slabs over each other", lambda: slabs(8)),
    ("slabs over each other, the floor below them", lambda: swept("stack", "hsao", "dss", "aof", "beside")),
    ("foliage", lambda: scored("random:foliage:3 " + SIZE, ("", "--set resolution=full"))),
    ("a radius that is too small, or too large", lambda: swept("radius", "hsao", "dss")),
    ("a floor seen along itself: a row of the wall", far_corner),
    ("history: an object moves", lambda: swept("kept-slide", "hsao-history")),
    ("history: a sun turns", lambda: swept("kept-light", "ssdo-history")),
    ("a camera moves: deviation in frames 1 to 8, 9 to 16; error, over that of one frame", moving),
    ("the near plane cuts a solid", lambda: swept("near-plane", "hsao", "dss", "aof")),
    ("smooth normals on facets", facets),
    ("a cloud of points", cloud),
    ("an emitter's back: the most behind it, where 0 is right", lambda: shining(
        0, ("--method ssdo", "--method ssdo --set one_sided=1", "--method ssdo-best --set one_sided=1"))),
    ("a spark of 1000 among 0.05: the most that it brings", lambda: shining(
        1, ("--method ssdo", "--method ssdo-best", "--method ssdo --set clamp=0.2",
            "--method ssdo-best --set clamp=0.2"))),
    ("a bounce, as its emitter turns away", lambda: swept("emitter", "ssdo-bounce", "s3ho-bounce", "dss-bounce",
                                                          "beside")),
    ("a black screen before an emitter", lambda: swept("leak", "ssdo-bounce", "s3ho-bounce", "dss-bounce")),
    ("a lamp of 1 degree in a black sky", lambda: swept("lamp", "ssdo", "s3ho", "ssbn", "beside")),
    ("light through a slit of 10 degrees", lambda: swept("slit", "ssdo", "s3ho", "ssbn", "dss-lit")),
    ("a contact's shadow, by a map of 32 texels", lambda: swept("contact-size", "ssdo-map", "ssdo-fill", "ssdo-segment",
                                                                "beside")),
    ("1 over the number of shades, with 2 directions or more, unfiltered", lambda: swept(
        "shades", "ssao-raw", "hsao-march-raw", "beside")),
    ("linear depth of 16 bits: good to this view depth, with the near plane at 0.1", lambda: swept(
        "depth-16f", "hsao")),
    ("depth of 24 bits, likewise", lambda: swept("depth-24", "hsao")),
    ("reversed depth of 32 bits, likewise", lambda: swept("depth-reversed", "hsao")),
    ("a sun as harmonics", lambda: swept("sh-open")),
    ("aof: inside a hull", lambda: swept("hull")),
]


HEAD = """# Where it fails, measured

By `make failures`, which writes this file: each fault that README names, as it is and with its remedies, on small
scenes. Figures are RMSE against ray-traced truth where nothing else is said. `--flags` are build/render's, a fault
without any is drawn by `hsao`. `stack: dss` is the worst figure of a sweep, by `build/stability --quick --cause stack
--method dss`; beside methods stands an image without the effect, or the truth's own figure.

| fault | drawn by | figure |
|---|---|---|
"""


def main():
    folder = ROOT + "/build/failures"
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    table = HEAD
    for name, measure in ROWS:
        if len(sys.argv) > 1 and sys.argv[1] not in name:
            continue
        for way, figure in measure():
            line = "| %s | `%s` | %s |" % (name, way or "hsao", figure)
            print(line, flush=True)
            table += line + "\n"
    if len(sys.argv) == 1:
        with open(ROOT + "/examples/docs/FAILURES.md", "w") as f:
            f.write(table)


main()
