// SPDX-License-Identifier: BSD-3-Clause
/**
 * Named relaxations, as published, to combine with the moduli of MaterialPreset.
 *
 * The list is the enumeration "Relaxation" of ToolContactResponse, in its order; the help there
 * names author and year. Published values for a tissue scatter more than its modulus.
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

  /// 0, Custom, up to count() - 1; others are ignored.
  void choose(int relaxation);
  int chosen() const { return this->Chosen; }

  /// The user's values for Custom: strength and seconds of each.
  std::vector<std::array<double, 2>> own;

  /// The present values.
  std::vector<std::array<double, 2>> inForce() const;

private:
  int Chosen = Custom;
};
} // namespace palpate

/// Adds a Relaxation by name to a filter's subclass, at the end of its class: it replaces the
/// relaxations given one by one, which are kept for Custom.
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
