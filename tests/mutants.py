"""make mutants: makes wrong edits to the headers, drawn by a seed, and records which test notices each.

    make mutants                    tries the edits of tests/mutants.txt and writes their verdicts anew
    make mutants ONLY="3 17"        tries these alone and prints their verdicts; the file stays
    make mutants DRAW=100 SEED=50   draws so many edits and writes the file, without verdicts

An edit replaces text that occurs once in its header. It is applied to a copy of the tree, the objects that depend on it
are compiled, and the groups of tests that examples/docs/CONTRIBUTING.md names for its room run until one fails. An edit
whose text is no longer there counts as survived. If an edit changes nothing observable, you strike it by hand: its
verdict begins with "struck:" and the reason, and is kept. Two copies of the tree are used at once.
"""
import os, random, re, shutil, subprocess, sys, threading, time

LIST, COPIES = "tests/mutants.txt", "build/mutants"
HEADERS = ("ssgi.h", "ssgi_gl.h")
LIMIT = 240  # seconds for an edit; one that keeps a test from ending counts as noticed


def groups_of_rooms():
    rows = re.findall(r"^\| (ssgi\w*\.h) >>(\w+) \| ([a-z ]+) \|$", open("examples/docs/CONTRIBUTING.md").read(), re.M)
    return {(header, room): groups.split() for header, room, groups in rows}


# ---- drawing

def spoilt_number(chance, match):
    text, suffix = re.match(r"([\d.]+(?:e-?\d+)?)(f?)$", match.group(0)).groups()
    if "." not in text and "e" not in text:
        return str(int(text) + 1)
    value = float(text) * chance.choice((0.5, 0.8, 1.25, 2.0)) or 0.25
    text = repr(round(value, 12))
    return text + suffix


SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " > ", " > ": " < ", " <= ": " > ",
         " >= ": " < ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ", " += ": " -= ", " -= ": " += ",
         " *= ": " /= ", "min(": "max(", "max(": "min(", "cos(": "sin(", "sin(": "cos(", "fmin(": "fmax(",
         "fmax(": "fmin("}
KINDS = {
    "literal scaled": (re.compile(r"(?<![\w.\[])(?:\d+\.\d*|\d*\.\d+|\d+)(?:e-?\d+)?f?(?![\w.\]])"), spoilt_number),
    "operator exchanged": (re.compile(r"(?<!\w)(?:f?min|f?max|sin|cos)\(| (?:[-+*]=?|[/<>]|[<>=!]=|&&|\|\|) "),
                           lambda chance, match: SWAPS[match.group(0)]),
    "term dropped": (re.compile(r" [-+*/] [a-z_][\w.]*(?:->\w+)?(?=[;,)]| [-+])"), lambda chance, match: ""),
    "guard turned": (re.compile(r"(?<=\bif \()[^()]+(?=\))|(?<=^\"#if )[^\"\\]+(?=\\n\")"),
                     lambda chance, match: "!(" + match.group(0) + ")"),
}


def lines_of(header):
    """Lists lines of code as (number, text, room), without comments, prototypes and tables of words or sentences."""
    lines, code, room, inside = open(header).read().split("\n"), [], None, False
    glsl = False
    for i, line in enumerate(lines):
        heading = re.match(r"/\* ==== >>(\w+)(.*)", line)
        if heading:
            room = heading.group(1)
            if "(implementation)" in heading.group(2) or room in ("library", "fetch", "passes"):
                inside = True
            glsl = room in ("library", "fetch", "visibility", "harmonics", "light", "gather", "field", "splat",
                            "filter") and header == "ssgi_gl.h" and "(implementation)" not in heading.group(2)
        stripped = line.strip()
        if not inside or room in ("rows", "passes", "library") or not stripped:
            continue
        if glsl:
            if not re.match(r'^\s+".*\\n"', line) or stripped.startswith('"//') or stripped.startswith('"    //'):
                continue
        elif not line.startswith("    ") or '"' in line or stripped.startswith(("/*", "*", "SSGI__CHECK", "#", "{")):
            continue
        elif not re.search(r"[;{]$|[-+*/&|]$", stripped.split(" /*")[0]):
            continue
        code.append((i, line, room))
    return lines, code


