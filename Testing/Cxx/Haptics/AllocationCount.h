// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_AllocationCount_h
#define palpate_testing_AllocationCount_h

namespace palpate::testing
{
/// How often this thread has asked for or returned memory: by operator new and delete, and, where
/// no sanitizer owns them, by malloc, calloc and realloc. Linking AllocationCount.cxx replaces
/// these for the whole process, the libraries included.
long allocationCount() noexcept;

/// Whether malloc itself is counted.
bool countsMalloc() noexcept;
} // namespace palpate::testing

#endif
