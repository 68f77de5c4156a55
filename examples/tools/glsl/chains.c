/* chains.c - whole chains by name, and as one writes them. Declared in chains.h. */
#include "tools/glsl/chains.h"
#include <stdlib.h>
#include <string.h>

const chain_named chain_names[] = {
    { "ssao", "ssao,balanced", "ambient visibility by points" },
    { "hsao-fast", "hsao,fast", "ambient visibility by slices" },
    { "hsao", "hsao,balanced", "ambient visibility by slices" },
    { "hsao-best", "hsao,best", "ambient visibility by slices" },
    { "hsao-quarter", "hsao,fast,half=QUARTER,directions=2,steps=8", "at a quarter of the size, for weak GPUs" },
    { "hsao-fast-history", "hsao,fast,history=1", "over frames" },
    { "hsao-history", "hsao,balanced,history=1,directions=1,steps=12", "over frames: one slice of many taps" },
    { "hsao-best-history", "hsao,best,history=1", "over frames" },
    { "hsao-fast-slabs", "hsao,fast,thickness=SLABS", "two slabs behind what is seen" },
    { "hsao-history-slabs", "hsao,balanced,history=1,directions=1,steps=12,thickness=SLABS",
      "two slabs, over frames" },
    { "hsao-slabs", "hsao,balanced,thickness=SLABS", "two slabs behind what is seen" },
    { "hsao-best-slabs", "hsao,best,thickness=SLABS", "two slabs behind what is seen" },
    { "hsao-back", "hsao,balanced,thickness=BACK", "one slab behind what is seen" },
    { "hsao-linear", "hsao,balanced,depth=LINEAR", "from view depth" },
    { "hsao-depth", "hsao,balanced,normal=FROM_DEPTH", "without normals" },
    { "hsao-march", "hsao,balanced,search=MARCH", "the published march" },
    { "ssdo-fast", "ssdo,fast,environment=MAP", "light of an environment" },
    { "ssdo", "ssdo,balanced,environment=MAP", "light of an environment" },
    { "ssdo-best", "ssdo,best,environment=MAP", "light of an environment" },
    { "ssdo-slabs", "ssdo,balanced,environment=MAP,thickness=SLABS", "light of an environment, two slabs" },
    { "ssdo-best-slabs", "ssdo,best,environment=MAP,thickness=SLABS", "light of an environment, two slabs" },
    { "ssdo-history", "ssdo,balanced,environment=MAP,history=1", "light of an environment, over frames" },
    { "ssdo-sh", "ssdo,balanced,environment=SH,residual=1", "light as harmonics" },
    { "ssdo-bounce", "ssdo,balanced,environment=MAP,bounce=SOLID_ANGLE", "light of an environment, one bounce of it" },
    { "ssdo-bounce-reuse", "ssdo,balanced,environment=MAP,bounce=SOLID_ANGLE,reuse=1", "the same in one gather" },
    { "ssdo-lights", "ssdo,balanced,environment=MAP,bounce=SOLID_ANGLE,lights.shadow=FILL",
      "environment, lights with shadow maps, one bounce" },
    { "ssdo-points", "ssdo,balanced,environment=MAP,search=POINTS", "the published points" },
    { "s3ho-fast", "s3ho,fast,shaded=1,residual=1,restore=RATIO", "light as harmonics" },
    { "s3ho", "s3ho,balanced,shaded=1,residual=1,restore=RATIO", "light as harmonics" },
    { "s3ho-best", "s3ho,best,shaded=1,residual=1,restore=RATIO", "light as harmonics" },
    { "s3ho-bounce", "s3ho,balanced,shaded=1,transfer=BOTH,packed=1,restore=DIFFERENCE", "light and one bounce of it" },
    { "s3ho-coefficients", "s3ho,balanced,packed=1,residual=1,coefficients=1", "coefficients, filtered, then shaded" },
    { "ssbn", "s3ho,balanced,bands=2,shading=BENT_CONE", "bent normals and cones" },
    { "aof", "field", "occlusion by baked fields" },
    { "dss-fast", "splat,fast,span=6", "occlusion by surfels, near ones by slices" },
    { "dss", "splat,balanced,span=6", "occlusion by surfels, near ones by slices" },
    { "dss-best", "splat,best,span=6", "occlusion by surfels, near ones by slices" },
    { "dss-alone", "splat", "occlusion by surfels alone" },
    { "dss-light", "splat,balanced,span=6,effect=LIGHT,environment=MAP", "light of an environment" },
    { "dss-lit", "splat,balanced,span=6,effect=LIGHT,environment=MAP,bounce=SOLID_ANGLE,surfels=1,sends=LIGHTS,"
                 "hidden_sky=1,lights.shadow=MAP",
      "environment, lights, one bounce; surfels lit by transform feedback" },
    { "dss-gloss", "splat,best,effect=SPECULAR,levels=5,near_samples=4", "specular bounce" },
    { "dss-scatter", "splat,best,effect=SCATTER,levels=7", "light under the surface" },
};
const int chain_names_count = (int)(sizeof chain_names / sizeof chain_names[0]);

