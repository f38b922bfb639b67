// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyField_h
#define BodyField_h

#include "palpateResponseModule.h" // For export macro

#include "Laws/ContactField.h" // For palpate::ContactField
#include "vtkType.h"           // For vtkIdType

#include <memory> // For std::shared_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkDataArray;
class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;
class Ranks;

/**
 * Computes the displacement of a body around successive contacts. Uses the arrays that ContactField
 * needs: `LayerThickness` and `LayerBase` of the response; the point arrays `GlobalMode0`... and
 * the field array `GlobalModeSign`, if the model has a global compliance or uses the true shape of
 * the body; and `NearField`, if the model uses the true shape.
 *
 * The object keeps the neighbours of the mesh, computed in O(n log n), as long as points and
 * triangles do not change. It also keeps the solution for the most recent layer.
 */
class PALPATERESPONSE_EXPORT BodyField
{
public:
  BodyField();
  ~BodyField();
  BodyField(const BodyField&) = delete;
  BodyField& operator=(const BodyField&) = delete;

  struct Request
  {
    /// Tool of the contact; not needed if this process has no piece of the body.
    const AxisymmetricTool* tool = nullptr;
    std::string responseName;
    FieldSettings settings;
  };
  /// Computes `ContactDisplacement` (float 3, mm) of a body that has passed checkBody. Without
  /// contact the displacement is zero. The cell of the contact is a triangle of the body on `rank`.
  /// Collective. Returns "" or an error message, the same on all ranks.
  std::string displace(const Ranks& ranks, vtkPolyData* body, const FieldContact& contact, int rank,
    const Request& request, vtkFloatArray* displacement);
  /// Returns sentences about the parts of the field that displace() has left out. Missing modes are
  /// reported once.
  const std::vector<std::string>& warnings() const { return this->Warnings; }

private:
  class LinkedPiece;

  std::unique_ptr<const LinkedPiece> Piece;
  std::shared_ptr<const LayerKernel> Kernel;
  std::vector<std::string> Warnings;
  std::string ReportedModel;
};

/// Returns the triangle `cell` of a body, with the data that the field of the response `name` needs
/// at this triangle.
PALPATERESPONSE_EXPORT FieldTriangle fieldTriangle(
  vtkPolyData* body, vtkIdType cell, const std::string& name);

/// Name of the point array with the NearField of a response for the true shape of a body. The array
/// has NearField::Numbers components.
constexpr const char* NearFieldArray = "NearField";

/// Returns the name of the point array of mode `k` of a body's motion (GlobalModes.h). The array
/// has 3 components, in sqrt(mm/N).
inline std::string globalModeName(std::size_t k)
{
  return "GlobalMode" + std::to_string(k);
}

/// Name of the field array with the signs of the modes, 1 or -1.
constexpr const char* GlobalModeSignArray = "GlobalModeSign";

/// Returns the arrays of the modes that belong to the response `name` of a body. The result is
/// empty unless the response has a global compliance or is for the true shape of the body.
PALPATERESPONSE_EXPORT std::vector<vtkDataArray*> globalModeArrays(
  vtkPolyData* body, const std::string& name);

/// Adds the displacements `other` of another contact, at the same points, to `sum`.
PALPATERESPONSE_EXPORT void addDisplacements(vtkFloatArray* other, vtkFloatArray* sum);

/// Returns whether a cell is one of the triangles of a body.
PALPATERESPONSE_EXPORT bool isTriangle(vtkPolyData* body, vtkIdType cell);

/// Checks the triangles, and the point arrays of the modes and the layer. Returns "" if they are
/// valid, else an error message. The other functions do not check these arrays; they ignore an
/// array that does not have one value per point.
PALPATERESPONSE_EXPORT std::string checkBody(vtkPolyData* body, const std::string& name);
} // namespace palpate

#endif
