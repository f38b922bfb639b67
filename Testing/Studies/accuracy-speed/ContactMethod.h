// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Contact/TriangleProjection.h"

#include <cstddef>
#include <string>

namespace palpate::testing
{

/// One way to render what a tool feels. All methods of a scene answer the same tips.
class ContactMethod
{
public:
  virtual ~ContactMethod() = default;

  /// What the method is called in tables and charts.
  virtual std::string name() const = 0;

  /// Force on the tool at this tip, mm -> N, without friction. Tips come in the order of a path; a
  /// method may start from where the last one was.
  virtual Vector3 force(const Vector3& tip) = 0;

  /// The next tip has nothing to do with the last one.
  virtual void forget() {}

  /// What the tick reads from: tables, mesh and index, bytes in all.
  virtual std::size_t bytes() const = 0;
};

} // namespace palpate::testing
