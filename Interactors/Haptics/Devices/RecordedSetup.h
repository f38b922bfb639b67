// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RecordedSetup_h
#define palpate_RecordedSetup_h

#include "Contact/ContactSettings.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/// The parts of a contact's setup that a record names.
enum class SetupPart : std::uint8_t
{
  Body,     ///< a file or a scene
  Tool,     ///< the tool's specification, "sphere:6.35"
  Material, ///< "E = 0.05 MPa, nu = 0.45"
  Model,    ///< the law and the layers
  Friction
};

/// Names of the parts, as in a trajectory file, in the order of SetupPart.
constexpr std::array<const char*, 5> SetupPartNames = { "body", "tool", "material", "model",
  "friction" };

/// A setup in words, one text per part; "": unknown.
struct RecordedSetup
{
  std::array<std::string, SetupPartNames.size()> texts;

  std::string& operator[](SetupPart part) { return this->texts[static_cast<std::size_t>(part)]; }
  const std::string& operator[](SetupPart part) const
  {
    return this->texts[static_cast<std::size_t>(part)];
  }
  bool operator==(const RecordedSetup& other) const { return this->texts == other.texts; }
};

/// A setup that was in use from a time (s) on.
struct SetupSince
{
  double time = 0.0;
  RecordedSetup setup;
};

/// The setups of a record, in the order of their times. The first is also that of all earlier
/// times. Empty: unknown.
class PALPATE_EXPORT RecordedSetups
{
public:
  /// Adds a setup from a time on, unless it is equal to the newest one. Replaces setups of this
  /// time and later.
  void add(double time, const RecordedSetup& setup);
  /// Removes all setups but the newest.
  void keepNewest();
  void clear() { this->All.clear(); }
  /// The setups that were in use from `begin` to `end`, s; their times are not before `begin`.
  RecordedSetups between(double begin, double end) const;
  /// Subtracts `begin` (s) from all times.
  void shift(double begin);

  bool isEmpty() const { return this->All.empty(); }
  const std::vector<SetupSince>& all() const { return this->All; }
  /// The setup at a time, s; null: unknown.
  const RecordedSetup* at(double time) const;

  /// The lines of a trajectory file, without '#': "tool: sphere:6.35", and for changes "tool from
  /// 1.5 s: flat:1.6".
  std::vector<std::string> lines() const;
  /// Reads such a line. Lines of other programs have no effect.
  void readLine(std::string_view line);

private:
  std::vector<SetupSince> All;
};

/// "E = 0.05 MPa, nu = 0.45".
PALPATE_EXPORT std::string materialInWords(double youngsModulus, double poissonRatio);
/// "mu = 0.3, elasto-plastic, 1 N/mm"; "none" without friction.
PALPATE_EXPORT std::string frictionInWords(const FrictionSettings& friction);

/// Parts that both setups name and that differ: "tool sphere:1.6 (here sphere:6.35), ..."; "" for
/// none.
PALPATE_EXPORT std::string differenceOf(const RecordedSetup& recorded, const RecordedSetup& here);
/// The parts that are known: "body liver.stl, tool sphere:1.6, ...".
PALPATE_EXPORT std::string setupInWords(const RecordedSetup& setup);
/// A sentence about a replay at a time (s) of the record, without its full stop.
PALPATE_EXPORT std::string replayInWords(
  const RecordedSetups& recorded, double time, const RecordedSetup& here);
} // namespace palpate

#endif
