// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Contact/TriangleProjection.h"

#include <cstddef>
#include <string>

namespace palpate::testing
{

/// A method that computes the force on a tool. All methods of a scene get the same tips.
class ContactMethod
{
public:
  virtual ~ContactMethod() = default;

  /// Name of the method in tables and charts.
  virtual std::string name() const = 0;

  /// Force on the tool at this tip, mm -> N, without friction. Tips come in the order of a path; a
  /// method may start its search at the last tip.
  virtual Vector3 force(const Vector3& tip) = 0;

  /// To be called if the next tip is unrelated to the last one.
  virtual void forget() {}

  /// Bytes that the tick reads: tables, mesh and index.
  virtual std::size_t bytes() const = 0;
};

} // namespace palpate::testing
