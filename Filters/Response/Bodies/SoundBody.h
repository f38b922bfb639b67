// SPDX-License-Identifier: BSD-3-Clause
#ifndef SoundBody_h
#define SoundBody_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/SoundMesh.h" // For palpate::MeshDefects

#include "vtkPolyData.h"     // For vtkSmartPointer<vtkPolyData>
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <cstdint> // For std::int32_t
#include <string>  // For std::string
#include <vector>  // For std::vector

namespace palpate
{
class Ranks;

/**
 * A body as laws, display and mesher use it: the triangles of a SoundMesh on the points of the
 * input. Points of the input that are at one place are represented by the first of them.
 */
class PALPATERESPONSE_EXPORT SoundBody
{
public:
  enum class Extent
  {
    Whole,
    Piece ///< of a body on several processes: a piece does not show which side is outside
  };

  /// The input may have no points.
  explicit SoundBody(vtkPolyData* input, Extent extent = Extent::Whole);

  /// Why the input is no body (checkTriangles, SoundMesh), or "". Then body() is null.
  const std::string& fault() const { return this->Fault; }
  /// The input itself if nothing is repaired; otherwise a copy that shares its points and point
  /// arrays.
  vtkPolyData* body() const { return this->Body; }
  const MeshDefects& defects() const { return this->Found; }

  /// How many points are represented by another one.
  vtkIdType joinedPoints() const { return static_cast<vtkIdType>(this->Found.joinedPoints); }
  /// The first point at the place of this one.
  vtkIdType firstAt(vtkIdType point) const
  {
    return this->First.empty() ? point : this->First[static_cast<std::size_t>(point)];
  }

  /// Gives an output that was made from body() the triangles and cell arrays of the input, and the
  /// points that are represented by another one its values. Arrays of the input keep theirs.
  void giveBack(vtkPolyData* output) const;

private:
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> Body;
  std::vector<std::int32_t> First; ///< empty: all points are at places of their own
  MeshDefects Found;
  std::string Fault;
};

/// What a process has of a body.
SoundBody::Extent extentOn(const Ranks& ranks);

/// The triangles of a surface in their order, outward, without repeats, on its own points; itself
/// if it has no such defect. `found`: what was wrong. A fault, or "".
std::string orientSurface(
  vtkSmartPointer<vtkPolyData>& surface, SoundBody::Extent extent, MeshDefects& found);

/// The defects and how each was handled, with their numbers; "" for a sound mesh. Open borders are
/// no defect, nor are joined points: files split a surface for its texture or normals.
PALPATERESPONSE_EXPORT std::string describeDefects(const MeshDefects& found);
} // namespace palpate

#endif
