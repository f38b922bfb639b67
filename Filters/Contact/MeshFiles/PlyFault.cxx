// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshFiles/PlyFault.h"

#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

namespace
{
// Largest number of corners of a face; size of a buffer in vtkPLYReader.
constexpr std::uint64_t LongestFace = 255;
// Largest number of characters; size of a buffer in vtkPLY.
constexpr std::size_t LongestLine = 4000;

struct Property
{
  std::string name;
  int countSize; // bytes of the length of a list; 0 if the property is not a list
  int size;      // bytes of one value
  bool whole;    // whether the values are integers
};

struct Element
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader
{
  std::string format;
  std::vector<Element> elements;
  std::uint64_t lines = 0;
  std::uint64_t vertices = 0;
};

bool isCorners(const Element& element, const Property& property)
{
  return element.name == "face" && property.countSize > 0 &&
    (property.name == "vertex_indices" || property.name == "vertex_index");
}

std::string readProperty(std::istream& words, Element& element)
{
  static const std::map<std::string, int> sizes = { { "char", 1 }, { "uchar", 1 }, { "int8", 1 },
    { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 }, { "int", 4 },
    { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  std::string type;
  std::string countType;
  std::string name;
  words >> type;
  const bool list = type == "list";
  if (list)
  {
    words >> countType >> type;
  }
  words >> name;
  if (name.empty() || sizes.count(type) == 0 || (list && sizes.count(countType) == 0))
  {
    return "a property that cannot be understood";
  }
  const bool whole = type[0] != 'f' && type[0] != 'd';
  element.properties.push_back({ name, list ? sizes.at(countType) : 0, sizes.at(type), whole });
  if (list && (countType[0] == 'f' || countType[0] == 'd'))
  {
    return "the length of a list must be an integer";
  }
  return isCorners(element, element.properties.back()) && !whole ? "corners must be integers" : "";
}

bool hasCoordinates(const Element& element)
{
  const auto has = [&element](const char* name)
  {
    return std::any_of(element.properties.begin(), element.properties.end(),
      [name](const Property& one) { return one.name == name && one.countSize == 0; });
  };
  return has("x") && has("y") && has("z");
}

/** The fault of the elements, or "". vtkPLYReader assumes that the first element is the
 * vertices. */
std::string elementFault(const PlyHeader& header)
{
  bool vertices = false;
  for (const Element& element : header.elements)
  {
    const bool isVertex = element.name == "vertex";
    if (element.properties.empty())
    {
      return "element " + element.name + " has no properties";
    }
    if (element.name == "face" && !vertices)
    {
      return "element face precedes element vertex; vertices must come first";
    }
    if (isVertex && (vertices || !hasCoordinates(element)))
    {
      return vertices ? "element vertex occurs twice" : "element vertex has no x, y and z";
    }
    vertices = vertices || isVertex;
  }
  return "";
}

std::string readHeader(std::istream& file, PlyHeader& header)
{
  std::string line;
  bool faces = false;
  while (std::getline(file, line))
  {
    std::string fault;
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (line.size() > LongestLine)
    {
      return palpate::joined("line ", header.lines + 1, " is longer than ", LongestLine);
    }
    if (++header.lines == 1 && word != "ply")
    {
      return "it does not begin with \"ply\"";
    }
    if (word == "end_header")
    {
      return faces ? elementFault(header) : "it has no faces with vertex_indices";
    }
    if (word == "format")
    {
      words >> header.format;
    }
    else if (word == "element")
    {
      header.elements.emplace_back();
      Element& element = header.elements.back();
      words >> element.name >> element.count;
      fault = words ? "" : "an element needs a name and a count";
      header.vertices = element.name == "vertex" ? element.count : header.vertices;
    }
    else if (word == "property")
    {
      fault = header.elements.empty() ? "a property before any element"
                                      : readProperty(words, header.elements.back());
      faces = faces ||
        (fault.empty() &&
          isCorners(header.elements.back(), header.elements.back().properties.back()));
    }
    else if (word != "ply" && word != "comment" && word != "obj_info")
    {
      fault = "\"" + word + "\" is not understood";
    }
    if (!fault.empty())
    {
      return palpate::joined("line ", header.lines, ": ", fault);
    }
  }
  return "its header does not end";
}

/** Reads the values of a file in order. A failed stream means the end. */
class Values
{
public:
  Values(std::istream& file, const PlyHeader& header)
    : stream(file)
    , ascii(header.format == "ascii")
    , bigEndian(header.format == "binary_big_endian")
  {
  }

  /** Moves to the next row: a line of an ASCII file. */
  bool nextRow()
  {
    if (this->ascii && std::getline(this->stream, this->line))
    {
      this->words.clear();
      this->words.str(this->line);
    }
    return this->stream.good() && this->line.size() <= LongestLine;
  }

  /** Reads a value as unsigned, so that a negative one appears large; from a binary file, its
   * bytes. */
  bool next(int size, std::uint64_t& value)
  {
    if (this->ascii)
    {
      std::string word;
      this->words >> word;
      value = std::strtoull(word.c_str(), nullptr, 10);
      return !word.empty();
    }
    unsigned char bytes[8] = {};
    this->stream.read(reinterpret_cast<char*>(bytes), size);
    value = 0;
    for (int i = 0; i < size; ++i)
    {
      value = value << 8 | bytes[this->bigEndian ? i : size - 1 - i];
    }
    return this->stream.good();
  }

private:
  std::istream& stream;
  std::istringstream words;
  std::string line;
  bool ascii;
  bool bigEndian;
};

/** The fault of one row of an element, or "". */
std::string rowFault(Values& values, const Element& element, std::uint64_t vertices)
{
  for (const Property& property : element.properties)
  {
    const bool corners = isCorners(element, property);
    std::uint64_t length = 1;
    if (property.countSize > 0 && !values.next(property.countSize, length))
    {
      return "is cut short";
    }
    if (element.name == "face" && length > LongestFace)
    {
      return palpate::joined("has a list of ", length, ", more than ", LongestFace);
    }
    for (std::uint64_t i = 0; i < length; ++i)
    {
      std::uint64_t value = 0;
      if (!values.next(property.size, value))
      {
        return "is cut short";
      }
      if (corners && value >= vertices)
      {
        return palpate::joined(
          "names a vertex that does not exist; the number of vertices is ", vertices);
      }
    }
  }
  return "";
}

} // namespace

namespace palpate
{
std::string plyFault(std::istream& file)
{
  PlyHeader header;
  std::string fault = readHeader(file, header);
  if (!fault.empty())
  {
    return fault;
  }
  const std::string& format = header.format;
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
  {
    return "its format \"" + format + "\" is unknown";
  }
  Values values(file, header);
  for (const Element& element : header.elements)
  {
    for (std::uint64_t row = 0; row < element.count; ++row)
    {
      fault = values.nextRow() ? rowFault(values, element, header.vertices) : "is cut short";
      if (!fault.empty())
      {
        return palpate::joined(element.name, " ", row, " of ", element.count, " ", fault);
      }
    }
  }
  return "";
}
} // namespace palpate
