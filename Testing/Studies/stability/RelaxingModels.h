// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_RelaxingModels_h
#define palpate_testing_RelaxingModels_h

#include "ResponseModels.h"

#include "Contact/ContactSettings.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
/// p = 1 with τ = 0.01, 0.1 and 1 s, and three branches, as in stability_prony.csv of the reference
/// sheet.
inline std::vector<PronySeries> relaxingMaterials()
{
  std::vector<PronySeries> all(4);
  all[0].add(1.0, 0.01);
  all[1].add(1.0, 0.1);
  all[2].add(1.0, 1.0);
  all[3].add(0.5, 0.02);
  all[3].add(0.8, 0.2);
  all[3].add(1.2, 2.0);
  return all;
}

/// The material as text, such as "1:0.1" or "0.5:0.02 0.8:0.2 1.2:2": strength and time (s) of each
/// branch, without a comma.
inline std::string materialOf(const PronySeries& series)
{
  std::string text = textOf(series);
  for (char& each : text)
  {
    each = each == ',' ? ' ' : each;
  }
  return text.empty() ? "elastic" : text;
}

/// The body of plateOf(model), with relaxation.
std::shared_ptr<const ContactBody> relaxingPlate(
  const ResponseModel& model, const PronySeries& series);

inline ContactSettings withElements(int count)
{
  ContactSettings settings;
  settings.relaxationElements = count;
  return settings;
}
/// Numbers of relaxation elements in the study: 16 elements, and 0 for quasi-linear.
constexpr int AllElements[] = { 16, 0 };
} // namespace palpate::testing

#endif
