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
/// The parts of a contact's setup that are stored in a record.
enum class SetupPart : std::uint8_t
{
  Body,     ///< the name of a file or a scene
  Tool,     ///< the specification of the tool, such as "sphere:6.35"
  Material, ///< such as "E = 0.05 MPa, nu = 0.45"
  Model,    ///< the law and the layers
  Friction
};

/// Names of the parts in a trajectory file, in the order of SetupPart.
constexpr std::array<const char*, 5> SetupPartNames = { "body", "tool", "material", "model",
  "friction" };

/// A setup in words, one text per part. A part is "" if it is unknown.
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

/// The setups of a record, in the order of their times. The first setup also applies to all earlier
/// times. The list is empty if no setup is known.
class PALPATE_EXPORT RecordedSetups
{
public:
  /// Adds a setup that was in use from `time` on, unless it is equal to the newest one. Replaces
  /// all setups of this time and later.
  void add(double time, const RecordedSetup& setup);
  /// Removes all setups but the newest.
  void keepNewest();
  void clear() { this->All.clear(); }
  /// The setups that were in use from `begin` to `end`, s. A setup that began before `begin` gets
  /// the time `begin`.
  RecordedSetups between(double begin, double end) const;
  /// Subtracts `begin` (s) from all times.
  void shift(double begin);

  bool isEmpty() const { return this->All.empty(); }
  const std::vector<SetupSince>& all() const { return this->All; }
  /// The setup that was in use at a time, s; null if it is unknown.
  const RecordedSetup* at(double time) const;

  /// The lines for a trajectory file, without '#'. The first setup has lines such as "tool:
  /// sphere:6.35"; a change has a line such as "tool from 1.5 s: flat:1.6".
  std::vector<std::string> lines() const;
  /// Reads a line that was made by lines(). Other lines have no effect.
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
/// Lists the known parts of a setup: "body liver.stl, tool sphere:1.6, ...".
PALPATE_EXPORT std::string setupInWords(const RecordedSetup& setup);
/// Returns a sentence, without its full stop, that compares the present setup with the one that was
/// in use at `time` (s) of the record.
PALPATE_EXPORT std::string replayInWords(
  const RecordedSetups& recorded, double time, const RecordedSetup& here);
} // namespace palpate

#endif
