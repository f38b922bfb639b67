// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/FlatBodyHeader.h"

#include "Contact/FlatBodyFile.h"
#include "Contact/ResponseSampling.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace palpate
{
namespace
{
constexpr int LargestLawCount = 4096;
constexpr std::array<std::size_t, 5> HeaderSizes = { FlatBodyHeader::SmallestSize, 416, 456, 560,
  sizeof(FlatBodyHeader) };
static_assert(HeaderSizes.size() == FlatBodyFile::Version);
} // namespace

FlatBodyHeader FlatBodyHeader::read(const unsigned char* file, std::size_t size)
{
  FlatBodyHeader header{};
  std::memcpy(&header, file, SmallestSize);
  std::memcpy(&header, file, std::min(size, header.size()));
  return header;
}

std::size_t FlatBodyHeader::size() const
{
  return HeaderSizes[std::clamp<std::size_t>(this->version, 1, HeaderSizes.size()) - 1];
}

std::uint64_t FlatBodyHeader::offset(std::size_t section) const
{
  return section < FirstSectionCount ? this->firstOffset[section]
    : section < LaterSectionCount    ? this->laterOffset[section - FirstSectionCount]
                                     : this->latestOffset[section - LaterSectionCount];
}

std::uint64_t& FlatBodyHeader::offset(std::size_t section)
{
  return section < FirstSectionCount ? this->firstOffset[section]
    : section < LaterSectionCount    ? this->laterOffset[section - FirstSectionCount]
                                     : this->latestOffset[section - LaterSectionCount];
}

FlatBodyHeader::Sections FlatBodyHeader::sectionSizes() const
{
  const std::uint64_t n = this->points;
  const auto count = static_cast<std::uint64_t>(this->samples);
  const auto rows = static_cast<std::uint64_t>(this->laws);
  const auto has = [this](RelaxationPart part) { return (this->relaxationParts & part) != 0; };
  Sections bytes{};
  bytes[Coordinates] = n * 3 * sizeof(double);
  bytes[Corners] = this->triangles * 3 * sizeof(std::int32_t);
  bytes[Force] = rows > 0 ? 0 : n * count * sizeof(float);
  bytes[Stiffness] = bytes[Force];
  bytes[Basis] = rows * 2 * count * sizeof(float);
  bytes[Coefficient] = n * rows * sizeof(float);
  bytes[Normal] = n * 3 * sizeof(float);
  bytes[Range] = n * sizeof(float);
  bytes[Status] = n;
  bytes[Validity] = n * sizeof(float);
  bytes[Limit] = n;
  bytes[LocalRelaxation] =
    has(LocalPart) ? n * static_cast<std::uint64_t>(this->branches) * sizeof(float) : 0;
  bytes[ElasticCompliance] = has(ElasticPart) ? n * sizeof(float) : 0;
  const auto couples = [this](CouplingPart part) { return (this->couplingParts & part) != 0; };
  bytes[CouplingKnots] =
    couples(KnotsPart) ? CouplingLaw::KnotCount * sizeof(CouplingKnot) : std::uint64_t{ 0 };
  bytes[CouplingModulus] = couples(ModulusPart) ? n * sizeof(float) : 0;
  bytes[CouplingThickness] = couples(ThicknessPart) ? n * sizeof(float) : 0;
  bytes[CouplingModes] = n * static_cast<std::uint64_t>(this->couplingModes) * sizeof(float);
  const TiltTerms tilt = this->tiltTerms();
  if (tilt.areFelt())
  {
    bytes[TiltDrop] = TiltTable::dropCount(tilt) * sizeof(double);
    bytes[TiltNode] = TiltTable::nodeCount(tilt) * sizeof(double);
    bytes[TiltWeight] =
      this->tiltWeights != 0 ? n * static_cast<std::uint64_t>(tilt.laws) * sizeof(float) : 0;
  }
  return bytes;
}

void FlatBodyHeader::setEdges(const EdgeTerms& terms)
{
  if (terms.areFelt())
  {
    this->edges = { terms.exponent, terms.radius, terms.poissonRatio, terms.extent,
      terms.isInCurves ? 1.0 : 0.0 };
  }
}

EdgeTerms FlatBodyHeader::edgeTerms() const
{
  EdgeTerms terms;
  if (this->edges[0] != 0.0)
  {
    terms = { this->edges[0], this->edges[1], this->edges[2], this->edges[3],
      this->edges[4] != 0.0 };
  }
  return terms;
}

void FlatBodyHeader::setRelaxation(const RelaxationTerms& terms)
{
  if (terms.series.count > 0)
  {
    this->branches = static_cast<std::int32_t>(terms.series.count);
    this->relaxationParts =
      (terms.strength ? LocalPart : 0) | (terms.elasticCompliance ? ElasticPart : 0);
    this->strength = terms.series.strength;
    this->time = terms.series.time;
    this->contact = { terms.exponent, terms.radius };
  }
}

RelaxationTerms FlatBodyHeader::relaxationTerms() const
{
  RelaxationTerms terms;
  if (this->branches > 0)
  {
    terms.series = { static_cast<std::size_t>(this->branches), this->strength, this->time };
    terms.exponent = this->contact[0];
    terms.radius = this->contact[1];
  }
  return terms;
}

void FlatBodyHeader::setCoupling(const CouplingTerms& terms)
{
  if (terms.areFelt())
  {
    this->couplingParts = (terms.knots ? KnotsPart : 0) | (terms.localModulus ? ModulusPart : 0) |
      (terms.localThickness ? ThicknessPart : 0);
    this->couplingModes = terms.modes ? terms.modeCount : 0;
    this->coupling = { terms.modulus, terms.thickness };
  }
}

CouplingTerms FlatBodyHeader::couplingTerms() const
{
  CouplingTerms terms;
  terms.modulus = this->coupling[0];
  terms.thickness = this->coupling[1];
  terms.modeCount = this->couplingModes;
  return terms;
}

void FlatBodyHeader::setTilt(const TiltViews& tilt)
{
  if (tilt.areFelt())
  {
    const TiltTerms& terms = tilt.terms;
    this->tiltNumbers = { terms.range, terms.largest, terms.dropScale };
    this->tiltCounts = { terms.depths, terms.angles, terms.drops, terms.laws };
    this->tiltWeights = tilt.weight ? 1 : 0;
  }
}

TiltTerms FlatBodyHeader::tiltTerms() const
{
  const auto& counts = this->tiltCounts;
  return { this->tiltNumbers[0], this->tiltNumbers[1], this->tiltNumbers[2], counts[0], counts[1],
    counts[2], counts[3] };
}

std::string FlatBodyHeader::fault(std::uint64_t fileBytes) const
{
  if (this->magic != Magic)
  {
    return "is not a Palpate body file";
  }
  if (this->byteOrder != ByteOrderMark)
  {
    return "was written on a machine of the other byte order";
  }
  if (this->version > FlatBodyFile::Version)
  {
    return "is of format " + std::to_string(this->version) +
      ", newer than this program, which reads up to " + std::to_string(FlatBodyFile::Version);
  }
  if (this->fileSize != fileBytes)
  {
    return "has " + std::to_string(fileBytes) + " bytes instead of " +
      std::to_string(this->fileSize) + ": it is truncated or damaged";
  }
  if (!this->isSound())
  {
    return "has a damaged header";
  }
  const Sections bytes = this->sectionSizes();
  for (std::size_t k = 0; k < SectionCount; ++k)
  {
    const std::uint64_t begin = this->offset(k);
    if (bytes[k] > 0 &&
      (begin < this->size() || begin % Alignment != 0 || begin > fileBytes ||
        bytes[k] > fileBytes - begin))
    {
      return "has a damaged header";
    }
  }
  return {};
}

bool FlatBodyHeader::isSound() const
{
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  return this->version >= 1 && this->points > 0 && this->points <= most && this->triangles > 0 &&
    this->triangles <= most / 3 && this->samples >= 2 &&
    this->samples <= ResponseSampling::LargestCount && this->laws >= 0 &&
    this->laws <= LargestLawCount && this->exponent > 0.0 && this->exponent <= 10.0 &&
    this->tool.back() == '\0' && this->model.back() == '\0' &&
    (this->edges[0] == 0.0 || faultOfEdges(this->edgeTerms()).empty()) &&
    this->isRelaxationSound() && this->isCouplingSound() && this->isTiltSound();
}

bool FlatBodyHeader::isTiltSound() const
{
  const TiltTerms terms = this->tiltTerms();
  return (terms.laws == 0 && this->tiltWeights == 0) ||
    (faultOfTilts(terms).empty() && (this->tiltWeights == 0 || this->tiltWeights == 1) &&
      (terms.laws == 1 || this->tiltWeights == 1));
}

bool FlatBodyHeader::isRelaxationSound() const
{
  constexpr auto most = static_cast<std::int32_t>(PronySeries::LargestCount);
  if (this->branches == 0)
  {
    return this->relaxationParts == 0;
  }
  return this->branches > 0 && this->branches <= most && this->relaxationParts >= 0 &&
    this->relaxationParts <= (LocalPart | ElasticPart) &&
    faultOfRelaxation(this->relaxationTerms().series).empty() && this->contact[0] > 0.0 &&
    this->contact[1] >= 0.0 && std::isfinite(this->contact[0]) && std::isfinite(this->contact[1]);
}

bool FlatBodyHeader::isCouplingSound() const
{
  return this->couplingParts >= 0 &&
    this->couplingParts <= (KnotsPart | ModulusPart | ThicknessPart) && this->couplingModes >= 0 &&
    this->couplingModes <= CouplingTerms::MostModes && this->coupling[0] >= 0.0 &&
    this->coupling[1] >= 0.0 && std::isfinite(this->coupling[0]) &&
    std::isfinite(this->coupling[1]);
}
} // namespace palpate
