#!/usr/bin/python3
"""Presses keys in a program's window and drops files on it, as a user would, for viewer.sh. It needs an X server that
shows no other window.

    build/press KEY ..           X's names of keys: m M bracketleft; title: prints the title; drop:/a/file: drops a
                                 file; turn:N: turns the wheel; drag:X,Y: drags with the left button; size:WxH: resizes
                                 the window; grab:F.ppm: saves its picture; wait: waits 0.3 seconds
"""
import re, select, sys, time
from Xlib import X, XK, display
from Xlib.protocol import event

server = display.Display()
root = server.screen().root
source = root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
window = None


def shown(below):
    """Returns the visible window that has a name."""
    if below.get_wm_name() and below.get_attributes().map_state == X.IsViewable:
        return below
    return next(filter(None, map(shown, below.query_tree().children)), None)


def send(kind, mask, detail=0, at=(0, 0), state=0):
    time.sleep(0.002)    # a window notices two presses of one key by their times
    now = int(time.monotonic() * 1000) & 0xffffffff
    window.send_event(kind(time=now, root=root, window=window, child=X.NONE, same_screen=1, root_x=0, root_y=0,
                           event_x=at[0], event_y=at[1], state=state, detail=detail), event_mask=mask)
    server.flush()


def press(name):
    key = XK.string_to_keysym(name)
    if key == X.NoSymbol:
        sys.exit("press: %s: cannot be done" % name)
    state = X.ShiftMask if len(name) == 1 and name.isupper() else 0
    send(event.KeyPress, X.KeyPressMask, server.keysym_to_keycode(key), state=state)
    send(event.KeyRelease, X.KeyReleaseMask, server.keysym_to_keycode(key), state=state)


def turn(steps):
    for _ in range(abs(steps)):
        send(event.ButtonPress, X.ButtonPressMask, 4 if steps > 0 else 5, (100, 100))


def drag(x, y):
    send(event.MotionNotify, X.PointerMotionMask, at=(200, 200))
    send(event.ButtonPress, X.ButtonPressMask, 1, (200, 200))
    for k in range(1, 9):
        send(event.MotionNotify, X.PointerMotionMask, at=(200 + int(x * k / 8), 200 + int(y * k / 8)))
    send(event.ButtonRelease, X.ButtonReleaseMask, 1, (200 + x, 200 + y))


def title():
    text = window.get_full_property(server.intern_atom("_NET_WM_NAME"), server.intern_atom("UTF8_STRING"))
    print(text.value.decode() if text else "")


def grab(path):
    size = window.get_geometry()
    shot = window.get_image(0, 0, size.width, size.height, X.ZPixmap, 0xffffffff).data    # blue, green, red, padding
    rgb = bytearray(3 * size.width * size.height)
    for channel in range(3):
        rgb[channel::3] = shot[2 - channel::4]
    with open(path, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (size.width, size.height) + rgb)


def message(kind, *values):
    data = [source.id, *values] + [0] * (4 - len(values))
    window.send_event(event.ClientMessage(window=window, client_type=server.intern_atom(kind), data=(32, data)))
    server.flush()


def drop(path):
    """Drops a file by the protocol XDND, version 5: answers the window's requests until it reports the end."""
    source.set_selection_owner(server.intern_atom("XdndSelection"), X.CurrentTime)
    message("XdndEnter", 5 << 24, server.intern_atom("text/uri-list"))
    message("XdndPosition", 0, 100 << 16 | 100, X.CurrentTime, server.intern_atom("XdndActionCopy"))
    message("XdndDrop", 0, X.CurrentTime)
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if not server.pending_events():
            select.select([server], [], [], 0.1)
            continue
        asked = server.next_event()
        if asked.type == X.ClientMessage and asked.client_type == server.intern_atom("XdndFinished"):
            return
        if asked.type == X.SelectionRequest:
            asked.requestor.change_property(asked.property, asked.target, 8, b"file://%s\r\n" % path.encode())
            asked.requestor.send_event(event.SelectionNotify(
                time=asked.time, requestor=asked.requestor, selection=asked.selection, target=asked.target,
                property=asked.property))
            server.flush()
    sys.exit("press: drop:%s: the window does not take it" % path)


for _ in range(200):
    window = shown(root)
    if window:
        break
    time.sleep(0.05)
else:
    sys.exit("press: no window")
for what in sys.argv[1:]:
    name, _, value = what.partition(":")
    numbers = [int(n) for n in re.findall(r"-?\d+", value)]
    if what == "wait":
        time.sleep(0.3)
    elif name == "size" and value:
        window.configure(width=numbers[0], height=numbers[1])
        server.flush()
    elif name in ("turn", "drag") and value:
        (turn if name == "turn" else drag)(*numbers)
    elif name in ("drop", "grab") and value:
        (drop if name == "drop" else grab)(value)
    elif what == "title":
        title()
    else:
        press(what)
server.sync()
