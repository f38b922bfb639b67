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
 * The body with the dents of its contacts, which add up, coloured by the length of the
 * displacement.
 *
 * By shader (the default) a frame costs the same at any size of the mesh; otherwise each point is
 * computed anew (BodyField). Both draw the same field, see ContactField; the shader's limits stand
 * in DeflectionShader. Pickers that draw (vtkHardwareSelector) see the displaced surface either
 * way; those that intersect the data of the actor (vtkCellPicker) see it where points are computed,
 * and the undisturbed body by shader.
 *
 * Setters take effect in the next frame. A body that has changed is noticed by show().
 */
class BodyDisplay
{
public:
  /// `colors` has the colours and the range of the displacement, mm.
  explicit BodyDisplay(vtkLookupTable* colors);
  ~BodyDisplay();
  BodyDisplay(const BodyDisplay&) = delete;
  BodyDisplay& operator=(const BodyDisplay&) = delete;

  void setBody(vtkPolyData* body);
  void setTool(vtkContactTool* tool);
  void setPoissonRatio(double ratio);
  /// Prefix of the response that is felt. Default "Response".
  void setResponseName(const std::string& name);
  /// The field ends at this distance from the contact, mm, fading over its last quarter; 0
  /// (default): DeflectionShader::FieldRadii contact radii.
  void setFieldRadius(double radius);
  /// The dent is drawn this many times deeper than it is.
  void setExaggeration(double factor);
  double exaggeration() const;
  void setByShader(bool on);
  bool byShader() const { return this->ByShader; }

  void show(const ShownContact& contact) { this->show(std::vector<ShownContact>{ contact }); }
  void show(const std::vector<ShownContact>& contacts);

  /// Of a contact shown, mm: radius of its circle, and how deep below the contact point that lies;
  /// 0 without contact.
  double contactRadius(std::size_t contact = 0) const;
  double circleDepth(std::size_t contact = 0) const;

  /// Of the body as it is drawn, mm.
  void bounds(double bounds[6]);
  vtkActor* actor() { return this->Actor; }

private:
  /// One contact.
  struct Dent;

  void takeBody();
  void installShader(std::size_t modes);
  void refresh();
  void showByShader();
  void showByPoints();
  /// The field of a dent, as it is drawn; empty, with what is wrong, if the body does not allow it.
  ContactField makeField(Dent& dent, std::string& fault);
  bool touches() const;
  /// How far each point moves by a dent.
  vtkSmartPointer<vtkFloatArray> displaceByPoints(Dent& dent, std::string& fault);
  void complain(const std::string& fault);

  vtkSmartPointer<vtkActor> Actor;
  std::vector<Dent> Dents; ///< at least one
  double FieldRadius = 0.0;
  bool ByShader = true;

  vtkSmartPointer<vtkPolyData> Body;
  vtkMTimeType BodyTime = 0;            ///< of the body that is drawn by shader
  std::vector<vtkMTimeType> DrawnTimes; ///< of the surface and the modes that the mapper has
  vtkSmartPointer<vtkContactTool> Tool;
  std::string Fault;       ///< that was complained about last
  bool HasField = true;    ///< the body is one a field can be drawn on
  double ModeLength = 0.0; ///< longest vector of any mode
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
