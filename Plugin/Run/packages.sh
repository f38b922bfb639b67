# SPDX-License-Identifier: BSD-3-Clause
#
# ./run sources this file. It defines which packages of Debian each job needs, and installs them.

# Groups of packages, by Debian's names. In A|B the first is for Qt 5, the second for Qt 6. ParaView's CMake package
# does not depend on all packages that it looks for: the group vtk lists those that its VTK needs for the viewer and
# Python, the group plugin those that the rest needs (found by trial on bare systems).
declare -rA packages=(
  [core]='g++ cmake ninja-build libeigen3-dev libcli11-dev ccache'
  [devices]='libhidapi-dev'
  [elements]='libsuitesparse-dev libopenblas0-pthread'
  [mesher]='libcgal-dev'
  [vtk]='paraview-dev python3-paraview libdouble-conversion-dev libexpat1-dev libfreetype-dev libgl-dev
    libglew-dev libjpeg-dev liblz4-dev liblzma-dev libopenmpi-dev libpng-dev libtiff-dev libutfcpp-dev
    libx11-dev zlib1g-dev'
  [plugin]='paraview libavformat-dev libgdal-dev libgl2ps-dev libswscale-dev libtheora-dev
    libqt5opengl5-dev|qt6-base-dev libqt5svg5-dev|qt6-svg-dev qttools5-dev|qt6-tools-dev
    qttools5-dev-tools|qt6-tools-dev-tools libqt5x11extras5-dev|qt6-5compat-dev
    libqt5svg5|qt6-svg-plugins qtbase5-dev|qt6-declarative-dev qtxmlpatterns5-dev-tools|xsltproc'
  [python]='python3-dev python3-numpy'
  [display]='xvfb xauth'
  [head]='mricron-data'
  [gtest]='libgtest-dev libgmock-dev'
  [tests]='libgtest-dev libgmock-dev umockdev libumockdev-dev pkgconf xdotool git python3-matplotlib mypy'
  [benchmarks]='libbenchmark-dev libembree-dev'
  [pictures]='python3-matplotlib'
  [calculix]='calculix-ccx'
  [style]='clang-format clang-tidy'
  [sanitizers]='clang libclang-rt-dev valgrind git'
  [plain]='libjsoncpp-dev libtbb-dev'
  [kernel]='qemu-system-x86 cpio'
  [deb]='dpkg-dev file fakeroot'
  [docs]='doxygen graphviz'
)

# For each job: groups of packages, a colon, and targets of the release build. The jobs demo-… are additions to a demo,
# for the modules that the demo uses.
declare -rA needs=(
  [demo]='core vtk head display:palpate'
  [demo-solid]='elements mesher:palpateViewerSolids palpateMesher'
  [demo-elements]='elements:palpateViewerSolids'
  [demo-compare]='elements:palpateViewerSolids palpateViewerComparison'
  [demo-map]=':palpateViewerComparison'
  [demo-measured]=':palpateViewerIdentification'
  [demo-trial]=':palpateViewerTrials'
  [demo-strain]=':palpateStrain'
  [demo-device]='devices:palpateTransports'
  [python]='core devices elements mesher vtk python display:palpatePython'
  [pvpython]='core devices elements mesher vtk python plugin display:palpatePython Palpate'
  [paraview]='core devices elements mesher vtk python plugin display:palpatePython Palpate'
  [bench]='core devices elements mesher vtk gtest benchmarks pictures display:palpateMesher palpateLongBenchmarks'
  [bench-python]='core devices elements mesher vtk python display head:palpatePython'
  [bench-plugin]='core devices elements mesher vtk python plugin display:palpatePython Palpate'
  [bench-all]='core devices elements mesher vtk python plugin gtest benchmarks pictures display head:palpatePython Palpate palpateLongBenchmarks'
  [study]='core devices elements mesher vtk python pictures display gtest:palpatePython palpate palpateModules palpateLongStudies'
  [study-calculix]='core devices elements mesher vtk python pictures display calculix:palpatePython palpate palpateModules'
  [endurance]='core devices elements mesher vtk tests sanitizers pictures display head:all palpateLong'
  [package]='core devices elements mesher vtk python plugin deb:palpatePacked'
  [docs]='core devices elements mesher vtk python pictures docs display:palpatePython'
  [test]='core devices elements mesher vtk python plugin tests head display:all'
  [test-ci]='core devices elements mesher vtk python plugin tests head display style sanitizers plain docs deb:all'
  [test-all]='core devices elements mesher vtk python plugin tests head display benchmarks style sanitizers plain kernel docs deb:all palpateLong'
  [build]='core devices elements mesher vtk python plugin tests head display benchmarks style pictures:all palpateLong'
)

