"""ranks.py - whether two sets of seeded scenes, such as those of two commits, rank settings alike.

    build/try --judge yes --from 5005 --count 70 --out old.csv METHOD[:key=value,..] ..
    build/try --judge yes --from 5005 --count 70 --out new.csv ..the same..
    python3 examples/lab/ranks.py old.csv new.csv

Prints for each kind of scene, and for all: Kendall's tau between both sets' means of the settings; tau between random
halves of one set, averaged over forty draws, which is the most that so many scenes allow; the mean of each set, the
mean difference of a setting, and the largest."""
import random
import sys

KINDS = ["rooms", "streets", "halls", "foliage", "machines", "scans", "terrain"]


def load(path):
    rows = (line.split(",") for line in open(path))
    return {int(row[0]): [float(v) for v in row[1:]] for row in rows}


def means(scenes):
    return [sum(column) / len(scenes) for column in zip(*scenes)]


def tau(a, b):
    pairs = [(i, k) for i in range(len(a)) for k in range(i)]
    sign = [(a[i] - a[k]) * (b[i] - b[k]) for i, k in pairs]
    return sum((s > 0) - (s < 0) for s in sign) / len(pairs)


def halves(scenes):
    found = []
    for _ in range(40):
        random.shuffle(scenes)
        middle = len(scenes) // 2
        found.append(tau(means(scenes[:middle]), means(scenes[middle:])))
    return sum(found) / len(found)


random.seed(1)
both = [load(path) for path in sys.argv[1:3]]
kept = [i for i, v in enumerate(next(iter(both[0].values()))) if v == v]  # methods without visibility have NaN
for kind in range(-1, len(KINDS)):
    of = [[[row[i] for i in kept] for seed, row in rows.items() if kind in (-1, seed % 7)] for rows in both]
    a, b = means(of[0]), means(of[1])
    off = [y - x for x, y in zip(a, b)]
    print("%-9s %3d, %3d scenes: tau %.3f (halves %.3f, %.3f), means %.3f %.3f, by %+.3f, at most %+.3f" % (
        "all" if kind < 0 else KINDS[kind], len(of[0]), len(of[1]), tau(a, b), halves(of[0]), halves(of[1]),
        sum(a) / len(a), sum(b) / len(b), sum(off) / len(off), max(off, key=abs)))
