#!/bin/sh
# Puts the models of the named scenes of the chart into build/models, from Debian's packages. Existing models stay. A
# model that cannot be had is left out; the chart then says so and continues. Run it in the folder of the Makefile.
#  sh examples/kit/models.sh iron-bed maple stairs attic
kit=$(dirname "$0")
new=build/models/new

from_furniture() {  # NAME, its path in the library without .obj
    [ -s "build/models/$1.obj" ] && return
    sh "$kit/install.sh" sweethome3d-furniture unzip && mkdir -p "$new" || return
    unzip -p /usr/share/sweethome3d/furniture/Scopia.sh3f "scopia/$2.obj" >"$new/$1.obj" \
        && mv "$new/$1.obj" build/models/
}

house() {  # AC14-FZK-Haus by KIT/IAI, a building model in IFC
    [ -s build/models/fzk-house.obj ] && return
    sh "$kit/install.sh" assimp-utils assimp-testmodels && mkdir -p "$new" || return
    # -gn: flat normals; the default rounds the corners of rooms
    assimp export /usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc "$new/fzk-house.obj" -gn >"$new/log" 2>&1 \
        && mv "$new/fzk-house.mtl" "$new/fzk-house.obj" build/models/
}

for scene in "$@"; do
    case $scene in
    iron-bed) from_furniture iron-bed iron_bed/iron_bed ;;
    maple) from_furniture maple sycamoreMaple/sycamoreMaple ;;
    stairs | attic) house ;;
    esac
done
rm -rf "$new"
exit 0
