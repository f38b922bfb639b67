// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Sanitized_h
#define palpate_testing_Sanitized_h

// PALPATE_SANITIZED: this is compiled under the address or the thread sanitizer, which have a
// malloc of their own and let mlockall do nothing. g++ tells by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PALPATE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PALPATE_SANITIZED
#endif
#endif

namespace palpate::testing
{
/// How often something is repeated that is so many times elsewhere: under a sanitizer, which makes
/// it ten times as slow, a tenth.
constexpr int casesOf(int all)
{
#ifdef PALPATE_SANITIZED
  return all / 10;
#else
  return all;
#endif
}
} // namespace palpate::testing

#endif
