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
 * A body as it is used by laws, display and mesher: the triangles of a SoundMesh on the points of
 * the input. If several points of the input coincide, the first of them represents the others.
 */
class PALPATERESPONSE_EXPORT SoundBody
{
public:
  enum class Extent
  {
    Whole,
    Piece ///< part of a body on several processes; the outside of a piece is unknown
  };

  /// The input may have no points.
  explicit SoundBody(vtkPolyData* input, Extent extent = Extent::Whole);

  /// Reason why the input is not a body (checkTriangles, SoundMesh), or "". With a fault body() is
  /// null.
  const std::string& fault() const { return this->Fault; }
  /// The input itself if nothing was repaired; otherwise a copy that shares its points and point
  /// arrays.
  vtkPolyData* body() const { return this->Body; }
  const MeshDefects& defects() const { return this->Found; }

  /// Number of points that are represented by another point.
  vtkIdType joinedPoints() const { return static_cast<vtkIdType>(this->Found.joinedPoints); }
  /// Returns the first point at the place of `point`.
  vtkIdType firstAt(vtkIdType point) const
  {
    return this->First.empty() ? point : this->First[static_cast<std::size_t>(point)];
  }

  /// Restores an output that was made from body(). The output gets the triangles and cell arrays of
  /// the input. A point that is represented by another point gets the values of that point. Arrays
  /// of the input keep their values.
  void giveBack(vtkPolyData* output) const;

private:
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> Body;
  /// First point at the place of each point; empty: no points coincide.
  std::vector<std::int32_t> First;
  MeshDefects Found;
  std::string Fault;
};

/// Whether this process has the whole body or a piece.
SoundBody::Extent extentOn(const Ranks& ranks);

/// Turns the triangles of a surface outward and removes repeated ones. The remaining triangles keep
/// their order, and all points remain. A surface without such defects is not replaced. `found`
/// receives the defects. Returns "" or an error message.
std::string orientSurface(
  vtkSmartPointer<vtkPolyData>& surface, SoundBody::Extent extent, MeshDefects& found);

/// Describes the defects and the treatment of each, with their numbers; "" for a sound mesh. Open
/// borders and joined points are not defects: files split a surface for its texture or normals.
PALPATERESPONSE_EXPORT std::string describeDefects(const MeshDefects& found);
} // namespace palpate

#endif
