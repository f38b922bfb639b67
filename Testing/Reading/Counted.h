// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_reading_Counted_h
#define palpate_reading_Counted_h

extern "C" void __gcov_reset(void);
extern "C" void __gcov_dump(void);

namespace palpate::reading
{
/// Of all lines that a program executes those are counted that it executes in here.
template <class What>
void counted(const What& what)
{
  __gcov_reset();
  what();
  __gcov_dump(); // once: what comes later, destructors too, is not added at the end of the program
}
} // namespace palpate::reading

#endif
