// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/FlatBodyFile.h"

#include "Mechanics/Files/WholeFile.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::array<char, 8> Magic = { 'P', 'A', 'L', 'P', 'A', 'T', 'E', '\0' };
constexpr std::uint32_t ByteOrderMark = 0x01020304;
constexpr std::uint64_t Alignment = 64;
constexpr int LargestLawCount = 4096;

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
  SectionCount
};

/// The first bytes of the file. Fixed layout: only add behind, and raise the version.
struct Header
{
  std::array<char, 8> magic;
  std::uint32_t version;
  std::uint32_t byteOrder;
  std::uint64_t fileSize;
  std::uint64_t checksum;
  std::uint64_t points;
  std::uint64_t triangles;
  std::int32_t samples;
  std::int32_t laws; ///< 0: per point; k: compact
  double exponent;
  std::array<std::uint64_t, SectionCount> offset; ///< from the start of the file; 0: absent
  std::array<char, 128> tool;                     ///< ends with '\0'
  std::array<char, 128> model;
  std::int64_t modelParts; ///< since format 2
  /// Since format 3, of EdgeTerms: exponent, 0 if there are none, radius, Poisson's ratio, extent,
  /// and 1 if they are in the curves.
  std::array<double, 5> edges;
};
static_assert(sizeof(Header) == 456, "the layout of a file is fixed");
constexpr std::size_t FirstHeaderSize = 408;  ///< format 1
constexpr std::size_t SecondHeaderSize = 416; ///< format 2

std::size_t sizeOf(const Header& header)
{
  return header.version < 2 ? FirstHeaderSize
    : header.version < 3    ? SecondHeaderSize
                            : sizeof(Header);
}

EdgeTerms edgesOf(const Header& header)
{
  EdgeTerms edges;
  if (header.version >= 3 && header.edges[0] != 0.0)
  {
    edges = { header.edges[0], header.edges[1], header.edges[2], header.edges[3],
      header.edges[4] != 0.0 };
  }
  return edges;
}

/// Bytes of each section, from the counts alone.
std::array<std::uint64_t, SectionCount> sectionSizes(const Header& header)
{
  const std::uint64_t n = header.points;
  const auto samples = static_cast<std::uint64_t>(header.samples);
  const auto laws = static_cast<std::uint64_t>(header.laws);
  std::array<std::uint64_t, SectionCount> size{};
  size[Coordinates] = n * 3 * sizeof(double);
  size[Corners] = header.triangles * 3 * sizeof(std::int32_t);
  size[Force] = laws > 0 ? 0 : n * samples * sizeof(float);
  size[Stiffness] = size[Force];
  size[Basis] = laws * 2 * samples * sizeof(float);
  size[Coefficient] = n * laws * sizeof(float);
  size[Normal] = n * 3 * sizeof(float);
  size[Range] = n * sizeof(float);
  size[Status] = n;
  size[Validity] = n * sizeof(float);
  size[Limit] = n;
  return size;
}

std::uint64_t aligned(std::uint64_t offset)
{
  return (offset + Alignment - 1) / Alignment * Alignment;
}

/// FNV-1a over 64-bit words (Fowler, Noll, Vo), the rest byte by byte: finds damage, not malice.
class Checksum
{
public:
  void add(const unsigned char* bytes, std::uint64_t count)
  {
    std::uint64_t i = 0;
    for (; i + sizeof(std::uint64_t) <= count; i += sizeof(std::uint64_t))
    {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + i, sizeof word);
      this->mix(word);
    }
    for (; i < count; ++i)
    {
      this->mix(bytes[i]);
    }
  }
  std::uint64_t value() const { return this->Value; }

private:
  void mix(std::uint64_t word)
  {
    this->Value = (this->Value ^ word) * 0x100000001b3ULL;
    this->Value ^= this->Value >> 32;
  }
  std::uint64_t Value = 0xcbf29ce484222325ULL;
};

/// Over the header, its own field taken as 0, and the sections.
std::uint64_t checksumOf(const std::array<const void*, SectionCount>& data, Header header)
{
  const auto sizes = sectionSizes(header);
  header.checksum = 0;
  std::array<unsigned char, sizeof(Header)> head;
  std::memcpy(head.data(), &header, sizeof(Header));
  Checksum sum;
  sum.add(head.data(), sizeOf(header));
  for (std::size_t k = 0; k < SectionCount; ++k)
  {
    sum.add(static_cast<const unsigned char*>(data[k]), sizes[k]);
  }
  return sum.value();
}

void copyText(const std::string& text, std::array<char, 128>& to)
{
  to.fill('\0');
  text.copy(to.data(), to.size() - 1);
}

Header makeHeader(const FlatBody& body)
{
  Header header{};
  header.magic = Magic;
  header.version = FlatBodyFile::Version;
  header.byteOrder = ByteOrderMark;
  header.points = body.points;
  header.triangles = body.triangles;
  header.samples = body.response.samples;
  header.laws = body.response.basis ? body.response.laws : 0;
  header.exponent = body.response.exponent;
  copyText(body.tool, header.tool);
  copyText(body.model, header.model);
  header.modelParts = body.modelParts;
  const EdgeTerms& edges = body.response.edges;
  if (edges.areFelt())
  {
    header.edges = { edges.exponent, edges.radius, edges.poissonRatio, edges.extent,
      edges.isInCurves ? 1.0 : 0.0 };
  }
  const auto sizes = sectionSizes(header);
  std::uint64_t end = sizeof(Header);
  for (std::size_t k = 0; k < SectionCount; ++k)
  {
    header.offset[k] = sizes[k] > 0 ? aligned(end) : 0;
    end = sizes[k] > 0 ? header.offset[k] + sizes[k] : end;
  }
  header.fileSize = end;
  return header;
}

