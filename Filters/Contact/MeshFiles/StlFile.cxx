// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshFiles/StlFile.h"

#include "Contact/MeshFiles/FileWords.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string_view>

namespace palpate
{
namespace
{
constexpr std::size_t HeadSize = 84; // head of a binary file: 80 bytes and the number of facets
constexpr std::size_t FacetSize = 50;

std::string lowerCase(std::string_view word)
{
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Adds the facets to a mesh with three consecutive points per facet.
FileMesh withFacets(FileMesh mesh)
{
  const std::size_t points = mesh.points.size() / 3;
  mesh.corners.resize(points);
  std::iota(mesh.corners.begin(), mesh.corners.end(), 0);
  mesh.starts.resize(points / 3 + 1);
  for (std::size_t i = 0; i < mesh.starts.size(); ++i)
  {
    mesh.starts[i] = static_cast<std::int64_t>(3 * i);
  }
  return mesh;
}

FileMesh faulty(const std::string& fault)
{
  FileMesh mesh;
  mesh.fault = fault;
  return mesh;
}

/// Reads facets from text. The keywords must be in the prescribed order; they may be on one line or
/// several.
class AsciiFacets
{
public:
  explicit AsciiFacets(std::istream& file)
    : Words(file)
  {
  }

  FileMesh read()
  {
    while (this->Fault.empty() && this->Words.nextLine())
    {
      this->readLine();
    }
    if (this->Fault.empty() && this->IsOpen)
    {
      this->fail("the file ends without an 'endsolid'");
    }
    return this->Fault.empty() ? withFacets(std::move(this->Mesh)) : faulty(this->Fault);
  }

private:
  void readLine()
  {
    for (std::string word = lowerCase(this->Words.word()); !word.empty() && this->Fault.empty();
         word = lowerCase(this->Words.word()))
    {
      const bool isSolid = word == "solid";
      if (isSolid || word == "endsolid")
      {
        this->expect(isSolid != this->IsOpen && this->Corners == NoFacet, word);
        this->IsOpen = isSolid;
        return; // the rest of the line is the name of the solid
      }
      this->readWord(word);
    }
  }

  void readWord(const std::string& word)
  {
    if (word == "vertex")
    {
      this->expect(this->Corners >= 0 && this->Corners < 3, word);
      this->readVertex();
    }
    else if (word == "facet")
    {
      this->expect(this->IsOpen && this->Corners == NoFacet, word);
      this->skipNormal();
      this->Corners = NoLoop;
    }
    else if (word == "outer")
    {
      this->expect(this->Corners == NoLoop && lowerCase(this->Words.word()) == "loop", word);
      this->Corners = 0;
    }
    else if (word == "endloop")
    {
      this->expect(this->Corners == 3, word);
    }
    else if (word == "endfacet")
    {
      this->expect(this->Corners == 3, word);
      this->Corners = NoFacet;
    }
    else
    {
      this->fail(FileWords::shown(word) + " is not understood");
    }
  }

  void readVertex()
  {
    for (int axis = 0; axis < 3 && this->Fault.empty(); ++axis)
    {
      float value = 0.0F;
      std::string_view wrong;
      if (!this->Words.number(value, wrong))
      {
        this->fail(wrong.empty() ? "a vertex needs three numbers"
                                 : FileWords::shown(wrong) + " is not a finite number");
      }
      this->Mesh.points.push_back(value);
    }
    ++this->Corners;
  }

  void skipNormal()
  {
    const bool isNamed = lowerCase(this->Words.word()) == "normal";
    this->expect(isNamed, "facet");
    for (int axis = 0; axis < 3; ++axis)
    {
      // Skips the value, whatever it is, because some programs write an undefined one.
      this->Words.word();
    }
  }

  void expect(bool holds, const std::string& word)
  {
    if (!holds)
    {
      this->fail(this->Corners >= 0 && this->Corners != 3
          ? joined("'", word, "' after ", this->Corners, " corners of a facet")
          : joined("'", word, "' out of order"));
    }
  }

  void fail(const std::string& what)
  {
    if (this->Fault.empty())
    {
      this->Fault = joined("line ", this->Words.lineNumber(), ": ", what);
    }
  }

  static constexpr int NoFacet = -2;
  static constexpr int NoLoop = -1;

  FileWords Words;
  FileMesh Mesh;
  std::string Fault;
  bool IsOpen = false;   ///< whether the reader is within a solid
  int Corners = NoFacet; ///< number of corners of the current facet
};

std::uint32_t wordAt(const unsigned char* bytes)
{
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

FileMesh readBinary(std::istream& file, std::uint64_t facets, std::uint64_t size)
{
  const std::uint64_t whole = HeadSize + facets * FacetSize;
  if (size < whole)
  {
    return faulty(
      joined("it ends after ", (size - HeadSize) / FacetSize, " of ", facets, " facets"));
  }
  FileMesh mesh;
  mesh.points.resize(9 * static_cast<std::size_t>(facets));
  float* values = mesh.points.data();
  for (std::uint64_t facet = 0; facet < facets; ++facet)
  {
    std::array<unsigned char, FacetSize> bytes{};
    file.read(reinterpret_cast<char*>(bytes.data()), FacetSize);
    if (!file)
    {
      return faulty(joined("facet ", facet, " of ", facets, " cannot be read"));
    }
    for (std::size_t i = 0; i < 9; ++i, ++values)
    {
      // The coordinates of the corners follow the normal of the facet.
      const std::uint32_t word = wordAt(bytes.data() + 12 + 4 * i);
      std::memcpy(values, &word, sizeof word);
      if (!std::isfinite(*values))
      {
        return faulty(joined("facet ", facet, " has a coordinate that is not a finite number"));
      }
    }
  }
  if (size > whole)
  {
    mesh.notes.push_back(
      joined("the ", size - whole, " bytes after its ", facets, " facets left out"));
  }
  return withFacets(std::move(mesh));
}

/// Returns whether a text begins with "solid", possibly after a byte order mark and blanks.
bool beginsWithSolid(const std::string& head)
{
  const std::size_t mark = head.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  const std::size_t begin = head.find_first_not_of(" \t\r\n\v\f", mark);
  return begin != std::string::npos && lowerCase(head.substr(begin, 5)) == "solid";
}

bool isText(const std::string& head)
{
  return std::none_of(head.begin(), head.end(), [](unsigned char c) { return c < 9; });
}
} // namespace

FileMesh readStl(std::istream& file)
{
  std::string head(HeadSize, '\0');
  file.read(head.data(), static_cast<std::streamsize>(HeadSize));
  head.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(file.tellg());
  const std::uint64_t facets = head.size() < HeadSize
    ? 0
    : wordAt(reinterpret_cast<const unsigned char*>(head.data()) + HeadSize - 4);
  const bool isWhole = head.size() == HeadSize && size == HeadSize + facets * FacetSize;
  if (!isWhole && isText(head))
  {
    file.seekg(0);
    return beginsWithSolid(head)
      ? AsciiFacets(file).read()
      : faulty("it is a text, but does not begin with 'solid' as an ASCII .stl does");
  }
  if (head.size() < HeadSize)
  {
    return faulty("it is shorter than the head of a binary .stl");
  }
  file.seekg(static_cast<std::streamoff>(HeadSize));
  return readBinary(file, facets, size);
}
} // namespace palpate
