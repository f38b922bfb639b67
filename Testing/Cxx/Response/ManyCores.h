// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ManyCores_h
#define palpate_testing_ManyCores_h

namespace palpate::testing
{
/// While this lives, the machine says it has `count` cores: VTK's threads are never more than that,
/// and a test of eight is to have eight on a machine of two.
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
