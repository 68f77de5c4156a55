# ssgi: the library is ssgi.h and ssgi_gl.h; everything here is for examples, tests and measurements.
#
#  make            everything that the kit draws with, into build/
#  make test       the library's tests; test-all: also those of examples, page, hosts, Vulkan, viewer
#  make demo       the main example, into report/; chart, stability, papers, quiet, peers: measurements
#  make viewer     a window; web: a page in build/web/; hosts-test, vulkan: the library in other programs
#  make glsl       the shaders of every pass; wasm, npm: the headers for JavaScript; install: for pkg-config and
#                  CMake; shared: one library with all functions, for other languages
#
# All targets are below, each with its purpose; those for editors of the headers are in examples/docs/CONTRIBUTING.md.

CFLAGS   ?= -O2 -g
WARNINGS  = -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion
EXR       = $(shell pkg-config --cflags OpenEXR 2>/dev/null || echo -I/usr/include/OpenEXR)
KIT_FLAGS = -std=c11 -D_GNU_SOURCE -ffp-contract=off -Iexamples -Itests -Ibuild/include $(WARNINGS) $(EXR) $(CFLAGS)
KIT_LIBS  = -lOpenEXRCore-3_1 -lz -lm -lpthread -ldl \
            -Wl,--as-needed $(shell pkg-config --libs assimp 2>/dev/null)
