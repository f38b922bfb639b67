// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/FlatBodyFile.h"

#include "Contact/FlatBodyHeader.h"
#include "Contact/TermTable.h"
#include "Mechanics/Files/WholeFile.h"

#include <array>
#include <cstring>

namespace palpate
{
namespace
{
using Header = FlatBodyHeader;

std::uint64_t aligned(std::uint64_t offset)
{
  return (offset + Header::Alignment - 1) / Header::Alignment * Header::Alignment;
}

/// FNV-1a hash (Fowler, Noll, Vo) over 64-bit words, and over the remaining bytes one by one. It
/// detects damaged files, not attacks.
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

/// Returns the checksum over the sections and the header. The member for the checksum itself counts
/// as 0.
std::uint64_t checksumOf(const std::array<const void*, Header::SectionCount>& data, Header header)
{
  const auto sizes = header.sectionSizes();
  header.checksum = 0;
  std::array<unsigned char, sizeof(Header)> head;
  std::memcpy(head.data(), &header, sizeof(Header));
  Checksum sum;
  sum.add(head.data(), header.size());
  for (std::size_t k = 0; k < Header::SectionCount; ++k)
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
  header.magic = Header::Magic;
  header.version = FlatBodyFile::Version;
  header.byteOrder = Header::ByteOrderMark;
  header.points = body.points;
  header.triangles = body.triangles;
  header.samples = body.response.samples;
  header.laws = body.response.basis ? body.response.laws : 0;
  header.exponent = body.response.exponent;
  copyText(body.tool, header.tool);
  copyText(body.model, header.model);
  header.modelParts = body.modelParts;
  header.setEdges(body.response.edges);
  header.setRelaxation(body.response.relaxation);
  header.setCoupling(body.response.coupling);
  header.setTilt(body.response.tilt);
  const auto sizes = header.sectionSizes();
  std::uint64_t end = sizeof(Header);
  for (std::size_t k = 0; k < Header::SectionCount; ++k)
  {
    header.offset(k) = sizes[k] > 0 ? aligned(end) : 0;
    end = sizes[k] > 0 ? header.offset(k) + sizes[k] : end;
  }
  header.fileSize = end;
  return header;
}

FlatBody view(const Header& header, const unsigned char* file)
{
  const auto sizes = header.sectionSizes(); // an empty section may have any offset
  const auto at = [&](Header::Section section) -> const void*
  { return sizes[section] > 0 ? file + header.offset(section) : nullptr; };
  FlatBody body;
  body.points = header.points;
  body.triangles = header.triangles;
  body.coordinates = static_cast<const double*>(at(Header::Coordinates));
  body.corners = static_cast<const std::int32_t*>(at(Header::Corners));
  body.response.points = header.points;
  body.response.samples = header.samples;
  body.response.exponent = header.exponent;
  body.response.laws = header.laws;
  body.response.force = static_cast<const float*>(at(Header::Force));
  body.response.stiffness = static_cast<const float*>(at(Header::Stiffness));
  body.response.basis = static_cast<const float*>(at(Header::Basis));
  body.response.coefficient = static_cast<const float*>(at(Header::Coefficient));
  body.response.normal = static_cast<const float*>(at(Header::Normal));
  body.response.range = static_cast<const float*>(at(Header::Range));
  body.response.status = static_cast<const std::uint8_t*>(at(Header::Status));
  body.response.edges = header.edgeTerms();
  body.response.relaxation = header.relaxationTerms();
  body.response.relaxation.strength = static_cast<const float*>(at(Header::LocalRelaxation));
  body.response.relaxation.elasticCompliance =
    static_cast<const float*>(at(Header::ElasticCompliance));
  CouplingTerms& coupling = body.response.coupling;
  coupling = header.couplingTerms();
  coupling.knots = static_cast<const CouplingKnot*>(at(Header::CouplingKnots));
  coupling.localModulus = static_cast<const float*>(at(Header::CouplingModulus));
  coupling.localThickness = static_cast<const float*>(at(Header::CouplingThickness));
  coupling.modes = static_cast<const float*>(at(Header::CouplingModes));
  body.response.tilt = { header.tiltTerms(), static_cast<const double*>(at(Header::TiltDrop)),
    static_cast<const double*>(at(Header::TiltNode)),
    static_cast<const float*>(at(Header::TiltWeight)) };
  body.validity = static_cast<const float*>(at(Header::Validity));
  body.limit = static_cast<const std::uint8_t*>(at(Header::Limit));
  body.tool = header.tool.data();
  body.model = header.model.data();
  body.modelParts =
    header.version < 2 ? modelPartsOfText(body.model) : static_cast<int>(header.modelParts);
  return body;
}

std::array<const void*, Header::SectionCount> sectionsOf(const FlatBody& body)
{
  const ResponseArrays& response = body.response;
  return { body.coordinates, body.corners, response.force, response.stiffness, response.basis,
    response.coefficient, response.normal, response.range, response.status, body.validity,
    body.limit, response.relaxation.strength, response.relaxation.elasticCompliance,
    response.coupling.knots, response.coupling.localModulus, response.coupling.localThickness,
    response.coupling.modes, response.tilt.drops, response.tilt.nodes, response.tilt.weight };
}

void writeAll(WholeFile& file, const Header& header, const FlatBody& body)
{
  const auto data = sectionsOf(body);
  const auto sizes = header.sectionSizes();
  constexpr std::array<char, Header::Alignment> padding{};
  std::uint64_t written = sizeof(Header);
  file.write(&header, sizeof(Header));
  for (std::size_t k = 0; k < Header::SectionCount; ++k)
  {
    if (sizes[k] == 0)
    {
      continue;
    }
    const std::uint64_t gap = header.offset(k) - written;
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
  std::string fault = "is not a Palpate body file: it is too short, or not a file";
  if (size >= Header::SmallestSize)
  {
    const Header header = Header::read(this->File.bytes(), size);
    fault = header.fault(size);
    if (fault.empty())
    {
      this->Body = view(header, this->File.bytes());
      fault = checksumOf(sectionsOf(this->Body), header) == header.checksum
        ? faultOfTerms(this->Body.response)
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
