// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ManyCores_h
#define palpate_testing_ManyCores_h

namespace palpate::testing
{
/// During its lifetime the machine reports `count` cores. VTK never uses more threads than cores,
/// so a test of eight threads needs eight cores also on a machine with two.
class ManyCores
{
public:
  explicit ManyCores(int count);
  ~ManyCores();
  ManyCores(const ManyCores&) = delete;
  ManyCores& operator=(const ManyCores&) = delete;
};
} // namespace palpate::testing

#endif
