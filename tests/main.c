/* main.c - runs all tests; the last line is "N passed, N failed". Arguments name the groups to run, none = all. */
#include <string.h>
#include "t.h"

extern int t_passed, t_failed;

int main(int argc, char **argv)
{
    static const struct { const char *name; void (*run)(void); } groups[] = {
        { "math", test_math }, { "trace", test_trace }, { "files", test_files }, { "text", test_text }, { "pipeline", test_pipeline }, { "light", test_light }, { "vectors", test_vectors }, { "field", test_field }, { "casters", test_casters }, { "surfels", test_surfels }, { "plan", test_plan }, { "stability", test_stability }, { "build", test_build }
    };
    for (size_t g = 0; g < sizeof groups / sizeof groups[0]; ++g) {
        int wanted = argc < 2;
        for (int i = 1; i < argc; ++i) wanted |= !strcmp(argv[i], groups[g].name);
        if (!wanted) continue;
        printf("%s\n", groups[g].name);
        groups[g].run();
    }
    printf("%d passed, %d failed\n", t_passed, t_failed);
    return t_failed != 0;
}
