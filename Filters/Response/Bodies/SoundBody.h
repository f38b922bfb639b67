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
 * The repaired body that laws, display and mesher use. It has the triangles of a SoundMesh and the
 * points of the input. If several points of the input coincide, the first of them represents the
 * others.
 */
class PALPATERESPONSE_EXPORT SoundBody
{
public:
  enum class Extent
  {
    Whole,
    /// A piece of a body on several processes; the outer side of the piece is unknown.
    Piece
  };

  /// The input may have no points. `content`, if not null, receives the content of body(); null
  /// after a fault.
  explicit SoundBody(vtkPolyData* input, Extent extent = Extent::Whole,
    std::shared_ptr<const BodyContent>* content = nullptr);

  /// Reason why the input is not a body (checkTriangles, SoundMesh); "" if it is a body. If there
  /// is a fault, body() is null.
  const std::string& fault() const { return this->Fault; }
  /// Returns the input itself if nothing was repaired. Otherwise returns a copy that shares the
  /// points and point arrays of the input.
  vtkPolyData* body() const { return this->Body; }
  const MeshDefects& defects() const { return this->Found; }

  /// Returns the number of points that are represented by another point.
  vtkIdType joinedPoints() const { return static_cast<vtkIdType>(this->Found.joinedPoints); }
  /// Returns the index of the first point at the same position as `point`.
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
  /// For each point, the index of the first point at the same position. The list is empty if no
  /// points coincide.
  std::vector<std::int32_t> First;
  MeshDefects Found;
  std::string Fault;
};

/// Returns whether this process has the whole body or a piece of a body.
SoundBody::Extent extentOn(const Ranks& ranks);

/// Reverses the triangles of a surface that wind inward, and removes repeated triangles. The
/// remaining triangles keep their order, and all points remain. A surface without such defects is
/// not replaced. `found` receives the defects. Returns "" or an error message.
std::string orientSurface(
  vtkSmartPointer<vtkPolyData>& surface, SoundBody::Extent extent, MeshDefects& found);

/// Returns a description of the defects and of the treatment of each, with numbers; "" for a sound
/// mesh. Open borders and joined points are not defects, because many files split a surface for its
/// texture or normals.
PALPATERESPONSE_EXPORT std::string describeDefects(const MeshDefects& found);
} // namespace palpate

#endif