/* ---- members of a chain ------------------------------------------------------------------------------------------ */

static const struct { const char *name; size_t offset; int most;
} members[] = { { "blur", offsetof(ssgi_gl_chain, blur), 1 },
                { "history", offsetof(ssgi_gl_chain, history), 1 },
                { "coefficients", offsetof(ssgi_gl_chain, coefficients), 1 },
                { "unsmoothed", offsetof(ssgi_gl_chain, unsmoothed), 1 },
                { "reuse", offsetof(ssgi_gl_chain, reuse), 1 },
                { "bounced", offsetof(ssgi_gl_chain, bounced), 1 },
                { "vpls", offsetof(ssgi_gl_chain, vpls), 1 },
                { "direct", offsetof(ssgi_gl_chain, direct), 1 },
                { "surfels", offsetof(ssgi_gl_chain, surfels), 1 },
                { "hidden_sky", offsetof(ssgi_gl_chain, hidden_sky), 1 },
                { "precise", offsetof(ssgi_gl_chain, precise), 2 },
                { "rgba8", offsetof(ssgi_gl_chain, rgba8), 1 } };
enum { MEMBERS = (int)(sizeof members / sizeof members[0]) };

const char *chain_member(const ssgi_gl_chain *chain, int i, int *value)
{
    if (i >= MEMBERS) return NULL;
    memcpy(value, (const char *)chain + members[i].offset, sizeof *value);
    return members[i].name;
}

/* ---- as one writes them ------------------------------------------------------------------------------------------ */

static int same_word(const char *word, const char *text, size_t length)
{
    return strlen(word) == length && !memcmp(word, text, length);
}

/* The number that a value stands for: a whole number, or one of the words; -1: none of these. */
static int value_of(const char *words, const char *text)
{
    const size_t n = strlen(text);
    char *end;
    int k = 0;
    for (; *words; ++k) {
        const size_t length = strcspn(words, " ");
        if (length == n && !memcmp(words, text, n)) return k;
        words += length + (words[length] == ' ');
    }
    const long number = strtol(text, &end, 10);
    return !n || *end || number < 0 || number > 1 << 20 ? -1 : (int)number;
}

static int set_field(ssgi_gl_desc *d, const char *chain, const char *name, size_t length, const char *value,
                     kit_error *err)
{
    const ssgi_gl_choice *c;
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        if (!same_word(c->name, name, length) || !i) continue;              /* the pass is the first word */
        const int v = value_of(c->values, value);
        if (v < 0 || v > c->most) return kit_fail(err, "--chain %s: %s", chain, c->sentence);
        memcpy((char *)d + c->offset, &v, sizeof v);
        return 0;
    }
    return kit_fail(err, "--chain %s: %.*s: is neither a field of ssgi_gl_desc nor a member of ssgi_gl_chain", chain,
                    (int)length, name);
}