def code_part(line):
    """Returns how many characters of a line are before its comment."""
    ends = [line.index(mark) for mark in (" //", " /*") if mark in line]
    return min(ends) if ends else len(line)


def unique(lines, whole, i):
    """Returns a line, with so many lines before it that the text occurs once. None: six lines do not suffice."""
    for first in range(i, max(i - 6, -1), -1):
        text = "\n".join(lines[first:i + 1])
        if whole.count(text) == 1:
            return text
    return None


def draw(count, seed):
    chance, drawn = random.Random(seed), []
    pools = []
    for header in HEADERS:
        lines, code = lines_of(header)
        glsl = [c for c in code if c[1].lstrip().startswith('"')]
        c = [c for c in code if not c[1].lstrip().startswith('"')]
        pools += [(header, lines, part) for part in (glsl, c) if part]
    taken = set()
    while len(drawn) < count:
        header, lines, part = pools[len(drawn) % len(pools)]
        i, line, room = chance.choice(part)
        kind = chance.choice(list(KINDS))
        pattern, spoil = KINDS[kind]
        places = list(pattern.finditer(line, 0, code_part(line)))
        if not places or (header, i) in taken:
            continue
        match = chance.choice(places)
        new = line[:match.start()] + spoil(chance, match) + line[match.end():]
        whole = "\n".join(lines)
        search = unique(lines, whole, i)
        if search is None or new == line:
            continue
        replacement = search[:len(search) - len(line)] + new
        if not compiles(header, whole.replace(search, replacement)):
            continue
        taken.add((header, i))
        drawn.append({"header": header, "room": room, "kind": kind, "search": search, "replacement": replacement,
                      "verdict": ""})
        print("  drawn %d of %d" % (len(drawn), count), end="\r" if sys.stdout.isatty() else "\n")
    return drawn


def compiles(header, text):
    """Returns whether the C of the headers compiles. The GLSL is left to the tests."""
    folder = COPIES + "/draw"
    os.makedirs(folder, exist_ok=True)
    for name in HEADERS:
        with open(folder + "/" + name, "w") as file:
            file.write(text if name == header else open(name).read())
    source = ("#define SSGI_IMPLEMENTATION\n#define SSGI_GL_IMPLEMENTATION\n#include \"ssgi_gl.h\"\n"
              "int main(void) { return 0; }\n")
    return subprocess.run(["gcc", "-std=c99", "-fsyntax-only", "-w", "-I", folder, "-xc", "-"], input=source, text=True,
                          stderr=subprocess.DEVNULL).returncode == 0


# ---- the list

def read_list():
    mutants = []
    for part in open(LIST).read().strip("\n").split("\n\n"):
        head = re.match(r"(\d+) (\S+) >>(\w+), (.*)", part)
        if not head:
            continue
        rows = part.split("\n")[1:]
        mutants.append({"header": head.group(2), "room": head.group(3), "kind": head.group(4),
                        "search": "\n".join(r[1:] for r in rows if r[:1] in " -"),
                        "replacement": "\n".join(r[1:] for r in rows if r[:1] in " +"),
                        "verdict": "".join(r[2:] for r in rows if r[:1] == "=")})
    return mutants


def write_list(mutants, seed_line):
    with open(LIST + ".part", "w") as file:
        file.write(seed_line)
        for n, m in enumerate(mutants, 1):
            before, after = m["search"].split("\n"), m["replacement"].split("\n")
            file.write("\n%d %s >>%s, %s\n" % (n, m["header"], m["room"], m["kind"]))
            for old, new in zip(before, after):
                file.write(" " + old + "\n" if old == new else "-" + old + "\n+" + new + "\n")
            file.write("= " + m["verdict"] + "\n")
    os.replace(LIST + ".part", LIST)


# ---- judging

