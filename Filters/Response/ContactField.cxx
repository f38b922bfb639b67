// SPDX-License-Identifier: BSD-3-Clause
#include "Response/ContactField.h"

#include "Response/BodyConversion.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/LayerSurface.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
/// Where a contact lies in its triangle.
struct Place
{
  std::array<vtkIdType, 3> corners{};
  Vector3 weights = Vector3::Zero();
};

Place placeOf(vtkPolyData* body, const FieldContact& contact)
{
  Place place;
  std::array<Vector3, 3> points;
  vtkNew<vtkIdList> corners;
  const vtkIdType triangle = contact.cell - body->GetNumberOfVerts() - body->GetNumberOfLines();
  body->GetPolys()->GetCellAtId(triangle, corners);
  for (std::size_t i = 0; i < 3; ++i)
  {
    place.corners[i] = corners->GetId(static_cast<vtkIdType>(i));
    body->GetPoint(place.corners[i], points[i].data());
  }
  place.weights = projectOnTriangle(contact.point, points[0], points[1], points[2]).weights;
  return place;
}

/// The thickness of the layer under the contact, mm; 0 on a half-space. 1/h is interpolated, which
/// is what a base stiffens by, and 0 where there is none.
double thicknessAt(const Place& place, vtkDataArray* thickness)
{
  double inverse = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double h = thickness->GetTuple1(place.corners[i]);
    inverse += h > 0.0 ? place.weights[static_cast<Eigen::Index>(i)] / h : 0.0;
  }
  return inverse > 0.0 ? 1.0 / inverse : 0.0;
}

/// n·φ at the contact.
double modeAt(const Place& place, vtkDataArray* mode, const Vector3& normal)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    Vector3 phi;
    mode->GetTuple(place.corners[i], phi.data());
    sum += place.weights[static_cast<Eigen::Index>(i)] * normal.dot(phi);
  }
  return sum;
}

bool hasShape(vtkDataArray* array, int components, vtkIdType tuples)
{
  return array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == tuples;
}

/// Null where there is none, or none of a value per point.
vtkDataArray* layerThickness(vtkPolyData* body, const std::string& name)
{
  vtkDataArray* layers = body->GetPointData()->GetArray((name + "LayerThickness").c_str());
  return layers && hasShape(layers, 1, body->GetNumberOfPoints()) ? layers : nullptr;
}

/// The edge of a tool that lies well within its contact; 0 if there is none.
double edgeWithin(const AxisymmetricTool& tool, double contactRadius)
{
  const std::vector<double> kinks = tool.kinks();
  return !kinks.empty() && kinks.front() < 0.999 * contactRadius ? kinks.front() : 0.0;
}

