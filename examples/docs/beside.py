"""beside.py - the picture at the head of README: the same crop by others' effects, by hsao and by ray tracing.

    make peers build/quiet && python3 examples/docs/beside.py [SEED ..]        (numpy, ImageMagick)

The scenes are the first judged seeds of three kinds that people know: rooms 1001, streets 1002 and halls 1003. The crop
is the window of 208x140 pixels, on a grid of 20, in which ray-traced visibility varies most. Neither was chosen by
looking at a result. Each effect draws one frame of 1280x720 without antialiasing, at its maker's defaults for the same
radius. Under it stand the milliseconds that `make cost` models, and the error of the whole image: RMSE over that of no
ambient occlusion; "fitted" is that error after the better of a v^b and 1 - a (1 - v)^b.
"""
import csv, glob, os, re, subprocess, sys
import numpy as np

SIZE, CROP, GRID, RAYS = (1280, 720), (208, 140), 20, 256
SEEDS = [int(a) for a in sys.argv[1:]] or [1001, 1002, 1003]
PANELS = [("three-js-gtao", "three.js GTAOPass", "three.js GTAO"), ("n8ao", "n8ao, Medium", "n8ao"),
          ("playcanvas-ssao", "PlayCanvas SSAO", "PlayCanvas SSAO"),
          ("three-js-gtaonode", "three.js GTAONode", "three.js GTAONode"), ("hsao", "ssgi hsao", "hsao"),
          ("truth", f"ray tracing, {RAYS} rays a pixel", None)]


def read(path):
    raw = subprocess.run(["convert", path, "-colorspace", "gray", "-depth", "8", "gray:-"], stdout=subprocess.PIPE,
                         check=True).stdout
    assert len(raw) == SIZE[0] * SIZE[1], f"{path}: is of another size"
    return np.frombuffer(raw, np.uint8).reshape(SIZE[1], SIZE[0]) / 255.0


def fitted(image, truth):
    """The least RMSE of a v^b and of 1 - a (1 - v)^b."""
    best = 1e9
    for v, t in ((image, truth), (1 - image, 1 - truth)):
        for b in np.geomspace(0.2, 5, 81):
            p = v ** b
            a = (p * t).sum() / max((p * p).sum(), 1e-9)
            best = min(best, np.sqrt(((np.clip(a * p, 0, 1) - t) ** 2).mean()))
    return best


def crop_of(truth):
    (w, h), best = CROP, (0, 0, 0)
    for y in range(0, SIZE[1] - h + 1, GRID):
        for x in range(0, SIZE[0] - w + 1, GRID):
            best = max(best, (truth[y:y + h, x:x + w].std(), x, y))
    return best[1:]


def milliseconds():
    """Modelled, of an RX 6800 at 1920x1080: by "method / settings"."""
    rows = reversed(list(csv.DictReader(open("examples/docs/figures/cost-peers.csv"))))    # a chain's sum is its first
    ms = {r["chain"]: float(r["RX 6800 weighed"]) for r in rows if r["family"] == "navi21"}
    cost = subprocess.run(["build/cost", "hsao"], stdout=subprocess.PIPE, text=True, check=True).stdout
    ms["hsao / "] = float(re.search(r"^hsao .*?([\d.]+) \(", cost, re.M).group(1))
    return ms


def picture(seed, ms, folder):
    """Draws all effects of a scene, unless they lie in folder, and writes examples/docs/pictures/beside-SEED.png."""
    table = f"{folder}/quiet.csv"
    os.makedirs(folder, exist_ok=True)
    if not os.path.exists(table):
        subprocess.run(["build/quiet", "--scene", f"random:{seed}", "--size", f"{SIZE[0]}x{SIZE[1]}",
                        "--rays", str(RAYS), "--pictures", folder, "--out", table], check=True)
    settings = {r["method"]: r["settings"] for r in reversed(list(csv.DictReader(open(table))))}   # the first row's
    files = {re.sub(r"^\d+-", "", os.path.basename(f)[:-4]): f for f in glob.glob(f"{folder}/*[0-9a-z].png")}
    truth = read(files["truth"])
    none, (x, y), panels = np.sqrt(((1 - truth) ** 2).mean()), crop_of(truth), []
    for slug, name, method in PANELS:
        image, label = read(files[slug]), name
        if method:
            error = np.sqrt(((image - truth) ** 2).mean()) / none
            label += f"\n{ms[method + ' / ' + settings[method]]:.2f} ms    error {error:.3f}"
            label += f"    fitted {fitted(image, truth) / none:.3f}" if method != "hsao" else ""
        part = f"{folder}/panel-{slug}.png"
        subprocess.run(["convert", files[slug], "-crop", f"{CROP[0]}x{CROP[1]}+{x}+{y}", "+repage", "-filter", "point",
                        "-resize", "200%", part], check=True)
        panels += ["-label", label, part]
    subprocess.run(["montage", *panels, "-font", "DejaVu-Sans", "-pointsize", "15", "-background", "white", "-tile",
                    "3x", "-geometry", "+3+3", "-depth", "8", f"examples/docs/pictures/beside-{seed}.png"], check=True)


for seed in SEEDS:
    picture(seed, milliseconds(), f"build/beside/{seed}")
