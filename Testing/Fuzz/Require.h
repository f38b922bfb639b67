// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Require_h
#define palpate_testing_Require_h

#include <cstdio>
#include <cstdlib>

namespace palpate::testing
{
/// Checks a requirement that must hold for every input. The fuzzer keeps an input that violates it.
inline void require(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
  }
}
} // namespace palpate::testing

#endif