# The files of a folder that match, without their ending.
all_of    = $(patsubst $(1)/%.c,%,$(wildcard $(addprefix $(1)/,$(2))))
# The kit's rooms; make tree proves that none call each other in a circle.
KIT_BASE  = $(filter-out library%,$(call all_of,examples/kit,*.c))
KIT       = $(KIT_BASE) $(call all_of,examples/kit,$(addsuffix /*.c,scene scene/tables trace gl run))
LIBRARY   = library.o library_gl.o
KIT_O     = $(KIT:%=build/kit/%.o) $(LIBRARY:%=build/kit/%)

# These targets are built by as many processes as there are processors, unless -j says otherwise.
ifneq ($(filter all demo test,$(or $(MAKECMDGOALS),all)),)
ifeq ($(filter -j% --jobs%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell nproc 2>/dev/null || echo 1)
endif
endif

all: build/render build/report build/stability build/glsl-text build/minimal

# Missing packages are installed if that is possible, else named in one line.
deps:
	@sh examples/kit/install.sh
# Installs packages if a program is missing, or fails. arguments: the program, packages, a target, what is missing
needs = command -v $(1) >/dev/null || sh examples/kit/install.sh $(2) || \
        { echo '$(3): $(or $(4),$(1)) is missing (apt-get install $(2))' >&2; exit 2; }
# Ends a test with a line that names the missing ones of these programs. arguments: these, how others are looked for
skips = lacks=; for p in $(1); do command -v $$p >/dev/null || lacks="$$lacks $$p"; done; $(2) \
        test -z "$$lacks" || { echo "skipped: everything: no$$lacks"; echo '0 passed, 0 failed'; exit 0; }

# Copies of the headers without their implementations, for all files that only call them. An edit of an implementation
# leaves the copies unchanged, so make only compiles files that include the whole ../ssgi_gl.h: library_gl.c and the
# tests with own.h. Compilers still name the true files. The + makes the copies under make -n, too, which is then
# correct.
DECLARED = build/include/ssgi.h build/include/ssgi_gl.h
$(DECLARED): build/include/%.h: %.h Makefile
	+@mkdir -p $(@D); { echo '#line 1 "$<"'; sed '/END OF HEADER/q' $<; } >$@.$$$$ && \
	  if cmp -s $@.$$$$ $@; then rm $@.$$$$; else mv $@.$$$$ $@; fi

# The compiler writes beside each object a list of the files that it read (-MMD; with -MP a listed file may be deleted).
# An object without a list, made by an older Makefile, is made again. Tests are compiled by -O1: in two thirds of the
# time, and they run as fast.
compile   = @mkdir -p $(@D); echo '  cc $@'; $(CC) $(1) -MMD -MP -c $< -o $@
FLAGS_sanitized = $(KIT_FLAGS) -O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer
FLAGS_threads   = $(KIT_FLAGS) -O1 -fsanitize=thread
MADE     := $(shell find build/kit build/examples build/tests build/sanitized build/threads -name '*.[do]' 2>/dev/null)
LISTS    := $(filter %.d,$(MADE))
-include $(LISTS)
$(filter-out $(LISTS:.d=.o),$(filter %.o,$(MADE))): unlisted
# arguments: the folder of objects, the folder of sources, flags
define objects
$(1)/%.o: $(2)/%.c | deps $(DECLARED)
	$$(call compile,$(3))
endef
$(eval $(call objects,build/kit,examples/kit,$$(KIT_FLAGS)))
$(eval $(call objects,build/examples,examples,$$(KIT_FLAGS)))
$(eval $(call objects,build/tests,tests,$$(KIT_FLAGS:-O2=-O1)))
$(foreach way,sanitized threads,$(eval $(call objects,build/$(way),examples/kit,$$(FLAGS_$(way)))) \
  $(eval $(call objects,build/$(way)/examples,examples,$$(FLAGS_$(way)))))
$(eval $(call objects,build/sanitized/tests,tests,$$(FLAGS_sanitized)))
$(LIBRARY:%=build/kit/%): build/kit/%.o: examples/kit/%.c | deps $(DECLARED)
	$(call compile,-std=c99 $(WARNINGS) $(CFLAGS))

# Models are read by Assimp if it can be had; make installs it once if it can, else glTF and other formats are refused
# in one line. Only this file depends on it: it is compiled again when Assimp was installed or removed.
build/%/scene/assimp.o: KIT_FLAGS += $(shell pkg-config --exists assimp 2>/dev/null && echo -DKIT_ASSIMP)
build/kit/scene/assimp.o build/sanitized/scene/assimp.o build/threads/scene/assimp.o: build/assimp
build/assimp: deps
	@mkdir -p $(@D)
	@test -s $@ || pkg-config --exists assimp || sh examples/kit/install.sh libassimp-dev || true
	@version=$$(pkg-config --modversion assimp 2>/dev/null || echo none); \
	  test "$$version" = "$$(cat $@ 2>/dev/null)" || echo "$$version" >$@

# Programs made of the kit and of the files that are named here, under examples/.
examples_of   = $(call all_of,examples,$(addsuffix /*.c,$(1)))
LAB           = $(call examples_of,lab/measure lab/page)
OF_render     = $(call examples_of,tools/render)
OF_report     = lab/report $(LAB) $(call examples_of,lab/chart lab/papers)
OF_stability  = $(LAB) $(call examples_of,lab/stability)
OF_bench      = $(LAB) $(call examples_of,lab/bench)
# Compares settings on scenes by seed, to tune them: build/try hsao hsao:samples=12.
OF_try        = lab/try $(LAB)
# Interreflection and glossy lobes, the light that ambient visibility dims, beside their ground truth.
OF_reflection = lab/reflection $(LAB)
OF_quiet      = $(LAB) $(call examples_of,lab/quiet)
OF_against    = $(LAB) $(call examples_of,lab/against)
OF_cost       = tools/glsl/chains $(LAB) $(call examples_of,lab/cost lab/chart lab/papers)
GLSL          = $(addprefix tools/glsl/,choices chains manifest)
OF_glsl-text  = tools/glsl/glsl $(GLSL)
OF_web-scenes = web/scenes
KITS          = render report stability bench try reflection quiet against cost glsl-text web-scenes
$(foreach p,$(KITS),$(eval build/$(p): $(OF_$(p):%=build/examples/%.o)))
# A method's chain with its inputs and its picture, for tests that draw it by another API.
build/capture: build/tests/examples/capture.o $(GLSL:%=build/examples/%.o)
$(KITS:%=build/%) build/capture build/test build/test-examples build/viewer: $(KIT_O)

# build/render under sanitizers, for make test: it draws with each method once.
SANITIZED = $(KIT:%=build/sanitized/%.o) $(LIBRARY:%=build/sanitized/%)
build/render-sanitized: $(SANITIZED) $(OF_render:%=build/sanitized/examples/%.o)

# Programs of objects, those above and below. LIBS_NAME is what else build/NAME is linked with.
LIBS_render-sanitized = -fsanitize=address,undefined
LIBS_fuzz-files       = $(LIBS_render-sanitized) -lOpenEXR-3_1
LIBS_test-examples    = -lOpenEXR-3_1
LIBS_viewer           = $$(pkg-config --libs glfw3)
LIBS_viewer-sanitized = $(LIBS_render-sanitized) $(LIBS_viewer)
LIBS_viewer-threads   = -fsanitize=thread $(LIBS_viewer)
$(addprefix build/,$(KITS) capture render-sanitized test test-examples fuzz-files viewer viewer-sanitized \
  viewer-threads):
	@echo '  cc $@'; $(CC) $^ $(KIT_LIBS) $(LIBS_$(@F)) -o $@

build/minimal: examples/minimal.c ssgi.h ssgi_gl.h | deps
	@mkdir -p $(@D)
	@echo '  cc $@'; $(CC) -E -include GL/osmesa.h -xc /dev/null >/dev/null 2>&1 && gl=-lOSMesa || gl='-lEGL -lGL'; \
	  $(CC) -std=c11 -Wall -Wextra $(CFLAGS) $< $$gl -lm -o $@

# The main example: a scanned mesh by every method, beside the ground truth; report/index.html.
demo: build/render build/report
	build/report demo
report/demo.js: build/report $(wildcard examples/lab/page/*.html examples/lab/page/*.js)
	build/report demo
# Opens the page that demo wrote in headless Chromium.
demo-test: report/demo.js web-deps
	@$(call skips,node); node tests/pages/demo.mjs $(ONLY)

# Speed against accuracy, and error on scenes by seed; report/index.html. QUICK=1 is smaller. SCENE=room METHOD=hsao:
# only that scene and methods whose names begin so. CONTEXT=egl draws on a GPU. Some scenes and one probe are in
# packages that no other target needs; without them, the chart says so.
PROBE   = /usr/share/blender/datafiles/studiolights/world/interior.exr
# OF=ambient, lit, fields, deep or plan: that part alone, at full length. Half of the scenes by seed come from the hash
# of the code, so that nothing was tuned on them.
CODE      = sh examples/lab/figures.sh --hash
DRAWN     = $(if $(filter chart seeds,$(or $(OF),chart)),--drawn $$($(CODE)))
ASKED_FOR = $(if $(QUICK),--quick) $(SCENE:%=--scene %) $(METHOD:%=--method %) $(CONTEXT:%=--context %)
chart: build/report build/glsl-text | page-deps
	$(if $(QUICK),,@sh examples/kit/models.sh $(or $(SCENE),iron-bed maple stairs attic))
	@test -n "$(QUICK)$(SCENE)" -o -s $(PROBE) || sh examples/kit/install.sh blender-data || true
	build/report $(or $(OF),chart) $(ASKED_FOR) $(DRAWN)
	@$(FIGURES)

# Every figure of the documents, in parts of at most an hour that can be stopped: all parts whose figures are of other
# code, or PART="seeds cost". figures-check names those parts; their hash is that of all shaders and of ssgi.h's code.
figures: build/report build/glsl-text
	@MAKE='$(MAKE)' sh examples/lab/figures.sh $(PART)
figures-check: build/glsl-text
	@sh examples/lab/figures.sh --check

# The papers' tables and figures, their values beside ours; report/index.html, and their part of
# examples/docs/FIGURES.md. QUICK=1 is smaller; PAPER=DSS14 or PAPER='DSS14 Figure 7' selects some. Without these the
# figures of PAPERS.md that stand below commands are measured again.
papers: build/report build/render | page-deps
	build/report papers $(if $(QUICK),--quick) $(if $(PAPER),--paper '$(PAPER)') $(CONTEXT:%=--context %)
	@$(FIGURES)
	$(if $(QUICK)$(PAPER),,awk -f examples/lab/papers/repeat.awk -v long=1 examples/docs/PAPERS.md)

# Only the chart's part on light: every pair of a scene and a probe; or its part on scenes by seed. QUICK=1 is smaller.
# Seeds from 1000 on are for reports only: FROM=0 shows the seeds on which settings may be tuned.
light seeds: build/report build/glsl-text | page-deps
	build/report $@ $(ASKED_FOR) $(FROM:%=--from %) $(COUNT:%=--count %) $(if $(filter seeds,$@),$(DRAWN))
	@$(FIGURES)

NPM = npm install --no-save --ignore-scripts --no-audit --no-fund --silent --prefix

# Effects of other libraries from npm, which the next make chart measures; none is part of the library. make cost-peers
# models their costs on a GPU; XEGTAO=FOLDER, a checkout of XeGTAO: and its passes, beside its published times.
PEERS = three@0.187.0 n8ao@2.1.0 postprocessing@6.39.6 @babylonjs/core@9.34.0 playcanvas@2.23.3
peers:
	@command -v npm > /dev/null || { echo 'peers: npm is missing (apt-get install npm)' >&2; exit 2; }
	@mkdir -p build/peers
	$(NPM) build/peers $(PEERS)
	@cp examples/lab/measure/peers.mjs examples/lab/measure/tsl.mjs build/peers/

# The faults of methods; report/index.html. make stability QUICK=1 is smaller.
stability: build/stability | page-deps
	build/stability $(if $(QUICK),--quick)
	@$(FIGURES)

# The page, report/index.html, shows all records that exist; its charts need these packages from npm. The same records
# give examples/docs/FIGURES.md and README's chart; those of quick runs are written beside the page.
FIGURES = if command -v node >/dev/null; then node examples/lab/page/figures.mjs report; \
  else echo 'figures: FIGURES.md and charts are left as they are: node is missing (apt-get install nodejs npm)'; fi
page-deps:
	@test -d build/page/node_modules/linkedom || ! command -v npm >/dev/null || { mkdir -p build/page && \
	  $(NPM) build/page @observablehq/plot@0.6.17 linkedom@0.18.12; } || { rm -rf build/page/node_modules; false; } || \
	  echo 'page: npm brought no @observablehq/plot; the page has tables and pictures alone'

# Fits the table of ssgi.h's room >>plan after a change of methods: measures and prints the table (never on seeds from
# 1000 on, which are for reports only). Its second column of costs is measured on a GPU by make bench; else fit-cost
# models it from the code that RADV's compiler makes of the choices for an RX 6800.
fit: cost-plan build/report build/fit
	@sh examples/kit/models.sh iron-bed stairs
	build/report fit
	build/fit report/plan-fit.csv \
	  $$(for f in report/plan-gpu.csv report/plan-cost.csv; do test -s $$f && echo $$f && break; done)
# The same table with only that column changed.
fit-cost: cost-plan
fit-gpu fit-cost: build/fit
	build/fit /dev/null report/plan-$(@:fit-%=%).csv

# Programs of one file.
build/fit: examples/lab/fit.c ssgi.h
build/rmse: tests/examples/rmse.c
build/fit build/rmse: | deps
	@mkdir -p $(@D)
	@echo '  cc $@'; $(CC) -std=c11 $(WARNINGS) -Wno-unused-function $(CFLAGS) $< -lm -o $@

# Milliseconds of every method on EGL's GPU, their bounds, and the plan's costs: report/index.html, bench.csv,
# plan-gpu.csv. METHOD=hsao: only names that begin so, without the plan. SIZE=1920x1080,3840x2160 SECONDS=100
bench: build/bench | page-deps
	build/bench $(CONTEXT:%=--context %) $(SCENE:%=--scene %) $(METHOD:%=--method %) $(SIZE:%=--size %) \
	  $(PLAN:%=--plan %) $(SECONDS:%=--seconds %)

# The visible noise of the presets and of the effects that make peers installed. For other entries: build/quiet --scene
# room hsao hsao:samples=12.
quiet: build/quiet | page-deps
	build/quiet --out report/quiet.csv
	@$(FIGURES)

# Builds a revision's build/render from its own sources, under build/old, once. METHOD="hsao ssdo": those rows, or all
# whose names begin so. Status 1: a row breaks a limit, see examples/docs/CONTRIBUTING.md.
against: build/against build/render
	@revision=$$(git rev-parse --verify -q --short=12 '$(OLD)^{commit}') || \
	  { echo 'against: OLD=$(OLD) is no revision' >&2; exit 2; }; old=build/old/$$revision; \
	test -d $$old || { rm -rf $$old.part && mkdir -p $$old.part && git archive $$revision | tar -x -C $$old.part && \
	  mv $$old.part $$old; } || exit 2; \
	$(MAKE) -C $$old build/render || exit 2; build/against $$old/build/render build/render $(METHOD)

# Every chain's instructions by RADV's compiler, for GPUs that need not be present, and milliseconds by a model;
# report/cost.csv. ONLY="hsao hsao,best,samples=16 own.frag": only those, with their passes; SINCE=FILE.csv: the changes
# since that run. cost-test, for CI: compares with examples/lab/cost/recorded.csv, which make cost-record writes.
# cost-shares measures how many waves enter a branch that they may skip: examples/lab/cost/shares.csv, in three minutes.
# cost-papers models the times of the papers' rows: examples/lab/papers/modelled.csv.
COST_NEEDS = mesa-vulkan-drivers libvulkan-dev glslang-dev libspirv-cross-c-shared-dev
LIBS_cost  = -lvulkan -lspirv-cross-c-shared -Wl,--start-group $$(pkg-config --libs --static spirv) \
             -lglslang-default-resource-limits -Wl,--end-group -lstdc++
cost cost-test cost-record cost-shares cost-plan cost-papers cost-peers: deps
	@sh examples/kit/install.sh $(COST_NEEDS) || true
	@for h in vulkan/vulkan.h glslang/Include/glslang_c_interface.h spirv_cross/spirv_cross_c.h; do \
	  echo "#include <$$h>" | $(CC) -E - >/dev/null 2>&1 || { echo "skipped: everything: no $$h"; exit 0; }; done; \
	$(MAKE) -s --no-print-directory build/cost page-deps && $(if $(XEGTAO),sh examples/lab/cost/xegtao.sh '$(XEGTAO)' &&) \
	  build/cost $(if $(filter cost,$@),\
	  $(SINCE:%=--against %) $(ONLY) $(if $(ONLY),,&& { $(FIGURES); }),--$(patsubst test,check,$(@:cost-%=%)))
# The shaders of every pass, dialect and choice, as plain files; manifest.json lists the files that belong together.
# make glsl WGSL=1 HLSL=1 MSL=1 SPV=1 also translates the vulkan shaders, in five minutes; each needs a tool, which is
# named if it is missing. One method takes three seconds: build/glsl-text --chain hsao,balanced --hlsl DIR.
TRANSLATED = $(if $(SPV),spv) $(if $(WGSL),wgsl) $(if $(HLSL),hlsl) $(if $(MSL),msl)
glsl: build/glsl-text
	build/glsl-text build/glsl
	$(if $(strip $(TRANSLATED)),sh examples/tools/glsl/translate.sh build/glsl $(TRANSLATED))

# examples/docs/PASSES.md: the inputs and outputs of each pass, and every choice.
passes: build/glsl-text
	build/glsl-text --passes ssgi_gl.h >examples/docs/PASSES.md

# Pictures of README, METHODS.md and TUNING.md. ONLY=radius: those whose names contain it. examples/docs/beside.py makes
# the crop beside other libraries' effects.
pictures: build/render
	@ONLY='$(ONLY)' sh examples/docs/pictures.sh

# Measures the figures of LIMITS.md again. ONLY=word: rows whose names contain it.
failures: build/render build/stability
	@$(call needs,python3,python3,$@)
	@python3 examples/lab/failures.py $(ONLY)

# Makes wrong edits of both headers, each with the test that must notice it; tests/mutants.py explains. Forty take six
# minutes.
mutants: build/test
	@$(call needs,python3,python3,$@)
	@python3 tests/mutants.py ONLY='$(ONLY)' DRAW='$(DRAW)' SEED='$(SEED)'

# Installs the headers under PREFIX, where pkg-config and CMake's find_package(ssgi) find them.
PREFIX ?= /usr/local
VERSION = $(shell sed -n 's/^.define SSGI_VERSION_M[AI][JN]OR //p' ssgi.h | paste -sd.)
TO      = $(DESTDIR)$(PREFIX)
INSTALLED = include/ssgi.h include/ssgi_gl.h share/pkgconfig/ssgi.pc share/cmake/ssgi/ssgi-config.cmake \
            share/cmake/ssgi/ssgi-config-version.cmake
install:
	@mkdir -p '$(TO)/include' '$(TO)/share/pkgconfig' '$(TO)/share/cmake/ssgi'
	@for f in $(INSTALLED); do from=$${f##*/}; test -e $$from || from=examples/tools/packages/$$from; \
	  sed 's/@VERSION@/$(VERSION)/' $$from >'$(TO)'/$$f && chmod 644 '$(TO)'/$$f || exit 1; done
	@echo 'ssgi $(VERSION): $(TO)/include'

uninstall:
	@for f in $(INSTALLED); do rm -f '$(TO)'/$$f; done; rmdir '$(TO)/share/cmake/ssgi' 2>/dev/null || true

# All functions of both headers as one library, and libssgi.h, its declarations without directives, as cffi reads them.
SHARED = build/libssgi.so
shared: $(SHARED:.so=.h)
$(SHARED:.so=.h): ssgi.h ssgi_gl.h
	@mkdir -p $(@D)
	@$(CC) -std=c99 -O2 -fPIC -shared -DSSGI_IMPLEMENTATION -DSSGI_GL_IMPLEMENTATION -x c ssgi_gl.h -o $(SHARED) -lm
	@$(CC) -std=c99 -E -P '-D__attribute__(x)=' ssgi_gl.h -o $@

# The headers as WebAssembly, without a C library; examples/tools/wasm/ssgi.mjs loads it.
WASM_FLAGS = --target=wasm32 -std=c99 $(WARNINGS) -Oz -fno-builtin -fno-math-errno -fdata-sections \
             -nostdlib -nostdlibinc -isystem examples/tools/wasm/libc \
             -Wl,--no-entry,--strip-all,--stack-first,--compress-relocations,--export=__heap_base
wasm: build/wasm/ssgi.wasm
WASM_LIBC  = $(wildcard examples/tools/wasm/libc/*)
build/wasm/ssgi.wasm: examples/tools/wasm/ssgi.c examples/tools/wasm/ssgi.mjs $(WASM_LIBC) ssgi.h ssgi_gl.h
	@$(call needs,clang >/dev/null && command -v wasm-ld,clang lld,wasm,clang or wasm-ld)
	@mkdir -p $(@D)
	@echo '  clang $@'; clang $(WASM_FLAGS) $< -o $@
	@cp examples/tools/wasm/ssgi.mjs $(@D)

# Every chain of build/glsl-text --chains, in WGSL.
build/wgsl/manifest.json: build/glsl-text examples/tools/glsl/translate.sh examples/tools/glsl/wgsl.mjs
	@$(call needs,glslangValidator,glslang-tools,npm)
	@rm -rf build/wgsl && build/glsl-text --chain all --wgsl build/wgsl || { rm -rf build/wgsl; exit 2; }

# An npm package: ssgi.mjs with its types and ssgi.wasm, which makes all GLSL, and the methods' chains in WGSL. It is
# packed into a file, because npm may install a folder as a link, from which bundlers do not find three. build/wgsl has
# a second package, ssgi-wgsl: the WGSL of all named chains as files, with a manifest.
npm: build/wasm/ssgi.wasm build/glsl-text build/wgsl/manifest.json
	@$(call needs,npm,npm,npm)
	@rm -rf build/npm build/ssgi-*.tgz build/wgsl/*.tgz && mkdir -p build/npm
	@node examples/tools/packages/chains.mjs build/wgsl build/npm/chains
	@cp build/wasm/ssgi.wasm examples/tools/wasm/*.mjs examples/tools/wasm/*.d.ts LICENSE build/npm
	@cp LICENSE build/wgsl && sed 's/@VERSION@/$(VERSION)/' examples/tools/packages/wgsl.json >build/wgsl/package.json
	@npm pack ./build/wgsl --pack-destination build/wgsl --silent >/dev/null
	@cp examples/tools/packages/npm.md build/npm/README.md
	@{ build/glsl-text --types && cat examples/tools/wasm/ssgi.d.ts; } >build/npm/ssgi.d.ts
	@sed 's/@VERSION@/$(VERSION)/' examples/tools/packages/package.json >build/npm/package.json
	@packed=$$(npm pack ./build/npm --pack-destination build --silent) && echo "npm install $(CURDIR)/build/$$packed"

# A release's files, into build/dist: archives of the headers and of shaders, the npm package, recipes, CHANGELOG.md and
# SHA256SUMS. URL=https://..: from where the recipes will fetch them.
DIST = build/dist
dist: build/glsl-text
	@MAKE='$(MAKE)' URL='$(URL)' sh examples/tools/packages/dist.sh $(DIST) $(VERSION)

# The GLSL of ssgi_gl.h as files, a room each, to be read in an editor or compared with another revision's.
glsl-out:
	@test -n '$(DIR)' || { echo '$@: DIR=folder is missing' >&2; exit 2; }
	@mkdir -p '$(DIR)' && awk -v folder='$(DIR)' -f examples/tools/glsl/rooms.awk ssgi_gl.h

# Groups of tests: those of the library run in make test, those of the examples in make test-all.
OF_LIBRARY  = build text scenes pipeline history light coefficients surfels occluders trace field steps read plan \
              twins library view bias kernel sh environment cap arguments
OF_EXAMPLES = tools stability errors files models seeds papers cost
# The files that tests of the examples call: all except the programs.
TESTED = $(sort $(filter-out lab/report lab/stability/stability lab/stability/show,$(OF_report) $(OF_stability)) \
         $(addprefix lab/,against/compared against/subjects cost/count cost/share cost/model measure/csv))
build/test: $(addprefix build/tests/,main.o t.o $(addprefix library/,frames.o $(OF_LIBRARY:%=test_%.o)))
# Models in scenes by seed, from packages.
model-deps:
	@sh examples/kit/install.sh unzip sweethome3d-furniture assimp-testmodels || true
build/test-examples: | model-deps
build/test-examples: $(addprefix build/tests/,main.o t.o $(addprefix examples/,others.o $(OF_EXAMPLES:%=test_%.o))) \
                     $(TESTED:%=build/examples/%.o)

# Writes tests/examples/errors.csv with the errors, noise and bounds of this tree; test group errors checks them.
errors: build/test-examples
	T_ERRORS=build/errors.csv build/test-examples errors
	mv build/errors.csv tests/examples/errors.csv

# Reads damaged pictures for so many seconds, under sanitizers: build/fuzz-files 600.
build/fuzz-files: $(addprefix build/sanitized/,$(addprefix tests/examples/,fuzz_files.o others.o) $(KIT_BASE:%=%.o) \
                  trace/camera.o)

# Checks that no room of examples/ calls one above it.
tree: $(KIT_O) $(patsubst %,build/examples/%.o,$(OF_render) $(OF_report) $(GLSL) $(OF_bench) $(OF_against))
	@sh tests/tree.sh $(sort $^)

# make test ONLY="sh text" runs those groups, make test PASS=blur those that name that pass (SSGI_GL_PASS_BLUR), both
# of the library and of the examples. Only programs that their files name are built.
GROUPS_OF = $(shell sh tests/groups.sh $(1))
ASKED     = $(ONLY) $(if $(PASS),text library $(call GROUPS_OF,$(PASS)))
PROGRAMS  = $(addprefix build/,render render-sanitized glsl-text fuzz-files bench fit report try quiet reflection \
            stability)
NAMED_IN  = $(filter $(PROGRAMS),$(shell grep -oh 'build/[a-z-]*' $(1:%=tests/*/test_%.c) /dev/null 2>/dev/null))
RUN      := $(or $(strip $(ASKED)),$(OF_LIBRARY))
test: $(if $(filter files,$(RUN)),page-deps) \
      $(if $(filter-out $(OF_EXAMPLES),$(RUN)),build/test) $(if $(filter $(OF_EXAMPLES),$(RUN)),build/test-examples) \
      $(sort $(call NAMED_IN,$(RUN)))
	$(if $(PASS),$(if $(call GROUPS_OF,$(PASS)),,$(error PASS=$(PASS): no group of tests names it)))
	$(if $(filter $(OF_EXAMPLES),$(RUN)),build/test-examples $(filter $(OF_EXAMPLES),$(RUN)))
	$(if $(filter-out $(OF_EXAMPLES),$(RUN)),build/test $(filter-out $(OF_EXAMPLES),$(RUN)))

