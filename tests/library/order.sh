# order.sh ROOT - reverses the enum of passes in a copy of ssgi_gl.h. No pass may change by that.
set -e
mkdir -p turned
cp "$1/ssgi.h" turned
perl -0pe '
    s/(    SSGI_GL_PASS_SSAO = 0,\n.*?)(?=    SSGI_GL_PASSES,)/
        my $lines = $1; $lines =~ s{ = 0}{}; join("", reverse split m{(?<=\n)}, $lines)/se;
    s/"SSAO HSAO([A-Z0-9_ "\n]*?)", NULL/
        my $words = "SSAO HSAO$1"; $words =~ s{"\s*"}{}g; "\"" . join(" ", reverse split m{ +}, $words) . "\", NULL"/se' \
    "$1/ssgi_gl.h" >turned/ssgi_gl.h
grep -q 'SSGI_GL_PASS_SSAO,' turned/ssgi_gl.h && grep -q 'HSAO SSAO"' turned/ssgi_gl.h
for headers in "$1" turned; do
    gcc -std=c99 -I"$headers" "$1/tests/library/order.c" -o order -lm
    ./order | sort >"order-$(basename "$headers")"
done
grep -q '; change_share ' "order-$(basename "$1")"
diff "order-$(basename "$1")" order-turned | cut -c1-200 >differ.txt || true
if test -s differ.txt; then head -4 differ.txt; exit 1; fi
