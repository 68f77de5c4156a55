/* press.c - presses keys in a program's window and drops files on it, as a user would; for viewer.sh. It needs an X
   server, and the window alone there.

      build/press KEY ..           X's names of keys: m M bracketleft; title: prints the window's; drop:/a/file: drops
                                   it; turn:N: the wheel; drag:X,Y: with the left button; size:WxH: of the window;
                                   grab:F.ppm: what the window shows; wait: 0.3 seconds */
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static Display *display;
static Window window, source;

static void wait_ms(int ms)
{
    const struct timespec t = { ms / 1000, ms % 1000 * 1000000L };
    nanosleep(&t, NULL);
}

/* What a window takes for two presses of a key has two times. */
static Time now(void)
{
    struct timespec t;
    wait_ms(2);
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (Time)(t.tv_sec * 1000 + t.tv_nsec / 1000000);
}

static Atom atom(const char *name) { return XInternAtom(display, name, False); }

/* The window that is shown and has a name. */
static Window shown(Window below)
{
    Window root, parent, *children = NULL, found = 0;
    unsigned count = 0;
    XWindowAttributes is;
    char *name = NULL;
    if (XFetchName(display, below, &name) && XGetWindowAttributes(display, below, &is) && is.map_state == IsViewable)
        found = below;
    if (name) XFree(name);
    if (found || !XQueryTree(display, below, &root, &parent, &children, &count)) return found;
    for (unsigned i = 0; i < count && !found; ++i) found = shown(children[i]);
    if (children) XFree(children);
    return found;
}

static void send(XEvent *e, long mask)
{
    XSendEvent(display, window, False, mask, e);
    XFlush(display);
}

static int press(const char *name)
{
    const KeySym key = XStringToKeysym(name);
    const int shift = strlen(name) == 1 && *name >= 'A' && *name <= 'Z';
    XEvent e;
    if (key == NoSymbol) return -1;
    for (int up = 0; up < 2; ++up) {
        memset(&e, 0, sizeof e);
        e.xkey.type = up ? KeyRelease : KeyPress;
        e.xkey.display = display;
        e.xkey.window = window;
        e.xkey.root = DefaultRootWindow(display);
        e.xkey.same_screen = True;
        e.xkey.keycode = XKeysymToKeycode(display, key);
        e.xkey.state = shift ? ShiftMask : 0;
        e.xkey.time = now();
        send(&e, up ? KeyReleaseMask : KeyPressMask);
    }
    return 0;
}

static void button(unsigned number, int x, int y, int up)
{
    XEvent e;
    memset(&e, 0, sizeof e);
    e.xbutton.type = up ? ButtonRelease : ButtonPress;
    e.xbutton.display = display;
    e.xbutton.window = window;
    e.xbutton.root = DefaultRootWindow(display);
    e.xbutton.same_screen = True;
    e.xbutton.x = x;
    e.xbutton.y = y;
    e.xbutton.button = number;
    send(&e, up ? ButtonReleaseMask : ButtonPressMask);
}

static void motion(int x, int y)
{
    XEvent e;
    memset(&e, 0, sizeof e);
    e.xmotion.type = MotionNotify;
    e.xmotion.display = display;
    e.xmotion.window = window;
    e.xmotion.root = DefaultRootWindow(display);
    e.xmotion.same_screen = True;
    e.xmotion.x = x;
    e.xmotion.y = y;
    send(&e, PointerMotionMask);
}

static void drag(int x, int y)
{
    motion(200, 200);
    button(1, 200, 200, 0);
    for (int k = 1; k <= 8; ++k) motion(200 + x * k / 8, 200 + y * k / 8);
    button(1, 200 + x, 200 + y, 1);
}

static void title(void)
{
    Atom type;
    int format;
    unsigned long count, left;
    unsigned char *text = NULL;
    XGetWindowProperty(display, window, atom("_NET_WM_NAME"), 0, 1000, False, atom("UTF8_STRING"), &type, &format,
                       &count, &left, &text);
    puts(text ? (char *)text : "");
    if (text) XFree(text);
}

/* ---- >>drop: the protocol XDND, version 5 ------------------------------------------------------------------------ */

static void message(const char *type, long b, long c, long d, long e)
{
    XEvent m;
    memset(&m, 0, sizeof m);
    m.xclient.type = ClientMessage;
    m.xclient.display = display;
    m.xclient.window = window;
    m.xclient.message_type = atom(type);
    m.xclient.format = 32;
    m.xclient.data.l[0] = (long)source;
    m.xclient.data.l[1] = b;
    m.xclient.data.l[2] = c;
    m.xclient.data.l[3] = d;
    m.xclient.data.l[4] = e;
    send(&m, NoEventMask);
}