# The library, each of its shaders in three dialects, by more compilers and random inputs (T_ALL), then all else:
# examples, the page, WGSL, hosts, Vulkan, the viewer, the compiler's count. Each ends with its own "N passed, N
# failed"; a part that needs a missing program is skipped by name.
test-all:
	T_ALL=1 $(MAKE) test
	$(MAKE) tree
	$(MAKE) test ONLY='$(OF_EXAMPLES)'
	for part in demo web webgpu hosts vulkan viewer cost; do $(MAKE) $$part-test || exit 1; done

# Formats in place, by clang-format 14 only, because other versions give another layout. Tables that it would break are
# between clang-format off and on.
CLANG_FORMAT = $(shell command -v clang-format-14 || echo clang-format)
format:
	@$(CLANG_FORMAT) --version 2>/dev/null | grep -q 'version 14\.' || \
	  { echo 'format: clang-format 14 is missing (apt-get install clang-format-14)' >&2; exit 2; }
	$(CLANG_FORMAT) -i ssgi.h ssgi_gl.h

clean:
	rm -rf build report

.PHONY: page-deps model-deps all install uninstall wasm npm dist passes glsl-out demo demo-test test test-all tree \
        figures figures-check chart light seeds papers errors peers stability quiet against fit fit-gpu fit-cost bench \
        cost cost-test cost-record cost-shares cost-plan cost-papers cost-peers glsl mutants failures deps unlisted \
        shared format clean viewer glfw viewer-test hosts-test web web-deps web-test web-first web-shots webgpu-test \
        vulkan vulkan-test pictures

