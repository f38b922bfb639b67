# SPDX-License-Identifier: BSD-3-Clause
#
# ./run sources this file. It configures and builds, and shows the progress.

is_ci()
{
  case ${CI:-} in
    '' | 0 | false | FALSE | no) return 1 ;;
  esac
}

# Sources are compiled through ccache if it is installed: release and plain-vtk share the kernels, and a second clone
# compiles only what is new in it, since the hashes do not contain paths.
export CCACHE_BASEDIR=$source_dir CCACHE_NOHASHDIR=1
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime

# Whether the packages of a group are installed, or whether this cannot be determined.
has_group()
{
  is_debian_like || return 0
  local entry
  while read -r entry; do
    [ -n "${optional_packages[$entry]:-}" ] || return 1
  done < <(unmet "$1")
}

on_if() { if "$@"; then echo ON; else echo OFF; fi; }

# cmake_options PRESET: the options depend on the installed packages. They do not change how a source is compiled, so
# that nothing is compiled again after more packages are installed.
cmake_options()
{
  echo "-DPALPATE_BUILD_PLUGIN=$(on_if has_group plugin)"
  echo "-DBUILD_TESTING=$(on_if has_group gtest)"
  # In continuous integration the cache is empty, and filling it takes a tenth of the time. There it is used only for
  # the kernels, which release and plain-vtk share.
  echo "-DPALPATE_CACHE_TESTS=$(is_ci && echo OFF || echo ON)"
  # With the thread sanitizer, compiling the solids takes three minutes for the tests of only five files. These tests
  # are therefore among the long tests.
  [ "$1" != tsan ] || echo "-DPALPATE_TEST_THREADS_OF_SOLIDS=$(on_if is_long)"
  if have ccache && ! { is_ci && [[ $1 == [at]san ]]; }; then
    printf -- '-DCMAKE_%s_COMPILER_LAUNCHER=ccache\n' C CXX
  fi
}

# configure PRESET: configures the first time, and whenever presets, options or installed packages have changed. Ninja
# notices changes of CMakeLists.txt.
configure()
{
  local preset=$1 options stamp=$build_dir/$1/configured-by-run log=$build_dir/$1/configure.log
  mapfile -t options < <(cmake_options "$preset")
  if [ -e "$build_dir/$preset/build.ninja" ] && [ "${options[*]}" = "$(cat "$stamp" 2>/dev/null)" ] &&
    [ ! "$source_dir/CMakePresets.json" -nt "$stamp" ] && [ ! /var/lib/dpkg/status -nt "$stamp" ]; then
    return 0
  fi
  mkdir -p "$build_dir/$preset" || return 1
  progress "configuring $preset"
  (cd "$source_dir" && cmake --preset "$preset" "${options[@]}") >"$log" 2>&1 || {
    done_with "error: could not configure $preset (log: $log):"
    grep -A 15 'CMake Error' "$log" | head -n 60 >&2
    return 1
  }
  echo "${options[*]}" >"$stamp"
}

# Builds the kernels of the release build before VTK is installed. The commands are the same as with VTK, so that
# nothing is compiled again.
build_kernels()
{
  local options
  mapfile -t options < <(cmake_options release)
  cd "$source_dir" && cmake --preset release "${options[@]}" -DPALPATE_WITH_VTK=OFF -DBUILD_TESTING=OFF &&
    exec nice ninja -C "$release_dir" palpateLaws palpateHaptics
}

# Reads ninja's lines "[done/all] step" and shows the progress and the estimated remaining time.
show_build()
{
  local line start=$SECONDS finished all left
  while read -r line; do
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    finished=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
    ((finished > 0)) || continue
    left=$(((SECONDS - start) * (all - finished) / finished))
    progress "building $1: $finished of $all, about $(minutes $left) left"
  done
}

# build PRESET TARGETS [COMMAND]: with COMMAND, cmake runs under that command. The compiler's output is shown if it
# fails; in continuous integration a warning is a failure, too.
build()
{
  local preset=$1 targets=$2 start=$SECONDS log=$build_dir/$1/build.log status
  configure "$preset" || return 1
  (cd "$source_dir" && "${@:3}" cmake --build --preset "$preset" --target $targets) 2>&1 |
    tee "$log" | show_build "$preset"
  status=${PIPESTATUS[0]}
  if [ "$status" -ne 0 ]; then
    done_with "error: could not build $preset (log: $log):"
    sed -n '/^FAILED: /,/^\[/p' "$log" | grep -vE '^(\[|ccache |/usr/bin/c)' | head -n 60 >&2
    [ -n "$(sed -n '/^FAILED: /p' "$log")" ] || tail -n 20 "$log" >&2
    return 1
  fi
  if is_ci && grep -q ' warning: ' "$log"; then
    done_with "error: the compiler warns in $preset (log: $log):"
    grep -A 4 ' warning: ' "$log" | head -n 60 >&2
    return 1
  fi
  ((SECONDS - start < 3)) || done_with "built $preset in $(minutes $((SECONDS - start))) (log: $log)"
}

# build_release JOB [ADDITION...]: the first step of every job. All its messages go to the error stream; the output
# stream contains only the output of the job.
build_release()
{
  prepare_system "$@"
  build release "$(targets_of "$@" | tr '\n' ' ')" || exit 1
}
