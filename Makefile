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
KIT       = util image mesh scene truth gl gbuffer method
KIT_O     = $(KIT:%=build/kit/%.o) build/kit/library.o
HEADERS   = ssgi.h ssgi_gl.h examples/kit/kit.h examples/kit/kit_gl.h

all: deps build/render

# What is missing is installed where that can be done, else named in one line.
deps:
	@sh examples/kit/install.sh

build/kit/%.o: examples/kit/%.c $(HEADERS)
	@mkdir -p $(@D)
	$(CC) $(KIT_FLAGS) -c $< -o $@

build/kit/library.o: examples/kit/library.c ssgi.h ssgi_gl.h
	@mkdir -p $(@D)
	$(CC) -std=c99 $(WARNINGS) $(CFLAGS) -c $< -o $@

build/render: examples/render.c $(KIT_O)
	$(CC) $(KIT_FLAGS) $< $(KIT_O) $(KIT_LIBS) -o $@

clean:
	rm -rf build report

.PHONY: all deps clean