# A window onto a scene, with every method live: build/viewer MODEL (OBJ, glTF, PLY .., or a built-in scene's name).
viewer: build/viewer
glfw:
	@pkg-config --exists glfw3 || sh examples/kit/install.sh libglfw3-dev || \
	  { echo 'viewer: GLFW is missing (apt-get install libglfw3-dev)' >&2; exit 2; }
VIEWER      = $(patsubst %.c,%.o,$(wildcard examples/viewer/*.c))
$(foreach f,build build/sanitized build/threads,$(VIEWER:%=$f/%)): | glfw
build/viewer: $(VIEWER:%=build/%)
# The viewer under sanitizers: of memory and undefined behaviour, of threads.
build/viewer-sanitized: $(VIEWER:%=build/sanitized/%) $(SANITIZED)
build/viewer-threads: $(VIEWER:%=build/threads/%) $(SANITIZED:build/sanitized/%=build/threads/%)

# Tests it under Xvfb, beside build/render's pictures; parts whose programs are missing are skipped by name. FUZZ=300:
# so many damaged files and arguments.
XLIB = /usr/bin/python3 -c 'import Xlib' 2>/dev/null
viewer-test: build/render build/rmse
	@command -v Xvfb >/dev/null && pkg-config --exists glfw3 && $(XLIB) || \
	  sh examples/kit/install.sh xvfb libglfw3-dev python3-xlib || true
	@if $(XLIB); then install -m 755 tests/examples/press.py build/press; else rm -f build/press; fi
	@if pkg-config --exists glfw3; then $(MAKE) -s viewer build/viewer-sanitized build/viewer-threads; fi
	@FUZZ=$(FUZZ) sh tests/examples/viewer.sh

# Builds the pages of examples/hosts without a warning and runs them: their occlusion beside build/render's. Hosts whose
# packages are missing are skipped by name. ONLY="glfw sdl": only those hosts.
HOST_PACKAGES = xvfb libglfw3-dev libsdl2-dev libgles-dev python3-moderngl python3-cffi libegl1 libopenscenegraph-dev \
                libvtk9-dev libogre-1.12-dev
NPM_HOSTS = $(NPM) build/hosts babylonjs@9.34.0 \
            playcanvas@2.23.3 three@0.187.0 vite@7.3.8 typescript@5.9.3 @types/three@0.187.0 postprocessing@6.39.6
hosts-test: build/render build/rmse build/glsl-text web-deps shared
	@for p in $(HOST_PACKAGES); do sh examples/kit/install.sh $$p || true; done; mkdir -p build/hosts
	@test -d build/hosts/node_modules/postprocessing || ! command -v npm >/dev/null || $(NPM_HOSTS) || true
	@! command -v wasm-ld >/dev/null || $(MAKE) -s npm
	@sh tests/examples/hosts.sh $(ONLY)

# The page: examples/web on three.js from npm, to be served from build/web; its tests draw it in a headless browser.
# Their packages are in build/web-deps; make web-test skips by name the tests whose programs cannot be had.
WEB      = $(wildcard examples/web/*.html examples/web/*.css examples/web/*.mjs)
THREE    = build/three.module.js build/three.core.js LICENSE $(addprefix examples/jsm/,controls/OrbitControls.js \
           $(patsubst %,loaders/%Loader.js,GLTF OBJ MTL DRACO HDR EXR) utils/BufferGeometryUtils.js \
           utils/SkeletonUtils.js libs/meshopt_decoder.module.js libs/fflate.module.js libs/draco/README.md \
           libs/draco/gltf/draco_wasm_wrapper.js libs/draco/gltf/draco_decoder.wasm)
NPM_WEB  = $(NPM) build/web-deps three@0.187.0 \
           puppeteer-core@24.43.1 esbuild@0.25.12
web: build/web/index.html
WEB_SSGI = $(addprefix examples/tools/wasm/,ssgi.mjs webgl.mjs three.mjs webgpu.mjs)
build/web/index.html: $(WEB) $(WEB_SSGI) build/wasm/ssgi.wasm build/web/three/three.module.js \
                      build/web/scenes/scenes.json build/web/wgsl/list.json
	@rm -f build/web/*.mjs # else a renamed module would hide imports of its old name
	@cp $(WEB) $(WEB_SSGI) build/wasm/ssgi.wasm LICENSE examples/docs/pictures/page/first.jpg build/web
	@touch $@
	@echo 'build/web: cd build/web && python3 -m http.server, then http://localhost:8000'

build/web-deps/node_modules/three/package.json:
	@$(call needs,npm,npm,web)
	@mkdir -p build/web-deps
	@echo '  npm three, esbuild, puppeteer-core'; $(NPM_WEB)

# esbuild removes two thirds of three.js; without esbuild it is copied unchanged.
MINIFY   = build/web-deps/node_modules/.bin/esbuild
build/web/three/three.module.js: build/web-deps/node_modules/three/package.json
	@mkdir -p $(@D)/controls $(@D)/loaders $(@D)/utils $(@D)/libs/draco/gltf
	@for f in $(THREE); do to=$${f#build/}; cp $(<D)/$$f $(@D)/$${to#examples/jsm/} || exit 1; done
	@sed -i "s|from 'three'|from '../three.module.js'|" $(@D)/controls/*.js $(@D)/loaders/*.js $(@D)/utils/*.js
	@sed -i 's|^\(\s*\)console.error( error );$$|\1// said on the page|' $(@D)/loaders/DRACOLoader.js
	@! $(MINIFY) --version >/dev/null 2>&1 || \
	  $(MINIFY) --minify --legal-comments=inline --log-level=error --allow-overwrite --outdir=$(@D) --outbase=$(@D) \
	  $(@D)/*.js $(@D)/controls/*.js $(@D)/loaders/*.js $(@D)/utils/*.js
	@touch $@

# The page's worker, which makes surfels and fields of triangles. Surfels take two thirds of their time with -Os.
build/web/index.html: build/web/bake.wasm
build/web/bake.wasm: examples/web/bake.c $(WASM_LIBC) ssgi.h | build/wasm/ssgi.wasm
	@mkdir -p $(@D)
	@echo '  clang $@'; clang $(WASM_FLAGS) -O3 $< -o $@

# A picture of each scene, if it can be drawn, by which the user chooses one on the page.
THUMB = --method ssdo --env sky --light sun:0.58,0.57,0.58,0.5,0.5,0.4 --size 160x100
build/web/scenes/scenes.json: build/web-scenes build/render
	@mkdir -p $(@D)
	@echo '  pictures of the scenes'; build/web-scenes --list | while read name from; do \
	  build/render "$$from" $(THUMB) --out $(@D)/$$name.png >/dev/null 2>&1 || rm -f $(@D)/$$name.png; done
	@build/web-scenes $(@D)

# Every shader that the page's settings can need, in WGSL; without a translator the page only has WebGL 2.
TO_WGSL = examples/web/make/wgsl.mjs $(addprefix examples/web/,chain.mjs settings.mjs show-texts.mjs webgpu-keys.mjs) \
          $(addprefix examples/tools/glsl/,translate.sh wgsl.mjs)
build/web/wgsl/list.json: build/wasm/ssgi.wasm $(TO_WGSL)
	@echo '  wgsl $(@D)'; node $(firstword $(TO_WGSL)) build/wasm/ssgi.wasm build/wasm/ssgi.mjs build/web-wgsl $(@D)

# Headless Chromium draws the page of make web; last line "N passed, N failed". ONLY=address: tests with that word.
web-deps:
	@lacks=; for p in chromium clang:clang wasm-ld:lld npm fonts-dejavu-core; do \
	  command -v $${p%:*} >/dev/null || test -d /usr/share/fonts/truetype/dejavu -a $$p = fonts-dejavu-core || lacks="$$lacks $${p#*:}"; \
	done; test -z "$$lacks" || sh examples/kit/install.sh $$lacks || true
	@test -d build/web-deps/node_modules/esbuild || { mkdir -p build/web-deps && $(NPM_WEB); } || true

web-test: web-deps
	@$(call skips,node clang wasm-ld,test -d build/web-deps/node_modules/three || lacks="$$lacks three.js (npm)";); \
	$(MAKE) --no-print-directory web build/render build/glsl-text && mkdir -p build/web-test && \
	echo '<!doctype html><link rel="icon" href="data:,">' >build/web-test/empty.html && \
	build/glsl-text build/web-test/glsl 300es >/dev/null && node tests/pages/web.mjs $(ONLY)

# The time of the page until its first picture; BESIDE=folder: alternates with another build/web.
web-first: web-deps web
	@node tests/pages/web-first.mjs $(or $(COUNT),5) $(BESIDE) build/web

# Pictures of the page, into examples/docs/pictures/page. ONLY=phone: those whose names contain it.
web-shots: web-deps web
	@node tests/pages/web-shots.mjs $(ONLY)

# Headless Chromium compiles the WGSL of every shader on WebGPU's software adapter, makes pipelines of them, and draws
# the page of examples/hosts.
WEBGPU = build/webgpu-test
webgpu-test: web-deps build/glsl-text build/capture
	@$(call skips,node npm glslangValidator); \
	rm -rf $(WEBGPU) && mkdir -p $(WEBGPU) && echo '<!doctype html><link rel="icon" href="data:,">' >$(WEBGPU)/empty.html && \
	build/glsl-text $(WEBGPU)/glsl vulkan >/dev/null && { sh examples/tools/glsl/translate.sh $(WEBGPU)/glsl wgsl || \
	{ test $$? = 2 && echo 'skipped: everything: no translator' && echo '0 passed, 0 failed' && exit 0; exit 1; }; } && \
	node tests/pages/webgpu.mjs $(ONLY)

# The Vulkan host, and its drawing loop on captures, under sanitizers.
VULKAN_O     = $(KIT_BASE:%=build/kit/%.o) $(LIBRARY:%=build/kit/%)
VULKAN_FLAGS = -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Iexamples \
               -Ibuild/include -MMD -MP -MF $@.d -MT $@
-include $(wildcard build/vulkan.d build/vulkan-replay.d)
vulkan: build/vulkan
build/vulkan: examples/hosts/vulkan.cpp
build/vulkan-replay: tests/examples/vulkan.cpp
LIBS_vulkan        = -O1
LIBS_vulkan-replay = -fsanitize=address,undefined -fno-sanitize-recover=undefined
build/vulkan build/vulkan-replay: $(VULKAN_O)
	@echo '  c++ $@'; $(CXX) $(VULKAN_FLAGS) -g $(filter %.cpp %.o,$^) -lvulkan $(KIT_LIBS) $(LIBS_$(@F)) -o $@

# Chains drawn by lavapipe with the validation layer, beside the kit's pictures.
VULKAN_NEEDS = mesa-vulkan-drivers vulkan-validationlayers libvulkan-dev nlohmann-json3-dev g++ glslang-tools
vulkan-test: deps
	@sh examples/kit/install.sh $(VULKAN_NEEDS) || true
	@MAKE='$(MAKE)' CXX='$(CXX)' sh tests/examples/vulkan.sh