# Packages that a job can do without, and what is lost without them. A job needs all other packages.
declare -rA optional_packages=(
  [xvfb]="no virtual display: pictures need a running X server"
  [xauth]="no virtual display: pictures need a running X server"
  [libsuitesparse-dev]="finite elements are some hundred times slower (no CHOLMOD)"
  [libopenblas0-pthread]="finite elements are some ten times slower (BLAS is the reference one)"
  [libbenchmark-dev]="the filters are not timed (./run bench filters)"
  [libcgal-dev]="no graded solids: neither --solid nor vtkGradedBody (no CGAL)"
  [libembree-dev]="a tick is not timed beside Embree (./run bench tick)"
  [python3-matplotlib]="studies and benchmarks draw no pictures, only tables (./run study, ./run bench)"
  [calculix-ccx]="no new finite-element curves (./run study calculix); those in Data are there"
  [clang-format]="the layout of the code is not tested"
  [clang-tidy]="the kernels are not tested with clang-tidy"
  [mypy]="the type annotations of the Python package are not tested with mypy"
  [xdotool]="the live window is not tested with real mouse events"
  [libjsoncpp-dev]="nothing is tested against plain VTK"
  [libtbb-dev]="nothing is tested against plain VTK"
  [libhidapi-dev]="no HID devices: neither SpaceMouse nor self-built force devices"
  [umockdev]="the HID devices are not tested on the real hidapi"
  [libumockdev-dev]="the HID devices are not tested on the real hidapi"
  [pkgconf]="the HID devices are not tested on the real hidapi"
  [qemu-system-x86]="the HID devices are not tested on a real kernel"
  [cpio]="the HID devices are not tested on a real kernel"
  [clang]="no suite asan: neither clang's sanitizers nor fuzzing"
  [libclang-rt-dev]="no suite asan: neither clang's sanitizers nor fuzzing"
  [valgrind]="the kernels are not run under valgrind (./run endurance)"
  [ccache]="what was compiled before is compiled again"
  [git]="a clone's version and ignored files are not known"
  ['qtxmlpatterns5-dev-tools|xsltproc']="ParaView has no help pages on Palpate"
  [graphviz]="the classes' pages have no diagrams"
  [mricron-data]="the demo has no head (ch2.nii.gz)"
)

is_debian_like() { have apt-get && have dpkg-query; }

# The packages among the arguments that are not installed, one per line.
missing_packages()
{
  local installed
  installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package}\n' "$@" 2>/dev/null |
    sed -n 's/^installed://p' | tr '\n' ' ')"
  local package
  for package in "$@"; do
    [[ $installed == *" $package "* ]] || echo "$package"
  done
}

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif [ -t 0 ]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

may_install()
{
  [ -z "${PALPATE_NO_INSTALL:-}" ] && { [ "$(id -u)" -eq 0 ] || have sudo; }
}

# Runs apt-get without questions. A conflicting package is never removed.
readonly apt_log=$build_dir/apt.log
apt()
{
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@" \
    </dev/null >>"$apt_log" 2>&1
}

# install_packages PACKAGE...: shows the progress that apt reports ("pmstatus:package:percent:what").
install_packages()
{
  local kind what percent text status
  while IFS=: read -r kind what percent text; do
    case $kind in
      dlstatus) progress "downloading packages: ${percent%.*} %" ;;
      pmstatus) progress "installing packages: ${percent%.*} % ($text)" ;;
    esac
  done < <(apt install --yes --no-remove --no-install-recommends -o APT::Status-Fd=3 "$@" 3>&1
    echo "exit:$?:" >"$build_dir/apt.status")
  IFS=: read -r _ status _ <"$build_dir/apt.status"
  rm -f "$build_dir/apt.status"
  return "${status:-1}"
}

# If one optional package is not available, the others are still installed.
install_optional()
{
  install_packages "$@" && return
  local package
  for package in "$@"; do
    install_packages "$package"
  done
}

# choose A|B: A is for Qt 5, B for Qt 6, a single package for both. The caller's depends_of_paraview decides.
choose()
{
  if [[ $1 == *'|'* && $depends_of_paraview == *libqt6core* ]]; then echo "${1#*|}"; else echo "${1%%|*}"; fi
}

