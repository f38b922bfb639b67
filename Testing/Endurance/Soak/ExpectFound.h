// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_ExpectFound_h
#define palpate_endurance_ExpectFound_h

#include "TickSeries.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace palpate::endurance
{
/// Expects that the first fault is of this kind and in this tick.
inline void expectFound(const TickSeries& series, TickFault fault, std::size_t tick)
{
  const TickSeries::Finding found = series.firstFault();
  EXPECT_STREQ(nameOf(found.fault), nameOf(fault)) << found.text;
  EXPECT_EQ(found.tick, tick) << found.text;
}
} // namespace palpate::endurance

#endif
