# SPDX-License-Identifier: BSD-3-Clause
#
# ./run sources this file. It builds and runs the suites of tests, and sums up the results.

# Plain VTK conflicts with ParaView's packages, so its packages are not installed but unpacked in a folder of the build.
readonly plain_vtk=$build_dir/vtk

prepare_plain_vtk()
{
  [ ! -e "$plain_vtk/complete" ] || return 0
  is_debian_like || { say "plain VTK: there is no apt"; return 1; }
  local folder=$plain_vtk.part needed
  mapfile -t needed < <(apt-cache depends libvtk9-dev 2>/dev/null |
    sed -n 's/^ *Depends: \(.*vtk9.*\)/\1/p' | sed 's/^\(libvtk9\.[0-9]*\)$/\1\n\1-qt/')
  [ ${#needed[@]} -gt 0 ] || { say "plain VTK: there is no libvtk9-dev"; return 1; }
  rm -rf "$folder" "$plain_vtk" && mkdir -p "$folder/packages" || return 1
  progress "unpacking libvtk9-dev ${needed[*]}"
  download_packages "$folder/packages" libvtk9-dev "${needed[@]}" ||
    { say "plain VTK: its packages are not to be had"; return 1; }
  local package
  for package in "$folder"/packages/*.deb; do
    dpkg -x "$package" "$folder" || return 1
  done
  rm -r "$folder/packages" && touch "$folder/complete" && mv "$folder" "$plain_vtk"
}

# download_packages FOLDER PACKAGES: if the lists of packages are too old, they are updated and the download is
# repeated.
download_packages()
{
  local folder=$1
  shift
  (cd "$folder" && apt-get -qq download "$@" >&2) ||
    { apt update && (cd "$folder" && apt-get -qq download "$@" >&2); }
}

# A kernel for the emulated machine that plugs in HID devices. The kernel and the modules for HID are unpacked from the
# newest package; boot.sh checks for which CPUs the modules are.
readonly kernel_dir=$build_dir/kernel

prepare_kernel()
{
  [ ! -e "$kernel_dir/complete" ] || return 0
  is_debian_like || { say "kernel: there is no apt"; return 1; }
  local folder=$kernel_dir.part package
  package=$(LC_ALL=C apt-cache depends linux-image-amd64 | sed -n 's/^ *Depends: \(linux-image-[0-9].*\)/\1/p' | head -n 1)
  [ -n "$package" ] || { say "kernel: linux-image-amd64 depends on none"; return 1; }
  rm -rf "$folder" "$kernel_dir" && mkdir -p "$folder/packages" || return 1
  progress "unpacking $package"
  download_packages "$folder/packages" "$package" ||
    { say "kernel: $package is not to be had"; return 1; }
  dpkg --fsys-tarfile "$folder"/packages/*.deb | tar -x -C "$folder" --wildcards \
    --transform 's,^\./usr/lib,./lib,' './boot/vmlinuz-*' '*lib/modules/*/kernel/drivers/hid/*' || return 1
  rm -r "$folder/packages" && touch "$folder/complete" && mv "$folder" "$kernel_dir"
}

# The thread sanitizer of g++ 12 fails if the kernel randomises addresses more than the sanitizer expects.
tsan_launcher()
{
  if setarch -R true 2>/dev/null; then echo setarch -R; fi
}

# The suite plain-vtk needs no other program; its tests in C++ are among the long tests.
suite_targets()
{
  case $1 in
    plain-vtk) echo palpate palpateModules palpatePython; ! is_long || echo palpateResponseTests palpateInteractionTests ;;
    release) is_long && echo all palpateLong || echo all ;;
    *) echo all ;;
  esac
}

# run_suite PRESET [CTEST ARGS]: builds, tests, and adds a row to the table.
run_suite()
{
  local preset=$1 launcher=() choice=() start=$SECONDS
  shift
  [ "$preset" != tsan ] || read -ra launcher < <(tsan_launcher)
  is_long || choice=(-LE 'Long') # under sanitizers, neither Heavy nor Long is registered
  is_long || [ "$preset" != plain-vtk ] || choice+=(-R '^(Python|Viewer)')
  printf '\n=== %s\n' "$preset"
  if [ "$preset" = plain-vtk ] && ! prepare_plain_vtk; then
    add_row "$preset" 'not run' - - 0 0
    ! is_ci # in CI all suites must be possible
    return
  fi
  if ! build "$preset" "$(suite_targets "$preset")" "${launcher[@]}"; then
    add_row "$preset" 'not built' - - "$((SECONDS - start))" 0
    return 1
  fi

  local built=$((SECONDS - start)) status log=$build_dir/$preset/ctest.log
  # For two processors. Tests with windows and devices often wait, but fail if they wait for too long.
  local at_a_time=4
  case $preset in release | plain-vtk) launcher=(on_virtual_display) at_a_time=3 ;; esac
  rm -f "$log" "$(failed_tests "$preset")"
  (cd "$source_dir" &&
    "${launcher[@]}" ctest --preset "$preset" -j "$at_a_time" --output-log "$log" "${choice[@]}" "$@")
  status=$?
  read_log "$log"
  if [ "$tests_run" -eq 0 ] && [ $# -eq 0 ]; then
    say "error: $preset has no tests"
    status=1
  fi
  total_run=$((total_run + tests_run)) total_skipped=$((total_skipped + tests_skipped))
  add_row "$preset" "$tests_run" "$tests_failed" "$tests_skipped" "$built" \
    "$((SECONDS - start - built))"
  labels+=("$(label_times "$preset" "$log")")
  return $status
}

# The processor times that ctest sums up per label, as rows "suite label seconds tests".
label_times()
{
  sed -n '/^Label Time Summary/,/^$/p' "$2" |
    sed -nE "s|^(\S+) +=  *([0-9]+)[0-9.]* sec\*proc *\(([0-9]+) test.*|$1 \1 \2 \3|p"
}

# Checks the sources against the headers of Debian 13; adds a row to the table, as a suite with one test.
check_trixie()
{
  local log=$build_dir/trixie.log start=$SECONDS status
  printf '\n=== trixie\n'
  "$source_dir/Testing/Systems/check_trixie.sh" 2>&1 | tee "$log"
  status=${PIPESTATUS[0]}
  if [ "$status" -eq 77 ]; then
    add_row trixie 'not run' - - 0 0 # Debian 13's packages are missing; not every network has them
    return 0
  fi
  total_run=$((total_run + 1))
  add_row trixie 1 "$((status != 0))" 0 0 "$((SECONDS - start))"
  return "$status"
}

# The file in which ctest leaves "number:name" of each test that failed.
failed_tests() { echo "$build_dir/$1/Testing/Temporary/LastTestsFailed.log"; }

# show_failures PRESET: shows the tests that failed, and the end of the output of each.
show_failures()
{
  local list name
  list=$(failed_tests "$1")
  [ -e "$list" ] || return 0
  while IFS=: read -r _ name; do
    printf '\n--- %s: %s failed\n' "$1" "$name"
    awk -v start="\"$name\" start time:" 'index($0, start) == 1 { ours = 1 } ours; ours && /^<end of output>/ { exit }' \
      "${list%/*}/LastTest.log" | tail -n 20
  done <"$list"
}

# Reads the closing lines of ctest into the caller's tests_run, tests_failed and tests_skipped.
read_log()
{
  tests_failed=0 tests_run=0 tests_skipped=0
  [ -e "$1" ] || return
  read -r tests_failed tests_run < <(
    sed -n 's/.*tests passed, \([0-9]*\) tests failed out of \([0-9]*\).*/\1 \2/p' "$1" | tail -n 1)
  tests_skipped=$(grep -cE '^[[:space:]]*[0-9]+ - .*\((Skipped|Disabled|Not Run.*)\)$' "$1")
  tests_run=${tests_run:-0} tests_failed=${tests_failed:-0}
}

add_row() { table+=("$(printf '%-9s %9s %7s %8s %8s s %7s s' "$@")"); }

# Whether the long tests are requested.
long_tests=
is_long() { [ -n "$long_tests" ]; }

# All suites are run even if one fails.
run_test()
{
  local job=test suites=(release)
  if [ "${1:-}" = --all ]; then
    shift
    job=test-all suites=(release plain-vtk asan tsan) long_tests=yes
  elif is_ci; then
    job=test-ci suites=(release plain-vtk asan tsan)
  fi
  prepare_system "$job"
  rm -f "$build_dir/trixie.log"
  local failed=0 preset total_run=0 total_skipped=0 table=() labels=()
  local tests_run tests_failed tests_skipped
  ! is_long || prepare_kernel || ! is_ci || failed=1 # in CI all suites must be possible
  for preset in "${suites[@]}"; do
    run_suite "$preset" "$@" || failed=1
  done
  [ "$job" = test ] || [ $# -gt 0 ] || check_trixie || failed=1
  printf '\n%-9s %-14s %9s %7s\n' suite label 'seconds' tests
  printf '%s\n' "${labels[@]}" | sort -k1,1 -k3,3nr | while read -r row; do
    printf '%-9s %-14s %9s %7s\n' $row
  done
  printf '\n%-9s %9s %7s %8s %10s %9s\n' suite tests failed skipped building testing
  printf '%s\n' "${table[@]}"
  if [ $total_run -eq 0 ]; then
    say "error: no test was run"
    failed=1
  fi
  if [ $failed -eq 0 ]; then
    echo "All tests passed, but for $total_skipped skipped."
    is_long || echo "All suites, and the long tests, are run by: ./run test --all"
  else
    for preset in "${suites[@]}"; do show_failures "$preset"; done
    [ ! -e "$build_dir/trixie.log" ] || grep -A 4 ' error: ' "$build_dir/trixie.log" | head -n 60
    echo 'THERE WERE FAILURES.'
  fi
  return $failed
}