/* Answers what the window asks until it says that it is done. */
static int serve(const char *uri)
{
    for (int tries = 0; tries < 600;) {
        XEvent e;
        struct pollfd ready = { ConnectionNumber(display), POLLIN, 0 };
        if (!XPending(display)) {
            ++tries;
            poll(&ready, 1, 100);
            continue;
        }
        XNextEvent(display, &e);
        if (e.type == ClientMessage && e.xclient.message_type == atom("XdndFinished")) return 0;
        if (e.type != SelectionRequest) continue;
        XEvent answer;
        memset(&answer, 0, sizeof answer);
        answer.xselection.type = SelectionNotify;
        answer.xselection.display = display;
        answer.xselection.requestor = e.xselectionrequest.requestor;
        answer.xselection.selection = e.xselectionrequest.selection;
        answer.xselection.target = e.xselectionrequest.target;
        answer.xselection.property = e.xselectionrequest.property;
        answer.xselection.time = e.xselectionrequest.time;
        XChangeProperty(display, e.xselectionrequest.requestor, e.xselectionrequest.property,
                        e.xselectionrequest.target, 8, PropModeReplace, (const unsigned char *)uri, (int)strlen(uri));
        XSendEvent(display, e.xselectionrequest.requestor, False, NoEventMask, &answer);
        XFlush(display);
    }
    return -1;
}

static int drop(const char *path)
{
    char uri[5000];
    snprintf(uri, sizeof uri, "file://%s\r\n", path);
    XSetSelectionOwner(display, atom("XdndSelection"), source, CurrentTime);
    message("XdndEnter", 5L << 24, (long)atom("text/uri-list"), 0, 0);
    message("XdndPosition", 0, 100L << 16 | 100, CurrentTime, (long)atom("XdndActionCopy"));
    message("XdndDrop", 0, CurrentTime, 0, 0);
    return serve(uri);
}

static int grab(const char *path)
{
    XWindowAttributes is;
    FILE *f = fopen(path, "wb");
    XImage *image = NULL;
    if (f && XGetWindowAttributes(display, window, &is))
        image = XGetImage(display, window, 0, 0, (unsigned)is.width, (unsigned)is.height, AllPlanes, ZPixmap);
    if (image) fprintf(f, "P6\n%d %d\n255\n", is.width, is.height);
    for (int i = 0; image && i < is.width * is.height; ++i) {
        const unsigned long p = XGetPixel(image, i % is.width, i / is.width);
        fputc((int)(p >> 16 & 255), f);
        fputc((int)(p >> 8 & 255), f);
        fputc((int)(p & 255), f);
    }
    const int failed = !f || !image || fclose(f);
    if (image) XDestroyImage(image);
    return failed ? -1 : 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int do_one(const char *what)
{
    int x, y;
    if (!strcmp(what, "wait")) {
        wait_ms(300);
        return 0;
    }
    if (!strcmp(what, "title")) {
        title();
        return 0;
    }
    if (!strncmp(what, "drop:", 5)) return drop(what + 5);
    if (!strncmp(what, "grab:", 5)) return grab(what + 5);
    if (sscanf(what, "turn:%d", &x) == 1) {
        for (int k = 0; k < abs(x); ++k) button(x > 0 ? 4 : 5, 100, 100, 0);
        return 0;
    }
    if (sscanf(what, "drag:%d,%d", &x, &y) == 2) {
        drag(x, y);
        return 0;
    }
    if (sscanf(what, "size:%dx%d", &x, &y) == 2) {
        XResizeWindow(display, window, (unsigned)x, (unsigned)y);
        XFlush(display);
        return 0;
    }
    return press(what);
}

int main(int argc, char **argv)
{
    display = XOpenDisplay(NULL);
    if (!display) {
        fputs("press: no display\n", stderr);
        return 2;
    }
    for (int k = 0; k < 200 && !(window = shown(DefaultRootWindow(display))); ++k) wait_ms(50);
    if (!window) {
        fputs("press: no window\n", stderr);
        return 2;
    }
    source = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    for (int i = 1; i < argc; ++i)
        if (do_one(argv[i])) {
            fprintf(stderr, "press: %s: cannot be done\n", argv[i]);
            return 2;
        }
    XSync(display, False);
    XCloseDisplay(display);
    return 0;
}
