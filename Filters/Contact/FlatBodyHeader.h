// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FlatBodyHeader_h
#define palpate_FlatBodyHeader_h

#include "Contact/Coupled/CouplingTerms.h"
#include "Contact/Edges/EdgeLaw.h"
#include "Contact/Relaxation/RelaxationTerms.h"
#include "Contact/Tilt/TiltViews.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace palpate
{
/// The first bytes of a FlatBodyFile. The layout is fixed: a change may only append members, and
/// must increase the version.
struct FlatBodyHeader
{
  static constexpr std::array<char, 8> Magic = { 'P', 'A', 'L', 'P', 'A', 'T', 'E', '\0' };
  static constexpr std::uint32_t ByteOrderMark = 0x01020304;
  static constexpr std::uint64_t Alignment = 64;
  static constexpr std::size_t SmallestSize = 408; ///< size of the header in format 1

  enum Section : std::size_t
  {
    Coordinates,
    Corners,
    Force,
    Stiffness,
    Basis,
    Coefficient,
    Normal,
    Range,
    Status,
    Validity,
    Limit,
    LocalRelaxation, ///< since format 4
    ElasticCompliance,
    CouplingKnots, ///< since format 5
    CouplingModulus,
    CouplingThickness,
    CouplingModes,
    TiltDrop,
    TiltNode,
    TiltWeight,
    SectionCount
  };
  static constexpr std::size_t FirstSectionCount = LocalRelaxation;
  static constexpr std::size_t LaterSectionCount = CouplingKnots;
  using Sections = std::array<std::uint64_t, SectionCount>;

  /// Parts of the relaxation terms that a file may contain in addition to the series.
  enum RelaxationPart : std::int32_t
  {
    LocalPart = 1,
    ElasticPart = 2
  };
  /// Parts of the coupling terms that a file may contain in addition to a single modulus.
  enum CouplingPart : std::int32_t
  {
    KnotsPart = 1,
    ModulusPart = 2,
    ThicknessPart = 4
  };

  std::array<char, 8> magic;
  std::uint32_t version;
  std::uint32_t byteOrder;
  std::uint64_t fileSize;
  std::uint64_t checksum;
  std::uint64_t points;
  std::uint64_t triangles;
  std::int32_t samples;
  /// 0 if each point has a separate curve; k > 0 if curves are combinations of k laws.
  std::int32_t laws;
  double exponent;
  /// Offsets from the start of the file; 0 if the section is absent.
  std::array<std::uint64_t, FirstSectionCount> firstOffset;
  std::array<char, 128> tool; ///< ends with '\0'
  std::array<char, 128> model;
  std::int64_t modelParts; ///< since format 2
  /// EdgeTerms, since format 3: exponent (0 if there are no terms), radius, Poisson's ratio,
  /// extent, and 1 if the curves contain the effect of edges.
  std::array<double, 5> edges;
  /// RelaxationTerms, since format 4: number of branches, sum of RelaxationPart, p_i, τ_i, exponent
  /// and contact radius.
  std::int32_t branches;
  std::int32_t relaxationParts;
  std::array<double, PronySeries::LargestCount> strength;
  std::array<double, PronySeries::LargestCount> time;
  std::array<double, 2> contact;
  std::array<std::uint64_t, LaterSectionCount - FirstSectionCount> laterOffset;
  /// CouplingTerms, since format 5: sum of CouplingPart, number of modes, E* and thickness.
  std::int32_t couplingParts;
  std::int32_t couplingModes;
  std::array<double, 2> coupling;
  /// TiltTerms, since format 5: range, largest tilt and scale of the drop; numbers of depths,
  /// angles, drops and laws (0 if there are no terms); and 1 if each point has weights.
  std::array<double, 3> tiltNumbers;
  std::array<std::int32_t, 4> tiltCounts;
  std::int64_t tiltWeights;
  std::array<std::uint64_t, SectionCount - LaterSectionCount> latestOffset;

  /// Reads the header of a file of at least SmallestSize bytes. Members that do not exist in an
  /// older format are set to 0.
  static FlatBodyHeader read(const unsigned char* file, std::size_t size);

  /// Returns the size of the header in bytes, in a file of the version of this header.
  std::size_t size() const;
  std::uint64_t& offset(std::size_t section);
  std::uint64_t offset(std::size_t section) const;
  /// Returns the size of each section in bytes, computed from the counts.
  Sections sectionSizes() const;

  void setEdges(const EdgeTerms& terms);
  EdgeTerms edgeTerms() const;
  void setRelaxation(const RelaxationTerms& terms);
  /// Returns the relaxation terms without the arrays per point.
  RelaxationTerms relaxationTerms() const;
  void setCoupling(const CouplingTerms& terms);
  /// Returns the coupling terms without the arrays.
  CouplingTerms couplingTerms() const;

  void setTilt(const TiltViews& tilt);
  TiltTerms tiltTerms() const;

  /// Returns the reason why a file of `fileBytes` bytes with this header cannot be used; "" if it
  /// can be used.
  std::string fault(std::uint64_t fileBytes) const;

private:
  bool isSound() const;
  bool isRelaxationSound() const;
  bool isCouplingSound() const;
  bool isTiltSound() const;
};
static_assert(sizeof(FlatBodyHeader) == 688, "the layout of a file is fixed");
} // namespace palpate

#endif
