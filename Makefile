# ssgi: the library is ssgi.h and ssgi_gl.h; everything here is examples, tests and measuring.
#
#   make         everything, into build/          make chart   speed against accuracy, into report/
#   make demo    the main job, into report/       make glsl    the text of every pass, into build/glsl/
#   make test    all tests                        make clean

CFLAGS   ?= -O2 -g
WARNINGS  = -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion
EXR       = $(shell pkg-config --cflags OpenEXR 2>/dev/null || echo -I/usr/include/OpenEXR)
KIT_FLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) $(EXR) $(CFLAGS)
KIT_LIBS  = -lOpenEXRCore-3_1 -lOpenEXR-3_1 -lm -lpthread -ldl
KIT       = util image mesh scene light truth gl gbuffer shadow field method
KIT_O     = $(KIT:%=build/kit/%.o) build/kit/library.o
HEADERS   = ssgi.h ssgi_gl.h examples/kit/kit.h examples/kit/kit_gl.h

all: build/render build/report build/glsl-text build/minimal

# What is missing is installed where that can be done, else named in one line.
deps:
	@sh examples/kit/install.sh

build/kit/%.o: examples/kit/%.c $(HEADERS) | deps
	@mkdir -p $(@D)
	@echo '  cc $@'; $(CC) $(KIT_FLAGS) -c $< -o $@

build/kit/library.o: examples/kit/library.c ssgi.h ssgi_gl.h | deps
	@mkdir -p $(@D)
	@echo '  cc $@'; $(CC) -std=c99 $(WARNINGS) $(CFLAGS) -c $< -o $@

build/render: examples/render.c $(KIT_O)
	@echo '  cc $@'; $(CC) $(KIT_FLAGS) $< $(KIT_O) $(KIT_LIBS) -o $@

build/report: examples/report.c examples/page.c examples/lit.c examples/fields.c examples/deep.c $(KIT_O)
	@echo '  cc $@'; $(CC) $(KIT_FLAGS) $< $(KIT_O) $(KIT_LIBS) -o $@

build/glsl-text: examples/glsl.c $(KIT_O)
	@echo '  cc $@'; $(CC) $(KIT_FLAGS) $< $(KIT_O) $(KIT_LIBS) -o $@

build/minimal: examples/minimal.c ssgi.h ssgi_gl.h | deps
	@mkdir -p $(@D)
	@echo '  cc $@'; $(CC) -std=c11 -Wall -Wextra $(CFLAGS) $< -lOSMesa -lm -o $@

# The main job: a scanned mesh with every method beside the truth; report/demo.html.
demo: build/render build/report
	build/report demo

# Speed against accuracy; report/chart.html. make chart QUICK=1 is smaller.
chart: build/report
	build/report chart $(if $(QUICK),--quick)

# The text of every pass, dialect and feature choice, as plain files.
glsl: build/glsl-text
	build/glsl-text build/glsl

TESTS = main t test_math test_trace test_files test_text test_pipeline test_light test_vectors test_field test_casters test_surfels test_build
build/test: $(TESTS:%=tests/%.c) tests/t.h tests/frames.h $(KIT_O)
	@echo '  cc $@'; $(CC) $(KIT_FLAGS) $(TESTS:%=tests/%.c) $(KIT_O) $(KIT_LIBS) -o $@

# make test ONLY="math text" runs those groups.
test: build/render build/glsl-text build/test
	build/test $(ONLY)

clean:
	rm -rf build report

.PHONY: all demo test chart glsl deps clean
