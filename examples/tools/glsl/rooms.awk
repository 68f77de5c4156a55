# rooms.awk - extracts the GLSL of ssgi_gl.h, to be read in an editor with its colours, or compared with another
# revision's by diff -r. make glsl-out DIR=d writes a file for each room, d/fetch.glsl, d/visibility.glsl .., with the
# header's comments, each condition as #if and #endif, and above each main function its name in the tables of passes.

/^static const ssgi_gl__code ssgi_gl__library/ { inside = 1; next }
!inside { next }
/^};/ { exit }
/^\/\* ==== >>/ {
    match($0, />>[a-z_]+/)
    file = folder "/" substr($0, RSTART + 2, RLENGTH - 2) ".glsl"
    printf "" >file
}
# Macros of C that write GLSL: their lines are not GLSL.
/^#(define|undef) / || macro { macro = /\\$/; next }
/^SSGI_GL_[A-Z_]+\(/ { next }
/^\{ "/ {
    condition = ""
    if (split($0, part, "\"") > 3) condition = part[4]
    if (part[2] ~ /^main_/) print "// " part[2] >file
    if (condition != "") print "#if " condition >file
    next
}
/^    "/ {
    last = / },?$/
    sub(/^    "/, "")
    sub(/\\n"( },?)?$/, "")
    print >file
    if (last && condition != "") print "#endif" >file
    next
}
{ print >file }
END { exit !inside }
