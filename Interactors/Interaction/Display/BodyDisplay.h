// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyDisplay_h
#define BodyDisplay_h

#include "Interaction/Display/DeflectionShader.h"
#include "Interaction/Display/ShownContact.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkActor;
class vtkContactTool;
class vtkFloatArray;
class vtkLookupTable;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkWarpVector;

namespace palpate
{
class DentMapper;

/**
 * Draws the body with the dents of its contacts. The displacements of several contacts are added.
 * The colour shows the length of the displacement.
 *
 * With the shader (default) the cost of a frame does not depend on the size of the mesh. Without
 * the shader, the displacement of each point is computed in each frame (BodyField). Both methods
 * draw the field of ContactField; DeflectionShader documents the limits of the shader. Pickers that
 * draw (vtkHardwareSelector) always find the displaced surface. Pickers that intersect the data of
 * the actor (vtkCellPicker) find the displaced surface only without the shader; with the shader
 * they find the undeformed body.
 *
 * Setters take effect in the next frame. show() detects a changed body.
 */
class BodyDisplay
{
public:
  /// `colors` contains the colours and the range of the displacement, mm.
  explicit BodyDisplay(vtkLookupTable* colors);
  ~BodyDisplay();
  BodyDisplay(const BodyDisplay&) = delete;
  BodyDisplay& operator=(const BodyDisplay&) = delete;

  void setBody(vtkPolyData* body);
  void setTool(vtkContactTool* tool);
  void setPoissonRatio(double ratio);
  /// Sets the prefix of the array names of the response. Default "Response".
  void setResponseName(const std::string& name);
  /// Sets the distance from the contact at which the field ends, mm. The field fades over the last
  /// quarter of the distance. With 0, the default, the field ends at DeflectionShader::FieldRadii
  /// contact radii.
  void setFieldRadius(double radius);
  /// Sets the factor by which the dent is drawn deeper than computed.
  void setExaggeration(double factor);
  double exaggeration() const;
  void setByShader(bool on);
  bool byShader() const { return this->ByShader; }

  void show(const ShownContact& contact) { this->show(std::vector<ShownContact>{ contact }); }
  void show(const std::vector<ShownContact>& contacts);

  /// Radius of the contact circle, mm, and depth of the circle below the contact point, mm. Both
  /// are 0 without contact.
  double contactRadius(std::size_t contact = 0) const;
  double circleDepth(std::size_t contact = 0) const;

  /// Bounds of the drawn body, mm.
  void bounds(double bounds[6]);
  vtkActor* actor() { return this->Actor; }

private:
  /// One contact and its field.
  struct Dent;

  void takeBody();
  void installShader(std::size_t modes);
  void refresh();
  void showByShader();
  void showByPoints();
  /// Makes the field of a dent. If the body does not allow a field, returns an empty field and sets
  /// `fault`.
  ContactField makeField(Dent& dent, std::string& fault);
  bool touches() const;
  /// Returns the displacement of each point by one dent.
  vtkSmartPointer<vtkFloatArray> displaceByPoints(Dent& dent, std::string& fault);
  void complain(const std::string& fault);

  vtkSmartPointer<vtkActor> Actor;
  std::vector<Dent> Dents; ///< one element per contact, at least one
  double FieldRadius = 0.0;
  bool ByShader = true;

  vtkSmartPointer<vtkPolyData> Body;
  vtkMTimeType BodyTime = 0; ///< modification time of the body that the shader shows
  /// Modification times of the surface and of the modes that the mapper shows.
  std::vector<vtkMTimeType> DrawnTimes;
  vtkSmartPointer<vtkContactTool> Tool;
  std::string Fault;       ///< the last reported fault
  bool HasField = true;    ///< whether a displacement field can be drawn on the body
  double ModeLength = 0.0; ///< length of the longest vector of any mode
  vtkSmartPointer<DentMapper> Mapper;
  DeflectionShader Shader;

  std::string ResponseName = "Response";
  double PoissonRatio = 0.45;
  vtkSmartPointer<vtkPolyData> Displaced; ///< the body with the displacement of each point
  bool IsDented = false;
  vtkSmartPointer<vtkWarpVector> Warp;
  vtkSmartPointer<vtkPolyDataMapper> PointsMapper;
};
} // namespace palpate

#endif
