// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/MeshFiles/ObjFile.h"

#include "Contact/MeshFiles/FileWords.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace palpate
{
namespace
{
constexpr std::size_t Parts = 3; // number of indices of a corner: point, texture coordinate, normal
constexpr std::array<const char*, Parts> PartNames = { "vertex", "texture coordinate", "normal" };

class ObjReader
{
public:
  explicit ObjReader(std::istream& file)
    : Words(file, '\\')
  {
    this->Mesh.starts.push_back(0);
  }

  FileMesh read()
  {
    while (this->Mesh.fault.empty() && this->Words.nextLine())
    {
      this->readLine(this->Words.word());
    }
    this->checkLargest();
    if (this->Mesh.fault.empty() && this->Mesh.starts.size() == 1 && this->LeftOut == 0)
    {
      this->Mesh.fault = "it has no faces";
    }
    if (!this->Mesh.fault.empty())
    {
      FileMesh wrong;
      wrong.fault = this->Mesh.fault;
      return wrong;
    }
    this->attachNormals();
    return std::move(this->Mesh);
  }

private:
  void readLine(std::string_view keyword)
  {
    if (keyword == "v")
    {
      this->readVector(this->Mesh.points);
      ++this->Counts[0];
    }
    else if (keyword == "vt")
    {
      ++this->Counts[1];
    }
    else if (keyword == "vn")
    {
      this->readVector(this->Normals);
      ++this->Counts[2];
    }
    else if (keyword == "f" || keyword == "fo")
    {
      this->readFace();
    }
    else if (keyword == "l" || keyword == "p")
    {
      ++this->LeftOut;
    }
  }

  void fail(const std::string& what)
  {
    this->Mesh.fault = joined("line ", this->Words.lineNumber(), ": ", what);
  }

  void readVector(std::vector<float>& values)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      float value = 0.0F;
      std::string_view wrong;
      if (!this->Words.number(value, wrong))
      {
        this->fail(wrong.empty() ? "three numbers are needed"
                                 : FileWords::shown(wrong) + " is not a finite number");
        return;
      }
      values.push_back(value);
    }
  }

  void readFace()
  {
    std::int64_t count = 0;
    for (std::string_view corner = this->Words.word(); !corner.empty() && corner[0] != '#';
         corner = this->Words.word())
    {
      if (!this->readCorner(corner))
      {
        return;
      }
      ++count;
    }
    if (count < 3)
    {
      this->fail(joined("a face needs three corners, but has ", count));
      return;
    }
    this->Mesh.starts.push_back(static_cast<std::int64_t>(this->Mesh.corners.size()));
  }

  /// Reads a corner in the form v, v/t, v//n or v/t/n.
  bool readCorner(std::string_view text)
  {
    const std::string_view whole = text;
    std::array<std::int64_t, Parts> named = { 0, 0, 0 };
    for (std::size_t part = 0; part < Parts; ++part)
    {
      const std::size_t end = std::min(text.find('/'), text.size());
      const std::string_view digits = text.substr(0, end);
      const bool mayLack = part == 1 && end < text.size();
      if (!(digits.empty() && mayLack) && !this->readIndex(digits, whole, part, named[part]))
      {
        return false;
      }
      if (end == text.size())
      {
        this->Mesh.corners.push_back(named[0] - 1);
        this->CornerNormals.push_back(named[2] - 1);
        return true;
      }
      text.remove_prefix(end + 1);
    }
    this->fail(joined("the corner ", FileWords::shown(whole), " has more than three parts"));
    return false;
  }

  bool readIndex(
    std::string_view digits, std::string_view whole, std::size_t part, std::int64_t& index)
  {
    if (!readNumber(digits, index) || index == 0)
    {
      this->fail(joined("the corner ", FileWords::shown(whole), " cannot be understood"));
      return false;
    }
    const std::int64_t count = this->Counts[part];
    if (index < -count)
    {
      this->fail(joined("the corner ", FileWords::shown(whole), " names ", PartNames[part], ' ',
        index, ", but only ", count, " precede it"));
      return false;
    }
    index = index < 0 ? count + 1 + index : index;
    if (index > this->Largest[part])
    {
      this->Largest[part] = index;
      this->LargestAt[part] = this->Words.lineNumber();
    }
    return true;
  }

  /// Checks the largest indices at the end of the file, because a corner may refer to a later
  /// vertex.
  void checkLargest()
  {
    for (std::size_t part = 0; part < Parts && this->Mesh.fault.empty(); ++part)
    {
      if (this->Largest[part] > this->Counts[part])
      {
        this->Mesh.fault =
          joined("line ", this->LargestAt[part], ": a corner names ", PartNames[part], ' ',
            this->Largest[part], ", but the number of them is ", this->Counts[part]);
      }
    }
  }

  /// Keeps the normals if each point of a face has exactly one normal.
  void attachNormals()
  {
    if (this->LeftOut > 0)
    {
      this->Mesh.notes.push_back(joined(this->LeftOut, " points and lines left out"));
    }
    if (this->Normals.empty())
    {
      return;
    }
    std::vector<std::int64_t> ofPoint(this->Mesh.points.size() / 3, -1);
    for (std::size_t i = 0; i < this->Mesh.corners.size(); ++i)
    {
      std::int64_t& normal = ofPoint[static_cast<std::size_t>(this->Mesh.corners[i])];
      const std::int64_t own = this->CornerNormals[i];
      if (own < 0 || (normal >= 0 && !this->areEqual(normal, own)))
      {
        this->Mesh.notes.push_back(own < 0
            ? "normals left out, since not all corners have one"
            : "normals left out, since corners of one point have different ones");
        return;
      }
      normal = own;
    }
    if (std::find(ofPoint.begin(), ofPoint.end(), -1) != ofPoint.end())
    {
      this->Mesh.notes.emplace_back("normals left out, since not all points have one");
      return;
    }
    for (const std::int64_t normal : ofPoint)
    {
      const auto first = this->Normals.begin() + 3 * normal;
      this->Mesh.normals.insert(this->Mesh.normals.end(), first, first + 3);
    }
  }

  bool areEqual(std::int64_t a, std::int64_t b) const
  {
    const auto first = this->Normals.begin();
    return a == b || std::equal(first + 3 * a, first + 3 * a + 3, first + 3 * b);
  }

  FileWords Words;
  FileMesh Mesh;
  std::vector<float> Normals;               ///< normals in the order of the file
  std::vector<std::int64_t> CornerNormals;  ///< index of each corner's normal; -1 if it has none
  std::array<std::int64_t, Parts> Counts{}; ///< number of lines of each kind so far
  std::array<std::int64_t, Parts> Largest{};
  std::array<std::size_t, Parts> LargestAt{}; ///< line in which the largest index occurs
  std::size_t LeftOut = 0;
};
} // namespace

FileMesh readObj(std::istream& file)
{
  return ObjReader(file).read();
}
} // namespace palpate