/// What keeps a file of `size` bytes that begins with `header` from being used, or "".
std::string faultOf(const Header& header, std::uint64_t size)
{
  if (header.magic != Magic)
  {
    return "is not a Palpate body file";
  }
  if (header.byteOrder != ByteOrderMark)
  {
    return "was written on a machine of the other byte order";
  }
  if (header.version > FlatBodyFile::Version)
  {
    return "is of format " + std::to_string(header.version) +
      ", newer than this program, which reads up to " + std::to_string(FlatBodyFile::Version);
  }
  if (header.fileSize != size)
  {
    return "has " + std::to_string(size) + " bytes instead of " + std::to_string(header.fileSize) +
      ": it is truncated or damaged";
  }
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  if (header.version < 1 || header.points == 0 || header.points > most || header.triangles == 0 ||
    header.triangles > most / 3 || header.samples < 2 ||
    header.samples > ResponseSampling::LargestCount || header.laws < 0 ||
    header.laws > LargestLawCount || !(header.exponent > 0.0 && header.exponent <= 10.0) ||
    header.tool.back() != '\0' || header.model.back() != '\0' ||
    (header.version >= 3 && header.edges[0] != 0.0 && !faultOfEdges(edgesOf(header)).empty()))
  {
    return "has a damaged header";
  }
  const auto sizes = sectionSizes(header);
  for (std::size_t k = 0; k < SectionCount; ++k)
  {
    const std::uint64_t offset = header.offset[k];
    if (sizes[k] > 0 &&
      (offset < sizeOf(header) || offset % Alignment != 0 || offset > size ||
        sizes[k] > size - offset))
    {
      return "has a damaged header";
    }
  }
  return {};
}

FlatBody view(const Header& header, const unsigned char* file)
{
  const auto sizes = sectionSizes(header); // the offset of an empty section may be anything
  const auto at = [&](Section section) -> const void*
  { return sizes[section] > 0 ? file + header.offset[section] : nullptr; };
  FlatBody body;
  body.points = header.points;
  body.triangles = header.triangles;
  body.coordinates = static_cast<const double*>(at(Coordinates));
  body.corners = static_cast<const std::int32_t*>(at(Corners));
  body.response.points = header.points;
  body.response.samples = header.samples;
  body.response.exponent = header.exponent;
  body.response.laws = header.laws;
  body.response.force = static_cast<const float*>(at(Force));
  body.response.stiffness = static_cast<const float*>(at(Stiffness));
  body.response.basis = static_cast<const float*>(at(Basis));
  body.response.coefficient = static_cast<const float*>(at(Coefficient));
  body.response.normal = static_cast<const float*>(at(Normal));
  body.response.range = static_cast<const float*>(at(Range));
  body.response.status = static_cast<const std::uint8_t*>(at(Status));
  body.response.edges = edgesOf(header);
  body.validity = static_cast<const float*>(at(Validity));
  body.limit = static_cast<const std::uint8_t*>(at(Limit));
  body.tool = header.tool.data();
  body.model = header.model.data();
  body.modelParts =
    header.version < 2 ? modelPartsOfText(body.model) : static_cast<int>(header.modelParts);
  return body;
}

std::array<const void*, SectionCount> sectionsOf(const FlatBody& body)
{
  const ResponseArrays& response = body.response;
  return { body.coordinates, body.corners, response.force, response.stiffness, response.basis,
    response.coefficient, response.normal, response.range, response.status, body.validity,
    body.limit };
}

void writeAll(WholeFile& file, const Header& header, const FlatBody& body)
{
  const auto data = sectionsOf(body);
  const auto sizes = sectionSizes(header);
  constexpr std::array<char, Alignment> padding{};
  std::uint64_t written = sizeof(Header);
  file.write(&header, sizeof(Header));
  for (std::size_t k = 0; k < SectionCount; ++k)
  {
    if (sizes[k] == 0)
    {
      continue;
    }
    const std::uint64_t gap = header.offset[k] - written;
    file.write(padding.data(), gap);
    file.write(data[k], sizes[k]);
    written += gap + sizes[k];
  }
}
} // namespace

std::string FlatBodyFile::write(const std::string& path, const FlatBody& body)
{
  Header header = makeHeader(body);
  header.checksum = checksumOf(sectionsOf(body), header);
  WholeFile file(path);
  std::string error = file.open();
  if (error.empty())
  {
    writeAll(file, header, body);
    error = file.finish();
  }
  return error;
}

std::string FlatBodyFile::open(const std::string& path)
{
  this->Body = FlatBody();
  std::string error = this->File.open(path);
  if (!error.empty())
  {
    return error;
  }
  const std::size_t size = this->File.size();
  std::string fault = "is not a Palpate body file: it is too short or no file";
  if (size >= FirstHeaderSize)
  {
    Header header{};
    std::memcpy(&header, this->File.bytes(), std::min(size, sizeof header));
    fault = faultOf(header, size);
    if (fault.empty())
    {
      this->Body = view(header, this->File.bytes());
      fault = checksumOf(sectionsOf(this->Body), header) == header.checksum
        ? ""
        : "is damaged: its checksum is wrong";
    }
  }
  if (!fault.empty())
  {
    this->Body = FlatBody();
    this->File.close();
    return "'" + path + "' " + fault;
  }
  return {};
}

std::shared_ptr<const ContactBody> makeContactBody(const FlatBody& body)
{
  return std::make_shared<const ContactBody>(
    body.coordinates, body.points, body.corners, body.triangles, body.response);
}
} // namespace palpate
