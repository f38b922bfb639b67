// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyKernels_h
#define BodyKernels_h

#include "Contact/ContactBody.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace palpate
{
/// The kernels of a body for the ticks of a session, and the peaks of its responses. Both are
/// stored under the prefix of the response. Both may be computed on any thread.
struct BodyKernels
{
  /// Largest force (N) and largest stiffness (N/mm) of a response.
  using Peaks = std::pair<double, double>;

  std::map<std::string, std::shared_ptr<const ContactBody>> read;
  /// Peaks of a response down to a depth (mm). The key consists of the prefix and the depth.
  std::map<std::pair<std::string, double>, std::optional<Peaks>> peaks;
};
} // namespace palpate

#endif
