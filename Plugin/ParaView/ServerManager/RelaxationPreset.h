// SPDX-License-Identifier: BSD-3-Clause
/**
 * Relaxations to choose from by name, as published, beside the moduli of MaterialPreset.
 *
 * The list is the enumeration "Relaxation" of ToolContactResponse, in its order; the help there
 * names author and year. What was found for a tissue scatters by more than its modulus does.
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

  /// 0, Custom, up to count() - 1; others leave things as they are.
  void choose(int relaxation);
  int chosen() const { return this->Chosen; }

  /// What the user has given for Custom: strength and seconds of each.
  std::vector<std::array<double, 2>> own;

  /// What is in force.
  std::vector<std::array<double, 2>> inForce() const;

private:
  int Chosen = Custom;
};
} // namespace palpate

/// A Relaxation by name in a filter's subclass, at the end of its class: it takes the place of the
/// relaxations that are given one by one, which are kept for Custom.
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
