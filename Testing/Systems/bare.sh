#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
#
# bare.sh SYSTEM [JOB ...] - what a newcomer meets: makes a bare Debian (debootstrap, minbase) of the given
# code name (bookworm, trixie, sid) in build/systems/SYSTEM, puts the last commit of this checkout into it,
# and runs jobs there, timed from outside, on two processors:
#
#   demo       ./run demo, from the bare system to the first picture
#   again      ./run demo once more
#   test       ./run test
#   package    ./run package
#   install    the packages in another bare system: installed, tried and purged (check_package.sh)
#   deprecated the release build with -Werror=deprecated-declarations
#   all        ./run test --all
#
# Without JOBs: demo again test package install. Each job goes on from where the one before left the system.
# Logs in build/systems/SYSTEM.log. Testing/Systems/report.md has the last times of each system, times.csv the times of all runs:
# both are committed.
#
#   MIRROR=ADDRESS   another mirror than debootstrap's own
#   KEEP=1           goes on in the system that there is, and keeps the report's rows of other jobs
#
# Needs root and debootstrap. The host's settings of apt (/etc/apt/apt.conf.d/99*, a proxy) come along.
# Exit code: 0 if all jobs passed, 1 if one failed, 2 for a wrong call.
set -u
here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd) || exit 1
source=$(cd -- "$here/../.." && pwd) || exit 1
system=${1:-}
[ -n "$system" ] || { sed -n '4,25s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
[ "$(id -u)" -eq 0 ] || { echo 'bare.sh: needs root' >&2; exit 2; }
command -v debootstrap >/dev/null || { echo 'bare.sh: needs debootstrap' >&2; exit 2; }
shift
jobs=("$@")
[ ${#jobs[@]} -gt 0 ] || jobs=(demo again test package install)

systems=$source/build/systems
root=$systems/$system
logs=$systems/$system.log
report=$here/report.md
mkdir -p "$logs" || exit 1

# make_bare ROOT: from a pristine copy, which is made once.
make_bare()
{
  local pristine=$systems/$system.pristine
  if [ ! -e "$pristine/complete" ]; then
    rm -rf "$pristine"
    debootstrap --variant=minbase "$system" "$pristine" ${MIRROR:+"$MIRROR"} >"$logs/debootstrap" 2>&1 ||
      { tail -n 5 "$logs/debootstrap"; return 1; }
    cp /etc/apt/apt.conf.d/99* "$pristine/etc/apt/apt.conf.d/" 2>/dev/null
    touch "$pristine/complete"
  fi
  leave "$1"
  rm -rf --one-file-system "$1" && cp -a "$pristine" "$1"
}

# enter ROOT COMMAND...: in the system, with nothing of the host's environment but its network.
enter()
{
  local place=$1
  shift
  mountpoint -q "$place/proc" || mount -t proc proc "$place/proc"
  mountpoint -q "$place/sys" || mount -t sysfs sysfs "$place/sys"
  mountpoint -q "$place/dev" || { mount --rbind /dev "$place/dev" && mount --make-rslave "$place/dev"; }
  cp -L /etc/resolv.conf /etc/hosts "$place/etc/" 2>/dev/null
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" \
    chroot "$place" "$@" </dev/null
}

leave()
{
  local place
  for place in dev sys proc; do
    ! mountpoint -q "$1/$place" || umount -R -l "$1/$place"
  done
}

version() { enter "$root" dpkg-query -W -f '${Version}' "$1" 2>/dev/null || echo -; }

# write_report: the system's section of the report, in place of an older one.
write_report()
{
  local section=$logs/section job
  {
    echo "## $system"
    echo
    echo "$(enter "$root" sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release);" \
      "ParaView $(version paraview-dev), Python $(version python3), g++ $(version g++)," \
      "CMake $(version cmake), Eigen $(version libeigen3-dev), hidapi $(version libhidapi-dev);" \
      "$(nproc) processors."
    echo
    echo '| job | what | min:s | packages it added | outcome | commit, day |'
    echo '|---|---|---|---|---|---|'
    for job in demo again test all package install deprecated; do
      [ -z "${rows[$job]:-}" ] || echo "${rows[$job]}"
    done
  } >"$section"
  awk -v own="## $system" '/^## /{skip = $0 == own} !skip' "$report" >"$section.others"
  { cat "$section.others"; [ -z "$(tail -n 1 "$section.others")" ] || echo; cat "$section"; } >"$report"
}

# add_row JOB WHAT SECONDS PACKAGES OUTCOME
add_row()
{
  echo "$(date -u +%Y-%m-%d),$commit,$system,$(nproc),$1,$3,$([[ $5 == passed* ]] && echo passed || echo failed)" >>"$here/times.csv"
  rows[$1]="| $1 | \`$2\` | $(($3 / 60)):$(printf %02d $(($3 % 60))) | $4 | $5 | $commit, $(date -u +%Y-%m-%d) |"
  echo "${rows[$1]}"
  write_report
}

# The rows that the report has of this system.
read_rows()
{
  local row job
  while IFS= read -r row; do
    IFS=' ' read -r _ job _ <<<"$row"
    rows[$job]=$row
  done < <(awk -v own="## $system" '/^## /{ours = $0 == own} ours && /^\| [a-z]+ \| `/' "$report")
}

count_packages() { enter "$root" dpkg-query -W 2>/dev/null | wc -l; }

# run_job NAME COMMAND: in the sources, which lie in /root/palpate of the system that was made.
run_job()
{
  local before start=$SECONDS status
  before=$(count_packages)
  enter "$root" bash -c "cd /root/palpate && $2" >"$logs/$1" 2>&1
  status=$?
  local seconds=$((SECONDS - start)) outcome=passed
  [ $status -eq 0 ] || { outcome="**failed** ($status)"; failed=1; }
  case $1 in
    demo | again) outcome+=", $(grep -c '\.png$' "$logs/$1") pictures" ;;
    test | all) outcome+=": $(grep -E '^[0-9]+% tests passed' "$logs/$1" | sed 's/^[0-9]*% tests passed, //' | paste -sd ';')" ;;
    package) outcome+=": $(sed -n 's|.*/\(palpate.*\.deb\)$|\1|p' "$logs/$1" | sort -u | paste -sd ' ')" ;;
  esac
  add_row "$1" "$2" $seconds $(($(count_packages) - before)) "$outcome"
}

