/* chains.c - the chains whose shaders are written, counted and checked, and their steps. Declared in chains.h. */
#include "tools/glsl/chains.h"
#include <stdio.h>
#include <string.h>

/* Chains with settings that differ from the library's methods, so that each kind of step is among them. */
static const char *const variations[] = {
    "hsao-fast,history=1", "hsao-best,history=1", "hsao-fast,thickness=SLABS", "hsao-history,thickness=SLABS",
    "hsao,thickness=SLABS", "hsao-best,thickness=SLABS", "hsao,thickness=BACK", "hsao,depth=LINEAR",
    "hsao,normal=FROM_DEPTH", "ssdo-fast,bounce=NONE", "ssdo,bounce=NONE", "ssdo-best,bounce=NONE",
    "ssdo,bounce=NONE,thickness=SLABS", "ssdo-best,bounce=NONE,thickness=SLABS", "ssdo,bounce=NONE,history=1",
    "ssdo,bounce=NONE,environment=SH,residual=1", "ssdo,reuse=1", "ssdo,lights.shadow=FILL",
    "ssdo-points,bounce=NONE", "s3ho-fast,transfer=DIRECT,packed_coefficients=0,restore=RATIO",
    "s3ho,transfer=DIRECT,packed_coefficients=0,restore=RATIO",
    "s3ho-best,transfer=DIRECT,packed_coefficients=0,restore=RATIO",
    "s3ho,transfer=DIRECT,shaded=0,restore=NONE,coefficients=1", "dss-best,span=0",
    "dss,effect=LIGHT,environment=MAP", "dss-lit,hidden_sky=1"
};
enum { VARIATIONS = (int)(sizeof variations / sizeof *variations) };

const char *chain_at(int i)
{
    const ssgi_gl_method *method = ssgi_gl_method_at(i);
    int methods = 0;
    if (method) return method->name;
    while (ssgi_gl_method_at(methods)) ++methods;
    return i >= methods && i - methods < VARIATIONS ? variations[i - methods] : NULL;
}

const char *chain_about(const char *name)
{
    const ssgi_gl_method *method;
    for (int i = 0; (method = ssgi_gl_method_at(i)) != NULL; ++i)
        if (!strcmp(method->name, name)) return method->sentence;
    return "";
}

int chain_parse(ssgi_gl_chain *chain, const char *text, int dialect, kit_error *err)
{
    const char *why = "";
    char in[4096];                              /* not every dialect has every value of a field */
    const int n = snprintf(in, sizeof in, "%s,dialect=%d", text, dialect);
    if (n >= (int)sizeof in - 32) return kit_fail(err, "--chain: a chain of %d characters is too long", n);
    if (strstr(text, "lights.")) snprintf(in + n, sizeof in - (size_t)n, ",lights.dialect=%d", dialect);
    if (ssgi_gl_chain_of(chain, in, &why) != SSGI_OK) return kit_fail(err, "--chain %s: %s", text, why);
    chain->width = chain->height = 1;
    return 0;
}

int chain_steps(ssgi_gl_step steps[MOST_STEPS], const ssgi_gl_chain *chain, int dialect, kit_error *err)
{
    ssgi_gl_chain c = *chain;
    const char *why = "";
    c.desc.shader.dialect = c.lights.shader.dialect = dialect;
    const int count = ssgi_gl_steps(NULL, 0, &c, &why);
    if (!count) return kit_fail(err, "%s", why), 0;
    if (count > MOST_STEPS) return kit_fail(err, "it has more than %d steps", MOST_STEPS), 0;
    return ssgi_gl_steps(steps, MOST_STEPS, &c, &why);
}
