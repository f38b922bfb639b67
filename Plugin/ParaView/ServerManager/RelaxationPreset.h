// SPDX-License-Identifier: BSD-3-Clause
/**
 * Named relaxations, as published, to combine with the moduli of MaterialPreset.
 *
 * The list is the enumeration "Relaxation" of ToolContactResponse, in its order. The help there
 * names author and year. Published values for a tissue differ more than its modulus.
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

  /// Chooses a relaxation, from 0 (Custom) to count() - 1; other values are ignored.
  void choose(int relaxation);
  int chosen() const { return this->Chosen; }

  /// The user's values, which are used for Custom: strength and time (s) of each branch.
  std::vector<std::array<double, 2>> own;

  /// The values in use.
  std::vector<std::array<double, 2>> inForce() const;

private:
  int Chosen = Custom;
};
} // namespace palpate

/// Adds a property Relaxation to a filter's subclass; used at the end of the class. The named
/// relaxation replaces the branches of the user, which are kept for Custom.
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
