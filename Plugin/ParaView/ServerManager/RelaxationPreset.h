// SPDX-License-Identifier: BSD-3-Clause
/**
 * Named relaxations with published values, for use with the moduli of MaterialPreset.
 *
 * The list has the order of the enumeration "Relaxation" of ToolContactResponse. The help of the
 * enumeration names author and year. The published relaxations of a tissue differ more than its
 * published moduli.
 */
#ifndef palpate_RelaxationPreset_h
#define palpate_RelaxationPreset_h

#include <array>
#include <vector>

namespace palpate
{
class RelaxationPreset
{
public:
  static constexpr int Custom = 0;
  static int count();

  /// Chooses a relaxation by its index, from 0 (Custom) to count() - 1. Other indices are ignored.
  void choose(int relaxation);
  int chosen() const { return this->Chosen; }

  /// Values of the user, which apply to Custom: strength and time (s) of each branch.
  std::vector<std::array<double, 2>> own;

  /// The branches in use, either of the relaxation or of the user.
  std::vector<std::array<double, 2>> inForce() const;

private:
  int Chosen = Custom;
};
} // namespace palpate

/// Adds a property Relaxation to the subclass of a filter. The named relaxation replaces the
/// branches of the user, which are kept for Custom. The macro must be used at the end of the class.
#define palpateRelaxationPresetMacro()                                                             \
public:                                                                                            \
  void SetRelaxation(int relaxation)                                                               \
  {                                                                                                \
    this->Relaxing.choose(relaxation);                                                             \
    this->TakeRelaxation();                                                                        \
  }                                                                                                \
  int GetRelaxation()                                                                              \
  {                                                                                                \
    return this->Relaxing.chosen();                                                                \
  }                                                                                                \
  void AddOwnRelaxation(double strength, double seconds)                                           \
  {                                                                                                \
    this->Relaxing.own.push_back({ strength, seconds });                                           \
    this->TakeRelaxation();                                                                        \
  }                                                                                                \
  void ClearOwnRelaxations()                                                                       \
  {                                                                                                \
    this->Relaxing.own.clear();                                                                    \
    this->TakeRelaxation();                                                                        \
  }                                                                                                \
                                                                                                   \
private:                                                                                           \
  void TakeRelaxation()                                                                            \
  {                                                                                                \
    this->ClearRelaxations();                                                                      \
    for (const auto& branch : this->Relaxing.inForce())                                            \
    {                                                                                              \
      this->AddRelaxation(branch[0], branch[1]);                                                   \
    }                                                                                              \
  }                                                                                                \
  palpate::RelaxationPreset Relaxing

#endif