/* NAME=VALUE. */
static int set(ssgi_gl_chain *to, const char *chain, const char *item, kit_error *err)
{
    static const char lights[] = "lights.";
    const size_t length = strcspn(item, "="), prefix = sizeof lights - 1;
    const char *value = item + length + 1;
    if (!item[length])
        return kit_fail(err, "--chain %s: %s: must be FIELD=VALUE (a preset comes second)", chain, item);
    for (int i = 0; i < MEMBERS; ++i) {
        if (!same_word(members[i].name, item, length)) continue;
        const int v = value_of("", value);
        if (v < 0 || v > members[i].most)
            return kit_fail(err, "--chain %s: %s: must be 0..%d", chain, members[i].name, members[i].most);
        memcpy((char *)to + members[i].offset, &v, sizeof v);
        return 0;
    }
    if (!strncmp(item, lights, prefix)) {
        to->lights.pass = SSGI_GL_PASS_LIGHTS;
        return set_field(&to->lights, chain, item + prefix, length - prefix, value, err);
    }
    if (same_word("lights", item, length) && to->desc.pass != SSGI_GL_PASS_S3HO) {
        to->lights.pass = value_of("", value) == 1 ? SSGI_GL_PASS_LIGHTS : 0;
        return 0;
    }
    return set_field(&to->desc, chain, item, length, value, err);
}

/* The first word, which names a pass. */
static int pass_of(const char *word)
{
    int pass = 0;
    while (ssgi_gl_pass_name(pass) && strcmp(ssgi_gl_pass_name(pass), word)) ++pass;
    return ssgi_gl_pass_name(pass) ? pass : -1;
}

static int preset_of(const char *word)
{
    static const char *const presets[] = { "fast", "balanced", "best" };
    for (int i = 0; i < 3; ++i) if (!strcmp(word, presets[i])) return i;
    return -1;
}

/* Every FIELD=VALUE of a list with commas between. */
static int set_all(ssgi_gl_chain *to, const char *chain, const char *items, kit_error *err)
{
    while (*items) {
        char item[128];
        const size_t length = strcspn(items, ",");
        if (length >= sizeof item) return kit_fail(err, "--chain %s: %.*s: is too long", chain, (int)length, items);
        memcpy(item, items, length);
        item[length] = 0;
        if (set(to, chain, item, err)) return -1;
        items += length + (items[length] == ',');
    }
    return 0;
}

/* The next word before a comma, which *items moves behind where it is the name of something: at(word) >= 0. */
static int take_word(const char **items, int (*at)(const char *))
{
    char word[32] = "";
    const size_t length = strcspn(*items, ",");
    if (length < sizeof word) memcpy(word, *items, length);
    const int number = at(word);
    if (number >= 0) *items += length + ((*items)[length] == ',');
    return number;
}

int chain_parse(ssgi_gl_chain *chain, const char *text, kit_error *err)
{
    ssgi_gl_chain c;
    const char *items = text, *why = "";
    for (int i = 0; i < chain_names_count; ++i) if (!strcmp(chain_names[i].name, text)) items = chain_names[i].means;
    memset(&c, 0, sizeof c);
    c.width = c.height = c.blur = 1;
    c.desc.pass = take_word(&items, pass_of);
    if (c.desc.pass < 0)
        return kit_fail(err, "--chain %s: must begin with ssao, hsao, ssdo, s3ho, field or splat, or be a name that "
                             "--chains lists", text);
    const int preset = take_word(&items, preset_of);
    if (set_all(&c, text, items, err)) return -1;
    if (c.desc.pass == SSGI_GL_PASS_SSDO && !c.desc.light.environment && !c.desc.light.bounce)
        c.desc.light.environment = SSGI_GL_ENVIRONMENT_MAP;
    if (preset < 0) { *chain = c; return 0; }
    if (ssgi_gl_preset(&c.desc, preset, &why) != SSGI_OK || ssgi_gl_preset(&c.lights, preset, &why) != SSGI_OK)
        return kit_fail(err, "--chain %s: %s", text, why);
    if (c.lights.pass != SSGI_GL_PASS_LIGHTS) memset(&c.lights, 0, sizeof c.lights);
    if (set_all(&c, text, items, err)) return -1;           /* what is given stands over what the preset sets */
    *chain = c;
    return 0;
}

int chain_steps(ssgi_gl_step steps[MOST_STEPS], const ssgi_gl_chain *chain, int dialect, kit_error *err)
{
    ssgi_gl_chain c = *chain;
    const char *why = "";
    c.desc.text.dialect = c.lights.text.dialect = dialect;
    const int count = ssgi_gl_steps(NULL, 0, &c, &why);
    if (!count) return kit_fail(err, "%s", why), 0;
    if (count > MOST_STEPS) return kit_fail(err, "it has more than %d steps", MOST_STEPS), 0;
    return ssgi_gl_steps(steps, MOST_STEPS, &c, &why);
}
