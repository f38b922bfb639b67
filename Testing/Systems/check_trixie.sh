#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
#
# check_trixie.sh [SOURCE] - compiles the sources that use VTK, ParaView's server manager or CGAL against
# the headers of Debian 13, with this system's compiler and -fsyntax-only. Sources with Qt are not tried. SOURCE is the
# checkout, by default the one that holds this script.
# The headers are unpacked from Debian 13's packages into build/trixie, at the first call; nothing is installed. ./run
# test calls this script in continuous integration. The whole system is tried by bare.sh.
#
# Exit code: 0 all sources compile; 1 one does not; 77 the packages cannot be had.
set -u
here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd) || exit 1
source=$(cd -- "${1:-$here/../..}" && pwd) || exit 1
place=$(cd -- "$here/../.." && pwd)/build/trixie

# Packages whose headers the sources include.
readonly packages=(paraview-dev libcgal-dev libeigen3-dev libcli11-dev libboost1.83-dev libgmp-dev libmpfr-dev
  libglew-dev libglu1-mesa-dev libgl-dev libx11-dev x11proto-dev libdouble-conversion-dev libutfcpp-dev libfreetype-dev)

skip() { echo "check_trixie: $1" >&2; exit 77; }

# apt_of_trixie COMMAND...: apt with lists and caches of its own, and at most three minutes. The host's other settings, a
# proxy say, hold.
apt_of_trixie()
{
  local command=$1
  shift
  timeout 180 "$command" -qq -o Acquire::http::Timeout=30 -o Acquire::Retries=1 \
    -o Dir::Etc::sourcelist="$place/sources.list" -o Dir::Etc::sourceparts=- \
    -o Dir::State="$place/state" -o Dir::State::status="$place/state/status" -o Dir::Cache="$place/cache" \
    -o APT::Sandbox::User=root "$@"
}

unpack_headers()
{
  local keys=/usr/share/keyrings/debian-archive-keyring.gpg mirror package
  command -v apt-get >/dev/null || skip "there is no apt"
  [ -e "$keys" ] || skip "there is no $keys"
  mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
    sed -nE 's,^(URIs:|deb( \[[^]]*\])?) *(https?://[^ ]*/debian/?)( .*)?$,\3,p' | head -n 1)
  rm -rf "$place"
  mkdir -p "$place/state/lists/partial" "$place/cache/archives/partial" "$place/root" || exit 1
  : >"$place/state/status"
  echo "deb [signed-by=$keys] ${mirror:-http://deb.debian.org/debian} trixie main" >"$place/sources.list"
  apt_of_trixie apt-get update || skip "the lists of Debian 13 cannot be had"
  (cd "$place/cache" && apt_of_trixie apt-get download "${packages[@]}") || skip "a package of Debian 13 cannot be had"
  for package in "$place"/cache/*.deb; do
    dpkg --fsys-tarfile "$package" | tar -x -C "$place/root" --wildcards './usr/include/*' || exit 1
  done
  rm -rf "$place/cache" "$place/state"
  touch "$place/complete"
}

# write_group NAME FILE...: one source that includes the files, as the build compiles a folder.
write_group()
{
  local group=$place/groups/$1.cxx
  shift
  printf '#include "%s"\n' "$@" >"$group"
}

# Sources by folder, up to twelve in a group. Sources with CGAL stand alone.
write_groups()
{
  local folder name files i
  rm -rf "$place/groups" && mkdir -p "$place/groups" || exit 1
  while read -r folder; do
    files=("$folder"/*.cxx)
    name=${folder#"$source"/}
    for ((i = 0; i < ${#files[@]}; i += 12)); do
      write_group "${name//\//_}_$i" "${files[@]:i:12}"
    done
    count=$((count + ${#files[@]}))
  done < <(find "$source"/Filters/{Response,SolidResponse,MeasuredResponse,Pieces} "$source"/Interactors/{Interaction,Comparison} \
    "$source"/Plugin/{Viewer,ParaView/ServerManager} -name '*.cxx' -not -path '*/Mesher/Cgal/*' -printf '%h\n' | sort -u)
  while read -r folder; do
    write_group "cgal_$(basename "$folder" .cxx)" "$folder"
    count=$((count + 1))
  done < <(grep -rlE '#include [<"](CGAL/|SolidResponse/Mesher/Cgal/CgalSurface.h)' "$source"/Filters --include='*.cxx' | sort)
}

# The headers that CMake generates: an empty export macro for each VTK module.
write_export_headers()
{
  local module
  mkdir -p "$place/include" || exit 1
  for module in palpateResponse palpateSolidResponse palpateMeasuredResponse palpateInteraction palpateComparison \
    palpateServerManager; do
    printf '#define %s_EXPORT\n#define %s_NO_EXPORT\n' "${module^^}" "${module^^}" >"$place/include/${module}Module.h"
  done
}

compile_group()
{
  local flags=()
  [[ $1 != */cgal_* ]] || flags=(-frounding-math)
  # What folders of a group define for themselves has two names in the build; sources of two folders never meet here.
  g++ -std=c++17 -fsyntax-only -w -DPALPATE_VERSION='"0"' -DPALPATE_PROJECT_VERSION='"0"' "${flags[@]}" \
    -I"$place/include" -I"$source/Filters" -I"$source/Interactors" \
    -I"$source"/Filters/{Response,SolidResponse,MeasuredResponse} \
    -I"$source"/Interactors/{Interaction,Comparison} -I"$source"/Plugin/Viewer{,/CommandLine,/Solids,/Identification,/Comparison,/Trials} \
    -I"$source/Plugin/ParaView/ServerManager" \
    -isystem "$vtk" -isystem "$vtk/vtkprotobuf/src" -isystem "$place/root/usr/include/eigen3" \
    -isystem "$place/root/usr/include/freetype2" -isystem "$place/root/usr/include" \
    -isystem "$place/root/usr/include/x86_64-linux-gnu" "$1"
}

count=0
[ -e "$place/complete" ] || unpack_headers
write_groups
write_export_headers
export -f compile_group
vtk=$(echo "$place"/root/usr/include/paraview-*)
export place source vtk
start=$SECONDS
jobs=$(nproc)
((jobs <= 4)) || jobs=4 # each takes up to 1.5 GB
# The longest first.
if ! find "$place/groups" -name '*.cxx' -printf '%f %p\n' | sort -r | sed -n 's/^\(cgal\)/0\1/;p' | sort | cut -d' ' -f2 |
  xargs -P "$jobs" -I{} bash -c 'compile_group {}'; then
  echo "check_trixie: a source does not compile against Debian 13's headers" >&2
  exit 1
fi
echo "check_trixie: $count sources compile against Debian 13's headers ($((SECONDS - start)) s)"
