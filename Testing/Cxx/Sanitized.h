// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Sanitized_h
#define palpate_testing_Sanitized_h

// PALPATE_SANITIZED: the code is compiled under the address or the thread sanitizer. Both have
// their own malloc, and mlockall does nothing under them. g++ reports the sanitizers by a macro,
// clang by a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PALPATE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PALPATE_SANITIZED
#endif
#endif

namespace palpate::testing
{
/// Number of repetitions: `all`, or a tenth of `all` under a sanitizer, which makes the code ten
/// times as slow.
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
