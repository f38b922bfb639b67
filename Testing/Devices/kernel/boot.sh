#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
#
# boot.sh PROGRAM KERNEL_DIR WORK_DIR [GTEST ARGS]: boots Debian's kernel in QEMU with nothing but
# PROGRAM, its libraries and the modules for uhid, and PROGRAM as the first process. No KVM, no disk, no
# network; the console tells the result. KERNEL_DIR is what `./run test` unpacks from the package of the
# kernel (prepare_kernel).
#
# Exit code: 0 passed, 1 failed or not over after ten minutes, 77 it cannot be run here.

set -u
readonly program=$1 kernel_dir=$2 work=$3 seconds=600
shift 3

skip() { echo "Skipped: $*"; exit 77; }

[ "$(uname -m)" = x86_64 ] || skip "the kernel is for amd64, this is $(uname -m)"
for tool in qemu-system-x86_64 cpio; do
  command -v "$tool" >/dev/null || skip "$tool is not installed"
done
kernels=("$kernel_dir"/boot/vmlinuz-*)
kernel=${kernels[0]}
[ -r "$kernel" ] || skip "there is no kernel in $kernel_dir/boot (./run test unpacks one)"

# The file of a module, if it needs no other one than hid, which is loaded first.
module_file()
{
  local file other
  file=$(find "$kernel_dir/lib/modules" -name "$1.ko" -print -quit)
  [ -n "$file" ] || { echo "there is no module $1 in $kernel_dir" >&2; return 1; }
  for other in $(tr '\0' '\n' <"$file" | sed -n 's/^depends=//p' | tr ',' ' '); do
    [ "$other" = hid ] || { echo "module $1 now needs $other: load it in KernelMain.cxx" >&2; return 1; }
  done
  echo "$file"
}

root=$work/root
rm -rf "$work" && mkdir -p "$root/modules" || exit 1
for module in hid hid-generic uhid; do
  file=$(module_file "$module") && cp "$file" "$root/modules/" || exit 1
done
# Libraries keep their places, so that the program's own search path holds.
ldd "$program" | grep -o '/[^ ]*' | while read -r library; do
  mkdir -p "$root/$(dirname "$library")" && cp -L "$library" "$root/$library"
done
cp "$program" "$root/init" || exit 1
(cd "$root" && find . -print0 | cpio --quiet --null --create --format=newc) >"$work/initramfs" || exit 1

# What follows -- are the program's arguments.
timeout --kill-after=2 "$seconds" qemu-system-x86_64 -accel tcg -cpu max -smp 1 -m 512 -nographic \
  -no-reboot -nodefaults -serial stdio -kernel "$kernel" -initrd "$work/initramfs" \
  -append "console=ttyS0 panic=-1 quiet -- --gtest_color=no $*" </dev/null | tr -d '\r' | tee "$work/console.log"
status=${PIPESTATUS[0]}
rm -rf "$root" "$work/initramfs"
[ "$status" -ne 124 ] || echo "boot.sh: not over after $seconds s"
[ "$status" -eq 0 ] && grep -qx 'palpate kernel job: passed' "$work/console.log"
