#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
#
# check_package.sh FOLDER - installs the packages of FOLDER (as ./run package leaves them) in this system, uses them
# and purges them. For a bare Debian that may be spoilt: a chroot of debootstrap --variant=minbase with apt set up.
# As root. The last line is "check_package: all is well"; anything that fails ends it with another.
#
#   PALPATE_CHECK_LIMIT  the longest that installing may take, s (120)
#   PALPATE_CHECK_BUILD=1  also compiles the programs of Testing/Consumers against palpate-dev (installs compilers)

set -eu -o pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
unset PYTHONPATH PV_PLUGIN_PATH PV_PLUGIN_CONFIG_FILE LD_LIBRARY_PATH

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
limit=${PALPATE_CHECK_LIMIT:-120}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work/home XDG_RUNTIME_DIR=$work/run XDG_CACHE_HOME=$work/cache # Mesa asks the latter, then passwd
mkdir -p "$HOME" "$XDG_RUNTIME_DIR"
chmod 700 "$XDG_RUNTIME_DIR"

say() { printf 'check_package: %s\n' "$*"; }
die() { say "FAILED: $*"; exit 1; }
apt() { apt-get -qq -o Dpkg::Use-Pty=0 "$@" </dev/null >"$work/apt.log" 2>&1 || { cat "$work/apt.log"; die "apt-get $*"; }; }

# Every file and folder, but for what packages' tools write about packages, and what is not kept.
list_files()
{
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /run -o -path "$work" \
    -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache/apt -o -path /var/log -o -path /var/cache/debconf \
    -o -path /var/cache/ldconfig -o -path "$here" \) -prune -o -printf '%y %p %l\n' | sort
}

[ "$(id -u)" -eq 0 ] || die "not root"
runtime=$(find "$(realpath "${1:?the folder of the packages}")" -name 'palpate_*.deb')
development=$(find "$(realpath "$1")" -name 'palpate-dev_*.deb')
[ -f "$runtime" ] && [ -f "$development" ] || die "$1 does not hold one palpate_*.deb and one palpate-dev_*.deb"

# install PACKAGE FILE: says how long it took, and how much of that a processor was at work; sets `took`.
install()
{
  local spent TIMEFORMAT='%R %U %S'
  { time apt install --yes --no-install-recommends "$2" 2>&3; } 3>&2 2>"$work/time"
  read -ra spent <"$work/time"
  took=${spent[0]%.*}
  say "$1 installed in $took s ($((${spent[1]%.*} + ${spent[2]%.*})) s of a processor)," \
    "with $(grep -c '^Setting up' "$work/apt.log") packages"
}

# --- Installed as a user does, from nothing
apt update
install palpate "$runtime"
[ "$took" -le "$limit" ] || die "installing took longer than $limit s"
install palpate-dev "$development"

# What the checks need; and then what is there without Palpate.
apt install --yes --no-install-recommends xvfb xauth lintian ${PALPATE_CHECK_BUILD:+g++ cmake ninja-build}
apt purge --yes palpate palpate-dev
list_files >"$work/before"
! grep -i 'palpate' "$work/before" || die "the first purge left these"
apt install --yes --no-install-recommends "$runtime" "$development"

# --- The program
palpate --version
xvfb-run -a palpate --scene cylinder --output "$work/session" >"$work/session.log" 2>&1 ||
  { cat "$work/session.log"; die "palpate"; }
for picture in overview deflection curves; do
  [ -s "$work/session/$picture.png" ] || die "palpate left no $picture.png"
done
say "palpate left $(find "$work/session" -type f | wc -l) files"
ldd /usr/bin/palpate | grep 'not found' && die "a library is not found"
[ -s /usr/share/man/man1/palpate.1.gz ] || die "no man page"

# --- Python: the force of a flat end on a half-space, F = 2 a E* d
cat >"$work/press.py" <<'EOF'
from palpate import vtkContactTool, vtkToolContactResponse, vtkToolContactProbe
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
body = vtkSphereSource()
body.SetRadius(50)
body.SetThetaResolution(100)
body.SetPhiResolution(100)
tool = vtkContactTool()
tool.SetSpecification("flat:2")
response = vtkToolContactResponse()
response.SetInputConnection(body.GetOutputPort())
response.SetTool(tool)
response.SetYoungsModulus(0.75)
response.SetPoissonRatio(0.5)
response.CurvatureCorrectionOff()
points = vtkPoints()
points.InsertNextPoint(0, 0, 49.5)
tip = vtkPolyData()
tip.SetPoints(points)
probe = vtkToolContactProbe()
probe.SetInputConnection(0, response.GetOutputPort())
probe.SetInputData(1, tip)
probe.Update()
felt = probe.GetOutput().GetPointData()
depth, force = felt.GetArray("Deflection").GetTuple1(0), felt.GetArray("NormalForce").GetTuple1(0)
assert abs(depth - 0.5) < 0.01 and abs(force - 4 * depth) < 1e-6, (depth, force)
print("force", force)
EOF
/usr/bin/python3 "$work/press.py" | grep '^force' || die "python3"
pvpython "$work/press.py" | grep '^force' || die "pvpython"

# --- ParaView lists the plugin as loaded, in pvpython and in its window
cat >"$work/plugins.py" <<'EOF'
import os, sys
from paraview import servermanager, simple
plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
found = [plugins.GetPluginName(i) for i in range(plugins.GetNumberOfPlugins()) if plugins.GetPluginLoaded(i)]
made = simple.ToolContactResponse(Input=simple.Sphere(Radius=50))
made.UpdatePipeline()
arrays = made.PointData.keys()
with open(os.environ["PALPATE_ANSWER"], "w") as answer:
    answer.write("loaded %s\narrays %s\n" % (found, arrays))
os._exit(0)
EOF
for program in pvpython paraview; do
  export PALPATE_ANSWER=$work/$program.answer
  case $program in
    pvpython) pvpython "$work/plugins.py" || true ;;
    paraview) timeout 120 xvfb-run -a paraview --script="$work/plugins.py" >"$work/paraview.log" 2>&1 || true ;;
  esac
  grep -q "^loaded .*'Palpate'" "$PALPATE_ANSWER" || { cat "$PALPATE_ANSWER" "$work"/*.log; die "$program: not loaded"; }
  grep -q "^arrays .*'ResponseForce'" "$PALPATE_ANSWER" || { cat "$PALPATE_ANSWER"; die "$program: no response"; }
  say "$program: $(head -n 1 "$PALPATE_ANSWER")"
done

# --- What others build against it
if [ -n "${PALPATE_CHECK_BUILD:-}" ]; then
  xvfb-run -a palpate --scene cylinder --tool sphere:6.35 --output "$work/session" \
    --export "$work/cylinder.palpate" >/dev/null
  for consumer in c loop vtk; do
    cmake -G Ninja -S "$here/../Consumers/$consumer" -B "$work/$consumer" -DCMAKE_BUILD_TYPE=Release >"$work/cmake.log" 2>&1 &&
      cmake --build "$work/$consumer" >>"$work/cmake.log" 2>&1 || { cat "$work/cmake.log"; die "consumer $consumer"; }
    "$work/$consumer/consumer" "$work/cylinder.palpate" || die "consumer $consumer"
  done
fi

# --- Debian's own judgement
lintian --allow-root --tag-display-limit 0 --fail-on error "$runtime" "$development" || die "lintian"

# --- Nothing is left
apt purge --yes palpate palpate-dev
list_files >"$work/after"
diff "$work/before" "$work/after" || die "purging left these (>) or took them (<)"
say "all is well"