def copy_tree(folder):
    os.makedirs(folder, exist_ok=True)
    files = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], text=True,
                           stdout=subprocess.PIPE, check=True).stdout.split("\0")
    for where, inside, names in os.walk(folder):       # gone from the tree: the Makefile would compile them
        inside[:] = [name for name in inside if os.path.join(where, name) != folder + "/build"]
        for name in names:
            if os.path.relpath(os.path.join(where, name), folder) not in files:
                os.remove(os.path.join(where, name))
    for name in filter(os.path.isfile, files):
        to = os.path.join(folder, name)
        os.makedirs(os.path.dirname(to), exist_ok=True)
        if not os.path.exists(to) or open(name, "rb").read() != open(to, "rb").read():
            shutil.copy2(name, to)
    built = [name for name in ("assimp", "examples", "include", "kit", "tests") if os.path.exists("build/" + name)]
    subprocess.run(["mkdir", "-p", folder + "/build"], check=True)
    subprocess.run(["cp", "-au", *built, os.path.abspath(folder) + "/build/"], cwd="build", check=True)


def run(folder, command):
    done = subprocess.run("timeout %d %s" % (LIMIT, command), cwd=folder, shell=True, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=dict(os.environ, T_FIRST="1", MAKEFLAGS=""))
    return done.returncode, done.stdout


def judge(mutant, folder, groups):
    text = open(mutant["header"]).read()
    if text.count(mutant["search"]) != 1:
        return "survived: its text is no longer there"
    path = os.path.join(folder, mutant["header"])
    with open(path, "w") as file:
        file.write(text.replace(mutant["search"], mutant["replacement"]))
    at = "tests/library/"
    own = [f for f in os.listdir(at) if f.startswith("test_") and "own.h" in open(at + f).read()]
    kept = " ".join("-o build/%s%s.o" % (at, f[:-2]) for f in own if f[5:-2] not in groups)
    try:
        for group in groups:
            status, said = run(folder, "make -s -j1 %s test ONLY=%s" % (kept, group))
            if status:
                failed = re.search(r"^FAILED +(.*?)(?: \([\d.]+ s\))?$", said, re.M)
                return "caught by %s: %s" % (group, failed.group(1) if failed
                                             else "does not end" if status == 124 else "does not run")
        return "survived " + " ".join(groups)
    finally:
        shutil.copy(mutant["header"], path)


def main(arguments):
    options = dict(a.split("=", 1) for a in arguments if a.split("=", 1)[1])
    if "DRAW" in options:
        seed = int(options.get("SEED", 1))
        write_list(draw(int(options["DRAW"]), seed), "Wrong edits of both headers, drawn by make mutants DRAW=%s "
                   "SEED=%d; = says which test notices it.\n" % (options["DRAW"], seed))
        return 0
    mutants, rooms = read_list(), groups_of_rooms()
    only = [int(n) for n in options.get("ONLY", "").split()]
    left = [n for n, m in enumerate(mutants, 1) if (n in only if only else not m["verdict"].startswith("struck:"))]
    first = open(LIST).readline()
    wanted, lock, began = len(left), threading.Lock(), time.time()

    def work(folder):
        copy_tree(folder)
        while True:
            with lock:
                if not left:
                    return
                n = left.pop(0)
            m = mutants[n - 1]
            since = time.time()
            m["verdict"] = judge(m, folder, rooms[m["header"], m["room"]])
            with lock:
                print("%3d %s (%.0f s; %d to go)" % (n, m["verdict"], time.time() - since, len(left)), flush=True)
                if not only:
                    write_list(mutants, first)

    workers = [threading.Thread(target=work, args=(COPIES + "/" + name,)) for name in ("a", "b")]
    for w in workers:
        w.start()
    for w in workers:
        w.join()
    if left:
        return 1                                           # a worker ended early: its traceback says why
    struck = sum(m["verdict"].startswith("struck:") for m in mutants)
    caught = sum(m["verdict"].startswith("caught") for m in mutants)
    print("%d of %d caught, %d struck; %d tried in %.0f s"
          % (caught, len(mutants), struck, wanted, time.time() - began))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
