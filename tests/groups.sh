# Prints the groups of tests that judge a pass: sh tests/groups.sh blur. They have it as SSGI_GL_PASS_BLUR or "blur".
# text and library test every pass, and build, tools, cost, papers and seeds judge other things.
grep -liwE "SSGI_GL_PASS_$1|_$1|\"$1\"" tests/*/test_*.c | sed 's/.*test_//; s/\.c$//' |
    grep -vxE 'text|library|build|tools|cost|papers|seeds'
