/* page.c - pages that reach the disk whole, and the HTML that all of them share. Declared in page.h. */
#include "lab/page/page.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>page ------------------------------------------------------------------------------------------------------ */

int page_open(page *p, kit_error *err)
{
    p->text = NULL;
    p->file = open_memstream(&p->text, &p->size);
    return p->file ? 0 : kit_fail(err, "out of memory");
}

int page_close(page *p, const char *folder, const char *name, kit_error *err)
{
    char path[4096];
    int status = ferror(p->file);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (fclose(p->file) || status) status = kit_fail(err, "%s: out of memory", path);
    else status = kit_file_write(path, p->text, p->size, err);
    free(p->text);
    return status;
}

void page_into(page *p, FILE *f)
{
    fclose(p->file);
    fwrite(p->text, 1, p->size, f);
    free(p->text);
}

/* A command's first line, without its end; "" if there is none. */
static void line_of(char *out, int size, const char *command)
{
    FILE *f = popen(command, "r");
    if (!f || !fgets(out, size, f)) *out = 0;
    if (f) pclose(f);
    out[strcspn(out, "\n")] = 0;
}

int page_note(const char *folder, const char *name, const char *kind, const char *command, const char *driver,
              kit_error *err)
{
    char commit[64], changed[64], processor[128];
    page p;
    line_of(commit, sizeof commit, "git log -1 --format=%h 2>/dev/null");
    line_of(changed, sizeof changed, "git status --porcelain -- ssgi.h ssgi_gl.h examples/kit 2>/dev/null");
    line_of(processor, sizeof processor, "sed -n 's/^model name[^:]*: //p' /proc/cpuinfo");
    if (page_open(&p, err)) return -1;
    fprintf(p.file, "%s\n`%s`, commit %s%s, %ld cores (%s), %s\n", kind, command, *commit ? commit : "unknown",
            *changed ? " with changes" : "", sysconf(_SC_NPROCESSORS_ONLN), *processor ? processor : "unknown",
            driver);
    return page_close(&p, folder, name, err);
}

/* ---- >>html ------------------------------------------------------------------------------------------------------ */

void page_escaped(FILE *f, const char *s)
{
    for (; *s; ++s) {
        const char *entity = *s == '&'   ? "&amp;"
                             : *s == '<' ? "&lt;"
                             : *s == '>' ? "&gt;"
                             : *s == '"' ? "&quot;"
                                         : NULL;
        if (entity) fputs(entity, f); else fputc(*s, f);
    }
}

void page_head(FILE *f, const char *title, const char *about)
{
    fputs("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
          "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light "
          "dark\">\n<title>",
          f);
    page_escaped(f, title);
    fputs("</title>\n<style>\n"
          ":root { --ink: #1c1c1e; --faint: #62626a; --paper: #fbfbfa; --line: #dededb; --panel: #fff }\n"
          "@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e6; --faint: #a0a0a6; --paper: #17181a; --line: "
          "#35363a; --panel: #202124 } }\n"
          "* { box-sizing: border-box }\n"
          "body { margin: 0 auto; padding: 2rem clamp(1rem, 3vw, 3rem) 4rem; max-width: 1680px; color: var(--ink); "
          "background: var(--paper); font: 16px/1.5 system-ui, -apple-system, 'Segoe UI', sans-serif }\n"
          "h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .4rem } h2 { font-size: 1.15rem; margin: 2.4rem 0 "
          ".8rem } h3 { font-size: 1rem; margin: 1.6rem 0 .6rem }\n"
          "p, dl { max-width: 76ch; margin: .4rem 0 } dt { font-weight: 600; margin-top: .6rem } dd { margin: 0 } "
          ".faint, figcaption span, dd { color: var(--faint) }\n"
          ".grid { display: grid; gap: 1.4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr)) "
          "}\n"
          ".crops { grid-template-columns: repeat(auto-fit, minmax(min(100%, 260px), 1fr)); margin-top: 1.4rem }\n"
          ".thumbs { grid-template-columns: repeat(auto-fit, minmax(min(100%, 200px), 1fr)); gap: .8rem; max-width: "
          "900px; margin: .8rem 0 } .thumbs figure { align-self: end } .thumbs figcaption, .thumbs figcaption span { "
          "display: block; font-size: .85rem; overflow-wrap: anywhere }\n"
          ".charts { display: grid; gap: 1.4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 600px), "
          "1fr)) } svg { display: block; width: 100%; height: auto; max-width: 900px }\n"
          "figure { margin: 0 } figcaption { margin: 0 0 .35rem; display: flex; justify-content: space-between; gap: "
          "1rem } figcaption span { font-variant-numeric: tabular-nums }\n"
          "img { display: block; width: 100%; height: auto; border: 1px solid var(--line) } img + img, a + a img { "
          "border-top: 0 }\n"
          ".key { padding: 1rem 0 } .key img { height: 18px } .key div { display: flex; justify-content: "
          "space-between; font-size: .85rem; color: var(--faint) }\n"
          ".wide { overflow-x: auto } table { border-collapse: collapse; font-variant-numeric: tabular-nums; "
          "font-size: .92rem; background: var(--panel) }\n"
          "th, td { padding: .3rem .8rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap "
          "} th { color: var(--faint); font-weight: 500 } .first td { border-top: 2px solid var(--line) }\n"
          "th:nth-child(-n+2), td:nth-child(-n+2) { text-align: left } code { font: .88em ui-monospace, Menlo, "
          "Consolas, monospace } summary { cursor: pointer; padding: .3rem 0 }\n"
          "</style>\n<h1>",
          f);
    page_escaped(f, title);
    fputs("</h1>\n<p>", f);
    page_escaped(f, about);
    fputs("</p>\n", f);
}

void page_figure(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference)
{
    fprintf(f, "<figure><figcaption><b>%s</b><span>%s</span></figcaption>", label, note);
    for (int k = 0; k <= difference; ++k)
        fprintf(f, "<a href=\"%s%s.png\"><img src=\"%s%s.png\" width=\"%d\" height=\"%d\" alt=\"%s%s\"></a>", slug,
                k ? "-difference" : "", slug, k ? "-difference" : "", width, height, k ? "difference of " : "", label);
}

void page_key(FILE *f, double range)
{
    fprintf(f,
            "<div class=\"key\"><img src=\"difference-legend.png\" alt=\"blue over white to red\"><div><span>&minus;%g "
            "too dark</span><span>0</span><span>too bright +%g</span></div>"
            "<p class=\"faint\">Under each picture: its difference to the truth, in these colours.</p></div>",
            range, range);
}
