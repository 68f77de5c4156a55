# Prints the groups of tests that judge a pass: sh tests/groups.sh blur. They have SSGI_GL_PASS_BLUR, "blur" or "blur,.
# text and library test every pass, and build, tools, cost, papers and seeds judge other things.
grep -liE "\bSSGI_GL_PASS_$1\b|\b_$1\b|\"$1[\",]" tests/*/test_*.c | sed 's/.*test_//; s/\.c$//' |
    grep -vxE 'text|library|build|tools|cost|papers|seeds|files'
