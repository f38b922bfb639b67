// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_reading_Counted_h
#define palpate_reading_Counted_h

extern "C" void __gcov_reset(void);
extern "C" void __gcov_dump(void);

namespace palpate::reading
{
/// Only the lines that a program executes inside counted() are counted.
template <class What>
void counted(const What& what)
{
  __gcov_reset();
  what();
  __gcov_dump(); // once, so later lines and destructors are not added at the end of the program
}
} // namespace palpate::reading

#endif
