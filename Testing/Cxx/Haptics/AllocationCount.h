// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_AllocationCount_h
#define palpate_testing_AllocationCount_h

namespace palpate::testing
{
/// Returns the number of times that this thread has allocated or freed memory by operator new and
/// delete and, if no sanitizer replaces them, by malloc, calloc and realloc. Linking
/// AllocationCount.cxx replaces these functions for the whole process, including its libraries.
long allocationCount() noexcept;

/// Returns true if malloc itself is counted.
bool countsMalloc() noexcept;
} // namespace palpate::testing

#endif
