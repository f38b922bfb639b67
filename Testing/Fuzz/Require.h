// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Require_h
#define palpate_testing_Require_h

#include <cstdio>
#include <cstdlib>

namespace palpate::testing
{
/// What must hold whatever comes in; the fuzzer keeps the input for which it does not.
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