# The packages are tried where nothing was ever built.
try_packages()
{
  local place=$root.installed start=$SECONDS status
  make_bare "$place" || return 1
  mkdir -p "$place/root/package" &&
    cp "$root"/root/palpate/build/package/*.deb "$here/check_package.sh" "$place/root/package/" &&
    enter "$place" bash /root/package/check_package.sh /root/package >"$logs/install" 2>&1
  status=$?
  leave "$place"
  local outcome=passed seconds=$((SECONDS - start))
  [ $status -eq 0 ] || { outcome="**failed** ($status)"; failed=1; }
  outcome+=": $(sed -n 's/^check_package: palpate \(installed in [0-9]* s\).*/\1/p' "$logs/install"); $(tail -n 1 "$logs/install")"
  add_row install check_package.sh $seconds - "$outcome"
}

failed=0
declare -A rows=()
commit=$(git -C "$source" rev-parse --short HEAD)
[ -z "${KEEP:-}" ] || read_rows
if [ -z "${KEEP:-}" ] || [ ! -d "$root/root/palpate" ]; then
  make_bare "$root" || exit 1
  mkdir -p "$root/root/palpate"
fi
trap 'leave "$root"; leave "$root.installed"' EXIT
git -C "$source" archive HEAD | tar -x -C "$root/root/palpate" || exit 1
for job in "${jobs[@]}"; do
  case $job in
    demo | again) run_job "$job" './run demo' ;;
    test) run_job test './run test' ;;
    all) run_job all './run test --all' ;;
    package) run_job package './run package' ;;
    deprecated) run_job deprecated \
      'CXXFLAGS=-Werror=deprecated-declarations cmake --preset release -B build/deprecated && cmake --build build/deprecated' ;;
    install) try_packages ;;
    *) echo "bare.sh: there is no job '$job'" >&2; failed=1 ;;
  esac
done
exit $failed
