// SPDX-License-Identifier: BSD-3-Clause
// The definitions of the handles of palpate.h, for its implementation only.
#ifndef palpate_CInterface_h
#define palpate_CInterface_h

#include "Haptics/palpate.h"

#include "Contact/SettingTable.h"
#include "Haptics/Servo/ServoStep.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

struct palpate_body
{
  std::shared_ptr<const palpate::ContactBody> kernel;
};

struct palpate_contact
{
  palpate::ServoStep servo;
};

namespace palpate::c
{
/// Copies a reason to the buffer `error`, truncated to `size` bytes.
void report(const std::string& reason, char* error, std::size_t size);
/// Writes a fault to `error`, with the C name of the setting. Returns whether there is a fault.
bool isRefused(const SettingFault& fault, char* error, std::size_t size);

/// Reports nonzero elements of `reserved`, a member of the struct `name`. Such elements were set by
/// a program with a later header, or were not initialised. Returns whether any element is nonzero.
template <std::size_t N>
bool isFromLater(const double (&reserved)[N], const char* name, char* error, std::size_t size)
{
  const bool isZero =
    std::all_of(reserved, reserved + N, [](double value) { return value == 0.0; });
  if (!isZero)
  {
    report(std::string(name) + ".reserved must be zero: begin with its defaults; this is version " +
        palpate_version(),
      error, size);
  }
  return !isZero;
}

ContactSettings given(const palpate_settings& settings);

void copy(const Eigen::Vector3d& from, double to[3]);
void copy(const Tick& felt, palpate_tick* tick);
} // namespace palpate::c

#endif