# unmet GROUP...: the packages of groups that are missing, one per line. If none of several alternatives ('A|B') is
# installed, all of them are listed.
unmet()
{
  local group entries=() missing entry package
  for group in "$@"; do
    read -ra entry < <(tr '\n' ' ' <<<"${packages[$group]}")
    entries+=("${entry[@]}")
  done
  missing=" $(missing_packages $(tr '|' ' ' <<<"${entries[*]}") | tr '\n' ' ')"
  for entry in "${entries[@]}"; do
    for package in ${entry//|/ }; do
      [[ $missing == *" $package "* ]] || continue 2
    done
    echo "$entry"
  done | sort -u
}

# groups_of JOB..., targets_of JOB...
groups_of()
{
  local job
  for job in "$@"; do echo "${needs[$job]%%:*}"; done
}

targets_of()
{
  local job
  for job in "$@"; do echo "${needs[$job]#*:}"; done
}

# Sorts the packages that jobs lack into the caller's missing_needed and missing_optional.
find_missing()
{
  missing_needed=() missing_optional=()
  local entry
  while read -r entry; do
    if [ -n "${optional_packages[$entry]:-}" ]; then
      missing_optional+=("$entry")
    else
      missing_needed+=("$entry")
    fi
  done < <(unmet $(groups_of "$@"))
}

# install_missing JOB...: installs the packages that find_missing found.
install_missing()
{
  local start=$SECONDS entry needed=() optional=() depends_of_paraview
  mkdir -p "$build_dir" && : >"$apt_log" || die "cannot write to $build_dir"
  progress "updating the lists of packages"
  apt update || say "apt-get update failed (see $apt_log); going on with the lists there are"
  depends_of_paraview=$(apt-cache depends paraview 2>/dev/null)
  for entry in "${missing_needed[@]}"; do needed+=("$(choose "$entry")"); done
  # Since version 6 ParaView is built on the system's VTK, whose headers paraview-dev does not install.
  if [[ $depends_of_paraview == *'Depends: libvtk9'* ]]; then
    needed+=(libvtk9-dev)
    [[ $(groups_of "$@") != *plugin* ]] || needed+=(libvtk9-qt-dev)
  fi
  for entry in "${missing_optional[@]}"; do
    entry=$(choose "$entry")
    if apt-cache show "$entry" >/dev/null 2>&1; then optional+=("$entry"); fi
  done
  compile_meanwhile
  # All packages are installed in one call, since each call takes seconds. If a package is not available, they are
  # installed one by one.
  install_packages "${needed[@]}" "${optional[@]}" || {
    [ ${#needed[@]} -eq 0 ] || install_packages "${needed[@]}" || tail -n 5 "$apt_log" >&2
    [ ${#optional[@]} -eq 0 ] || install_optional "${optional[@]}"
  }
  done_with "installed $((${#needed[@]} + ${#optional[@]})) packages and what they need in" \
    "$(minutes $((SECONDS - start))) (log: $apt_log)"
  finish_kernels
}

# On a system without a compiler, the packages of the group core come first. While the rest is
# downloaded and unpacked, the kernels are compiled, which need no VTK.
kernels_process=
compile_meanwhile()
{
  local first=()
  mapfile -t first < <(unmet core)
  [[ " ${first[*]} " == *' g++ '* ]] || return 0
  install_packages "${first[@]}" || return 0 # these packages are tried again with the rest
  build_kernels >"$build_dir/kernels.log" 2>&1 &
  kernels_process=$!
  trap 'kill "$kernels_process" 2>/dev/null' EXIT # prevents a second build in the same folder after an interrupt
}

finish_kernels()
{
  [ -n "$kernels_process" ] || return 0
  progress "compiling what needs no VTK (log: $build_dir/kernels.log)"
  wait "$kernels_process" # a failed part is built again later, and its errors are shown then
  kernels_process=
  trap - EXIT
}

report_missing()
{
  local package
  for package in "${missing_optional[@]}"; do
    say "not installed: $package - ${optional_packages[$package]}"
  done
  [ ${#missing_needed[@]} -gt 0 ] || return 0
  say "not installed: ${missing_needed[*]}"
  say "going on with what CMake finds. To install them, as root:"
  say "  apt-get install --no-install-recommends ${missing_needed[*]//|*/}"
}

# For another system: the names are hints, and CMake reports what it does not find.
list_packages()
{
  say "this system has no apt: nothing is installed. The build needs, by Debian's names:"
  unmet $(groups_of "$@") 2>/dev/null | tr '\n' ' ' | fold -s -w 96 | sed 's/^/  /' >&2
  echo >&2
}

# prepare_system JOB...
prepare_system()
{
  if is_debian_like; then
    local missing_needed missing_optional
    find_missing "$@"
    if [ $((${#missing_needed[@]} + ${#missing_optional[@]})) -gt 0 ]; then
      if may_install; then
        install_missing "$@"
        find_missing "$@"
      fi
      report_missing
    fi
  elif [ ! -e "$release_dir/build.ninja" ]; then
    list_packages "$@"
  fi
  local tool
  for tool in cmake ninja; do
    have "$tool" || die "$tool is not installed"
  done
}