/// 0 below `begin`, 1 above `end`, without a kink between.
double smoothStep(double begin, double end, double x)
{
  const double t = std::clamp((x - begin) / (end - begin), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
} // namespace

std::vector<vtkDataArray*> globalModeArrays(vtkPolyData* body, const std::string& name)
{
  std::vector<vtkDataArray*> modes;
  vtkDataArray* signs = body->GetFieldData()->GetArray("GlobalModeSign");
  const bool bends =
    signs && signs->GetNumberOfComponents() == 1 && responseModel(body, name).isInSeries();
  const vtkIdType count = bends ? signs->GetNumberOfTuples() : 0;
  for (vtkIdType k = 0; k < count; ++k)
  {
    vtkDataArray* mode = body->GetPointData()->GetArray(("GlobalMode" + std::to_string(k)).c_str());
    if (!mode || !hasShape(mode, 3, body->GetNumberOfPoints()))
    {
      break;
    }
    modes.push_back(mode);
  }
  return modes;
}

std::string checkFieldArrays(vtkPolyData* body, const std::string& name)
{
  const vtkIdType points = body->GetNumberOfPoints();
  const auto describe = [points](vtkDataArray* array, int components)
  {
    return std::string("array '") + array->GetName() + "' must have " + std::to_string(components) +
      " components and " + std::to_string(points) + " tuples, but has " +
      std::to_string(array->GetNumberOfComponents()) + " and " +
      std::to_string(array->GetNumberOfTuples());
  };
  vtkDataArray* layers = body->GetPointData()->GetArray((name + "LayerThickness").c_str());
  if (layers && !hasShape(layers, 1, points))
  {
    return describe(layers, 1);
  }
  for (vtkIdType k = 0;; ++k)
  {
    vtkDataArray* mode = body->GetPointData()->GetArray(("GlobalMode" + std::to_string(k)).c_str());
    if (!mode || !hasShape(mode, 3, points))
    {
      return mode ? describe(mode, 3) : std::string();
    }
  }
}

ContactField::ContactField(vtkPolyData* body, const AxisymmetricTool& tool,
  const FieldContact& contact, const FieldSettings& settings,
  std::shared_ptr<const LayerKernel>& kernel)
  : Deflection(contact.deflection)
  , Reach(settings.reach)
{
  if (contact.cell < 0 || !(contact.deflection > 0.0))
  {
    return;
  }
  this->bend(body, contact, settings.responseName);
  if (!(this->Deflection > 0.0))
  {
    return;
  }
  vtkDataArray* layers = layerThickness(body, settings.responseName);
  vtkDataArray* base =
    body->GetFieldData()->GetArray((settings.responseName + "LayerBase").c_str());
  this->press(tool, layers ? thicknessAt(placeOf(body, contact), layers) : 0.0,
    base && base->GetNumberOfValues() == 1 ? static_cast<int>(base->GetTuple1(0)) : 0,
    settings.poissonRatio, kernel);
}

void ContactField::bend(
  vtkPolyData* body, const FieldContact& contact, const std::string& responseName)
{
  const std::vector<vtkDataArray*> modes = globalModeArrays(body, responseName);
  if (modes.empty())
  {
    return;
  }
  const Place place = placeOf(body, contact);
  vtkDataArray* signs = body->GetFieldData()->GetArray("GlobalModeSign");
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    const double sign = signs->GetTuple1(static_cast<vtkIdType>(k));
    const double here = modeAt(place, modes[k], contact.normal);
    this->Weights.push_back(-contact.force * sign * here);
    this->Deflection -= contact.force * sign * here * here;
  }
}

void ContactField::press(const AxisymmetricTool& tool, double thickness, int base,
  double poissonRatio, std::shared_ptr<const LayerKernel>& kernel)
{
  const double deflection = this->Deflection;
  if (!(thickness > 0.0))
  {
    this->Radius = tool.contactRadius(deflection);
    this->Kink = edgeWithin(tool, this->Radius);
    this->Law = [&tool, deflection, poissonRatio](double r)
    { return tool.surfaceDisplacement(r, deflection, poissonRatio); };
    return;
  }
  const auto baseOfLayer = base == 1 ? LayerBase::Slip : LayerBase::Bonded;
  if (!kernel || kernel->poissonsRatio() != poissonRatio || kernel->base() != baseOfLayer)
  {
    kernel = std::make_shared<const LayerKernel>(poissonRatio, baseOfLayer);
  }
  auto layer = std::make_shared<const LayerContact>(tool, kernel, thickness);
  if (deflection > layer->deepest())
  {
    std::ostringstream text;
    text << "No field: the layer of " << thickness
         << " mm at the contact is thinner than a tenth of the contact radius";
    this->Fault = text.str();
    return;
  }
  this->Radius = layer->contactRadius(deflection);
  this->Kink = edgeWithin(tool, this->Radius);
  auto surface = std::make_shared<const LayerSurface>(*layer, deflection);
  this->Law = [layer, surface](double r) { return surface->at(r); };
}

SurfaceDisplacement ContactField::local(double r) const
{
  return this->Law ? this->Law(r) : SurfaceDisplacement{ 0.0, 0.0 };
}

double ContactField::fade(double r, double cosine) const
{
  if (!(this->Reach > 0.0))
  {
    return 1.0;
  }
  return smoothStep(CosineOfEnd, CosineOfFade, cosine) *
    (1.0 - smoothStep(FadeBegin * this->Reach, this->Reach, r));
}
} // namespace palpate
