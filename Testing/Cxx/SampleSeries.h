// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_SampleSeries_h
#define palpate_testing_SampleSeries_h

#include "Mechanics/Relaxation/PronySeries.h"

#include <array>
#include <initializer_list>
#include <sstream>
#include <string>

namespace palpate::testing
{
/// Makes a series from branches { p, τ }.
inline PronySeries relaxation(std::initializer_list<std::array<double, 2>> branches)
{
  PronySeries series;
  for (const auto& [strength, time] : branches)
  {
    series.add(strength, time);
  }
  return series;
}

/// Makes a series from two texts of a reference table, for example "0.5 0.8" and "0.02 0.2" (s).
inline PronySeries relaxation(const std::string& strengths, const std::string& times)
{
  std::istringstream p(strengths);
  std::istringstream tau(times);
  PronySeries series;
  double strength = 0.0;
  for (double time = 0.0; p >> strength && tau >> time;)
  {
    series.add(strength, time);
  }
  return series;
}
} // namespace palpate::testing

#endif
