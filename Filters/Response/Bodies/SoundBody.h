// SPDX-License-Identifier: BSD-3-Clause
#ifndef SoundBody_h
#define SoundBody_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/SoundMesh.h" // For palpate::MeshDefects

#include "vtkPolyData.h"     // For vtkSmartPointer<vtkPolyData>
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <cstdint> // For std::int32_t
#include <memory>  // For std::shared_ptr
#include <string>  // For std::string
#include <vector>  // For std::vector

namespace palpate
{
class Ranks;
struct BodyContent;

/**
 * A body as laws, display and mesher use it: the triangles of a SoundMesh on the points of the
 * input. Points of the input that coincide are represented by the first of them.
 */
class PALPATERESPONSE_EXPORT SoundBody
{
public:
  enum class Extent
  {
    Whole,
    Piece ///< part of a body on several processes; the outside of a piece is unknown
  };

  /// The input may have no points. `content`, if not null, receives the content of body(); null
  /// after a fault.
  explicit SoundBody(vtkPolyData* input, Extent extent = Extent::Whole,
    std::shared_ptr<const BodyContent>* content = nullptr);

  /// The reason why the input is not a body (checkTriangles, SoundMesh), or "". In case of a fault
  /// body() is null.
  const std::string& fault() const { return this->Fault; }
  /// The input itself if nothing was repaired; otherwise a copy that shares its points and point
  /// arrays.
  vtkPolyData* body() const { return this->Body; }
  const MeshDefects& defects() const { return this->Found; }

  /// Number of points that are represented by another point.
  vtkIdType joinedPoints() const { return static_cast<vtkIdType>(this->Found.joinedPoints); }
  /// The first point at the place of `point`.
  vtkIdType firstAt(vtkIdType point) const
  {
    return this->First.empty() ? point : this->First[static_cast<std::size_t>(point)];
  }

  /// Restores an output that was made from body(): it gets the triangles and cell arrays of the
  /// input, and points that are represented by another point get the values of that point. Arrays
  /// of the input keep their values.
  void giveBack(vtkPolyData* output) const;

private:
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> Body;
  std::vector<std::int32_t> First; ///< empty: no points coincide
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
